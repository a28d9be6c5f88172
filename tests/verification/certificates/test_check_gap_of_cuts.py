"""The second eigenvalue bounds every cut: what is accepted, and what is not."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.networks import read_network
from tests.strategies import connected_networks, rationals

from .cut_cases import ABOVE, CLEAR, KINDS, SMALL, THRESHOLD, all_cuts, some_nodes
from .documents import accepts
from .samples import RING, RING_GAP, cuts


def gap(least, n, bits=30):
    return {"kind": "gap", "least": str(least), "order": list(range(n)), "bits": bits}


def second_eigenvalue(network):
    return float(np.linalg.eigvalsh(network.laplacian().toarray())[1])


@given(connected_networks(min_nodes=2, max_nodes=6, weighted=True), st.data())
def test_no_bound_below_the_threshold_is_accepted(network, more):
    gamma = some_nodes(more.draw, network.n, SMALL)
    every = list(all_cuts(network, gamma, [Fraction(0)] * network.n))
    threshold = max(load / k for _, k, load, _, _ in every)
    value = Fraction(second_eigenvalue(network))
    inputs = {"graph": network.to_data(), "gamma": [*map(str, gamma)]}
    for least in (value * Fraction(99, 100), value * Fraction(101, 100), value * 3):
        top = 2 * max(gamma) / least
        for b in {top, threshold * Fraction(99, 100), threshold, threshold + 1}:
            witness = [cuts(gap(least, network.n))]
            believed = b > 0 and accepts(ABOVE, witness, inputs | {"b": str(b)}, THRESHOLD)
            assert not believed or (b >= threshold and least < value)
            if least < value and b == top > 0:
                assert believed


@given(
    connected_networks(min_nodes=2, max_nodes=6, weighted=True),
    rationals(Fraction(0), 2, 4),
    rationals(Fraction(1, 2), 6, 3),
)
def test_no_rate_that_some_cut_does_not_keep_is_accepted(network, gamma, b):
    error = [Fraction(1), *[Fraction(0)] * (network.n - 1)]
    every = list(all_cuts(network, [gamma] * network.n, error))
    gaps = [(b * k - load, p, spread) for _, k, load, p, spread in every]
    least = min(one for one, _, _ in gaps)
    sharp = max(spread * p / one**2 for one, p, spread in gaps) if least > 0 else Fraction(100)
    inputs = {"graph": network.to_data(), "gamma": str(gamma), "b": str(b), "e": [*map(str, error)]}
    bound = Fraction(second_eigenvalue(network)) * Fraction(999, 1000)
    for f in (sharp * Fraction(999, 1000), sharp, sharp * 10**6):
        believed = accepts(CLEAR, [cuts(gap(bound, network.n))], inputs | {"f": str(f)}, KINDS)
        assert not believed or (least > 0 and f >= sharp)


@pytest.mark.parametrize("label", ["complete:7", "bipartite:4,4", "petersen", "complete:2"])
def test_where_a_network_expands_the_value_is_closed(label):
    """Weights are whole numbers, so that a bound a little above is as good as the sharp one."""
    network = read_network(label)
    every = all_cuts(network, [Fraction(1)] * network.n, [Fraction(0)] * network.n)
    threshold = max(load / k for _, k, load, _, _ in every)
    least = Fraction(second_eigenvalue(network)) * (1 - Fraction(1, 10**6))
    inputs = {"graph": network.to_data(), "gamma": "1"}
    witness = [cuts(gap(least, network.n))]
    assert accepts(ABOVE, witness, inputs | {"b": str(threshold)}, THRESHOLD)
    smaller = {"b": str(threshold * Fraction(999_999, 10**6))}
    assert not accepts(ABOVE, witness, inputs | smaller, THRESHOLD)


@pytest.mark.parametrize(
    "change",
    [
        {"least": "2"},  # not below lambda_2
        {"least": "0"},
        {"least": "-1"},
        {"least": "1e-3"},
        {"order": [0, 1, 2]},
        {"order": [0, 1, 2, 2]},
        {"order": [0, 1, 2, 4]},
        {"bits": -1},
        {"bits": 5000},
        {"bits": "1/2"},
        {"more": 1},
    ],
)
def test_a_gap_that_is_not_shown_is_refused(change):
    inputs = {"graph": RING, "gamma": "3", "b": "9"}
    assert accepts(ABOVE, [cuts(RING_GAP)], inputs, THRESHOLD)
    assert not accepts(ABOVE, [cuts(RING_GAP | change)], inputs, THRESHOLD)
