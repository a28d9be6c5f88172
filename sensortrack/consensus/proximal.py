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
FIRST_LOOK = 8
"""Dual steps after which groups are looked for; then after twice as many, and so on."""
SMALL = 200
"""Networks of up to so many places are divided by maximum flows at once."""
MEDIUM, PATIENCE = 4000, 256
"""Networks of up to so many places are divided after so many dual steps without groups: in C, for
in Python that would take minutes."""


@dataclass(frozen=True, eq=False)
class Proximal:
    """A point of the proximal map with what is known about it.

    Parameters
    ----------
    x : ndarray of float64, shape (n,)
        The point, by place.
    flow : ndarray of float64, shape (m,)
        Feasible, with x = y - B flow up to rounding.
    exact : bool
        The optimality conditions hold up to rounding.
    error : float
        Bound of the distance from the exact point: 0 if `exact`.
    iterations : int
        Dual steps taken.
    """

    x: Floats
    flow: Floats
    exact: bool
    error: float
    iterations: int


def proximal(
    links: Links,
    y: Floats,
    capacity: Floats,
    start: Floats | None = None,
    tolerance: float = 0.0,
    most: int = 10_000,
) -> Proximal:
    """Evaluate the proximal map of one component.

    Parameters
    ----------
    links : Links
    y : ndarray of float64, shape (n,)
        By place.
    capacity : ndarray of float64, shape (m,)
        Of each link, not negative.
    start : ndarray of float64, shape (m,), optional
        A flow to start from; that of a similar problem saves most of the work.
    tolerance : float, optional
        Distance from the exact point at which to stop.
    most : int, optional
        Dual steps after which to stop in any case.

    Returns
    -------
    Proximal

    Notes
    -----
    With d = B'x and x = y - B f the duality gap is sum (c |d| - f d). Each of the two objectives
    is off by half of |x - prox|^2 at least, hence |x - prox|^2 <= gap.

    On a forest a dynamic program finds the groups. Elsewhere, as soon as the links that are not
    saturated make groups of one value each, and a flow through a spanning forest of the groups says
    that these are optimal, the point is exact.
    """
    if links.forest is not None:
        flow = _over_forest(links, links.forest, y, capacity)
    elif start is None:
        flow = np.zeros(links.m)
    else:
        flow = np.clip(start, -capacity, capacity)
    grouped = agreed_groups(links, y, capacity, flow)
    if grouped is not None:
        return Proximal(*grouped, True, 0.0, 0)
    if links.n <= SMALL:
        return _divided(links, y, capacity, 0)
    return _ascended(Ascent(links, y, capacity, flow), tolerance, most)


def _ascended(ascent: Ascent, tolerance: float, most: int) -> Proximal:
    """Take dual steps until groups are found or the point is close enough."""
    links, done = ascent.links, 0
    given = links, ascent.y, ascent.capacity
    divisible = links.n <= MEDIUM and kernel("split", native=True).library is not None
    patience = min(PATIENCE, most) if divisible else most + 1
    while True:
        batch = min(max(FIRST_LOOK, done), most - done)
        ascent.advance(batch)
        done += batch
        grouped = agreed_groups(*given, ascent.flow)
        if grouped is not None:
            return Proximal(*grouped, True, 0.0, done)
        if done >= patience:
            return _divided(*given, done)
        x, gap = ascent.point()
        error = float(np.sqrt(gap))
        if error <= tolerance or done >= most:
            return Proximal(x, ascent.flow.copy(), False, error, done)


def _divided(links: Links, y: Floats, capacity: Floats, done: int) -> Proximal:
    """The point by maximum flows; groups that differ by rounding only are made one."""
    x, flow = split(links, y, capacity)
    grouped = agreed_groups(links, y, capacity, flow)
    return Proximal(*((x, flow) if grouped is None else grouped), True, 0.0, done)


def _over_forest(links: Links, forest: Forest, y: Floats, capacity: Floats) -> Floats:
    """Optimal flow of each link, by the dynamic program."""
    below = forest.below
    link = forest.link[below]
    most = np.zeros(links.n)
    most[below] = capacity[link]
    flow = np.empty(links.m)
    flow[link] = forest.toward * tree_flow(forest, y[forest.order], most)[below]
    return flow
