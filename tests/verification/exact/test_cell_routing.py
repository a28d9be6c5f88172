"""Routings by cells: never below a cut, tight where theory says so, the same in C and in NumPy."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.kernels.build import Kernel
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from tests.verification.exact.literal_cuts import Component, cell_loads, check_clear
from verification.certificates import check
from verification.exact.cells import cell_bounds, cell_flows, cell_routing, wiring
from verification.exact.cells.cell_bounds import route_by_cells
from verification.exact.cells.cell_routing import CellRouting, add_exact, rounded_up
from verification.exact.cells.cells import hierarchy, places
from verification.exact.cells.charts import chart
from verification.exact.cut_problem import Problem, problem
from verification.exact.cuts.cut_reference import enumerate_all
from verification.exact.cuts.extreme import threshold

ONE, ZERO = Fraction(1), Fraction(0)
STEPS = 2_000_000


def routed(task: Problem, sizes: list[int]) -> CellRouting:
    numbers = chart(task.n, task.edges)
    return cell_bounds._routed(task, numbers, sizes, 0.0, STEPS, cell_bounds.GLOBAL)


def flat(family: str) -> Network:
    network = read_network(family)
    return Network(network.names, network.edges)


@pytest.mark.parametrize("sizes", [[1], [2, 1], [5, 1], [9, 3, 1]])
@pytest.mark.parametrize(
    "family",
    [
        "path:17", "cycle:20", "complete:7", "star:9", "bipartite:3,4", "bipartite:5,5",
        "grid:5,6", "grid:10,10", "torus:4,5", "hypercube:5", "petersen", "karate",
    ],
)  # fmt: skip
def test_no_cells_give_a_bound_below_the_threshold(family: str, sizes: list[int]) -> None:
    network = read_network(family)
    sharp = threshold(network, [ONE] * network.n).value
    assert sharp is not None
    found = routed(problem(flat(family), [ONE] * network.n), sizes)
    assert found.up >= sharp


@pytest.mark.parametrize(
    "family, best",
    [
        ("petersen", Fraction(1)), ("cycle:20", Fraction(5)), ("hypercube:5", Fraction(1)),
        ("path:17", Fraction(144, 17)), ("grid:10,10", Fraction(5)), ("karate", Fraction(145, 68)),
        ("bipartite:5,5", Fraction(13, 25)), ("bipartite:3,4", Fraction(5, 7)),
    ],
)  # fmt: skip
def test_single_nodes_as_cells_reach_the_best_routing(family: str, best: Fraction) -> None:
    network = flat(family)
    up = routed(problem(network, [ONE] * network.n), [1]).up
    assert best <= up <= best * Fraction(1003, 1000)


@given(connected_networks(2, 7, weighted=True), st.data())
@settings(max_examples=40)
def test_every_bound_is_one_and_stands_in_its_witness(
    network: Network, data: st.DataObject
) -> None:
    bounds = st.lists(rationals(0, 3, 4), min_size=network.n, max_size=network.n)
    gamma = data.draw(bounds.filter(any))
    found = routed(problem(network, gamma), data.draw(st.sampled_from([[1], [3, 1], [4, 2, 1]])))
    part = found.part()
    assert part is not None
    sharp = max(c.load / c.k for c in enumerate_all(network, gamma))
    inner = max(cell_loads(Component(network, gamma), part))
    assert sharp <= inner <= found.up <= inner * Fraction(1001, 1000)
    check_clear(network, gamma, found.up, ONE, ZERO, {"kind": "cuts", "parts": [part]})


def checked(network: Network, gamma: list[Fraction], b: Fraction, part: dict[str, Any]) -> None:
    """The checker's own word, without a file."""
    proof = check.Proof({}, [], {})
    rows = check.matrix([[bound] for bound in gamma])
    item = check.Graph(network.to_data()).parts[0]
    cuts = check.Cuts(proof, item, rows, check.constant(b), check.constant(1), check.constant(0))
    cuts.cells(part["scale"], part["levels"])


def test_the_checker_finds_the_same_bound() -> None:
    network = read_network("random_geometric:400,0.1,2")
    gamma = [Fraction(1 + i % 3, 7) for i in range(network.n)]
    found = routed(problem(network, gamma), [40, 6, 1])
    part = found.part()
    assert part is not None
    checked(network, gamma, found.up, part)
    with pytest.raises(check.Reject, match="only"):
        checked(network, gamma, found.up * Fraction(9999, 10000), part)


def test_a_medium_network_gets_a_narrow_bracket_with_a_witness() -> None:
    network = read_network("random_geometric:600,0.1,1")
    found = threshold(network, [ONE] * network.n)
    assert found.lower is not None
    assert found.upper is not None
    assert found.lower <= found.upper <= found.lower * Fraction(11, 10)
    assert found.clear is not None
    assert {part["kind"] for part in found.clear["parts"]} == {"cells"}


def test_components_and_long_witnesses() -> None:
    network = read_network("random_geometric:260,0.13,3")
    twice = np.concatenate([network.edges, network.edges + network.n])
    both = Network([str(i) for i in range(2 * network.n + 1)], twice)
    gamma = [ONE] * network.n
    one = threshold(network, gamma)
    two = threshold(both, gamma + [2 * ONE] * network.n + [ONE])
    assert one.lower is not None
    assert one.upper is not None
    assert (two.lower, two.upper) == (2 * one.lower, 2 * one.upper)
    task = problem(network, gamma)
    assert route_by_cells(task, one.lower, STEPS).part() is not None
    assert route_by_cells(task, one.lower, 10).part() is None


def test_networks_that_expand_have_many_small_cells(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cell_bounds, "EVERY", 100)
    circulant = [(i, (i + d) % 300) for i in range(300) for d in (1, 17, 73)]
    network = Network([str(i) for i in range(300)], [sorted(pair) for pair in circulant])
    task = problem(network, [ONE] * 300)
    coarse = routed(task, cell_bounds.sizes(300))
    low = Fraction(1, 1)
    assert low <= route_by_cells(task, low, STEPS).up < coarse.up


def test_weights_of_any_size_give_a_bound() -> None:
    network = read_network("grid:6,7")
    weights = [Fraction(10) ** (30 * (e % 9)) for e in range(network.m)]
    task = problem(Network(network.names, network.edges, weights), [ONE] * network.n)
    cuts = [task.measure([i]) for i in range(network.n)]
    assert routed(task, [6, 1]).up >= max(
        Fraction(load * task.weight_unit, k * network.n) for k, load, _ in cuts
    )


def in_python(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (wiring, cell_flows, cell_routing):
        monkeypatch.setattr(module, "kernel", lambda name: Kernel(name, None, "by request"))


def test_both_roads_find_the_same_cells(monkeypatch: pytest.MonkeyPatch) -> None:
    network = read_network("random_geometric:500,0.09,4")
    nodes = max(network.components(), key=len)
    wires = wiring.wiring(len(nodes), network.subnetwork(nodes).edges)
    in_c = hierarchy(wires, [60, 14, 1])
    in_python(monkeypatch)
    for one, two in zip(in_c, hierarchy(wires, [60, 14, 1]), strict=True):
        assert (one == two).all()


def test_both_roads_add_the_same_loads_to_the_last_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    network = read_network("grid:9,11")
    chance = np.random.default_rng(5)
    numbers = chart(network.n, network.edges)
    home, cell = hierarchy(numbers.wires, [12, 1])[1:]
    ones = np.ones(network.n), np.ones(network.m)
    level = cell_flows.Level(numbers, home, cell, *ones)
    m = len(level.edges)
    potential = chance.normal(size=(network.n, 11))
    weights = chance.integers(1, 2**20, m)
    share = chance.integers(0, 2**15, level.homes)
    x = chance.integers(-(2**30), 2**30, network.n)
    net = chance.integers(-(2**20), 2**20, network.n)
    for root in np.flatnonzero(level.trees.roots):
        net[root] -= net[home == home[root]].sum()

    def both() -> list[Any]:
        loads, exact = np.ones(m), np.ones(m, dtype=np.int64)
        cell_flows.add_loads((level.first, level.second), weights / 7.0, potential, loads)
        left = net.copy()
        add_exact(level, weights, x, share, 2**40, left, np.empty(m, dtype=np.int64), exact)
        return [loads, exact, left]

    in_c = both()
    in_python(monkeypatch)
    for one, two in zip(in_c, both(), strict=True):
        assert one.tobytes() == two.tobytes()


@pytest.mark.parametrize("python", [False, True])
@pytest.mark.parametrize(
    "change", [{"x": 2**60}, {"net": 2**45}, {"largest": 3}, {"net": 2**52}, {"leak": 1}]
)
def test_what_might_not_fit_or_leaks_is_refused(
    monkeypatch: pytest.MonkeyPatch, python: bool, change: dict[str, int]
) -> None:
    network = read_network("path:4")
    numbers = chart(4, network.edges)
    level = cell_flows.Level(numbers, *hierarchy(numbers.wires, [1]), np.ones(4), np.ones(3))
    if python:
        in_python(monkeypatch)

    def add(x: int = 5, net: int = 9, largest: int = 2**40, leak: int = 0) -> None:
        arrays = [np.array(values, dtype=np.int64) for values in ([0, -x, x, 0], [net, 0, 0, 0])]
        arrays[1][3] = leak - net
        room = np.empty(3, dtype=np.int64), np.zeros(3, dtype=np.int64)
        full = np.full(3, 2**20)
        add_exact(level, full, arrays[0], np.ones(1, dtype=np.int64), largest, arrays[1], *room)

    add()
    with pytest.raises(ArithmeticError):
        add(**change)


def test_cells_are_connected_and_about_as_large_as_asked_for() -> None:
    network = read_network("random_geometric:2000,0.05,1")
    nodes = max(network.components(), key=len)
    wires = wiring.wiring(len(nodes), network.subnetwork(nodes).edges)
    parts = hierarchy(wires, [100, 20, 1])
    for home, cell, size in zip(parts[:-1], parts[1:], [100, 20, 1], strict=True):
        counts = np.bincount(cell)
        assert wiring.forest(wires, cell).count == len(counts)
        assert counts.max() <= 4 * size
        assert size / 3 <= counts.mean() <= 2 * size
        place = places(home, cell)
        assert len({*zip(home.tolist(), place.tolist(), strict=True)}) == len(counts)
        assert (np.bincount(home) >= 1 + place[np.argsort(home, kind="stable")].min()).all()


@given(st.fractions(min_value=Fraction(1, 10**9), max_value=10**9))
def test_rounding_up_is_up_and_little(value: Fraction) -> None:
    up = rounded_up(value)
    assert value <= up <= value * (1 + Fraction(1, 2**28))
    assert up == value or up.denominator.bit_length() <= 80
