"""Exact minimum cuts among those that differ from a given one in a band of nodes only.

In the band the concave part of what makes a cut bad is replaced by its tangent at the given cut:
each node then has a price for being inside, the weights of the edges one for being cut, and a
minimum cut between the two ends of the band is the best of all 2^(size of the band) choices.

References
----------
E. A. Dinic, "Algorithm for solution of a problem of maximum flow in networks with power
estimation", Soviet Mathematics Doklady 11 (1970).
R. Andersen and K. Lang, "An algorithm for improving graph partitions", Symposium on Discrete
Algorithms (2008): quotients of cuts improved by flows.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.kernels import kernel
from sensortrack.kernels.calling import pointer

from .cut_graph import CutGraph, Flags, Floats, Nodes, Rows, Scales, rows_of

FLOW = 2.0**29
"""Largest flow that is asked for: what the road without a compiler can add up in 31 bits."""

ROUNDS = 6
"""How often a band is laid around the cut that the last one gave."""


def improved(graph: CutGraph, scales: Scales, side: Flags, widest: int) -> Flags:
    """A cut that no band around it of some sizes improves any more, or not for long.

    Parameters
    ----------
    graph : CutGraph
    scales : Scales
    side : ndarray of bool, shape (n,)
        A proper cut.
    widest : int
        Most nodes of a band.
    """
    best = scales.of(graph, side)
    width = widest
    for _ in range(ROUNDS):
        if not 0 < best < np.inf:
            break
        free = around(graph, side, width)
        better = side
        for trial in band_cuts(graph, scales, side, free, best):
            value = scales.of(graph, trial)
            if value > best * (1 + 1e-12):
                best, better = value, trial
        if better is side:
            if width < widest or width < 64:
                break
            width //= 8  # where the tangent is too far from the curve, closer ones may do
        side = better
    return side


def around(graph: CutGraph, side: Flags, count: int) -> Flags:
    """Nodes near a cut: all up to a number of hops at which there would be more than `count`."""
    rows = graph.rows
    leaves = side[graph.first] != side[graph.second]
    near = np.zeros(graph.n, dtype=bool)
    front = np.unique(np.concatenate([graph.first[leaves], graph.second[leaves]]))
    near[front] = True
    found = len(front)
    while len(front):
        front = np.unique(_neighbours(rows, front))
        front = front[~near[front]]
        found += len(front)
        if found > count:
            break
        near[front] = True
    return near


def _neighbours(rows: Rows, nodes: NDArray[np.integer]) -> Nodes:
    counts = rows.start[nodes + 1] - rows.start[nodes]
    offsets = np.repeat(rows.start[nodes] - np.r_[0, np.cumsum(counts)[:-1]], counts)
    found: Nodes = rows.head[offsets + np.arange(counts.sum())]
    return found


def band_cuts(
    graph: CutGraph, scales: Scales, side: Flags, free: Flags, value: float
) -> list[Flags]:
    """The smallest and the largest of the best cuts that differ from one in a band only.

    Parameters
    ----------
    graph : CutGraph
    scales : Scales
    side : ndarray of bool, shape (n,)
        The cut; the tangent is taken here.
    free : ndarray of bool, shape (n,)
        Nodes that may change.
    value : float
        How bad a cut has to be, positive and finite.
    """
    a, c, r = scales.prices(value)
    _, s, inside = graph.weights_of(side)
    n = graph.whole
    worth = c * (graph.gamma * (1 - 2 * s / n) + graph.size * ((graph.total - 2 * inside) / n))
    if r:
        worth += r * graph.size * ((n - 2 * s) / (2 * n * np.sqrt(graph.spread(s))))
    band = _Band.of(graph, side, free, worth / a)
    if band is None:
        return []
    cuts = []
    marks = band.solve()
    for chosen in (marks == 1, marks != 2):
        trial = side.copy()
        trial[band.nodes] = chosen
        if trial.any() and not trial.all():
            cuts.append(trial)
    return cuts


@dataclass(frozen=True)
class _Band:
    """A minimum cut problem: nodes with excess or lack, and edges with room both ways."""

    nodes: NDArray[np.int64]
    first: Nodes
    second: Nodes
    room: NDArray[np.int64]
    excess: NDArray[np.int64]

    @classmethod
    def of(cls, graph: CutGraph, side: Flags, free: Flags, worth: Floats) -> _Band | None:
        nodes = np.flatnonzero(free)
        place = np.full(graph.n, -1, dtype=np.int32)
        place[nodes] = np.arange(len(nodes), dtype=np.int32)
        i, j = place[graph.first], place[graph.second]
        pull = worth[nodes]
        for here, other in ((i, graph.second), (j, graph.first)):
            across = np.flatnonzero((here >= 0) & ~free[other])
            signed = np.where(side[other[across]], graph.weight[across], -graph.weight[across])
            pull = pull + np.bincount(here[across], signed, len(nodes))
        within = np.flatnonzero((i >= 0) & (j >= 0))
        if not (pull > 0).any() or not (pull < 0).any():
            return None
        most = min(float(pull[pull > 0].sum()), float(-pull[pull < 0].sum()))
        whole = np.array_equal(pull, np.rint(pull)) and most < FLOW
        unit = 1.0 if whole else FLOW / most
        room = np.rint(np.minimum(graph.weight[within] * unit, FLOW)).astype(np.int64)
        excess = np.rint(np.clip(pull * unit, -FLOW, FLOW)).astype(np.int64)
        return cls(nodes, i[within], j[within], room, excess)

    def solve(self) -> NDArray[np.uint8]:
        """1 on the smallest best set, 2 outside the largest, 0 in between."""
        rows = rows_of(len(self.nodes), self.first, self.second)
        library = kernel("mincut").library
        if library is None:
            return self._by_scipy()
        n, arcs = len(self.nodes), len(rows.head)
        room, excess = self.room[rows.edge].copy(), self.excess.copy()
        marks = np.zeros(n, dtype=np.uint8)
        arrays = (
            rows.start,
            rows.head,
            rows.twin,
            room,
            excess,
            np.zeros(n, dtype=np.int32),
            np.zeros(n, dtype=np.int32),
            np.zeros(n, dtype=np.int64),
            np.zeros(max(n, arcs, 1), dtype=np.int64),
            marks,
        )
        library.sensortrack_min_cut(ctypes.c_int32(n), *(pointer(array) for array in arrays))
        return marks

    def _by_scipy(self) -> NDArray[np.uint8]:
        """The same two sets: they are the same for every maximum flow."""
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import breadth_first_order, maximum_flow

        n = len(self.nodes)
        gives, takes = np.flatnonzero(self.excess > 0), np.flatnonzero(self.excess < 0)
        tails = (self.first, self.second, np.full(len(gives), n), takes)
        heads = (self.second, self.first, gives, np.full(len(takes), n + 1))
        rooms = (self.room, self.room, self.excess[gives], -self.excess[takes])
        ends = np.concatenate(tails), np.concatenate(heads)
        capacity = coo_array(
            (np.concatenate(rooms).astype(np.int32), ends), shape=(n + 2, n + 2)
        ).tocsr()
        rest = capacity - maximum_flow(capacity, n, n + 1).flow
        rest.data = np.maximum(rest.data, 0)
        rest.eliminate_zeros()
        marks = np.zeros(n + 2, dtype=np.uint8)
        marks[breadth_first_order(rest.T.tocsr(), n + 1, return_predecessors=False)] = 2
        marks[breadth_first_order(rest, n, return_predecessors=False)] = 1
        return marks[:n]
