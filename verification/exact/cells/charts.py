"""A network renumbered so that neighbours are near each other in memory, and its original trees."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..laplacians.nested_dissection import elimination_order
from .wiring import Forest, Nodes, Places, Wiring, forest, wiring


@dataclass(frozen=True)
class Chart:
    """Two numberings of one network.

    Parameters
    ----------
    original : Wiring
        As the network was given.
    wires : Wiring
        Nodes in an order in which eliminating them causes little fill, edges sorted by their ends;
        the first end of an edge is still the one that came first.
    order : ndarray of int32, shape (n,)
        Original number of each node.
    rank : ndarray of int32, shape (n,)
        New number of each original node.
    walk : ndarray of int64, shape (m,)
        Original number of each edge.
    """

    original: Wiring
    wires: Wiring
    order: Nodes
    rank: Nodes
    walk: Places

    def trees(self, home: Nodes) -> Forest:
        """Trees as they grow in the original numbering, in the new one.

        Parameters
        ----------
        home : ndarray of int32, shape (n,)
            In the new numbering.
        """
        found = forest(self.original, np.ascontiguousarray(home[self.rank]))
        number = np.empty(len(self.walk) + 1, dtype=np.int32)
        number[self.walk] = np.arange(len(self.walk), dtype=np.int32)
        number[-1] = -1
        return Forest(
            found.count,
            self.rank[found.up[self.order]],
            number[found.via[self.order]],
            self.rank[found.order],
            found.sign[self.order],
        )


def chart(n: int, edges: NDArray[np.int64]) -> Chart:
    """Renumber a network.

    Parameters
    ----------
    n : int
        Number of nodes.
    edges : ndarray of int64, shape (m, 2)
        The smaller node first.

    Returns
    -------
    Chart
    """
    order = elimination_order(n, edges)
    rank = np.empty(n, dtype=np.int32)
    rank[order] = np.arange(n, dtype=np.int32)
    ends = rank[edges].astype(np.int64)
    walk = np.argsort(ends.min(axis=1) * n + ends.max(axis=1))
    return Chart(wiring(n, edges), wiring(n, ends[walk]), order, rank, walk)
