"""The proximal map of total variation: optimality, bounds, and one result on every road."""

from itertools import combinations
from math import ceil

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.consensus import SignConsensus
from sensortrack.consensus.proximal import Proximal
from sensortrack.consensus.proximal import proximal as proximal_rows
from sensortrack.kernels import kernel
from sensortrack.kernels.dual import Ascent
from sensortrack.kernels.grouping import agreed_groups as agreed_rows
from sensortrack.kernels.links import Links, links_of
from sensortrack.kernels.split import split
from sensortrack.kernels.tree import tree_flow
from sensortrack.networks import Network, read_network
from tests.strategies import networks, trees
from verification.exact.runs.prox import levelled

compiles = pytest.mark.skipif(kernel("split", native=True).library is None, reason="no C compiler")
WITHOUT = "SENSORTRACK_NO_COMPILER"
ULP = 2.0**-52


def proximal(links: Links, y: np.ndarray, capacity: np.ndarray, **options) -> Proximal:
    """One component."""
    found = proximal_rows(links, y[None], capacity[None], **options)
    return Proximal(found.x[0], found.flow[0], found.error[0], found.iterations)


def agreed_groups(
    links: Links, y: np.ndarray, capacity: np.ndarray, flow: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """One component."""
    found, x, sent = agreed_rows(links, y[None], capacity[None], flow[None])
    return (x[0], sent[0]) if found[0] else None


def fall(links: Links, x: np.ndarray) -> np.ndarray:
    return x[links.ends[:, 0]] - x[links.ends[:, 1]]


def drawn(links: Links, seed: int, whole: bool) -> tuple[np.ndarray, np.ndarray]:
    """Data and capacities; whole numbers make ties between groups."""
    rng = np.random.default_rng(seed)
    if whole:
        y = rng.integers(-4, 5, size=links.n).astype(float)
        return y, rng.choice([0.0, 0.25, 0.5, 1.0, 2.0], size=links.m)
    return rng.normal(size=links.n), rng.uniform(0, 1, size=links.m)


def recursive_tree(n: int, seed: int) -> Network:
    """Each node is linked with one drawn from those before it, then all are renamed."""
    rng = np.random.default_rng(seed)
    parents = [int(rng.integers(0, k)) for k in range(1, n)]
    names = rng.permutation(n)
    pairs = np.sort(np.stack([names[parents], names[1:]], axis=1), axis=1)
    return Network([str(k) for k in range(n)], pairs)


@given(networks(max_nodes=7), st.integers(0, 99), st.booleans())
def test_a_point_is_optimal_and_keeps_the_mean(network, seed, whole) -> None:
    links = links_of(network)
    y, capacity = drawn(links, seed, whole)
    found = proximal(links, y, capacity)
    assert found.error == 0
    assert (np.abs(found.flow) <= capacity).all()
    assert np.allclose(found.x, y - links.incidence @ found.flow, rtol=0, atol=64 * ULP)
    lost = capacity * np.abs(fall(links, found.x)) - found.flow * fall(links, found.x)
    assert np.abs(lost).max(initial=0) < 64 * ULP
    for part in network.components():
        assert abs(found.x[part].sum() - y[part].sum()) < 64 * ULP


@compiles
@settings(max_examples=25)
@given(networks(max_nodes=7), st.integers(0, 99))
def test_a_point_is_the_same_without_a_compiler(network, seed) -> None:
    links = links_of(network)
    y, capacity = drawn(links, seed, whole=True)
    in_c = proximal(links, y, capacity)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(WITHOUT, "1")
        without = proximal(links, y, capacity)
    assert np.array_equal(in_c.x, without.x)
    assert in_c.error == without.error == 0


@given(trees(min_nodes=2, max_nodes=9), st.integers(0, 99), st.booleans())
def test_trees_are_solved_alike_by_program_and_by_flows(network, seed, whole) -> None:
    links = links_of(network)
    y, capacity = drawn(links, seed, whole)
    forest = links.forest
    assert forest is not None
    most = np.zeros(links.n)
    most[forest.below] = capacity[forest.link[forest.below]]
    flow = np.zeros(links.m)
    sent = tree_flow(forest, y[forest.order], most)[forest.below]
    flow[forest.link[forest.below]] = forest.toward * sent
    grouped = agreed_groups(links, y, capacity, flow)
    assert grouped is not None
    assert np.allclose(grouped[0], split(links, y, capacity)[0], rtol=0, atol=64 * ULP)


@pytest.mark.parametrize("network", [recursive_tree(300, 1), read_network("path:300")])
@pytest.mark.parametrize("size", [0.05, 0.5, 5.0])
def test_larger_trees_are_solved_alike(network: Network, size: float) -> None:
    links = links_of(network)
    y = np.random.default_rng(2).normal(size=links.n)
    capacity = np.full(links.m, size)
    found = proximal(links, y, capacity)
    assert found.error == 0
    assert found.iterations == 0
    assert np.allclose(found.x, split(links, y, capacity)[0], rtol=0, atol=1e-13)


@given(networks(min_nodes=2), st.integers(0, 99), st.integers(0, 60))
def test_the_gap_bounds_the_distance(network, seed, steps) -> None:
    links = links_of(network)
    y, capacity = drawn(links, seed, whole=False)
    ascent = Ascent(links, y, capacity, np.zeros(links.m))
    ascent.advance(steps)
    x, gap, hidden = ascent.point()
    assert 0 <= hidden <= gap
    assert (np.abs(ascent.flow) <= capacity).all()
    assert np.linalg.norm(x - split(links, y, capacity)[0]) <= np.sqrt(gap)


@compiles
def test_a_large_network_is_solved_within_what_its_status_says() -> None:
    links = links_of(read_network("grid:70,70"))
    y = np.random.default_rng(3).normal(size=links.n)
    capacity = np.full(links.m, 1.5)
    exact = split(links, y, capacity)[0]
    errors = []
    for most in (8, 32, 128):
        found = proximal(links, y, capacity, most=most)
        assert found.iterations == most
        assert found.error > 0
        assert np.linalg.norm(found.x - exact) <= found.error
        assert abs(found.x.sum() - y.sum()) < 1e-10
        errors.append(found.error)
    assert errors == sorted(errors, reverse=True)
    near = proximal(links, y, capacity, tolerance=1.0)
    assert np.linalg.norm(near.x - exact) <= near.error <= 1.0
    again = proximal(links, y, capacity, start=near.flow[None])
    assert again.error == 0
    assert np.allclose(again.x, exact, rtol=0, atol=1e-13)


@given(networks(min_nodes=2), st.integers(0, 99))
def test_the_map_does_not_stretch_distances(network, seed) -> None:
    links = links_of(network)
    y, capacity = drawn(links, seed, whole=False)
    z = drawn(links, seed + 100, whole=True)[0]
    apart = proximal(links, y, capacity).x - proximal(links, z, capacity).x
    assert np.linalg.norm(apart) <= np.linalg.norm(y - z) + 64 * ULP


def rate(network: Network, beta: float) -> float:
    """Least beta k/sqrt(p) over the cuts: how fast the disagreement shrinks at least."""
    n = network.n
    cuts = [set(s) for size in range(1, n) for s in combinations(range(n), size)]
    crossing = [sum((i in s) != (j in s) for i, j in network.edges.tolist()) for s in cuts]
    pairs = zip(cuts, crossing, strict=True)
    return min(beta * k / np.sqrt(len(s) * (n - len(s)) / n) for s, k in pairs)


@pytest.mark.parametrize("graph", ["path:5", "cycle:6", "complete:4", "star:5", "petersen"])
@pytest.mark.parametrize("seed", range(3))
def test_agreement_is_reached_in_the_steps_that_the_rate_promises(graph: str, seed: int) -> None:
    network = read_network(graph)
    h, beta = 0.0625, 0.5
    r = np.random.default_rng(seed).normal(size=(network.n, 1))
    law = SignConsensus(network, beta, h)
    state = law.init(r)
    start = float(np.linalg.norm(r - r.mean()))
    steps = ceil(start / (h * rate(network, beta)))
    for _ in range(steps):
        state = law.step(state, r)
    assert np.ptp(state.x) == 0


@pytest.mark.parametrize(
    "graph, drift", [("path:3", [1.0, -1.0, -1.0]), ("cycle:4", [1.0, 1.0, -1.0, -1.0])]
)
@pytest.mark.parametrize("share, agree", [(1.0, True), (0.99, False)])
def test_agreement_is_kept_from_the_threshold_on(
    graph: str, drift: list[float], share: float, agree: bool
) -> None:
    """Against the worst signals the thresholds are 4/3 and 1."""
    network, h = read_network(graph), 0.125
    law = SignConsensus(network, share * (4 / 3 if graph == "path:3" else 1), h)
    r = np.zeros((network.n, 1))
    state = law.init(r)
    for _ in range(20):
        r = r + h * np.array(drift)[:, None]
        state = law.step(state, r)
    assert (np.ptp(state.x) == 0) == agree


@pytest.mark.parametrize("graph", ["path:7", "grid:4,4", "petersen", "bipartite:3,4"])
def test_renamed_agents_find_the_same(graph: str) -> None:
    network = read_network(graph)
    links, n = links_of(network), network.n
    y, capacity = drawn(links, 4, whole=False)
    order = np.random.default_rng(5).permutation(n)
    pairs = np.sort(order[links.ends], axis=1)
    other = links_of(Network(network.names, pairs))
    turned = np.empty(n)
    turned[order] = y
    found = proximal(other, turned, capacity[other.rank]).x
    assert np.allclose(found[order], proximal(links, y, capacity).x, rtol=0, atol=64 * ULP)


@pytest.mark.parametrize("road", ["", "1"])
@pytest.mark.parametrize("size", [1e-310, 1e-200, 1e200])
def test_sizes_at_the_ends_of_the_range(
    size: float, road: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Capacities of ordinary size are then without limit, or nothing."""
    monkeypatch.setenv(WITHOUT, road)
    links = links_of(read_network("cycle:4"))
    y = size * np.array([4.0, 0.0, 8.0, 0.0])
    x = split(links, y, np.ones(links.m))[0]
    assert np.allclose(x / size, 3.0 if size < 1 else y / size, rtol=1e-12, atol=0)


@compiles
def test_an_offset_does_not_keep_dual_steps_from_ending() -> None:
    links = links_of(read_network("grid:70,70"))
    y = np.random.default_rng(9).normal(size=links.n)
    capacity = np.full(links.m, 1.5)
    plain = proximal(links, y, capacity, tolerance=1e-3)
    moved = proximal(links, y + 2.0**20, capacity, tolerance=1e-3)
    assert moved.error <= 1e-3
    assert moved.iterations == plain.iterations
    assert np.allclose(moved.x - 2.0**20, plain.x, rtol=0, atol=2e-3)


@pytest.mark.parametrize("graph", ["path:7", "grid:4,4", "petersen"])
def test_other_units_give_the_same_numbers(graph: str) -> None:
    links = links_of(read_network(graph))
    y, capacity = drawn(links, 6, whole=False)
    plain = proximal(links, y, capacity)
    scaled = proximal(links, 2.0**20 * y, 2.0**20 * capacity)
    assert np.array_equal(scaled.x, 2.0**20 * plain.x)


@compiles
@pytest.mark.parametrize("graph", ["path:40", "star:9", "grid:5,6", "random_geometric:60,0.25,1"])
def test_one_result_with_and_without_a_compiler(
    graph: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    links = links_of(read_network(graph))
    y, capacity = drawn(links, 7, whole=True)
    flow = 0.5 * capacity
    flow[::3] = capacity[::3]

    def everything() -> tuple[np.ndarray, ...]:
        ascent = Ascent(links, y, capacity, flow)
        ascent.advance(2)
        moved = ascent.flow.copy()
        ascent.advance(60)
        rough = agreed_groups(links, y, 100 * capacity, flow)
        assert rough is not None
        return (
            split(links, y, capacity)[0],
            moved,
            *rough,
            proximal(links, y, capacity).x,
            ascent.flow,
        )

    in_c = everything()
    monkeypatch.setenv(WITHOUT, "1")
    without = everything()
    for one, two in zip(in_c[:-1], without[:-1], strict=True):
        assert np.array_equal(one, two)
    # sums over all links, taken in another order, may restart a momentum at another step
    assert np.allclose(in_c[-1], without[-1], rtol=0, atol=1e-2)


@compiles
def test_tree_programs_agree_with_and_without_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    for network in (recursive_tree(200, 3), read_network("path:200")):
        forest = links_of(network).forest
        assert forest is not None
        y = np.random.default_rng(8).normal(size=network.n)
        capacity = np.full(network.n, 0.4)
        monkeypatch.delenv(WITHOUT, raising=False)
        in_c = tree_flow(forest, y, capacity)
        monkeypatch.setenv(WITHOUT, "1")
        # kinks at equal places may leave the heaps in another order
        assert np.allclose(in_c, tree_flow(forest, y, capacity), rtol=0, atol=1e-13)


def test_a_wrong_flow_is_not_taken_for_groups() -> None:
    links = links_of(read_network("path:3"))
    y, capacity = np.array([3.0, 0.0, 0.0]), np.full(2, 0.5)
    assert agreed_groups(links, y, capacity, np.zeros(2)) is None
    assert agreed_groups(links, y, capacity, np.array([-0.5, 0.0])) is None
    found = agreed_groups(links, y, capacity, np.array([0.5, 0.1]))
    assert found is not None
    assert found[0].tolist() == [2.5, 0.25, 0.25]


@given(networks(min_nodes=2, max_nodes=7, weighted=True), st.integers(0, 99))
def test_a_point_is_that_of_exact_rationals(network, seed) -> None:
    links = links_of(network)
    rng = np.random.default_rng(seed)
    y, sizes = rng.integers(-9, 10, size=links.n), rng.integers(0, 7, size=links.m)
    capacities = [(i, j, c) for (i, j), c in zip(links.ends.tolist(), sizes.tolist(), strict=True)]
    exact = [float(value) for value in levelled(capacities, y.tolist()).values]
    given = y.astype(float), sizes.astype(float)
    found = proximal(links, *given)
    assert found.error == 0
    assert np.allclose(found.x, exact, rtol=0, atol=64 * ULP)
    assert np.allclose(split(links, *given)[0], exact, rtol=0, atol=64 * ULP)
