"""The proximal map of total variation on a network, exactly, by maximum flows in whole numbers.

In C or in Python. The data are rounded to multiples of 2^-59 of the largest, and from there on all
is exact, so that both roads give the same point, bit by bit; the flows that prove it may differ.
"""

from __future__ import annotations

import ctypes
from math import frexp, ldexp

import numpy as np
from numpy.typing import NDArray

from .build import kernel
from .links import Links

Floats = NDArray[np.float64]
BITS = 59


def split(links: Links, y: Floats, capacity: Floats) -> tuple[Floats, Floats]:
    """Evaluate the proximal map.

    Parameters
    ----------
    links : Links
    y : ndarray of float64, shape (n,)
        By place, n below 2^20.
    capacity : ndarray of float64, shape (m,)
        Of each link, not negative.

    Returns
    -------
    x : ndarray of float64, shape (n,)
        One number for each group.
    flow : ndarray of float64, shape (m,)
        Within the capacities, y - B flow = x up to rounding.

    Notes
    -----
    A set of places whose mean can be reached by all through a feasible flow is a group. Else the
    source side of a least cut ends above the rest: links between are saturated, and both sides are
    asked in turn, which is the parametric maximum flow of the problem.

    References
    ----------
    D. Hochbaum (2001), *An efficient algorithm for image segmentation, Markov random fields and
    related problems*; A. Chambolle, J. Darbon (2009), *On total variation minimization and surface
    evolution using parametric maximum flows*.
    """
    exponent = BITS - frexp(float(np.max(np.abs(y))))[1]
    x, flow = np.empty(links.n), np.zeros(links.m)
    library = kernel("split", native=True).library
    if library is None:
        _Sets(links, y, capacity, exponent).run(x, flow)
        return x, np.clip(flow, -capacity, capacity)
    wide_links, wide_places = (
        np.empty((2, links.m, 2), np.int64),
        np.empty((2, links.n, 2), np.int64),
    )
    numbers = np.empty((6, links.n), dtype=np.int32)
    made = (x, flow, *wide_links, *wide_places, *numbers)
    task = _Split(
        links.n,
        *links.addresses[2:],
        y.ctypes.data,
        capacity.ctypes.data,
        exponent,
        *(array.ctypes.data for array in made),
    )
    library.sensortrack_split(ctypes.byref(task))
    return x, np.clip(flow, -capacity, capacity)


class _Split(ctypes.Structure):
    """``struct split`` of split.c."""

    _fields_ = (
        ("n", ctypes.c_int32),
        *((name, ctypes.c_void_p) for name in ("first", "index", "link", "y", "capacity")),
        ("exponent", ctypes.c_int32),
        *((name, ctypes.c_void_p) for name in ("x", "flow", "limit", "sent", "own", "rest")),
        *((name, ctypes.c_void_p) for name in ("node", "set", "stop", "level", "arc", "queue")),
    )


class _Sets:
    """The same in Python: sets of places that are asked whether they are groups."""

    def __init__(self, links: Links, y: Floats, capacity: Floats, exponent: int) -> None:
        highest = links.n << 61
        top = ldexp(highest, -exponent)
        self.limit = [
            round(ldexp(value, exponent)) if value < top else highest for value in capacity.tolist()
        ]
        self.own = [round(ldexp(value, exponent)) for value in y.tolist()]
        lists = zip(links.index.tolist(), links.link.tolist(), strict=True)
        entries, first = list(lists), links.first.tolist()
        self.near = [entries[first[i] : first[i + 1]] for i in range(links.n)]
        self.capacity, self.exponent = capacity.tolist(), exponent
        self.sent = [0] * links.m
        self.rest = [0] * links.n

    def run(self, x: Floats, flow: Floats) -> None:
        """Divide the places into groups; fill in their values and the flow."""
        waiting = [set(range(len(self.own)))]
        while waiting:
            part = waiting.pop()
            size, total = len(part), sum(self.own[i] for i in part)
            for i in part:
                self.rest[i] = size * self.own[i] - total
                for j, e in self.near[i]:
                    if j in part:
                        self.sent[e] = 0
            reached = self._sent_on(part)
            if reached:
                self._divide(part, reached, flow)
                waiting += [reached, part - reached]
                continue
            for i in part:
                x[i] = ldexp(float(total) / size, -self.exponent)
                for j, e in self.near[i]:
                    if j in part:
                        flow[e] = ldexp(float(self.sent[e]) / size, -self.exponent)

    def _divide(self, part: set[int], upper: set[int], flow: Floats) -> None:
        for i in upper:
            for j, e in self.near[i]:
                if j in part and j not in upper:
                    self.own[i] -= self.limit[e]
                    self.own[j] += self.limit[e]
                    flow[e] = self.capacity[e] if i < j else -self.capacity[e]

    def _sent_on(self, part: set[int]) -> set[int]:
        """Send all that can be sent; what is reached from places that still have too much."""
        while True:
            way: dict[int, tuple[int, int] | None]
            way = {i: None for i in sorted(part) if self.rest[i] > 0}
            queue, end = list(way), -1
            for i in queue:
                if self.rest[i] < 0:
                    end = i
                    break
                for j, e in self.near[i]:
                    if j in part and j not in way and self._room(i, j, e, len(part)) > 0:
                        way[j] = (i, e)
                        queue.append(j)
            if end < 0:
                return set(way)
            self._along(way, end, len(part))

    def _room(self, i: int, j: int, e: int, size: int) -> int:
        most = self.limit[e] * size
        return most - self.sent[e] if i < j else most + self.sent[e]

    def _along(self, way: dict[int, tuple[int, int] | None], end: int, size: int) -> None:
        """Send as much as one shortest way takes."""
        steps, j = [], end
        while (step := way[j]) is not None:
            steps.append((step[0], j, step[1]))
            j = step[0]
        most = min(self.rest[j], -self.rest[end], *(self._room(*s, size) for s in steps))
        for i, k, e in steps:
            self.sent[e] += most if i < k else -most
        self.rest[j] -= most
        self.rest[end] += most
