"""Routings: conserved to the last unit, never below a cut, tight where theory says so."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from tests.verification.exact.literal_cuts import Refused, check_clear
from verification.exact.cut_problem import problem
from verification.exact.cuts import flow_programs
from verification.exact.cuts.cut_reference import enumerate_all
from verification.exact.cuts.routing import better_routing, closes, first_routing, route

ONE, ZERO = Fraction(1), Fraction(0)


def witness(part: dict[str, object]) -> dict[str, object]:
    return {"kind": "cuts", "parts": [part]}


@given(connected_networks(2, 7, weighted=True), st.data())
@settings(max_examples=30)
def test_no_routing_lies_below_a_cut(network: Network, data: st.DataObject) -> None:
    bounds = st.lists(rationals(0, 3, 4), min_size=network.n, max_size=network.n)
    gamma = data.draw(bounds.filter(any))
    sharp = max(c.load / c.k for c in enumerate_all(network, gamma))
    up, part = route(network, gamma, sharp)
    assert up >= sharp
    check_clear(network, gamma, up, ONE, ZERO, witness(part))
    if up > sharp and len(set(gamma)) > 1:
        with pytest.raises(Refused):
            check_clear(network, gamma, sharp, ONE, ZERO, witness(part))


@pytest.mark.parametrize(
    "family", ["cycle:8", "complete:6", "petersen", "hypercube:4", "star:7", "path:9"]
)
def test_symmetric_networks_are_routed_exactly(family: str) -> None:
    network = read_network(family)
    network = Network(network.names, network.edges)
    gamma = [ONE] * network.n
    sharp = max(c.load / c.k for c in enumerate_all(network, gamma))
    up, part = route(network, gamma, sharp)
    assert up == sharp
    check_clear(network, gamma, sharp, ONE, ZERO, witness(part))


def test_the_gap_test_closes_what_rounding_leaves_open() -> None:
    network = read_network("karate")
    gamma = [ONE] * network.n
    task = problem(network, gamma)
    first = first_routing(task)
    sharp = Fraction(145, 68)
    assert first.up > sharp
    assert closes(task, task.gain_hurdle(sharp), first.up)
    check_clear(network, gamma, sharp, ONE, ZERO, witness(first.part()))


def test_bipartite_networks_have_a_gap_between_flow_and_cut() -> None:
    """The best routing of K_{3,4} loads an edge with 5/7, no cut asks for more than 4/7."""
    network = read_network("bipartite:3,4")
    up, part = route(network, [ONE] * 7, Fraction(4, 7))
    assert Fraction(5, 7) <= up < Fraction(5, 7) + Fraction(1, 10**6)
    with pytest.raises(Refused):
        check_clear(network, [ONE] * 7, Fraction(4, 7), ONE, ZERO, witness(part))


@pytest.mark.parametrize("largest", [0, 12_000])
def test_both_programs_find_the_best_flows(monkeypatch: pytest.MonkeyPatch, largest: int) -> None:
    monkeypatch.setattr(flow_programs, "ONE_PROGRAM", largest)
    network = read_network("random_geometric:24,0.35,1")
    gamma = [Fraction(1 + i % 3) for i in range(network.n)]
    task = problem(network, gamma)
    nothing = task.gain_hurdle(Fraction(1, 1000))  # a target that no routing can reach
    found = better_routing(task, first_routing(task), nothing)
    assert found.up == first_routing(task).up  # known to be hopeless: nothing is tried
    sharp = task.gain_hurdle(first_routing(task).up * Fraction(999, 1000))
    assert better_routing(task, first_routing(task), sharp).up <= first_routing(task).up


def test_a_leaking_flow_is_refused() -> None:
    network = read_network("cycle:6")
    up, part = route(network, [ONE] * 6, Fraction(3, 2))
    part["flows"][2][0][1] += 1
    with pytest.raises(Refused):
        check_clear(network, [ONE] * 6, up + 1, ONE, ZERO, witness(part))


def test_a_hundred_nodes_close() -> None:
    network = read_network("random_geometric:100,0.2,1")
    task = problem(network, [ONE] * 100)
    sharp = task.gain_hurdle(Fraction(2331, 1000))
    found = better_routing(task, first_routing(task), sharp)
    assert closes(task, sharp, found.up)
    assert found.up >= Fraction(2331, 1000)
    assert np.abs(found.flows).max() < 2**62
