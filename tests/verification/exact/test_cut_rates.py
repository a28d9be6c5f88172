"""What a bound on 2 p/k says about the weight and the rate of every cut."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from tests.verification.certificates.cut_cases import all_cuts
from verification.exact.cut_problem import Aim, Hurdle, problem
from verification.exact.cuts.cut_rates import least_weights, shown_hurdle
from verification.exact.cuts.extreme import margin, slowest, threshold


def cuts_of(network, gamma):
    return list(all_cuts(network, [gamma] * network.n, [Fraction(0)] * network.n))


def sharp_ratio(network):
    return max(2 * p / k for _, k, _, p, _ in cuts_of(network, Fraction(0)))


@given(
    connected_networks(min_nodes=2, max_nodes=7, weighted=True),
    st.sampled_from([Fraction(1), Fraction(11, 10), Fraction(5, 2)]),
)
def test_no_cut_weighs_less_than_its_size_allows(network, slack):
    task = problem(network, [Fraction(1)] * network.n)
    least = {s: k for k, _, s in least_weights(task, sharp_ratio(network) * slack)}
    for inside, k, *_ in cuts_of(network, Fraction(0)):
        assert k * task.weight_unit >= least[min(len(inside), network.n - len(inside))]


@given(
    connected_networks(min_nodes=2, max_nodes=7, weighted=True),
    rationals(Fraction(0), 3, 4),
    rationals(Fraction(1, 2), 20, 3),
)
def test_every_cut_clears_what_is_shown(network, gamma, beta):
    task = problem(network, [gamma] * network.n)
    start = task.gain_hurdle(beta)
    every = cuts_of(network, gamma)
    least = min(every, key=lambda cut: beta * cut[1] - cut[2])
    goal = start.marked(Aim.RATE, task.n, *task.measure(tuple(least[0])))
    if goal is not None:
        shown = shown_hurdle(task, start, goal, Aim.RATE, sharp_ratio(network))
        for inside, *_ in every if shown else ():
            assert shown.clears(task.n, *task.measure(tuple(inside)))


@pytest.mark.parametrize("label", ["torus:9,9", "random_geometric:300,0.12,3", "hypercube:8"])
def test_rates_of_networks_that_are_too_large_to_search_are_bracketed(label):
    network = read_network(label)
    found = margin(network)
    assert found.clear is not None
    assert 0 < found.lower <= found.upper
    k, p = weight_of(network, found.cut)
    assert found.upper == k * k / p


def weight_of(network, cut):
    inside = set(cut)
    k = sum((i in inside) != (j in inside) for i, j in network.edges.tolist())
    return Fraction(k), Fraction(len(cut) * (network.n - len(cut)), network.n)


def test_a_settling_time_of_a_large_network_is_bracketed():
    network = read_network("random_geometric:300,0.12,3")
    x0 = [Fraction(1), *[Fraction(0)] * 299]
    found = slowest(network, [Fraction(1)] * 300, Fraction(9), x0)
    assert found.clear is not None
    k, p = weight_of(network, found.cut)
    assert 0 < found.lower <= found.upper
    assert found.lower == Fraction(299, 300) * p / (9 * k - 2 * p) ** 2


def test_a_hurdle_that_no_weight_clears_shows_nothing():
    task = problem(read_network("cycle:8"), [Fraction(1)] * 8)
    start = task.gain_hurdle(Fraction(1, 10))
    goal = Hurdle(start.b, start.c, 1, 1)
    assert shown_hurdle(task, start, goal, Aim.RATE, Fraction(2)) is None


def test_a_large_product_is_bounded_by_its_lightest_node_without_its_edges():
    found = margin(read_network("hypercube:20"))
    assert found.upper == Fraction(400 * 2**20, 2**20 - 1)
    assert found.clear is None
    network = read_network("grid:300,200")
    corner = margin(network)
    assert weight_of(network, corner.cut)[0] == 2


@pytest.mark.parametrize("n", [5, 40, 601])
def test_half_of_an_even_ring_is_its_worst_cut(n: int) -> None:
    """At any size, also where no witness is short enough; nodes in any order."""
    order = np.random.default_rng(n).permutation(n)
    ends = np.sort(np.stack([order, np.roll(order, 1)], axis=1), axis=1)
    ring = Network([str(i) for i in range(n)], ends, (Fraction(3),) * n)
    p = Fraction(n // 2 * (n - n // 2), n)
    assert margin(ring).value == 36 / p
    assert threshold(ring, [Fraction(2)] * n).value == 4 * p / 6
    x0 = [Fraction(1), *[Fraction(0)] * (n - 1)]
    time = slowest(ring, [Fraction(2)] * n, p, x0)
    assert time.value == (1 - Fraction(1, n)) * p / (6 * p - 4 * p) ** 2


@pytest.mark.parametrize("ask", [margin, lambda ring: threshold(ring, [Fraction(1)] * ring.n)])
def test_a_long_ring_is_closed_because_its_cuts_are_even(ask):
    """Two links leave every set of a network whose nodes all have an even number of neighbours."""
    found = ask(read_network("cycle:1500"))
    assert found.closed
    assert found.clear["parts"][0]["kind"] in ("cells", "gap")
