"""The claims of the poster: what is refuted, where, and that nothing else is."""

from fractions import Fraction
from math import sqrt

import numpy as np
import pytest

from verification.adversary.small_graphs import connected_graphs
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.systems.bearing_dac.claims import DECISIONS
from verification.systems.bearing_dac.counterexamples import (
    gain_counterexamples,
    time_counterexamples,
)
from verification.verdict import Verdict


def printed_gain(network, gamma):
    values = np.linalg.eigvalsh(network.laplacian().toarray())
    return 1 + gamma * sqrt(network.n) / values[1]


def true_ratio(network):
    """Largest 2p/k, from every set of nodes."""
    edges, n, best = network.edges.tolist(), network.n, 0.0
    for code in range(1, 2**n - 1):
        s = bin(code).count("1")
        k = sum((code >> i & 1) != (code >> j & 1) for i, j in edges)
        best = max(best, 2 * s * (n - s) / (n * k))
    return best


@pytest.mark.parametrize("claim", sorted(DECISIONS))
def test_every_certificate_of_a_decision_is_valid_and_matches_its_verdict(claim):
    decision = DECISIONS[claim]()
    verdicts = {
        check.check_document(document, statements())["verdict"]
        for document in decision.certificates.values()
    }
    wanted = {Verdict.PROVED: {"PROVED"}, Verdict.CORRECTED: {"PROVED", "REFUTED"}}
    assert verdicts == wanted[decision.verdict]


def test_the_printed_gain_fails_exactly_on_two_sensors_and_on_the_triangle():
    found = {example.network.label: example for example in gain_counterexamples(4)}
    assert sorted(found) == ["01", "01 02 12"]
    for example in found.values():
        gamma, beta = float(example.gamma), float(example.beta)
        assert printed_gain(example.network, gamma) <= beta < gamma * true_ratio(example.network)
    for nodes in (2, 3, 4, 5):  # at most 1e6: a larger gamma would not change the comparison
        for network in connected_graphs(nodes):
            fails = 1e6 * true_ratio(network) > printed_gain(network, 1e6)
            assert fails == (network.label in found)


def test_the_printed_time_fails_on_complete_graphs_and_no_run_is_slower_than_the_sharp_bound():
    found = list(time_counterexamples(4))
    assert [example.network.label for example in found] == ["01", "01 02 12", "01 02 03 12 13 23"]
    for example in found:
        assert example.printed < float(example.run["t"]) < example.sharp
        assert any(example.run["x1"])


def test_there_are_as_many_small_graphs_as_known():
    """Connected graphs on n nodes, OEIS A001349."""
    counts = [sum(1 for _ in connected_graphs(n)) for n in range(2, 8)]
    assert counts == [1, 2, 6, 21, 112, 853]


@pytest.mark.parametrize("nodes", [1, 8])
def test_other_sizes_are_refused(nodes):
    with pytest.raises(ValueError, match="nodes"):
        next(connected_graphs(nodes))


@pytest.mark.parametrize(
    "change", [{"t": "1/10"}, {"beta": "4"}, {"lambda_2": "3"}, {"gamma": "3"}]
)
def test_a_planted_false_counterexample_is_refused(change):
    example = next(iter(gain_counterexamples(2)))
    document = example.document
    inputs = {**document["inputs"], **{k: Fraction(v) for k, v in change.items()}}
    witness = [item for item in document["witness"] if item["kind"] not in ("congruence",)]
    with pytest.raises(CertificateError):
        certificate("bearing_dac", "theorem_1_gain", inputs, witness, case="REFUTED")


@pytest.mark.parametrize("weights", [["1"], ["1/2"]])
def test_a_network_with_weights_is_no_counterexample_to_a_theorem_about_plain_ones(weights):
    document = next(iter(gain_counterexamples(2))).document
    graph = {**document["inputs"]["graph"], "weights": weights}
    forged = {**document, "inputs": {**document["inputs"], "graph": graph}}
    check.check_document(document, statements())
    with pytest.raises(check.Reject, match="without weights"):
        check.check_document(forged, statements())
