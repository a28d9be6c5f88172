"""Accelerated ascent of the dual of a total-variation problem on a network, in C or in NumPy.

Steps of both roads agree bit by bit until a momentum is restarted, which the sign of a sum over all
links decides; sums are taken in another order.
"""

from __future__ import annotations

import ctypes
from functools import cache

import numpy as np
from numpy.typing import NDArray

from .build import kernel
from .links import Links

Floats = NDArray[np.float64]
ROUNDING = 2.0**-50


class Ascent:
    """Dual steps f+ = clip(z + pace B'(y - B z)) with z = f + factor (f - former f).

    Parameters
    ----------
    links : Links
    y : ndarray of float64, shape (n,)
        By place.
    capacity : ndarray of float64, shape (m,)
        Bound of each flow.
    flow : ndarray of float64, shape (m,)
        A feasible flow to start from.

    References
    ----------
    A. Beck, M. Teboulle (2009), FISTA; B. O'Donoghue, E. Candes (2015), restart where the step
    turns against the momentum.
    """

    def __init__(self, links: Links, y: Floats, capacity: Floats, flow: Floats) -> None:
        self.links, self.y, self.capacity = links, y, capacity
        self._both = np.stack([flow, flow])
        self._speed = np.array([1.0, 0.0])
        self._x = np.empty(links.n)
        self._library = kernel("dual", native=True).library

    @property
    def flow(self) -> Floats:
        """The feasible flow reached, shape (m,)."""
        found: Floats = self._both[0]
        return found

    def advance(self, count: int) -> None:
        """Take some steps."""
        if self._library is None:
            self._in_numpy(count)
            return
        links = self.links
        arrays = (self.y, self.capacity, links.pace, self._both, self._x, self._speed)
        addresses = [array.ctypes.data for array in arrays]
        call = _prepared(self._library, "ascend")
        call(links.n, *links.addresses[:2], *addresses, count)

    def point(self) -> tuple[Floats, float, float]:
        """x = y - B f and the duality gap there, the sum of c |d| - f d with d = B'x.

        Returns
        -------
        x : ndarray of float64, shape (n,)
        gap : float
            Not below the gap in exact arithmetic: what rounding may have hidden is added.
        hidden : float
            How much that is.
        """
        x = np.empty(self.links.n)
        if self._library is None:
            x = self.y - self.links.incidence @ self.flow
            fall = self._fall(x)
            most = self.capacity * np.abs(fall)
            size, lost = float(most.sum()), float((most - self.flow * fall).sum())
        else:
            total = ctypes.c_double()
            arrays = (self.y, self.capacity, self.flow, x)
            addresses = (*self.links.addresses[:2], *(array.ctypes.data for array in arrays))
            call = _prepared(self._library, "gap")
            lost = call(self.links.n, *addresses, ctypes.byref(total))
            size = total.value
        scale = float(np.max(np.abs(x), initial=0.0)) * float(self.capacity.sum())
        hidden = ROUNDING * (size + scale)
        return x, max(lost, 0.0) + hidden, hidden

    def _fall(self, x: Floats) -> Floats:
        found: Floats = x[self.links.ends[:, 0]] - x[self.links.second]
        return found

    def _in_numpy(self, count: int) -> None:
        for _ in range(count):
            flow, former = self._both
            ahead = flow + self._speed[1] * (flow - former)
            fall = self._fall(self.y - self.links.incidence @ ahead)
            found = np.clip(ahead + self.links.pace * fall, -self.capacity, self.capacity)
            turn = np.dot(fall, found - flow)
            self._both = np.stack([found, flow])
            momentum = self._speed[0]
            later = (1 + np.sqrt(1 + 4 * momentum * momentum)) / 2
            speed = [1.0, 0.0] if turn < 0 else [later, (momentum - 1) / later]
            self._speed = np.array(speed)


@cache
def _prepared(library: ctypes.CDLL, name: str) -> ctypes._NamedFuncPointer:
    function: ctypes._NamedFuncPointer = getattr(library, f"sensortrack_{name}")
    address, number = ctypes.c_void_p, ctypes.c_int32
    if name == "ascend":
        function.argtypes = [number] + [address] * 8 + [number]
        function.restype = None
    else:
        function.argtypes = [number] + [address] * 7
        function.restype = ctypes.c_double
    return function
