"""The printed time is too early on small complete graphs and on no other small graph."""

import math
from fractions import Fraction

import pytest

from sensortrack.networks import read_network
from verification.adversary.small_graphs import connected_graphs

from .late_runs import latest, timed

GRAPHS = [network for nodes in range(2, 6) for network in connected_graphs(nodes)]


def is_complete(network):
    return 2 * network.m == network.n * (network.n - 1)


@pytest.mark.parametrize("gamma", [0, 1])
def test_the_printed_time_fails_exactly_on_complete_graphs(gamma):
    late = [network for network in GRAPHS if latest(network, Fraction(gamma)).late]
    assert late == [network for network in GRAPHS if is_complete(network)]


@pytest.mark.parametrize("nodes", [2, 3, 4, 5])
def test_without_disturbance_it_is_early_by_the_root_of_n_over_n_less_one(nodes):
    found = latest(read_network(f"complete:{nodes}"), Fraction(0), tries=5)
    assert found.ratio == pytest.approx(math.sqrt(nodes / (nodes - 1)), rel=1e-12)
    assert found.beta == 1


def test_on_five_nodes_it_holds_from_a_disturbance_of_two_and_a_half_on():
    five = read_network("complete:5")
    assert latest(five, Fraction(249, 100)).late
    assert not latest(five, Fraction(251, 100)).late


def test_on_two_sensors_a_large_disturbance_lets_them_never_agree():
    pair = read_network("complete:2")
    assert latest(pair, Fraction(3)).ratio > 10
    never = latest(pair, Fraction(4))
    assert (never.time, never.late, never.ratio) == (None, True, math.inf)


def test_a_cycle_of_four_takes_the_printed_time_to_the_digit():
    found = latest(read_network("cycle:4"), Fraction(0))
    assert found.ratio == pytest.approx(1, rel=1e-12)
    assert found.time == Fraction(1, 2)
    assert not found.late


def test_random_runs_are_no_later_than_those_of_cuts():
    for network in GRAPHS[:12]:
        cuts = latest(network, Fraction(1))
        assert latest(network, Fraction(1), tries=6, seed=network.m).ratio == cuts.ratio


def test_one_run_is_timed_from_its_own_start():
    pair = read_network("path:2")
    zero = [Fraction(0)] * 2
    found = timed(pair, Fraction(0), [Fraction(5), Fraction(1)], zero)
    assert found.x0 == (2, -2)
    assert found.time == 2
    assert found.ratio == pytest.approx(math.sqrt(2), rel=1e-12)
