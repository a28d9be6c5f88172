"""Sparse factors L D L' of weighted Laplacians plus a diagonal, for graphs of a million nodes.

The pattern is analysed once and factored for as many weights as there are. Nothing is pivoted: that
is safe for definite matrices, and the signs of the pivots tell how many eigenvalues are negative
(Sylvester) of a matrix close to the given one. Everything here is floating point and proposes; what
is proved from such a factor is computed again in integers.

In C by supernodes with SciPy's BLAS (``kernels/ldl.c``), else by SuperLU.

References
----------
J. W. H. Liu, "The multifrontal method for sparse matrix solution: theory and practice", SIAM Review
34 (1992). G. H. Golub and C. F. Van Loan, *Matrix Computations*, 4.1 (L D L' without pivoting).
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import SensorTrackError
from sensortrack.kernels import kernel
from sensortrack.kernels.calling import pointer

from .blas import blas, one_thread
from .nested_dissection import Integers
from .sparse_pattern import Symbolic, analyse

__all__ = ["Factor", "FactorError", "Symbolic", "analyse", "factorise"]

Floats = NDArray[np.float64]


class FactorError(SensorTrackError):
    """A pivot is zero or no number: the matrix has no such factor, or none in this order."""


class _Shape(ctypes.Structure):
    _fields_ = (
        ("n", ctypes.c_int32),
        ("supernodes", ctypes.c_int32),
        ("start", ctypes.c_void_p),
        ("at", ctypes.c_void_p),
        ("row", ctypes.c_void_p),
        ("panel", ctypes.c_void_p),
    )


class Factor:
    """L D L' of one matrix; made by `factorise`.

    Parameters
    ----------
    symbolic : Symbolic
    pivots : ndarray of float64, shape (n,)
        D in the order of elimination.
    panels : ndarray of float64 or None
        The dense panels of L, below the diagonal; None if SuperLU holds the factor.
    other : SuperLU or None
    """

    def __init__(
        self, symbolic: Symbolic, pivots: Floats, panels: Floats | None, other: Any = None
    ) -> None:
        self.symbolic, self.pivots, self.panels, self._other = symbolic, pivots, panels, other

    @property
    def negative(self) -> int:
        """How many pivots are negative."""
        return int((self.pivots < 0).sum())

    def solve(self, block: Floats) -> Floats:
        """Solve for one right-hand side or for many.

        Parameters
        ----------
        block : ndarray, shape (n,) or (n, k)
            Rows in the order of the nodes.

        Returns
        -------
        ndarray of float64, of the same shape

        Raises
        ------
        MemoryError
        """
        if self.panels is None:
            return np.asarray(self._other.solve(np.asarray(block, dtype=np.float64)))
        library, (gemm, trsm) = kernel("ldl").library, blas() or (None, None)
        x = np.array(block, dtype=np.float64, order="C")
        width = ctypes.c_int64(x.size // len(x))
        shape = _shape(self.symbolic)
        order = pointer(self.symbolic.order)
        data = (pointer(self.panels), pointer(self.pivots), order, pointer(x))
        assert library is not None
        with one_thread():
            status = library.sensortrack_solve(ctypes.byref(shape), *data, width, gemm, trsm)
        if status:
            raise MemoryError(f"no memory to solve with {len(x)} nodes")
        return x


def factorise(
    symbolic: Symbolic, weights: Floats | None = None, diagonal: Floats | float = 0.0
) -> Factor:
    """Factor a weighted Laplacian plus a diagonal.

    Parameters
    ----------
    symbolic : Symbolic
    weights : ndarray of float64, shape (m,), optional
        One an edge, in the order of ``symbolic.edges``; all one by default.
    diagonal : ndarray of float64, shape (n,), or float, optional
        Added to the diagonal, in the order of the nodes. A Laplacian itself is singular: a positive
        number at one node g grounds it, and solves with right-hand sides of sum zero are then exact
        solutions of the Laplacian itself with the value 0 at g. A shift -s gives L - s I.

    Returns
    -------
    Factor

    Raises
    ------
    FactorError
        A pivot is zero, or no number.
    MemoryError
    """
    n, edges = symbolic.n, symbolic.edges
    w = np.ones(len(edges)) if weights is None else np.ascontiguousarray(weights, dtype=np.float64)
    full: Floats = np.array(np.broadcast_to(diagonal, (n,)), dtype=np.float64)
    for end in (0, 1):
        full += np.bincount(edges[:, end], w, n)
    library, routines = kernel("ldl").library, blas()
    if library is None or routines is None or len(symbolic.start) == 1:
        return _superlu(symbolic, w, full)
    first, row, edge = symbolic.lower
    values, main = -w[edge], full[symbolic.order]
    panels, pivots = np.empty(int(symbolic.panel[-1])), np.empty(n)
    shape = _shape(symbolic)
    data = [pointer(array) for array in (first, row, values, main, panels, pivots)]
    with one_thread():
        status = library.sensortrack_factor(ctypes.byref(shape), *data, *routines)
    if status < 0:
        raise MemoryError(f"no memory to factor {n} nodes")
    if status > 0 or not np.isfinite(pivots).all():
        raise FactorError("a pivot is zero or no number")
    return Factor(symbolic, pivots, panels)


def _shape(symbolic: Symbolic) -> _Shape:
    arrays = (symbolic.start, symbolic.at, symbolic.row, symbolic.panel)
    return _Shape(symbolic.n, len(symbolic.start) - 1, *[pointer(array) for array in arrays])


def _superlu(symbolic: Symbolic, weights: Floats, diagonal: Floats) -> Factor:
    """The same by SuperLU, in the order that was found."""
    from scipy.sparse import coo_matrix, diags_array
    from scipy.sparse.linalg import splu

    n, edges = symbolic.n, symbolic.edges
    links = coo_matrix((weights, (edges[:, 0], edges[:, 1])), shape=(n, n)).tocsc()
    matrix = (diags_array(diagonal) - links - links.T).tocsc()
    place = np.argsort(symbolic.order)
    options = {"SymmetricMode": True}
    inner = matrix[symbolic.order][:, symbolic.order].tocsc()
    try:
        found = splu(inner, permc_spec="NATURAL", diag_pivot_thresh=0.0, options=options)
    except RuntimeError as error:
        raise FactorError(f"a pivot is zero or no number: {error}") from error
    return Factor(symbolic, found.U.diagonal(), None, _Reordered(found, symbolic.order, place))


@dataclass(frozen=True)
class _Reordered:
    """SuperLU of a matrix whose rows and columns were brought into an order."""

    inner: Any
    order: Integers
    place: NDArray[np.intp]

    def solve(self, block: Floats) -> Floats:
        return np.asarray(self.inner.solve(block[self.order])[self.place])
