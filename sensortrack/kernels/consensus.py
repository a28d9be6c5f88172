"""Explicit steps of sign consensus over all nodes: in C, else in NumPy; both give the same bits."""

from __future__ import annotations

import ctypes
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from .build import kernel

if TYPE_CHECKING:
    from .links import Links

Floats = NDArray[np.float64]
LANES = 8


def sign_step(
    links: Links,
    x: Floats,
    w: Floats,
    r: Floats,
    gain: Floats,
    weights: Floats | None = None,
    out: tuple[Floats, Floats] | None = None,
    part: tuple[int, int] | None = None,
) -> tuple[Floats, Floats]:
    """w+_i = w_i - gain * sum_j a_ij sgn(x_i - x_j) and x+_i = w+_i + r_i, with sgn(0) = 0.

    Parameters
    ----------
    links : Links
    x, w : ndarray of float64, shape (n, K), contiguous
        By place. A component that is NaN stays so at its own place, and its neighbours act as if
        it were equal to theirs.
    r : ndarray of float64, shape (n, K), contiguous
        By node.
    gain : ndarray of float64, shape (K,)
        Sampling period times the gain of each component.
    weights : ndarray of float64, shape (entries of the neighbour lists,), optional
        One each by default. See :meth:`Links.entry_weights`.
    out : pair of ndarray of float64, shape (n, K), contiguous, optional
        Where w+ and x+ go; the first may be `w`, the second must not be `x`.
    part : pair of int, optional
        Only the places from the first up to the second are written, the first a multiple of 8.
        Parts can be worked on at the same time.

    Returns
    -------
    w_out, x_out : ndarray of float64, shape (n, K)
        By place.
    """
    w_out, x_out = (np.empty_like(w), np.empty_like(x)) if out is None else out
    start, stop = part or (0, links.n)
    library = kernel("consensus", native=True).library
    if library is None:
        _in_numpy(links, x, w, r, gain, weights, w_out, x_out, slice(start, stop))
    elif x.shape[1] == 1 and weights is None:
        lists, width = links.slices, float(gain[0])
        numbers = (start // LANES, -(-stop // LANES), stop)
        arrays = _addresses(*lists, x, w, r, links.order)
        _prepared(library, "slices")(*numbers, *arrays, width, *_addresses(w_out, x_out))
    else:
        arrays = _addresses(links.first, links.index, weights, x, w, r, links.order, gain)
        function = _prepared(library, "rows")
        function(start, stop, x.shape[1], *arrays, *_addresses(w_out, x_out))
    return w_out, x_out


def _in_numpy(
    links: Links,
    x: Floats,
    w: Floats,
    r: Floats,
    gain: Floats,
    weights: Floats | None,
    w_out: Floats,
    x_out: Floats,
    part: slice,
) -> None:
    """Column by column, so that no more than a few arrays of links are needed at once."""
    values = np.ones(len(links.index)) if weights is None else weights
    toward = np.where(links.index > links.rows, values, -values)
    shape = (links.n, links.m)
    incidence = sparse.csr_array((toward, links.link, links.first), shape=shape)[part]
    place = part if links.order is None else links.order[part]
    for k in range(x.shape[1]):
        a, b = x[links.ends[:, 0], k], x[links.ends[:, 1], k]
        sums = incidence @ (np.greater(a, b).astype(np.float64) - np.less(a, b))
        np.subtract(w[part, k], gain[k] * sums, out=w_out[part, k])
        np.add(w_out[part, k], r[place, k], out=x_out[part, k])


def _addresses(*arrays: NDArray[np.generic] | None) -> list[int | None]:
    return [None if array is None else array.ctypes.data for array in arrays]


@cache
def _prepared(library: ctypes.CDLL, name: str) -> ctypes._NamedFuncPointer:
    function: ctypes._NamedFuncPointer = getattr(library, f"sensortrack_sign_{name}")
    address, number = ctypes.c_void_p, ctypes.c_int32
    function.restype = None
    if name == "rows":
        function.argtypes = [number] * 3 + [address] * 10
    else:
        function.argtypes = [number] * 3 + [address] * 6 + [ctypes.c_double] + [address] * 2
    return function
