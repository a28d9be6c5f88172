"""A large network in rows of neighbours, and walks over it: in C where a compiler is, else here.

Walks stay within the *home* of the node in which they begin: homes are the cells of a coarser
partition. Both roads visit the same nodes in the same order.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.kernels import kernel
from sensortrack.kernels.calling import call

Nodes = NDArray[np.int32]
Places = NDArray[np.int64]


@dataclass(frozen=True)
class Wiring:
    """Neighbours of each node, in the order in which the edges are listed.

    Parameters
    ----------
    n : int
        Number of nodes.
    first, second : ndarray of int32, shape (m,)
        Ends of each edge, the smaller node first.
    start : ndarray of int64, shape (n + 1,)
        The row of node i is ``start[i]`` to ``start[i + 1] - 1``.
    near, link : ndarray of int32, shape (2 m,)
        Neighbour and number of the edge to it.
    """

    n: int
    first: Nodes
    second: Nodes
    start: Places
    near: Nodes
    link: Nodes

    @property
    def most_neighbours(self) -> int:
        """The largest degree."""
        return int(np.diff(self.start).max(initial=0))


@dataclass(frozen=True)
class Forest:
    """A breadth-first tree in each connected part of each home, from its smallest node.

    Parameters
    ----------
    count : int
        Number of trees.
    up : ndarray of int32, shape (n,)
        The node before each; a root itself.
    via : ndarray of int32, shape (n,)
        Number of the edge to it; -1 at a root.
    order : ndarray of int32, shape (n,)
        All nodes, each after the one before it.
    sign : ndarray of int32, shape (n,)
        1 where a flow up the tree leaves the first end of its edge, else -1.
    """

    count: int
    up: Nodes
    via: Nodes
    order: Nodes
    sign: Nodes

    @property
    def roots(self) -> NDArray[np.bool_]:
        """Where the roots are."""
        found: NDArray[np.bool_] = self.via < 0
        return found


def wiring(n: int, edges: NDArray[np.int64]) -> Wiring:
    """Rows of neighbours of an edge list, shape (m, 2)."""
    first, second = (np.ascontiguousarray(edges[:, k], dtype=np.int32) for k in (0, 1))
    m = len(first)
    ends = np.concatenate([first, second])
    numbers = np.concatenate([np.arange(m, dtype=np.int32)] * 2)
    order = np.lexsort((numbers, ends))
    start = np.concatenate([[0], np.cumsum(np.bincount(ends, minlength=n))]).astype(np.int64)
    near = np.concatenate([second, first])[order]
    return Wiring(n, first, second, start, near, numbers[order])


def forest(wires: Wiring, home: Nodes) -> Forest:
    """Trees that span each home as far as it is connected."""
    n = wires.n
    up, order = np.empty(n, dtype=np.int32), np.empty(n, dtype=np.int32)
    rank = np.empty(n, dtype=np.int64)
    library = kernel("cells").library
    if library is not None:
        count = call(library.forest, n, wires.start, wires.near, home, up, rank, order)
    else:
        count = _forest(wires, home, up, rank, order)
    via = np.where(rank < 0, np.int32(-1), wires.link[np.maximum(rank, 0)])
    sign = np.where(wires.first[via] == np.arange(n), np.int32(1), np.int32(-1))
    return Forest(count, up, via.astype(np.int32), order, sign)


def grow(wires: Wiring, home: Nodes, label: Nodes) -> int:
    """Give nodes with the label -1 that of the node that reaches them first; in place.

    Returns
    -------
    int
        How many nodes have a label.
    """
    library = kernel("cells").library
    if library is not None:
        order = np.empty(wires.n, dtype=np.int32)
        reached: int = call(library.grow, wires.n, wires.start, wires.near, home, label, order)
        return reached
    walk = np.flatnonzero(label >= 0).tolist()
    for i in walk:
        for j in _row(wires, i):
            if label[j] < 0 and home[j] == home[i]:
                label[j] = label[i]
                walk.append(j)
    return len(walk)


def recentre(wires: Wiring, label: Nodes, seeds: Nodes) -> None:
    """Move each cell's seed to the middle of a long path of the cell; in place."""
    library = kernel("cells").library
    if library is not None:
        seen, up, order = (np.full(wires.n, -1, dtype=np.int32) for _ in range(3))
        call(
            library.recentre, len(seeds), wires.start, wires.near, label, seeds, seen, up, order,
            returns=None,
        )  # fmt: skip
        return
    for cell, seed in enumerate(seeds.tolist()):
        a = _last_reached(wires, label, seed)[0]
        b, before = _last_reached(wires, label, a)
        path = [b]
        while path[-1] != a:
            path.append(before[path[-1]])
        seeds[cell] = path[(len(path) - 1) // 2]


def smooth(wires: Wiring, home: Nodes, label: Nodes) -> int:
    """Let one node after the other join the cell of most of its neighbours; in place.

    Returns
    -------
    int
        Number of nodes that did.
    """
    library = kernel("cells").library
    if library is not None:
        tally = np.zeros(int(label.max()) + 1, dtype=np.int32)
        moved: int = call(library.smooth, wires.n, wires.start, wires.near, home, label, tally)
        return moved
    moves = 0
    for i in range(wires.n):
        around = [int(label[j]) for j in _row(wires, i) if home[j] == home[i]]
        best = int(label[i])
        for other in around:
            if around.count(other) > around.count(best):
                best = other
        moves += best != label[i]
        label[i] = best
    return moves


def _row(wires: Wiring, i: int) -> list[int]:
    row: list[int] = wires.near[wires.start[i] : wires.start[i + 1]].tolist()
    return row


def _forest(wires: Wiring, home: Nodes, up: Nodes, rank: Places, order: Nodes) -> int:
    up.fill(-1)
    reached: list[int] = []
    count = 0
    for root in range(wires.n):
        if up[root] >= 0:
            continue
        up[root], rank[root] = root, -1
        tree = [root]
        for i in tree:
            for place in range(int(wires.start[i]), int(wires.start[i + 1])):
                j = int(wires.near[place])
                if up[j] < 0 and home[j] == home[i]:
                    up[j], rank[j] = i, place
                    tree.append(j)
        count += 1
        reached += tree
    order[:] = reached
    return count


def _last_reached(wires: Wiring, label: Nodes, source: int) -> tuple[int, dict[int, int]]:
    """The last node of a walk through a cell, and the node before each."""
    before, walk = {source: source}, [source]
    for i in walk:
        for j in _row(wires, i):
            if j not in before and label[j] == label[i]:
                before[j] = i
                walk.append(j)
    return walk[-1], before
