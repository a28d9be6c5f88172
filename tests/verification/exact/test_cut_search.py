"""The search in C and the search in Python visit the same nodes, and so does the checker."""

import itertools
from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.kernels import kernel
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from verification.certificates import check
from verification.exact.cut_problem import Aim, Hurdle, Problem, problem
from verification.exact.cuts import cut_roads
from verification.exact.cuts.cut_orders import orders, twin_groups
from verification.exact.cuts.cut_roads import Budget, refute_or_show, solve
from verification.exact.cuts.cut_search import Walk, twins

needs_compiler = pytest.mark.skipif(
    kernel("cuts").library is None, reason=kernel("cuts").reason or "compiled"
)
STARTS = {Aim.RATIO: Hurdle(0, 1), Aim.RATE: Hurdle(1, 0, 1, 10**6)}


@st.composite
def problems(draw: st.DrawFn) -> Problem:
    network = draw(connected_networks(2, 8, weighted=draw(st.booleans())))
    n = network.n
    return problem(network, draw(st.lists(rationals(0, 3, 4), min_size=n, max_size=n)))


@needs_compiler
@given(problems(), st.sampled_from([Aim.RATIO, Aim.RATE]), st.integers(1, 200), st.data())
@settings(max_examples=150)
def test_both_roads_agree_to_the_last_visit(
    task: Problem, aim: Aim, limit: int, data: st.DataObject
) -> None:
    walk = Walk(task, data.draw(st.permutations(range(task.n))))
    assert walk.runs_in_c(STARTS[aim], aim)
    found = walk.search(STARTS[aim], aim, limit)
    assert found == walk._search_in_python(STARTS[aim], aim, limit)
    again = walk.search(found.hurdle, Aim.FAILURE, limit)
    assert again == walk._search_in_python(found.hurdle, Aim.FAILURE, limit)


def steps_of_checker(
    task: Network, gamma: Sequence[Fraction], b: Fraction, order: list[int]
) -> int:
    graph = check.Graph(task.to_data())
    proof = check.Proof({}, [], {})
    column = check.matrix([[bound] for bound in gamma])
    numbers = [check.constant(value) for value in (b, 1, 0)]
    check.Cuts(proof, graph.parts[0], column, *numbers).enumeration(order)
    return int(proof.steps)


@given(connected_networks(3, 7, weighted=True), st.data())
@settings(max_examples=60)
def test_visits_are_those_of_the_checker(network: Network, data: st.DataObject) -> None:
    gamma = data.draw(st.lists(rationals(0, 3, 4), min_size=network.n, max_size=network.n))
    task = problem(network, gamma)
    walk = Walk(task, data.draw(st.permutations(range(network.n))))
    best = walk.search(Hurdle(0, 1), Aim.RATIO, 10**6).hurdle
    b = task.ratio(best) * data.draw(st.sampled_from([1, Fraction(3, 2)]))
    visits = walk.search(task.gain_hurdle(b), Aim.FAILURE, 10**6).visits
    assert visits == steps_of_checker(network, gamma, b, list(walk.order))


def test_huge_numbers_take_the_road_in_python() -> None:
    weights = (Fraction(10**30), Fraction(1, 10**30), Fraction(1))
    network = Network(["a", "b", "c"], [[0, 1], [0, 2], [1, 2]], weights)  # type: ignore[arg-type]
    task = problem(network, [Fraction(1)] * 3)
    assert not Walk(task, range(3)).runs_in_c(Hurdle(0, 1), Aim.RATIO)
    solved = solve(task, Hurdle(0, 1), Aim.RATIO, Budget())
    assert solved.closed
    assert solved.hurdle
    assert task.ratio(solved.hurdle) == Fraction(4, 3) / (1 + Fraction(1, 10**30))


@pytest.mark.parametrize("family", ["complete:9", "bipartite:4,5", "star:6", "cycle:7", "petersen"])
def test_twins_are_found_and_stand_together(family: str) -> None:
    task = problem(network := read_network(family), [Fraction(1)] * network.n)
    groups = twin_groups(task)
    home = {node: place for place, group in enumerate(groups) for node in group}
    assert sorted(home) == list(range(task.n))
    for i in range(task.n):
        for j in range(i):
            assert twins(task, i, j) == (home[i] == home[j])
    for order in orders(task):
        assert sorted(order) == list(range(task.n))
        changes = sum(home[a] != home[b] for a, b in itertools.pairwise(order))
        assert changes == len(groups) - 1


def test_complete_networks_take_one_visit_a_size() -> None:
    task = problem(network := read_network("complete:100"), [Fraction(1)] * network.n)
    solved = solve(task, Hurdle(0, 1), Aim.RATIO, Budget())
    assert solved.closed
    assert solved.shown
    assert solved.shown.visits <= 100**2


def test_without_compiler_the_answers_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    network = read_network("torus:3,4")
    network = Network(network.names, network.edges)
    task = problem(network, [Fraction(1)] * 12)
    first = solve(task, Hurdle(0, 1), Aim.RATIO, Budget())
    monkeypatch.setenv("SENSORTRACK_NO_COMPILER", "1")
    assert kernel("cuts").library is None
    assert kernel("cuts").reason == "SENSORTRACK_NO_COMPILER is 1"
    assert solve(task, Hurdle(0, 1), Aim.RATIO, Budget()) == first


def test_what_is_too_long_for_a_witness_is_bracketed(monkeypatch: pytest.MonkeyPatch) -> None:
    """A few visits without routing or eigenvalue leave a bracket, never a wrong bound."""
    for road in ("_routed", "_expanding"):
        monkeypatch.setattr(cut_roads, road, lambda _task, _start, solved, _rest: solved)
    network = read_network("petersen")
    task = problem(network, [Fraction(1)] * 10)
    solved = solve(task, Hurdle(0, 1), Aim.RATIO, Budget(visits=40, search=20, flows=0))
    assert solved.hurdle
    assert task.ratio(solved.hurdle) == 1
    assert not solved.closed
    assert not solved.complete
    assert solved.shown is None or task.ratio(solved.shown.hurdle) > 1
    assert refute_or_show(task, task.gain_hurdle(Fraction(1)), Budget(visits=5)) is None
    valued = solve(task, Hurdle(0, 1), Aim.RATIO, Budget(visits=40, flows=0))
    assert valued.complete or kernel("cuts").library is None
