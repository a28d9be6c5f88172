"""Accelerated ascent of the dual of a total-variation problem on a network."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .links import Links

Floats = NDArray[np.float64]
ROUNDING = 2.0**-50


def ascend(
    links: Links,
    y: Floats,
    capacity: Floats,
    flow: Floats,
    ahead: Floats,
    momentum: float,
    count: int,
) -> tuple[Floats, Floats, float]:
    """Take dual steps: f = clip(z + pace B'(y - B z)), z = f + momentum (f - former f).

    Parameters
    ----------
    links : Links
    y : ndarray of float64, shape (n,)
        By place.
    capacity : ndarray of float64, shape (m,)
        Bound of each flow.
    flow, ahead : ndarray of float64, shape (m,)
        f and the extrapolated z; the same at the start.
    momentum : float
        Number from which the extrapolation follows; 1 at the start.
    count : int
        Steps.

    Returns
    -------
    flow, ahead, momentum
        As given, after the steps.

    References
    ----------
    A. Beck, M. Teboulle (2009), FISTA; B. O'Donoghue, E. Candes (2015), restart where the step
    turns against the momentum.
    """
    first, second = links.ends[:, 0], links.ends[:, 1]
    for _ in range(count):
        x = y - links.incidence @ ahead
        found = np.clip(ahead + links.pace * (x[first] - x[second]), -capacity, capacity)
        moved = found - flow
        if np.dot((ahead - found) / links.pace, moved) > 0:
            momentum, ahead = 1.0, found
        else:
            later = (1 + np.sqrt(1 + 4 * momentum * momentum)) / 2
            ahead = found + (momentum - 1) / later * moved
            momentum = float(later)
        flow = found
    return flow, ahead, momentum


def gap(links: Links, x: Floats, capacity: Floats, flow: Floats) -> float:
    """Duality gap of x = y - B f: sum of c |d| - f d over the links, d = B'x.

    Returns
    -------
    float
        Not below the gap in exact arithmetic: rounding of x and of the sum is added.
    """
    d = x[links.ends[:, 0]] - x[links.ends[:, 1]]
    size = float(np.dot(capacity, np.abs(d)))
    scale = float(np.max(np.abs(x), initial=0.0)) * float(capacity.sum())
    return max(size - float(np.dot(flow, d)), 0.0) + ROUNDING * (size + scale)
