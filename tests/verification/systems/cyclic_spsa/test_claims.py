"""Every decision about cyclic SPSA rests on files that the checker accepts, and on no more."""

import copy

import pytest

from tests.verification.systems.cyclic_spsa.decided import decided
from theory.systems.cyclic_spsa.statements import (
    PROOFS,
    experiment,
    measurement,
    schedule,
    theorem_1,
    theorem_2,
)
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.systems.cyclic_spsa.claims import DECISIONS
from verification.systems.cyclic_spsa.claims.common import proof
from verification.verdict import Verdict

SAID = {
    Verdict.PROVED: {"PROVED"},
    Verdict.CORRECTED: {"PROVED", "REFUTED"},
    Verdict.REFUTED: {"REFUTED"},
}
DECIDED = {name: decided(name) for name in DECISIONS}
FILES = {
    stem: document
    for decision in DECIDED.values()
    for stem, document in decision.certificates.items()
}
NAMES = {
    entry.name
    for module in (measurement, schedule, theorem_1, theorem_2, experiment)
    for entry in module.STATEMENTS
}
REPLAYED = sorted(
    stem
    for stem, document in FILES.items()
    if document["inputs"] and not document["witness"] and document["name"] in NAMES
)


@pytest.mark.parametrize("claim", sorted(DECISIONS))
def test_every_certificate_of_a_decision_is_valid_and_matches_its_verdict(claim):
    decision = DECIDED[claim]
    if decision.verdict not in SAID:  # what no file shows says why
        assert decision.reason
        return
    verdicts = {
        check.check_document(document, statements())["verdict"]
        for document in decision.certificates.values()
    }
    assert verdicts == SAID[decision.verdict]
    assert decision.reason
    corrected = decision.verdict is Verdict.CORRECTED
    assert bool(decision.repair) == bool(decision.repair_formula) == corrected


@pytest.mark.parametrize("name", sorted(PROOFS))
def test_every_hypothesis_of_a_universal_statement_is_needed_by_its_proof(name):
    """Without any one of them, renumbered, the checker refuses."""
    document, known = FILES[f"cyclic_spsa.{name}"], statements()
    full = known[f"cyclic_spsa.{name}"]
    for k in range(len(full["given"])):
        weaker = copy.deepcopy(full)
        weaker["given"][k] = "0*(" + weaker["given"][k] + ")"
        forged = document | {"digest": check.digest_of(weaker)}
        with pytest.raises(check.Reject):
            check.check_document(forged, known | {f"cyclic_spsa.{name}": weaker})


@pytest.mark.parametrize("stem", REPLAYED)
def test_a_replay_with_any_one_number_changed_is_refused(stem):
    """Vectors are changed as a whole."""
    document = FILES[stem]
    for name, value in document["inputs"].items():
        other = [["7/3"] for _ in value] if isinstance(value, list) else "-7/3"
        inputs = document["inputs"] | {name: other}
        if name in FREE.get(stem, ()):
            check.check_document(document | {"inputs": inputs}, statements())
        else:
            with pytest.raises(check.Reject):
                check.check_document(document | {"inputs": inputs}, statements())


FREE = {
    "cyclic_spsa.eq_2_zero_mean": {"s"},
    "cyclic_spsa.assumption_5_every_point": {"x"},
    "cyclic_spsa.theorem_2_lipschitz": {"x", "r"},
    "cyclic_spsa.theorem_2_c3_every_point": {"far"},
}
"""Numbers on which a counterexample does not depend: it is as good anywhere in the plane."""


@pytest.mark.parametrize("name, case", [("eq_13_inverse", "REFUTED"), ("eq_14_axes_repair", "X")])
def test_a_proof_proves_its_own_case_only(name, case):
    with pytest.raises((CertificateError, KeyError)):
        proof(name, case)


def test_a_derivation_of_another_statement_proves_nothing():
    other = [{"kind": "derivation", **entry.to_data()} for entry in PROOFS["eq_14_trace"]]
    with pytest.raises(CertificateError):
        certificate("cyclic_spsa", "eq_14_axes_repair", {}, other)


@pytest.mark.parametrize("claim", sorted(DECISIONS))
def test_a_figure_has_finite_numbers_within_its_axes(claim):
    figure = DECIDED[claim].figure
    if figure is None:
        return
    for mark in (*figure.curves, *figure.dots):
        for axis, numbers in ((figure.x, mark.x), (figure.y, mark.y)):
            slack = 1e-9 * (axis.high - axis.low)
            assert all(axis.low - slack <= number <= axis.high + slack for number in numbers)
    assert figure.title
    assert figure.finding.endswith(".")
    assert figure.caption.endswith(".")
