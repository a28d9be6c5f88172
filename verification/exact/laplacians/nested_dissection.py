"""Fill-reducing orders of sparse symmetric matrices, given by their graphs.

In C by nested dissection (``kernels/dissect.c``); without a compiler by the minimum
degree order that comes with SciPy's SuperLU.

References
----------
A. George, "Nested dissection of a regular finite element mesh", SIAM J. Numer. Anal. 10 (1973).
"""

from __future__ import annotations

import ctypes

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.kernels import kernel
from sensortrack.kernels.calling import pointer

Integers = NDArray[np.int32]
MOST = 2**30
"""Most links that the kernels number, each edge counted twice."""


def neighbours(n: int, edges: NDArray[np.int64]) -> tuple[NDArray[np.int64], Integers]:
    """Lists of neighbours.

    Parameters
    ----------
    n : int
        Number of nodes.
    edges : ndarray of int64, shape (m, 2)
        Each undirected edge once.

    Returns
    -------
    first : ndarray of int64, shape (n + 1,)
    to : ndarray of int32, shape (2 m,)
        The neighbours of node i are ``to[first[i]:first[i + 1]]``, increasing.
    """
    from scipy.sparse import coo_matrix

    rows = np.concatenate([edges[:, 0], edges[:, 1]]).astype(np.int32)
    columns = np.concatenate([edges[:, 1], edges[:, 0]]).astype(np.int32)
    links = coo_matrix((np.ones(len(rows), np.int8), (rows, columns)), shape=(n, n)).tocsr()
    links.sort_indices()
    return links.indptr.astype(np.int64), links.indices.astype(np.int32)


def elimination_order(n: int, edges: NDArray[np.int64]) -> Integers:
    """Order in which eliminating the nodes causes little fill.

    Parameters
    ----------
    n : int
        Number of nodes, one or more.
    edges : ndarray of int64, shape (m, 2)
        Each undirected edge once, no loops.

    Returns
    -------
    ndarray of int32, shape (n,)
        The node that is eliminated first, second, ...; trees are eliminated from their leaves,
        without any fill.

    Raises
    ------
    InputError
        There are too many edges for the kernel.
    MemoryError
    """
    if 2 * len(edges) > MOST:
        raise InputError("edges", f"{len(edges)} edges", f"at most {MOST // 2} are ordered")
    dissect, separator = kernel("dissect").library, kernel("separator").library
    if dissect is None or separator is None:
        return _minimum_degree(n, edges)
    first, to = neighbours(n, edges)
    order = np.empty(n, dtype=np.int32)
    starts = first.astype(np.int32)
    failed = dissect.sensortrack_dissect(
        ctypes.c_int32(n),
        pointer(starts),
        pointer(to),
        pointer(order),
        ctypes.cast(separator.sensortrack_separate, ctypes.c_void_p),
    )
    if failed:
        raise MemoryError(f"no memory to order {n} nodes")
    return order


def _minimum_degree(n: int, edges: NDArray[np.int64]) -> Integers:
    """The order in which SuperLU eliminates a diagonally dominant matrix with this graph."""
    from scipy.sparse import coo_matrix, diags_array
    from scipy.sparse.linalg import splu

    degree = np.bincount(edges.ravel(), minlength=n).astype(np.float64)
    ones = np.ones(len(edges))
    links = coo_matrix((ones, (edges[:, 0], edges[:, 1])), shape=(n, n)).tocsc()
    matrix = (diags_array(degree + 1.0) - links - links.T).tocsc()
    options = {"SymmetricMode": True}
    found = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
    return np.argsort(found.perm_c).astype(np.int32)
