"""The proximal map of total variation on a forest by dynamic programming, in C or in Python."""

from __future__ import annotations

import ctypes
from heapq import heappop, heappush

import numpy as np
from numpy.typing import NDArray

from .build import kernel
from .links import Forest

Floats = NDArray[np.float64]
SHORT = 1 - 2.0**-52
_Entry = tuple[float, int, list[float]]


def tree_flow(forest: Forest, y: Floats, capacity: Floats) -> Floats:
    """Optimal flow towards the parents.

    Parameters
    ----------
    forest : Forest
    y : ndarray of float64, shape (n,)
        By moment of the visit.
    capacity : ndarray of float64, shape (n,)
        Of the link to the parent; what stands beside a root is not read.

    Returns
    -------
    ndarray of float64, shape (n,)
        By moment, saturated exactly where a place and its parent differ; 0 at roots.

    References
    ----------
    V. Kolmogorov, T. Pock, M. Rolinek (2016), *Total variation on a tree*; for paths N. Johnson
    (2013), *A dynamic programming algorithm for the fused lasso*.
    """
    library = kernel("tree", native=True).library
    if library is None:
        return _in_python(forest, y, capacity)
    n = len(y)
    is_path = bool((forest.up == np.arange(-1, n - 1)).all())
    x, high, total, flow = np.empty((4, n))
    top = np.empty(0 if is_path else 2 * n, dtype=np.int32)
    kinks = np.empty((2 * n, 2 if is_path else 4))
    arrays = (forest.up, y, capacity, x, high, total, flow, top, kinks)
    task = _Tree(n, *(array.ctypes.data for array in arrays))
    (library.sensortrack_path if is_path else library.sensortrack_tree)(ctypes.byref(task))
    return flow


class _Tree(ctypes.Structure):
    """``struct tree`` of tree.c."""

    _fields_ = (
        ("n", ctypes.c_int32),
        *((name, ctypes.c_void_p) for name in ("up", "y", "capacity", "x", "high", "sum")),
        *((name, ctypes.c_void_p) for name in ("flow", "top", "kink")),
    )


def _in_python(forest: Forest, y: Floats, capacity: Floats) -> Floats:
    """The same recursion with the heaps of the standard library, the smaller put into the larger.

    A kink is [place, bend]; the heaps hold (place, serial number, kink), the upper with the sign
    turned, and a kink with bend 0 is struck out.
    """
    up, size, values = forest.up.tolist(), capacity.tolist(), y.tolist()
    n = len(values)
    heaps: list[tuple[list[_Entry], list[_Entry]]] = [([], []) for _ in range(n)]
    total, low, high = [0.0] * n, [0.0] * n, [0.0] * n
    for v in range(n - 1, -1, -1):
        lower, upper = heaps[v]
        if up[v] < 0:
            low[v] = _reach(lower, 1, -values[v] - total[v], 0.0)[0]
            continue
        c = size[v]
        low[v], rise = _reach(lower, 1, -values[v] - total[v], -c)
        high[v], fall = _reach(upper, -1, -values[v] + total[v], c)
        high[v] = max(low[v], high[v])
        for number, kink in ((2 * v, [low[v], rise]), (2 * v + 1, [high[v], -fall])):
            heappush(lower, (kink[0], number, kink))
            heappush(upper, (-kink[0], number, kink))
        total[up[v]] += c
        heaps[up[v]] = (_melded(heaps[up[v]][0], lower), _melded(heaps[up[v]][1], upper))
        heaps[v] = ([], [])
    return _settled(up, values, size, low, high)


def _melded(one: list[_Entry], two: list[_Entry]) -> list[_Entry]:
    large, small = (one, two) if len(one) >= len(two) else (two, one)
    for entry in small:
        heappush(large, entry)
    return large


def _reach(heap: list[_Entry], sign: int, offset: float, level: float) -> tuple[float, float]:
    """Where the function reaches a level, seen from below or above, and the slope there."""
    slope = 1.0
    while heap:
        at, bend = heap[0][2]
        if bend != 0 and sign * (slope * at + offset - level) >= 0:
            break
        slope += sign * bend
        offset -= sign * bend * at
        heappop(heap)[2][1] = 0.0
    return (level - offset) / slope, slope


def _settled(
    up: list[int], y: list[float], capacity: list[float], low: list[float], high: list[float]
) -> Floats:
    """Values from the roots on, then the flow that they ask for."""
    n = len(y)
    x, flow = low[:], [0.0] * n
    for v in range(n):
        if up[v] >= 0:
            x[v] = min(max(x[up[v]], low[v]), high[v])
    for v in range(n - 1, -1, -1):
        rest, c = y[v] - x[v] + flow[v], capacity[v]
        flow[v] = 0.0
        if up[v] >= 0:
            side = (x[v] > x[up[v]]) - (x[v] < x[up[v]])
            most = c * SHORT
            flow[v] = side * c if side else min(max(rest, -most), most)
            flow[up[v]] += flow[v]
    return np.array(flow)
