"""Cuts of large networks: each loop against a second road, and the whole against known values."""

from fractions import Fraction
from typing import Any

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from verification.exact.cut_problem import Aim, Hurdle, Problem, problem
from verification.exact.cuts.band_cuts import around, band_cuts, improved
from verification.exact.cuts.cut_annealing import Schedule, annealed
from verification.exact.cuts.cut_components import flat
from verification.exact.cuts.cut_graph import (
    CutGraph,
    Flags,
    Scales,
    coarser,
    contracted,
    graph_of,
)
from verification.exact.cuts.cut_lines import slow_modes, sweep_values
from verification.exact.cuts.cut_reference import enumerate_all
from verification.exact.cuts.large_cuts import Effort, large_cut, network_cut

ANY_LOAD, WEIGHT_ALONE = Hurdle(0, 1), Hurdle(1, 0)
ONE = Fraction(1)


def network_of(graph: Any) -> Network:
    numbered = nx.convert_node_labels_to_integers(graph)
    edges = sorted(tuple(sorted(edge)) for edge in numbered.edges)
    return Network(tuple(map(str, range(len(numbered)))), np.array(edges))


def random_task(seed: int, n: int = 60) -> tuple[Problem, CutGraph, Flags]:
    """A random network with unlike weights and bounds, in both forms, and a random cut."""
    rng = np.random.default_rng(seed)
    drawn = network_of(nx.connected_watts_strogatz_graph(n, 4, 0.3, seed=seed))
    weights = tuple(Fraction(int(w), 4) for w in rng.integers(1, 9, drawn.m))
    network = Network(drawn.names, drawn.edges, weights)
    gamma = [Fraction(int(g), 3) for g in rng.integers(0, 5, n)]
    gamma[0] = ONE
    task = problem(network, gamma)
    side: Flags = rng.random(n) < 0.5
    side[:2] = True, False
    return task, graph_of(task, ANY_LOAD, Aim.RATIO)[0], side


def without_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SENSORTRACK_NO_COMPILER", "1")


RATIO = Scales(Aim.RATIO, 0.0, 1.0)
RATE = Scales(Aim.RATE, 5.0, 1.0)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("scales", [RATIO, RATE])
def test_bands_in_c_and_by_scipy_give_the_same_cuts(
    seed: int, scales: Scales, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, graph, side = random_task(seed)
    free = around(graph, side, 40 if seed % 2 else graph.n)
    free[:2] = False
    quick = band_cuts(graph, scales, side, free, 0.4)
    without_compiler(monkeypatch)
    slow = band_cuts(graph, scales, side, free, 0.4)
    assert len(quick) == len(slow)
    assert all(np.array_equal(one, other) for one, other in zip(quick, slow, strict=True))


@pytest.mark.parametrize("seed", range(4))
def test_a_band_holds_a_minimum_cut(seed: int) -> None:
    """Without prices the best cut of a band is the minimum cut that networkx finds."""
    rng = np.random.default_rng(seed)
    drawn = network_of(nx.gnm_random_graph(40, 120, seed=seed))
    graph = graph_of(problem(drawn, [ONE] * 40), ANY_LOAD, Aim.RATIO)[0]
    order = rng.permutation(40)
    side = np.zeros(40, dtype=bool)
    side[order[:20]] = True  # half of the nodes: the tangent is flat
    free = np.zeros(40, dtype=bool)
    free[order[5:35]] = True
    flow: Any = nx.Graph()
    flow.add_edges_from(drawn.edges.tolist(), capacity=1)
    for node in order[:5]:
        flow.add_edge("in", int(node))
    for node in order[35:]:
        flow.add_edge("out", int(node))
    least = nx.minimum_cut_value(flow, "in", "out")
    found = band_cuts(graph, RATIO, side, free, 1.0)
    assert found
    assert [graph.weights_of(cut)[0] for cut in found] == [least] * len(found)
    assert all(np.array_equal(cut[~free], side[~free]) for cut in found)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("scales", [RATIO, RATE])
def test_annealing_in_c_and_in_python_are_one(
    seed: int, scales: Scales, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, graph, side = random_task(seed)
    schedule = Schedule(1.0, 0.1, 12)
    quick = annealed(graph, scales, side, schedule, seed)
    without_compiler(monkeypatch)
    assert np.array_equal(annealed(graph, scales, side, schedule, seed), quick)
    assert not np.array_equal(quick, side)


@pytest.mark.parametrize("seed", range(4))
def test_pairs_in_c_and_in_python_are_one(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    _, graph, _ = random_task(seed)
    small, group = coarser(graph, 10, seed)
    assert graph.n / 2 <= small.n < graph.n
    assert np.bincount(group).max() == 2
    without_compiler(monkeypatch)
    assert np.array_equal(coarser(graph, 10, seed)[1], group)


@given(st.integers(0, 50))
@settings(max_examples=20)
def test_a_coarse_cut_is_the_same_cut(seed: int) -> None:
    task, graph, _ = random_task(seed)
    small, group = coarser(graph, 5, seed)
    smaller, again = coarser(small, 5, seed)
    side = np.random.default_rng(seed).random(smaller.n) < 0.5
    fine = side[again][group]
    assert smaller.weights_of(side) == pytest.approx(graph.weights_of(fine))
    if fine.any() and not fine.all():
        k, load, s = task.measure(np.flatnonzero(fine).tolist())
        assert graph.weights_of(fine)[:2] == (k, s)
        assert graph.load(s, graph.weights_of(fine)[2]) * task.n == pytest.approx(load)


def test_groups_may_be_of_any_size() -> None:
    _, graph, _ = random_task(0)
    small = contracted(graph, (np.arange(60) // 20).astype(np.int32), 3)
    assert small.size.tolist() == [20, 20, 20]
    assert small.n == 3
    assert small.total == pytest.approx(graph.total)


def test_a_sweep_values_every_cut_of_its_order() -> None:
    _, graph, _ = random_task(3)
    order, values = sweep_values(graph, RATIO, np.random.default_rng(3).random(60))
    for place in range(59):
        side = np.zeros(60, dtype=bool)
        side[order[: place + 1]] = True
        assert values[place] == pytest.approx(RATIO.of(graph, side))


@pytest.mark.parametrize("name", ["grid:5,9", "grid:21,25"])
def test_slow_modes_are_those_of_a_grid(name: str) -> None:
    """Dense and sparse: the slowest mode of a grid is the cosine along its longer side."""
    network = flat(read_network(name))
    graph = graph_of(problem(network, [ONE] * network.n), ANY_LOAD, Aim.RATIO)[0]
    modes = slow_modes(graph, graph.weight)
    columns = int(name.split(",")[1])
    cosine = np.cos(np.pi * (np.arange(network.n) % columns + 0.5) / columns)
    assert abs(cosine @ modes[:, 0]) == pytest.approx(
        np.linalg.norm(cosine) * np.linalg.norm(modes[:, 0])
    )


@given(connected_networks(2, 7, weighted=True), st.data())
@settings(max_examples=40)
def test_no_cut_is_worse_than_the_worst_one(network: Network, data: st.DataObject) -> None:
    bounds = rationals(0, 3, 4)
    gamma = data.draw(st.lists(bounds, min_size=network.n, max_size=network.n))
    gamma[0] += 1
    cut = network_cut(network, gamma, effort=Effort(rounds=2, kept=2))
    k, load, _ = (task := problem(network, gamma)).measure(cut)
    ratio = Fraction(load * task.weight_unit, k * task.n * task.gamma_unit)
    assert ratio <= max(one.load / one.k for one in enumerate_all(network, gamma))


@pytest.mark.parametrize("seed", range(8))
def test_small_networks_lose_nothing(seed: int) -> None:
    network = network_of(nx.connected_watts_strogatz_graph(11, 4, 0.5, seed=seed))
    gamma = [Fraction(1 + i % 3) for i in range(11)]
    task = problem(network, gamma)
    k, load, _ = task.measure(large_cut(task))
    cuts = enumerate_all(network, gamma)
    assert Fraction(load, 11 * k) == max(one.load / one.k for one in cuts)
    k, _, s = task.measure(large_cut(task, WEIGHT_ALONE, Aim.RATE))
    assert Fraction(11 * k * k, s * (11 - s)) == min(one.k**2 / one.p for one in cuts)


KNOWN = {"cycle:700": Fraction(175), "grid:20,30": Fraction(15), "hypercube:9": ONE}


@pytest.mark.parametrize("name", KNOWN)
def test_families_give_their_worst_cuts(name: str) -> None:
    network = flat(read_network(name))
    task = problem(network, [ONE] * network.n)
    effort = Effort(direct=400, coarsest=150, rounds=2, tries=1)  # through several levels
    k, load, s = task.measure(large_cut(task, effort=effort))
    assert Fraction(load, task.n * k) == KNOWN[name]
    assert 2 * s <= network.n


def test_two_clusters_are_told_apart_whatever_the_road(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two dense random graphs of 50 nodes with three links between them."""
    one, other = (nx.gnp_random_graph(50, 0.2, seed=seed) for seed in (1, 2))
    graph = nx.disjoint_union(one, other)
    graph.add_edges_from([(3, 53), (10, 60), (49, 50)])
    network = network_of(graph)
    gamma = [ONE] * 100
    halves = set(range(50)), set(range(50, 100))
    effort = Effort(rounds=2, kept=2)
    assert set(network_cut(network, gamma, effort=effort)) in halves
    lean = np.random.default_rng(5).random(network.m) + 0.5
    assert set(network_cut(network, gamma, conductances=lean, effort=effort)) in halves
    without_compiler(monkeypatch)
    assert set(network_cut(network, gamma)) in halves


def test_improving_never_makes_a_cut_better() -> None:
    for seed in range(5):
        _, graph, side = random_task(seed)
        for scales in (RATIO, RATE):
            before = scales.of(graph, side)
            assert scales.of(graph, improved(graph, scales, side, 30)) >= before


def test_networks_that_are_not_connected_are_refused() -> None:
    apart = Network(["a", "b", "c"], [[0, 1]])  # type: ignore[arg-type]
    with pytest.raises(InputError) as found:
        network_cut(apart, [ONE] * 3)
    assert found.value.name == "graph"
