"""Lower bounds on lambda_2 by an elimination in integers whose rounding is paid for.

Let A = L - s I for the Laplacian L of a weighted graph. Column by column an integer c and integers
q close to the remaining column over c are chosen, and sign(c) (|c|, q)(|c|, q)' is taken off, in
units of 2^-bits. The c is so small, or if it is negative so far below zero, that what rounding
leaves is diagonally dominant with a diagonal >= 0, hence >= 0. If at most one c is negative, A is
>= 0 on the hyperplane where that one product vanishes, so that lambda_2 >= s. Weights are rounded
down and s up at the start, which makes A smaller.

The certificate checker does the same arithmetic (``gap_above``); here it runs in 128 bits in C, for
graphs that no certificate file can hold, and in Python's integers where that is not enough.

References
----------
N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., chapter 10 (L D L' with
rounding). S. M. Rump, "Verification of positive definiteness", BIT 46 (2006): the same idea for a
Cholesky factor in floating point.
"""

from __future__ import annotations

import ctypes
import math
from collections import defaultdict
from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import SensorTrackError
from sensortrack.kernels import kernel
from sensortrack.kernels.calling import pointer
from sensortrack.networks import Network

from .sparse_pattern import Symbolic

WIDE = 124
"""Bits that every number of the elimination in C keeps below."""

CHECKED = 7e8
"""Most multiplications that a certificate asks its checker for: a minute."""

SLOW = 2e7
"""Most multiplications of an elimination that is done in Python's integers: seconds."""


class EliminationError(SensorTrackError):
    """The elimination needs more digits or memory than there are; it proves nothing."""


class Matrix:
    """A graph's L - s I in units of 4^-bits, weights rounded down and s up.

    Parameters
    ----------
    network : Network
    s : Fraction
    bits : int
    """

    def __init__(self, network: Network, s: Fraction, bits: int) -> None:
        self.network, self.bits, self.unit = network, bits, 4**bits
        self.shift = math.ceil(s * self.unit)
        self.weights: list[int] | None = None
        if network.weights is not None:
            self.weights = [w.numerator * self.unit // w.denominator for w in network.weights]

    def diagonal(self) -> list[int]:
        """The diagonal, one entry a node."""
        edges, n = self.network.edges, self.network.n
        if self.weights is None:
            degrees = np.bincount(edges.ravel(), minlength=n).tolist()
            return [degree * self.unit - self.shift for degree in degrees]
        sums = [-self.shift] * n
        for (i, j), w in zip(edges.tolist(), self.weights, strict=True):
            sums[i] += w
            sums[j] += w
        return sums


def negatives(symbolic: Symbolic, matrix: Matrix) -> int:
    """Eliminate and count the negative c: at most one proves lambda_2 >= s.

    Parameters
    ----------
    symbolic : Symbolic
        Of the network's edges.
    matrix : Matrix

    Returns
    -------
    int
        0, 1, or 2 for two or more.

    Raises
    ------
    EliminationError
        There are too many digits for C and too many operations for Python, or no memory.
    """
    library = kernel("eliminate").library
    if library is not None and len(symbolic.start) > 1 and _fits(matrix):
        status = _negatives_in_c(library, symbolic, matrix)
        if status >= 0:
            return status
        if status == -1:
            raise EliminationError(f"no memory to eliminate {symbolic.n} nodes in integers")
    if len(symbolic.start) > 1 and symbolic.operations > SLOW:
        raise EliminationError("the elimination needs more than 126 bits")
    return negatives_in_python(symbolic.order.tolist(), matrix)


def negatives_in_python(order: Sequence[int], matrix: Matrix, most: float = SLOW) -> int:
    """The same in Python's integers, with any number of bits and in any order.

    Raises
    ------
    EliminationError
        After `most` multiplications.
    """
    n = matrix.network.n
    at = [0] * n
    for k, node in enumerate(order):
        at[node] = k
    rows: list[defaultdict[int, int]] = [defaultdict(int) for _ in range(n)]
    weights = matrix.weights or [matrix.unit] * matrix.network.m
    for (i, j), w in zip(matrix.network.edges.tolist(), weights, strict=True):
        rows[min(at[i], at[j])][max(at[i], at[j])] = -w
    for k, entry in enumerate(matrix.diagonal()):
        rows[at[k]][at[k]] = entry
    slack, negative = [0] * n, 0
    for k, row in enumerate(rows):
        v = row.pop(k)
        column = [(j, w) for j, w in sorted(row.items()) if w]
        row.clear()
        c = pivot(v - slack[k], len(column))
        negative += c < 0
        taken = []
        for j, w in column:
            q = (2 * w + c) // (2 * c)
            slack[j] += abs(w - c * q)
            taken.append((j, q))
        most -= len(taken) ** 2 / 2
        if most < 0:
            raise EliminationError("the elimination needs too many operations for Python")
        for i, (j, q) in enumerate(taken):
            factor, target = (q if c > 0 else -q), rows[j]
            for m, p in taken[i:]:
                target[m] -= factor * p
        if negative > 1:
            return 2
    return negative


def pivot(t: int, many: int) -> int:
    """The integer c for a diagonal entry that exceeds the slack by t, with `many` entries below it.

    c is such that t >= c |c| + many |c|/2.
    """
    if t > 0:
        room = t - (many * math.isqrt(t) + 1) // 2
        if room > 0:
            return math.isqrt(room)
    return -(math.isqrt(max(-t, 0)) + 1 + (many + 1) // 2)


def _fits(matrix: Matrix) -> bool:
    degree = int(np.bincount(matrix.network.edges.ravel(), minlength=1).max())
    largest = max(matrix.weights, default=0) if matrix.weights else matrix.unit
    return bool(max(degree * largest, abs(matrix.shift)) * 2 < 2**WIDE)


def _negatives_in_c(library: ctypes.CDLL, symbolic: Symbolic, matrix: Matrix) -> int:
    first, row, edge = symbolic.lower
    if matrix.weights is None:
        values = np.empty((len(edge), 2), dtype=np.uint64)
        values[:] = _halves([matrix.unit])
    else:
        values = _halves(matrix.weights)[edge]
    diagonal = np.ascontiguousarray(_halves(matrix.diagonal())[symbolic.order])
    arrays = (symbolic.start, symbolic.at, symbolic.row)
    shape = _Shape(symbolic.n, len(symbolic.start) - 1, *[pointer(array) for array in arrays])
    data = [pointer(array) for array in (first, row, values, diagonal)]
    return int(library.sensortrack_eliminate(ctypes.byref(shape), *data))


class _Shape(ctypes.Structure):
    _fields_ = (
        ("n", ctypes.c_int32),
        ("supernodes", ctypes.c_int32),
        ("start", ctypes.c_void_p),
        ("at", ctypes.c_void_p),
        ("row", ctypes.c_void_p),
    )


def _halves(numbers: Sequence[int]) -> NDArray[np.uint64]:
    """Two's complement of 128 bits, the lower half first."""
    data = b"".join(x.to_bytes(16, "little", signed=True) for x in numbers)
    return np.frombuffer(data, dtype="<u8").reshape(-1, 2)
