"""How a graph is eliminated: its order, its elimination tree and its supernodes.

A supernode is a run of columns of the factor with the same rows below them, up to some zeros that
are stored; its columns are a dense panel.

References
----------
J. W. H. Liu, "The role of elimination trees in sparse factorization", SIAM Journal on Matrix
Analysis and Applications 11 (1990).
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.kernels import kernel
from sensortrack.kernels.calling import pointer

from .blas import blas
from .nested_dissection import Integers, elimination_order, neighbours


@dataclass(frozen=True)
class Symbolic:
    """How a graph is eliminated, whatever its weights.

    Parameters
    ----------
    n : int
        Number of nodes.
    edges : ndarray of int64, shape (m, 2)
        Each undirected edge once.
    order : ndarray of int32, shape (n,)
        The node that is eliminated first, second, ...
    start : ndarray of int32, shape (k + 1,)
        First column of each supernode, in the order of elimination.
    at : ndarray of int64, shape (k + 1,)
        Where the rows of each supernode begin in `row`.
    row : ndarray of int32
        Rows below the columns of each supernode, increasing.
    """

    n: int
    edges: NDArray[np.int64]
    order: Integers
    start: Integers
    at: NDArray[np.int64]
    row: Integers

    @cached_property
    def panel(self) -> NDArray[np.int64]:
        """Where the dense panel of each supernode begins, and last their whole length."""
        columns, rows = np.diff(self.start).astype(np.int64), np.diff(self.at)
        return np.concatenate([[0], np.cumsum(columns * (columns + rows))])

    @property
    def entries(self) -> int:
        """Entries of L on and below the diagonal, the zeros that are stored among them."""
        columns, rows = np.diff(self.start).astype(np.int64), np.diff(self.at)
        return int((columns * (columns + 1) // 2 + columns * rows).sum())

    @property
    def operations(self) -> float:
        """Multiplications of one factorisation, each with an addition."""
        columns, rows = np.diff(self.start).astype(float), np.diff(self.at).astype(float)
        high = columns + rows
        return (
            float((high * (high + 1) * (2 * high + 1) - rows * (rows + 1) * (2 * rows + 1)).sum())
            / 12
        )

    @cached_property
    def lower(self) -> tuple[NDArray[np.int64], Integers, NDArray[np.int64]]:
        """The matrix below its diagonal, by columns: starts, rows, and which edge each entry is."""
        place = np.empty(self.n, dtype=np.int64)
        place[self.order] = np.arange(self.n)
        ends = place[self.edges]
        column, row = ends.min(axis=1), ends.max(axis=1)
        edge = np.argsort(column, kind="stable")
        first = np.concatenate([[0], np.cumsum(np.bincount(column, minlength=self.n))])
        return first.astype(np.int64), row[edge].astype(np.int32), edge


class _Pattern(ctypes.Structure):
    _fields_ = (
        ("supernodes", ctypes.c_int32),
        ("stored", ctypes.c_int64),
        ("start", ctypes.POINTER(ctypes.c_int32)),
        ("at", ctypes.POINTER(ctypes.c_int64)),
        ("row", ctypes.POINTER(ctypes.c_int32)),
    )


def analyse(n: int, edges: NDArray[np.int64], order: Integers | None = None) -> Symbolic:
    """Order a graph and find the pattern of its factor.

    Parameters
    ----------
    n : int
        Number of nodes, one or more.
    edges : ndarray of int64, shape (m, 2)
        Each undirected edge once, no loops; the graph need not be connected.
    order : ndarray of int32, shape (n,), optional
        An order that is known to be good, as one for a graph with more edges is; found by default.

    Returns
    -------
    Symbolic
        Each column a supernode of its own if there is no compiler.

    Raises
    ------
    InputError
        The edges are no such list.
    MemoryError
    """
    edges = _checked(n, edges)
    order = elimination_order(n, edges) if order is None else order
    library = kernel("ldl").library
    if library is None or blas() is None:
        return Symbolic(n, edges, order, *_columns(n, edges, order))
    order, first, to, parent = _postordered(library, n, edges, order)
    library.sensortrack_pattern.restype = ctypes.POINTER(_Pattern)
    pattern = library.sensortrack_pattern(
        ctypes.c_int32(n), pointer(first), pointer(to), pointer(parent)
    )
    if not pattern:
        raise MemoryError(f"no memory for the pattern of {n} nodes")
    shape = pattern.contents
    many = shape.supernodes + 1
    start = np.ctypeslib.as_array(shape.start, (many,)).copy()
    at = np.ctypeslib.as_array(shape.at, (many,)).copy()
    row = np.ctypeslib.as_array(shape.row, (int(shape.stored) + 1,))[:-1].copy()
    library.sensortrack_forget(pattern)
    return Symbolic(n, edges, order, start, at, row)


def _columns(
    n: int, edges: NDArray[np.int64], order: Integers
) -> tuple[Integers, NDArray[np.int64], Integers]:
    """Starts, places and rows of single columns: those of a column go on to its parent."""
    below: list[set[int]] = [set() for _ in range(n)]
    for i, j in np.argsort(order)[edges].tolist():
        below[min(i, j)].add(max(i, j))
    found: list[int] = []
    at = np.zeros(n + 1, dtype=np.int64)
    for k, rows in enumerate(below):
        found += sorted(rows)
        at[k + 1] = len(found)
        if rows:
            parent = min(rows)
            below[parent] |= rows - {parent}
    return np.arange(n + 1, dtype=np.int32), at, np.array(found, dtype=np.int32)


def _postordered(
    library: ctypes.CDLL, n: int, edges: NDArray[np.int64], order: Integers
) -> tuple[Integers, NDArray[np.int64], Integers, Integers]:
    """Reorder so that subtrees of the elimination tree stand together; order, graph and parents."""
    count = ctypes.c_int32(n)
    parent, spare = np.empty(n, dtype=np.int32), np.empty((3, n), dtype=np.int32)
    first, to = neighbours(n, np.argsort(order)[edges])
    library.sensortrack_tree(count, pointer(first), pointer(to), pointer(parent), pointer(spare))
    found = np.empty(n, dtype=np.int32)
    rooms = [pointer(found), *(pointer(room) for room in spare)]
    library.sensortrack_postorder(count, pointer(parent), *rooms)
    order = order[found]
    first, to = neighbours(n, np.argsort(order)[edges])
    place = np.full(n + 1, -1, dtype=np.int32)  # the root's parent is -1
    place[found] = np.arange(n)
    return order, first, to, place[parent[found]]


def _checked(n: int, edges: NDArray[np.int64]) -> NDArray[np.int64]:
    edges = np.asarray(edges)
    if edges.size == 0:
        edges = np.empty((0, 2), dtype=np.int64)
    if n < 1 or edges.ndim != 2 or edges.shape[1] != 2 or edges.dtype.kind not in "iu":
        found = f"{n} nodes and edges of shape {edges.shape}, {edges.dtype}"
        raise InputError("edges", found, "one node or more and whole numbers of shape (m, 2)")
    if edges.size and (edges.min() < 0 or edges.max() >= n):
        found = f"edges between nodes {edges.min()} to {edges.max()}"
        raise InputError("edges", found, f"node numbers from 0 to {n - 1}")
    if (edges[:, 0] == edges[:, 1]).any():
        raise InputError("edges", "an edge from a node to itself", "edges between different nodes")
    return edges.astype(np.int64, copy=False)
