"""How far explicit steps keep agents apart: a proved bound from the degrees of the network."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import csgraph

from sensortrack.errors import InputError
from sensortrack.kernels.links import Links

Floats = NDArray[np.float64]


def chatter_bound(
    links: Links, gains: Floats, h: float, gamma: float = 0.0, rate: float | None = None
) -> Floats:
    """Norm of the disagreement below which explicit steps end up, whatever they start from.

    Parameters
    ----------
    links : Links
    gains : ndarray of float64, shape (K,)
        In units of the signal per s.
    h : float
        Sampling period in s.
    gamma : float, optional
        Bound of each signal's rate of change, in its units per s.
    rate : float, optional
        A rate r at which the disagreement is known to shrink in continuous time, in the same
        units per s; by default what holds for every connected network of that size.

    Returns
    -------
    ndarray of float64, shape (K,)
        In units of the signal; for a disconnected network of its worst component; infinite where
        the gain is too small for the rate to be above zero.

    Raises
    ------
    InputError
        With the name ``gamma`` or ``rate``: negative, or not finite.

    Notes
    -----
    A step takes x to x - h (beta B s - M u) with |B s|^2 <= S = sum of the squared degrees, |M u|
    <= gamma sqrt(n) and (x, beta B s - M u) >= r |x|. Hence |x+|^2 <= |x|^2 - 2 h r |x| + h^2 Q
    with Q = (beta sqrt(S) + gamma sqrt(n))^2: |x| decreases above h Q / (2 r), and from below it
    the step leads to max(h sqrt(Q), h Q / (2 r)) at most. A cut with s nodes inside has a weight k
    of at least the lightest link's, a, and p = s (n - s)/n <= n/4, so that r = min (beta k - 2
    gamma p)/sqrt(p) is not below 2 (beta a - gamma n/2)/sqrt(n).
    """
    for name, value in (("gamma", gamma), ("rate", rate)):
        if value is not None and not (np.isfinite(value) and value >= 0):
            raise InputError(name, f"{value}", "a finite number of 0 or more is needed")
    if links.m == 0:
        return np.zeros_like(gains)
    first, second = links.ends[:, 0], links.ends[:, 1]
    pairs = sparse.coo_array((np.ones(links.m), (first, second)), shape=(links.n, links.n))
    group = csgraph.connected_components(pairs, directed=False)[1]
    size = np.bincount(group)
    squares = np.bincount(group, links.degree**2)
    lightest = np.full(len(size), np.inf)
    np.minimum.at(lightest, group[first], 1.0 if links.weight is None else links.weight)
    linked = size > 1
    size, squares, lightest = size[linked], squares[linked], lightest[linked]
    beta = gains[:, None]
    pushed = h**2 * (beta * np.sqrt(squares) + gamma * np.sqrt(size)) ** 2
    shrinking = 2 * (beta * lightest - gamma * size / 2) / np.sqrt(size)
    if rate is not None:
        shrinking = np.full_like(shrinking, rate)
    held = np.full_like(pushed, np.inf)
    np.divide(pushed, 2 * h * shrinking, out=held, where=shrinking > 0)
    held[pushed == 0] = 0
    found: Floats = np.maximum(np.sqrt(pushed), held).max(axis=1)
    return found
