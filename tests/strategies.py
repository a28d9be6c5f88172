"""What hypothesis draws for the tests of the three packages."""

from fractions import Fraction

import numpy as np
from hypothesis import strategies as st

from sensortrack.networks import Network

Matrix = tuple[tuple[Fraction, ...], ...]


def rationals(
    smallest: int | Fraction = -10, largest: int | Fraction = 10, max_denominator: int = 20
) -> st.SearchStrategy[Fraction]:
    """Fractions between two bounds, both included, with small denominators."""
    return st.fractions(smallest, largest, max_denominator=max_denominator)


def trees(
    min_nodes: int = 1, max_nodes: int = 8, weighted: bool = False
) -> st.SearchStrategy[Network]:
    """Networks without cycle, nodes and edges in shuffled order."""
    return _connected(min_nodes, max_nodes, weighted, extra=False)


def connected_networks(
    min_nodes: int = 1, max_nodes: int = 8, weighted: bool = False
) -> st.SearchStrategy[Network]:
    """Connected networks: a tree and any further edges, nodes and edges in shuffled order."""
    return _connected(min_nodes, max_nodes, weighted, extra=True)


@st.composite
def networks(
    draw: st.DrawFn, min_nodes: int = 1, max_nodes: int = 8, weighted: bool = False
) -> Network:
    """Networks of any number of components, edgeless ones too."""
    n = draw(st.integers(min_nodes, max_nodes))
    pairs = [(i, j) for j in range(n) for i in range(j)]
    pairs_drawn = draw(st.lists(st.sampled_from(pairs), unique=True)) if pairs else []
    return _network(draw, n, pairs_drawn, weighted)


@st.composite
def definite_matrices(draw: st.DrawFn, n: int) -> Matrix:
    """Exact symmetric positive definite n x n matrices: G G' + d I with a rational d > 0."""
    rows = [[draw(rationals(-3, 3, 4)) for _ in range(n)] for _ in range(n)]
    shift = draw(rationals(Fraction(1, 8), 4, 8))
    return tuple(
        tuple(
            sum((a * b for a, b in zip(rows[i], rows[j], strict=True)), Fraction(0))
            + (shift if i == j else 0)
            for j in range(n)
        )
        for i in range(n)
    )


@st.composite
def _connected(
    draw: st.DrawFn, min_nodes: int, max_nodes: int, weighted: bool, extra: bool
) -> Network:
    n = draw(st.integers(min_nodes, max_nodes))
    order = draw(st.permutations(range(n)))
    tree = [(draw(st.integers(0, j - 1)), j) for j in range(1, n)]
    further = [(i, j) for j in range(n) for i in range(j) if (i, j) not in tree]
    if extra and further:
        tree += draw(st.lists(st.sampled_from(further), unique=True))
    pairs = [(min(order[i], order[j]), max(order[i], order[j])) for i, j in tree]
    return _network(draw, n, draw(st.permutations(pairs)), weighted)


def _network(draw: st.DrawFn, n: int, pairs: list[tuple[int, int]], weighted: bool) -> Network:
    weights = None
    if weighted:
        weights = tuple(draw(rationals(Fraction(1, 10), 10)) for _ in pairs)
    names = [f"node {i}" for i in range(n)]
    return Network(names, np.array(pairs, dtype=np.int64).reshape(-1, 2), weights)
