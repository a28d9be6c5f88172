"""Round a nearly optimal flow to groups of equal value, and prove them optimal.

In C or in NumPy with the same bits.
"""

from __future__ import annotations

import ctypes
from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import csgraph

from .build import kernel
from .links import Forest, Links, rooted

Floats = NDArray[np.float64]
ULP = 2.0**-52


def agreed_groups(
    links: Links, y: Floats, capacity: Floats, flow: Floats
) -> tuple[NDArray[np.bool_], Floats, Floats]:
    """Exact points of the proximal map, where the unsaturated links tell their groups.

    Parameters
    ----------
    links : Links
    y : ndarray of float64, shape (K, n), contiguous
        A row for each component, by place.
    capacity, flow : ndarray of float64, shape (K, m), contiguous
        Of each link, |flow| <= capacity.

    Returns
    -------
    found : ndarray of bool, shape (K,)
        Whether the other results of a row count.
    x, flow : ndarray of float64, shapes (K, n) and (K, m)
        The point, one number for each group, and a flow that proves it: up to rounding x = y - B
        flow, within the capacities, and saturated downhill between groups of different value.

    Notes
    -----
    Places joined by unsaturated links are a group. What its saturated links leave it, shared
    equally, is its value; linked groups whose values differ by rounding only are made one. What is
    then missing inside a group is sent along a spanning tree. Rounding means 4 sqrt(n) units in the
    last place of the largest |y| plus the largest capacity.
    """
    largest = np.abs(y).max(axis=1) + capacity.max(axis=1, initial=0.0)
    slack: Floats = 4 * ULP * float(np.sqrt(links.n)) * largest
    x, sent, found = np.empty_like(y), np.empty_like(flow), np.zeros(len(y), dtype=np.bool_)
    library = kernel("grouping", native=True).library
    if library is None:
        for k, given in enumerate(zip(y, capacity, flow, slack.tolist(), strict=True)):
            found[k], x[k], sent[k] = _in_numpy(links, *given)
        return found, x, sent
    inner, floats = np.empty(links.m, dtype=np.uint8), np.empty((3, links.n))
    numbers = np.empty((5, links.n), dtype=np.int32)
    task = _Groups(
        links.n,
        *links.addresses,
        *(array.ctypes.data for array in (y, capacity, flow)),
        0.0,
        *(array.ctypes.data for array in (x, sent, *floats, *numbers, inner)),
    )
    rows = (slack.ctypes.data, found.ctypes.data)
    _prepared(library)(ctypes.byref(task), len(y), *rows)
    return found, x, sent


@cache
def _prepared(library: ctypes.CDLL) -> ctypes._NamedFuncPointer:
    function: ctypes._NamedFuncPointer = library.sensortrack_agreed_groups
    function.argtypes = [ctypes.c_void_p, ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p]
    function.restype = None
    return function


class _Groups(ctypes.Structure):
    """``struct groups`` of grouping.c."""

    _fields_ = (
        ("n", ctypes.c_int32),
        *((name, ctypes.c_void_p) for name in ("below", "second", "first", "index", "link")),
        *((name, ctypes.c_void_p) for name in ("y", "capacity", "flow")),
        ("slack", ctypes.c_double),
        *((name, ctypes.c_void_p) for name in ("x", "sent", "rest", "mean", "more")),
        *((name, ctypes.c_void_p) for name in ("size", "group", "order", "up", "over", "inner")),
    )


def _in_numpy(
    links: Links, y: Floats, capacity: Floats, flow: Floats, slack: float
) -> tuple[bool, Floats, Floats]:
    first, second = links.ends[:, 0], links.second
    inner = np.abs(flow) < capacity
    while True:
        group = _groups(links, inner)
        between = group[first] != group[second]
        x = _values(group, y - links.incidence @ np.where(between, flow, 0.0))
        fall = x[first] - x[second]
        equal = between & (capacity > 0) & (np.abs(fall) <= slack)
        if not equal.any():
            break
        inner |= equal
    missing = y - x - links.incidence @ flow
    forest = rooted(links.n, links.ends[inner], np.flatnonzero(inner).astype(np.int32))
    sent = flow + _routed(links, forest, missing)
    held = (np.abs(sent) <= capacity + slack).all() and (flow * fall >= -slack * capacity).all()
    return bool(held), x, np.clip(sent, -capacity, capacity)


def _groups(links: Links, inner: NDArray[np.bool_]) -> NDArray[np.int32]:
    """Number of the group of each place."""
    ends = links.ends[inner]
    ones = np.ones(len(ends), dtype=np.int8)
    joined = sparse.coo_array((ones, (ends[:, 0], ends[:, 1])), shape=(links.n, links.n))
    found: NDArray[np.int32] = csgraph.connected_components(joined, directed=False)[1]
    return found


def _values(group: NDArray[np.int32], rows: Floats) -> Floats:
    """Mean of each group, at its members; taken twice, the second time of small numbers."""
    size = np.bincount(group)
    mean = np.bincount(group, rows) / size
    mean = mean + np.bincount(group, rows - mean[group]) / size
    found: Floats = mean[group]
    return found


def _routed(links: Links, forest: Forest, missing: Floats) -> Floats:
    """Flow of links that brings each place what it lacks, along the forest to the roots."""
    below = missing[forest.order].tolist()
    up, link = forest.up.tolist(), forest.link.tolist()
    found = np.zeros(links.m)
    for moment in range(links.n - 1, -1, -1):
        parent = up[moment]
        if parent >= 0:
            below[parent] += below[moment]
            found[link[moment]] = below[moment]
    found[forest.link[forest.below]] *= forest.toward
    return found
