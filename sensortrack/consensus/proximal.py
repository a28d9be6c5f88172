"""The proximal map of total variation on a network, exact where it can be, else within a bound.

For numbers y at the nodes and capacities c of the links it is

    prox(y) = argmin over x of 1/2 |x - y|^2 + sum over links ij of c_ij |x_i - x_j|.

Its dual seeks a flow f with |f_ij| <= c_ij such that x = y - B f is as short as can be, so that the
sum over the nodes of each component is kept whatever flow one stops at.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.kernels.build import kernel
from sensortrack.kernels.dual import Ascent
from sensortrack.kernels.grouping import agreed_groups
from sensortrack.kernels.links import Forest, Links
from sensortrack.kernels.split import split
from sensortrack.kernels.tree import tree_flow

Floats = NDArray[np.float64]
ULP = 2.0**-52
FIRST_LOOK = 8
"""Dual steps after which groups are looked for; then after twice as many, and so on."""
SMALL = 200
"""Networks of up to so many places are divided by maximum flows at once."""
MEDIUM, PATIENCE = 4000, 256
"""Networks of up to so many places are divided after so many dual steps without groups: in C, for
in Python that would take minutes."""


@dataclass(frozen=True, eq=False)
class Proximal:
    """Points of the proximal map with what is known about them.

    Parameters
    ----------
    x : ndarray of float64, shape (K, n)
        A point in each row, by place.
    flow : ndarray of float64, shape (K, m)
        Feasible, with x = y - B flow up to rounding.
    error : ndarray of float64, shape (K,)
        Bound of the distance from the exact point: 0 where the optimality conditions hold up to
        rounding.
    iterations : int
        Most dual steps taken for a row.
    """

    x: Floats
    flow: Floats
    error: Floats
    iterations: int


def proximal(
    links: Links,
    y: Floats,
    capacity: Floats,
    start: Floats | None = None,
    tolerance: float = 0.0,
    most: int = 10_000,
) -> Proximal:
    """Evaluate the proximal map of some components.

    Parameters
    ----------
    links : Links
    y : ndarray of float64, shape (K, n), contiguous
        A row for each component, by place.
    capacity : ndarray of float64, shape (K, m), contiguous
        Of each link, not negative.
    start : ndarray of float64, shape (K, m), optional
        A flow to start from; that of a similar problem saves most of the work.
    tolerance : float, optional
        Distance from the exact point at which to stop; sooner where rounding hides what is left.
    most : int, optional
        Dual steps after which to stop in any case.

    Returns
    -------
    Proximal

    Notes
    -----
    With d = B'x and x = y - B f the duality gap is sum (c |d| - f d). Each of the two objectives
    is off by half of |x - prox|^2 at least, hence |x - prox|^2 <= gap.

    As soon as the links that are not saturated make groups of one value each, and a flow through a
    spanning forest of the groups says that these are optimal, the point is exact. On small networks
    maximum flows find such groups, on forests a dynamic program, elsewhere dual ascent.
    """
    flow = np.zeros_like(capacity) if start is None else np.clip(start, -capacity, capacity)
    found, x, sent = agreed_groups(links, y, capacity, flow)
    error, iterations = np.zeros(len(y)), 0
    for k in np.flatnonzero(~found):
        solver = _Row(links, y[k], capacity[k], tolerance, most)
        x[k], sent[k], error[k], done = solver.run(flow[k])
        iterations = max(iterations, done)
    return Proximal(x, sent, error, iterations)


@dataclass(frozen=True, eq=False)
class _Row:
    """The problem of one component."""

    links: Links
    y: Floats
    capacity: Floats
    tolerance: float
    most: int

    def run(self, flow: Floats) -> tuple[Floats, Floats, float, int]:
        """Point, flow, bound of the distance, and dual steps taken."""
        if self.links.n <= SMALL:
            return *self._divided(), 0.0, 0
        if self.links.forest is not None:
            grouped = self._grouped(self._over_forest(self.links.forest))
            if grouped is not None:
                return *grouped, 0.0, 0
        return self._ascended(flow)

    def _grouped(self, flow: Floats) -> tuple[Floats, Floats] | None:
        found, x, sent = agreed_groups(self.links, self.y[None], self.capacity[None], flow[None])
        return (x[0], sent[0]) if found[0] else None

    def _divided(self) -> tuple[Floats, Floats]:
        """By maximum flows; groups that differ by rounding only are made one."""
        x, flow = split(self.links, self.y, self.capacity)
        return self._grouped(flow) or (x, flow)

    def _over_forest(self, forest: Forest) -> Floats:
        """Optimal flow of each link, by the dynamic program."""
        below = forest.below
        link = forest.link[below]
        most = np.zeros(self.links.n)
        most[below] = self.capacity[link]
        flow = np.empty(self.links.m)
        flow[link] = forest.toward * tree_flow(forest, self.y[forest.order], most)[below]
        return flow

    def _ascended(self, flow: Floats) -> tuple[Floats, Floats, float, int]:
        """Dual steps until groups are found or the point is close enough.

        They are taken on y less its mean, which changes no difference and leaves less to rounding.
        """
        middle = float(self.y.mean())
        ascent, done = Ascent(self.links, self.y - middle, self.capacity, flow), 0
        rounding = ULP * float(np.sqrt(self.links.n)) * float(np.abs(self.y).max())
        divisible = self.links.n <= MEDIUM and kernel("split", native=True).library is not None
        patience = min(PATIENCE, self.most) if divisible else self.most + 1
        while True:
            batch = min(max(FIRST_LOOK, done), self.most - done)
            ascent.advance(batch)
            done += batch
            grouped = self._grouped(ascent.flow)
            if grouped is None and done >= patience:
                grouped = self._divided()
            if grouped is not None:
                return *grouped, 0.0, done
            x, gap, hidden = ascent.point()
            error = float(np.sqrt(gap)) + rounding
            if error <= self.tolerance or gap <= 2 * hidden or done >= self.most:
                return x + middle, ascent.flow.copy(), error, done
