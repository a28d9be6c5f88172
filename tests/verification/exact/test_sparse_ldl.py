"""Sparse factors: solutions, inertia and orders against dense linear algebra, on both roads."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.kernels import kernel
from sensortrack.networks import Network, read_network
from tests.strategies import networks
from verification.exact.laplacians.nested_dissection import elimination_order
from verification.exact.laplacians.sparse_ldl import FactorError, analyse, factorise

ROADS = [
    pytest.param("0", id="C", marks=pytest.mark.skipif(not kernel("ldl").library, reason="no C")),
    pytest.param("1", id="SuperLU"),
]
FAMILIES = (
    "path:2", "path:99", "cycle:100", "complete:90", "star:100", "bipartite:40,70", "grid:9,20",
    "torus:12,13", "hypercube:7", "karate", "random_geometric:250,0.12,1",
    "random_geometric:150,0.04,2",
)  # fmt: skip


@pytest.fixture(params=ROADS)
def road(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("SENSORTRACK_NO_COMPILER", request.param)
    return str(request.param)


def dense(network: Network, weights: np.ndarray, diagonal: np.ndarray) -> np.ndarray:
    matrix = np.diag(diagonal).astype(float)
    for (i, j), w in zip(network.edges.tolist(), weights.tolist(), strict=True):
        matrix[[i, j], [j, i]] -= w
        matrix[[i, j], [i, j]] += w
    return matrix


def compare(network: Network, weights: np.ndarray, diagonal: np.ndarray) -> None:
    symbolic = analyse(network.n, network.edges)
    assert sorted(symbolic.order.tolist()) == list(range(network.n))
    factor = factorise(symbolic, weights, diagonal)
    matrix = dense(network, weights, diagonal)
    assert factor.negative == int((np.linalg.eigvalsh(matrix) < 0).sum())
    sign, size = np.linalg.slogdet(matrix)
    assert np.sign(factor.pivots).prod() == sign
    assert np.log(np.abs(factor.pivots)).sum() == pytest.approx(size, rel=1e-9, abs=1e-9)
    block = np.random.default_rng(1).standard_normal((network.n, 70))
    found = factor.solve(block)
    assert np.abs(matrix @ found - block).max() <= 1e-9 * (1 + np.abs(found).max())
    assert np.allclose(factor.solve(block[:, 2]), found[:, 2], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("family", FAMILIES)
def test_solutions_and_inertia_are_those_of_dense_linear_algebra(family: str, road: str) -> None:
    network = read_network(family)
    random = np.random.default_rng(0)
    weights = random.random(network.m) + 0.1
    compare(network, weights, random.standard_normal(network.n) * 0.2)
    compare(network, weights, np.full(network.n, 1e-3))
    compare(network, weights, np.full(network.n, -0.0973))


@given(networks(1, 9), st.integers(0, 2**32 - 1))
@settings(max_examples=60)
def test_any_small_graph_is_factored(network: Network, seed: int) -> None:
    random = np.random.default_rng(seed)
    compare(network, random.random(network.m) + 0.1, random.random(network.n) * 2 + 0.1)


def test_a_grounded_laplacian_solves_the_laplacian_itself(road: str) -> None:
    network = read_network("random_geometric:400,0.12,3")
    weights = np.random.default_rng(2).random(network.m) + 0.5
    ground = np.zeros(network.n)
    ground[7] = 3.0
    flow = np.random.default_rng(3).standard_normal((network.n, 5))
    flow -= flow.mean(axis=0)
    found = factorise(analyse(network.n, network.edges), weights, ground).solve(flow)
    laplacian = dense(network, weights, np.zeros(network.n))
    assert np.abs(laplacian @ found - flow).max() <= 1e-9 * np.abs(found).max()
    assert np.abs(found[7]).max() <= 1e-9 * np.abs(found).max()


@pytest.mark.parametrize("family", ["path:3000", "star:2000"])
def test_trees_are_eliminated_without_fill(family: str) -> None:
    network = read_network(family)
    order = elimination_order(network.n, network.edges)
    place = np.argsort(order)
    ends = np.sort(place[network.edges], axis=1)
    assert np.bincount(ends[:, 0], minlength=network.n).max() == 1


@pytest.mark.skipif(not kernel("ldl").library, reason="the pattern is found in C")
def test_the_pattern_holds_every_entry_of_the_factor() -> None:
    network = read_network("random_geometric:300,0.1,5")
    symbolic = analyse(network.n, network.edges)
    weights = np.ones(network.m)
    matrix = dense(network, weights, np.full(network.n, 1.0))[
        np.ix_(symbolic.order, symbolic.order)
    ]
    lower = np.abs(np.linalg.cholesky(matrix)) > 1e-14
    stored = np.zeros_like(lower)
    for k, (first, last) in enumerate(zip(symbolic.start, symbolic.start[1:], strict=False)):
        stored[first:last, first:last] = True
        stored[symbolic.row[symbolic.at[k] : symbolic.at[k + 1]], first:last] = True
    assert not (lower & ~stored).any()
    assert int(np.tril(stored).sum()) == symbolic.entries


def test_nested_dissection_of_a_grid_causes_little_fill() -> None:
    network = read_network("grid:60,60")
    symbolic = analyse(network.n, network.edges)
    if len(symbolic.start) > 1:
        assert symbolic.entries <= 31 / 4 * network.n * np.log2(60)


def test_a_singular_matrix_is_refused(road: str) -> None:
    with pytest.raises(FactorError, match="pivot"):
        factorise(analyse(2, np.array([[0, 1]])))


@pytest.mark.parametrize(
    "n, edges, found",
    [
        (0, np.empty((0, 2), dtype=np.int64), "0 nodes"),
        (3, np.array([0, 1]), "shape"),
        (3, np.array([[0, 3]]), "between"),
        (3, np.array([[-1, 1]]), "between"),
        (3, np.array([[1, 1]]), "itself"),
        (3, np.array([[0.0, 1.0]]), "float64"),
    ],
)
def test_bad_edges_are_named(n: int, edges: np.ndarray, found: str) -> None:
    with pytest.raises(InputError, match=found):
        analyse(n, edges)
