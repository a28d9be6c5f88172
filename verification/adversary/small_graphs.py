"""Every connected graph on few nodes, one of each isomorphism class."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, permutations

import numpy as np

from sensortrack.networks import Network

LARGEST = 6


def connected_graphs(nodes: int) -> Iterator[Network]:
    """Yield the connected graphs on `nodes` nodes, one a class, fewest edges first.

    Parameters
    ----------
    nodes : int
        From 2 to 6.

    Yields
    ------
    Network
        Labelled by its edges, like ``01 12``.

    Raises
    ------
    ValueError
        `nodes` is outside 2 to 6.
    """
    if not 2 <= nodes <= LARGEST:
        raise ValueError(f"nodes: {nodes}; from 2 to {LARGEST} are enumerated")
    pairs = list(combinations(range(nodes), 2))
    relabelled = [
        {pair: tuple(sorted((order[pair[0]], order[pair[1]]))) for pair in pairs}
        for order in permutations(range(nodes))
    ]
    seen: set[frozenset[tuple[int, ...]]] = set()
    for size in range(nodes - 1, len(pairs) + 1):
        for edges in combinations(pairs, size):
            if frozenset(edges) in seen or not _connected(nodes, edges):
                continue
            seen.update(frozenset(order[edge] for edge in edges) for order in relabelled)
            yield Network(
                names=tuple(str(i) for i in range(nodes)),
                edges=np.array(edges, dtype=np.int64),
                weights=None,
                label=" ".join(f"{i}{j}" for i, j in edges),
            )


def _connected(nodes: int, edges: tuple[tuple[int, int], ...]) -> bool:
    reached, grown = {0}, True
    while grown:
        more = {j for edge in edges if reached & set(edge) for j in edge} - reached
        reached |= more
        grown = bool(more)
    return len(reached) == nodes
