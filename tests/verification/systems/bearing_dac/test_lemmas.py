"""The lemmas on graphs are decided as they have to be, and not by accident."""

import copy
import json
from fractions import Fraction
from itertools import product
from typing import Any

import pytest

from sensortrack.networks import read_network
from theory.systems.bearing_dac import SYSTEM
from verification.certificates import check
from verification.certificates.make import statements
from verification.exact.evaluate import multiply
from verification.exact.laplacians.gap_vectors import laplacian_rows
from verification.systems.bearing_dac.lemmas import (
    LEMMA_DECISIONS,
    centring,
    skew_inverses,
)
from verification.verdict import Decision, Verdict

DECIDED: dict[str, Decision] = {name: decide() for name, decide in LEMMA_DECISIONS.items()}
DOCUMENTS = [
    (stem, document)
    for decision in DECIDED.values()
    for stem, document in decision.certificates.items()
]
UNIVERSAL = [(stem, document) for stem, document in DOCUMENTS if not document["inputs"]]


def test_every_lemma_of_the_system_is_decided() -> None:
    claimed = {claim.id for claim in SYSTEM.claims if ".lemma_" in claim.id}
    assert {*DECIDED} == claimed


@pytest.mark.parametrize(
    "claim, verdict",
    [
        ("lemma_1_quadratic_form", Verdict.PROVED),
        ("lemma_1_symmetric", Verdict.CORRECTED),
        ("lemma_2_moore_penrose", Verdict.PROVED),
        ("lemma_2_generalized", Verdict.CORRECTED),
    ],
)
def test_verdicts(claim: str, verdict: Verdict) -> None:
    decision = DECIDED[f"bearing_dac.{claim}"]
    assert decision.verdict is verdict
    assert bool(decision.repair) == (verdict is Verdict.CORRECTED)
    shown = {document["verdict"] for document in decision.certificates.values()}
    assert shown == ({"PROVED", "REFUTED"} if verdict is Verdict.CORRECTED else {"PROVED"})


@pytest.mark.parametrize("stem, document", DOCUMENTS, ids=[stem for stem, _ in DOCUMENTS])
def test_certificates_are_accepted_after_a_round_trip(stem: str, document: dict[str, Any]) -> None:
    entry = check.check_document(json.loads(json.dumps(document)), statements())
    assert entry["verdict"] == document["verdict"]
    assert f"{entry['system']}.{entry['name']}" == stem


@pytest.mark.parametrize("stem, document", UNIVERSAL, ids=[stem for stem, _ in UNIVERSAL])
def test_every_term_of_a_derivation_is_needed(stem: str, document: dict[str, Any]) -> None:
    for item, place in enumerate(document["witness"]):
        for kind in ("squares", "relations"):
            for k in range(len(place[kind])):
                forged = copy.deepcopy(document)
                del forged["witness"][item][kind][k]
                with pytest.raises(check.Reject):
                    check.check_document(forged, statements())


def test_the_counterexample_is_the_smallest_and_really_one() -> None:
    network, inverse = next(skew_inverses())
    laplacian = laplacian_rows(network)
    assert network.n == 2
    assert sum(map(bool, sum(inverse, ()))) == 1
    assert multiply(multiply(laplacian, inverse), laplacian) == laplacian
    assert multiply(laplacian, inverse) != centring(2)


def test_an_inverse_that_is_none_is_refused() -> None:
    document = copy.deepcopy(DECIDED["bearing_dac.lemma_2_generalized"].certificates)
    refuted = document["bearing_dac.lemma_2_generalized"]
    for inverse in ([[1, 0], [0, 1]], [["1/2", "-1/2"], ["-1/2", "1/2"]], [["1/4", "-1/4"]] * 2):
        refuted["inputs"]["G"] = inverse
        with pytest.raises(check.Reject):
            check.check_document(refuted, statements())


def test_the_moore_penrose_inverse_is_no_counterexample() -> None:
    """L/4 is the Moore-Penrose inverse of the Laplacian of two sensors."""
    document = copy.deepcopy(DECIDED["bearing_dac.lemma_2_generalized"].certificates)
    refuted = document["bearing_dac.lemma_2_generalized"]
    refuted["inputs"]["G"] = [["1/4", "-1/4"], ["-1/4", "1/4"]]
    with pytest.raises(check.Reject, match="!="):
        check.check_document(refuted, statements())


def test_the_repair_separates_good_inverses_from_bad_ones() -> None:
    """Among all small generalized inverses, LG = M exactly where LG is symmetric."""
    laplacian, seen = laplacian_rows(read_network("path:2")), set()
    for flat in product([Fraction(k, 4) for k in range(-4, 5)], repeat=4):
        inverse = (flat[:2], flat[2:])
        along = multiply(laplacian, inverse)
        if multiply(along, laplacian) == laplacian:
            symmetric = along == tuple(zip(*along, strict=True))
            assert (along == centring(2)) == symmetric
            assert multiply(along, centring(2)) == centring(2)
            seen.add(symmetric)
    assert seen == {True, False}
