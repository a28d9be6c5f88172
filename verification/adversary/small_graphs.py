"""Every connected graph on few nodes, one of each isomorphism class.

Each connected graph has a node without which it is still connected (a leaf of a spanning tree), so
all come from those with one node fewer, by linking a new node to some of the old ones. Of the
graphs that a relabelling turns into each other, the one is kept whose list of links is first.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from itertools import combinations, permutations

import numpy as np

from sensortrack.networks import Network

LARGEST = 7


def connected_graphs(nodes: int) -> Iterator[Network]:
    """Yield the connected graphs on `nodes` nodes, one a class, fewest edges first.

    Parameters
    ----------
    nodes : int
        From 2 to 7.

    Yields
    ------
    Network
        Labelled by its edges, like ``01 12``.

    Raises
    ------
    ValueError
        `nodes` is outside 2 to 7.
    """
    if not 2 <= nodes <= LARGEST:
        raise ValueError(f"nodes: {nodes}; from 2 to {LARGEST} are enumerated")
    for edges in sorted(map(_edges, _classes(nodes)), key=lambda edges: (len(edges), edges)):
        yield Network(
            names=tuple(str(i) for i in range(nodes)),
            edges=np.array(edges, dtype=np.int64),
            weights=None,
            label=" ".join(f"{i}{j}" for i, j in edges),
        )


def _edges(rows: tuple[int, ...]) -> tuple[tuple[int, int], ...]:
    nodes = range(len(rows))
    return tuple((i, j) for i, j in combinations(nodes, 2) if rows[i] >> j & 1)


@functools.cache
def _classes(nodes: int) -> frozenset[tuple[int, ...]]:
    """Neighbours of each node as bits, of one graph of each class."""
    if nodes == 1:
        return frozenset({(0,)})
    pairs = {pair: k for k, pair in enumerate(combinations(range(nodes), 2))}
    powers = 2 ** np.arange(len(pairs) - 1, -1, -1, dtype=np.int64)  # the first pair weighs most
    orders = np.array(list(permutations(range(nodes))), dtype=np.int8)
    place = np.zeros((nodes, nodes), dtype=np.int64)
    for (i, j), k in pairs.items():
        place[i, j] = place[j, i] = powers[k]
    weights = np.array([place[orders[:, i], orders[:, j]] for i, j in pairs])
    codes = {
        int(weights[[pairs[edge] for edge in _edges(grown)]].sum(axis=0).max())
        for smaller in _classes(nodes - 1)
        for grown in _grown(smaller)
    }
    return frozenset(_rows(code, nodes, pairs) for code in codes)


def _grown(rows: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    """The graph with a further node, linked to any of the old ones."""
    n = len(rows)
    for linked in range(1, 2**n):
        yield (*(row | (linked >> i & 1) << n for i, row in enumerate(rows)), linked)


def _rows(code: int, nodes: int, pairs: dict[tuple[int, int], int]) -> tuple[int, ...]:
    rows = [0] * nodes
    for (i, j), k in pairs.items():
        if code >> (len(pairs) - 1 - k) & 1:
            rows[i] |= 1 << j
            rows[j] |= 1 << i
    return tuple(rows)
