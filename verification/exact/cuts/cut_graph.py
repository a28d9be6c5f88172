"""Networks in doubles for the search of cuts where exact numbers would be slow, and their pairing.

A graph here may stand for a larger one of which several nodes were put together: a node then has a
size. Whatever is found is a proposal: `Problem.measure` says exactly what a cut is worth.

References
----------
G. Karypis and V. Kumar, "A fast and high quality multilevel scheme for partitioning irregular
graphs", SIAM Journal on Scientific Computing 20 (1998): graphs made coarse by pairing of nodes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.kernels import kernel
from sensortrack.kernels.calling import pointer

from ..cut_problem import Aim, Hurdle, Problem

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Nodes = NDArray[np.int32]

INTEGER = 2**20
"""Weights up to this stay the whole numbers that they are."""

HEAVIEST = 3.0
"""No pair may be larger than this many times the average that the coarsest graph would have."""


@dataclass(frozen=True)
class CutGraph:
    """A connected graph with weights in doubles.

    Parameters
    ----------
    first, second : ndarray of int32, shape (m,)
        Ends of the edges.
    weight : ndarray, shape (m,)
        Weights of the edges, positive.
    conductance : ndarray, shape (m,)
        What stands for the weights where slow modes are computed.
    size, gamma : ndarray, shape (n,)
        How many nodes a node stands for, and the sum of their bounds.
    """

    first: Nodes
    second: Nodes
    weight: Floats
    conductance: Floats
    size: Floats
    gamma: Floats

    @property
    def n(self) -> int:
        """Number of nodes."""
        return len(self.size)

    @cached_property
    def whole(self) -> float:
        """Sum of all sizes."""
        return float(self.size.sum())

    @cached_property
    def total(self) -> float:
        """Sum of all bounds."""
        return float(self.gamma.sum())

    @cached_property
    def rows(self) -> Rows:
        """Neighbours of each node."""
        return rows_of(self.n, self.first, self.second)

    @cached_property
    def arc_weight(self) -> Floats:
        """Weight of each arc, in the order of `rows`."""
        return self.weight[self.rows.edge]

    def weights_of(self, side: Flags) -> tuple[float, float, float]:
        """Weight of the cut, size and bounds inside."""
        leaves = side[self.first] != side[self.second]
        inside = self.gamma[side].sum()
        return float(self.weight[leaves].sum()), float(self.size[side].sum()), float(inside)

    def load(self, s: Any, inside: Any) -> Any:
        """N = (1 - s/n) gamma(S) + (s/n) gamma(not S)."""
        return inside + s / self.whole * (self.total - 2.0 * inside)

    def spread(self, s: Any) -> Any:
        """p = s (n - s)/n."""
        return s * (self.whole - s) / self.whole


@dataclass(frozen=True)
class Rows:
    """Arcs of a graph, grouped by their tails.

    Parameters
    ----------
    start : ndarray of int64, shape (n + 1,)
        Arcs out of node v are start[v], ..., start[v + 1] - 1.
    head, twin, edge : ndarray of int32, shape (2 m,)
        Where an arc leads, the arc back, and the edge that it is made of.
    """

    start: NDArray[np.int64]
    head: Nodes
    twin: Nodes
    edge: Nodes


def rows_of(n: int, first: Nodes, second: Nodes) -> Rows:
    """Arcs of a graph, grouped by their tails."""
    from scipy.sparse import coo_array

    m = len(first)
    arcs = np.arange(2 * m, dtype=np.int32)
    ends = (np.concatenate([first, second]), np.concatenate([second, first]))
    table = coo_array((arcs + 1, ends), shape=(n, n)).tocsr()
    arc = (table.data - 1).astype(np.int32)
    place = np.empty(2 * m, dtype=np.int32)
    place[arc] = arcs
    twin = place[np.where(arc < m, arc + m, arc - m)]
    start, head = table.indptr.astype(np.int64), table.indices.astype(np.int32)
    return Rows(start, head, twin, np.where(arc < m, arc, arc - m).astype(np.int32))


@dataclass(frozen=True)
class Scales:
    """What is looked for, in the units of a `CutGraph`.

    Parameters
    ----------
    aim : Aim
        ``RATIO`` or ``RATE``.
    b, c : float
        Factors of weight and load, for ``Aim.RATE``.
    """

    aim: Aim
    b: float
    c: float

    def badness(self, graph: CutGraph, k: Any, s: Any, inside: Any) -> Any:
        """N/k, or sqrt(p) over b k - c N, of proper cuts; the larger, the nearer to the answer."""
        load = graph.load(s, inside)
        with np.errstate(divide="ignore", invalid="ignore"):
            if self.aim is Aim.RATE:
                gap = np.maximum(self.b * k - self.c * load, 0.0)
                value = np.sqrt(np.maximum(graph.spread(s), 0.0)) / gap
            else:
                value = load / k
        return np.where((s > 0) & (s < graph.whole), value, -np.inf)

    def of(self, graph: CutGraph, side: Flags) -> float:
        """How bad one cut is."""
        return float(self.badness(graph, *graph.weights_of(side)))

    def prices(self, value: float) -> tuple[float, float, float]:
        """A, c and r: a cut is worse than the value if A k - c N - r sqrt(p) < 0."""
        if self.aim is Aim.RATE:
            return self.b, self.c, 1.0 / value
        return 1.0, 1.0 / value, 0.0


def graph_of(
    task: Problem, hurdle: Hurdle, aim: Aim, conductance: Floats | None = None
) -> tuple[CutGraph, Scales]:
    """A problem in doubles.

    Parameters
    ----------
    task : Problem
    hurdle : Hurdle
        Its b and c, for ``Aim.RATE``.
    aim : Aim
    conductance : ndarray, shape (m,), optional
        What stands for the weights where slow modes are computed, positive.
    """
    weight, unit = _scaled(task.weights)
    gamma, top = _scaled(task.gamma)
    ends = task.edges.astype(np.int32)
    given = weight if conductance is None else np.asarray(conductance, dtype=np.float64)
    given = given / given.max()
    graph = CutGraph(ends[:, 0].copy(), ends[:, 1].copy(), weight, given, np.ones(task.n), gamma)
    b, c = hurdle.b * unit, hurdle.c * task.n * top
    size = max(abs(b), abs(c), 1)
    return graph, Scales(aim, float(b / size), float(c / size))


def _scaled(values: tuple[int, ...]) -> tuple[Floats, int]:
    """Values in doubles, and the unit that they are multiples of."""
    top = max(values) or 1
    if top <= INTEGER:
        return np.array(values, dtype=np.float64), 1
    unit = max(1, top // INTEGER)
    return np.array([value / unit for value in values]), unit


def coarser(graph: CutGraph, wanted: int, seed: int) -> tuple[CutGraph, Nodes]:
    """A graph of pairs of neighbours, and the pair of each node.

    Parameters
    ----------
    graph : CutGraph
    wanted : int
        How many nodes are wanted in the end; pairs much larger than that needs are not made.
    seed : int
        Of the order in which nodes choose.
    """
    mate = _pairs(graph, HEAVIEST * graph.whole / wanted, seed)
    heads = np.flatnonzero(mate >= np.arange(graph.n))
    group = np.empty(graph.n, dtype=np.int32)
    group[heads] = np.arange(len(heads), dtype=np.int32)
    group[mate[heads]] = group[heads]
    return contracted(graph, group, len(heads)), group


def contracted(graph: CutGraph, group: Nodes, count: int) -> CutGraph:
    """Nodes of one group become one; edges between two groups become one of their whole weight."""
    low, high = group[graph.first].astype(np.int64), group[graph.second].astype(np.int64)
    kept = np.flatnonzero(low != high)
    keys = np.minimum(low, high)[kept] * count + np.maximum(low, high)[kept]
    order = np.argsort(keys, kind="stable")
    keys, kept = keys[order], kept[order]
    starts = np.flatnonzero(np.r_[True, keys[1:] != keys[:-1]])
    first, second = np.divmod(keys[starts], count)
    sums = (np.add.reduceat(row[kept], starts) for row in (graph.weight, graph.conductance))
    nodes = (np.bincount(group, row, count) for row in (graph.size, graph.gamma))
    return CutGraph(first.astype(np.int32), second.astype(np.int32), *sums, *nodes)


def _pairs(graph: CutGraph, largest: float, seed: int) -> Nodes:
    """The mate of each node: its neighbour of the heaviest link over both sizes, or itself."""
    order = np.random.default_rng(seed).permutation(graph.n).astype(np.int32)
    mate = np.full(graph.n, -1, dtype=np.int32)
    rows, weight = graph.rows, graph.arc_weight
    library = kernel("mincut").library
    if library is not None:
        import ctypes

        arrays = (rows.start, rows.head, weight, graph.size, order)
        library.sensortrack_pair(
            ctypes.c_int32(graph.n),
            *(pointer(array) for array in arrays),
            ctypes.c_double(largest),
            pointer(mate),
        )
        return mate
    sizes, links, heads = graph.size.tolist(), weight.tolist(), rows.head.tolist()
    start = rows.start.tolist()
    for v in order.tolist():
        if mate[v] >= 0:
            continue
        best, top = v, 0.0
        for arc in range(start[v], start[v + 1]):
            u = heads[arc]
            if mate[u] < 0 and sizes[u] + sizes[v] <= largest:
                value = links[arc] / (sizes[u] * sizes[v])
                if value > top:
                    top, best = value, u
        mate[v], mate[best] = best, v
    return mate
