"""A network laid out for loops over its links: neighbour lists, slices, a spanning forest."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import sparse
from scipy.sparse import csgraph

from sensortrack.errors import InputError
from sensortrack.networks import Network

Floats = NDArray[np.float64]
Int32s = NDArray[np.int32]
REORDERED = 10_000
"""Networks of more nodes are renumbered so that neighbours lie close together in memory."""
LANES = 8
LARGEST = 2**31 - 1


@dataclass(frozen=True, eq=False)
class Links:
    """The links of a network by places; a large network has its nodes at other places.

    Parameters
    ----------
    n : int
        Number of nodes.
    ends : ndarray of int32, shape (m, 2)
        The places of each link's ends, the smaller first, in lexicographic order.
    rank : ndarray of int64, shape (m,)
        The network's number of each of these links.
    weight : ndarray of float64, shape (m,), or None
        Of each of these links; None says that all are one.
    order : ndarray of int32, shape (n,), or None
        The node at each place; None says that node i is at place i.
    first, index, link : ndarray of int32
        The neighbours of place i are ``index[first[i]:first[i + 1]]``, increasing, over the links
        ``link[first[i]:first[i + 1]]``.
    """

    n: int
    ends: Int32s
    rank: NDArray[np.int64]
    weight: Floats | None
    order: Int32s | None
    first: Int32s
    index: Int32s
    link: Int32s

    @property
    def m(self) -> int:
        """Number of links."""
        return len(self.ends)

    def packed(self, rows: Floats) -> Floats:
        """Rows by node put at their places."""
        return rows if self.order is None else rows[self.order]

    def unpacked(self, rows: Floats) -> Floats:
        """Rows by place put back in the order of the nodes."""
        if self.order is None:
            return rows
        found = np.empty_like(rows)
        found[self.order] = rows
        return found

    @cached_property
    def degree(self) -> Floats:
        """Sum of the weights of the links of each place."""
        weight = self.weight
        first, second = self.ends[:, 0], self.ends[:, 1]
        found = np.bincount(first, weight, self.n) + np.bincount(second, weight, self.n)
        return found.astype(np.float64)

    @cached_property
    def rows(self) -> Int32s:
        """The place to which each entry of the neighbour lists belongs."""
        counts = np.diff(self.first)
        return np.repeat(np.arange(self.n, dtype=np.int32), counts)

    @cached_property
    def below(self) -> Int32s:
        """The links whose first end is place i: from ``below[i]`` to ``below[i + 1] - 1``."""
        found = np.searchsorted(self.ends[:, 0], np.arange(self.n + 1, dtype=np.int32))
        return found.astype(np.int32)

    @cached_property
    def second(self) -> Int32s:
        """The second end of each link, side by side."""
        return np.ascontiguousarray(self.ends[:, 1])

    @cached_property
    def addresses(self) -> tuple[int, ...]:
        """Where `below`, `second`, `first`, `index` and `link` lie in memory."""
        arrays = (self.below, self.second, self.first, self.index, self.link)
        return tuple(array.ctypes.data for array in arrays)

    @cached_property
    def slices(self) -> tuple[Int32s, Int32s]:
        """Neighbour lists of eight places side by side, filled up with the place itself."""
        count = -(-self.n // LANES)
        degrees = np.zeros(count * LANES, dtype=np.int64)
        degrees[: self.n] = np.diff(self.first)
        height = degrees.reshape(count, LANES).max(axis=1)
        start = np.concatenate([[0], np.cumsum(height)])
        own = np.arange(count * LANES, dtype=np.int32)
        own[self.n :] = 0
        filled = np.repeat(own.reshape(count, LANES), height, axis=0)
        column = np.arange(len(self.index)) - self.first[self.rows]
        filled[start[self.rows // LANES] + column, self.rows % LANES] = self.index
        return start.astype(np.int32), filled

    @cached_property
    def forest(self) -> Forest | None:
        """The links as a rooted forest, or None where they close a cycle."""
        found = rooted(self.n, self.ends, np.arange(self.m, dtype=np.int32), deep=True)
        return found if np.count_nonzero(found.up < 0) == self.n - self.m else None

    @cached_property
    def incidence(self) -> sparse.csr_array:
        """B, places by links: 1 at the first end of a link and -1 at the second."""
        toward = np.where(self.index > self.rows, 1.0, -1.0)
        return sparse.csr_array((toward, self.link, self.first), shape=(self.n, self.m))

    @cached_property
    def pace(self) -> Floats:
        """Step of each link's dual ascent: one over the links that share an end with it.

        The Hessian B'B has row sums of absolute values d_i + d_j, d the numbers of links.
        """
        counts = np.diff(self.first)
        sums: Floats = 1.0 / (counts[self.ends[:, 0]] + counts[self.ends[:, 1]])
        return sums

    def entry_weights(self, active: NDArray[np.bool_] | None) -> Floats | None:
        """Weight of each entry of the neighbour lists, 0 where its owner hears nothing.

        Parameters
        ----------
        active : ndarray of bool, shape (m,) or (m, 2), or None
            By the network's numbers of links: whether the link carries, or whether its first and
            its second end hear.
        """
        if active is None:
            return None if self.weight is None else self.weight[self.link]
        heard = active[self.rank][self.link]
        if heard.ndim == 2:
            node = self.rows if self.order is None else self.order[self.rows]
            other = self.index if self.order is None else self.order[self.index]
            heard = np.where(node < other, heard[:, 0], heard[:, 1])
        weights = heard.astype(np.float64)
        return weights if self.weight is None else weights * self.weight[self.link]

    def link_weights(self, active: NDArray[np.bool_] | None) -> Floats:
        """Weight of each link, 0 where it does not carry."""
        weights = np.ones(self.m) if self.weight is None else self.weight
        return weights if active is None else weights * active[self.rank]


@dataclass(frozen=True, eq=False)
class Forest:
    """A rooted forest, parents before children.

    Parameters
    ----------
    order : ndarray of int32, shape (n,)
        The place visited at each moment; parents come before children.
    up : ndarray of int32, shape (n,)
        The moment at which the parent was visited, -1 for a root.
    link : ndarray of int32, shape (n,)
        The link to the parent, -1 for a root.
    """

    order: Int32s
    up: Int32s
    link: Int32s

    @cached_property
    def below(self) -> NDArray[np.bool_]:
        """Whether each moment's place has a parent."""
        return self.link >= 0

    @cached_property
    def toward(self) -> Floats:
        """1 where the place is the first end of the link to its parent, else -1; roots left out."""
        order = self.order[self.below]
        return np.where(order < self.order[self.up[self.below]], 1.0, -1.0)


def links_of(network: Network) -> Links:
    """Layout of a network, made once and kept as long as the network is.

    Raises
    ------
    InputError
        With the name ``graph`` if it has more links than numbers of 32 bits can count.
    """
    found = _KNOWN.get(network)
    if found is None:
        found = _KNOWN[network] = _laid_out(network)
    return found


_KNOWN: WeakKeyDictionary[Network, Links] = WeakKeyDictionary()


def _laid_out(network: Network) -> Links:
    n = network.n
    if 2 * network.m > LARGEST or LANES * n > LARGEST:
        found = f"{n} nodes and {network.m} links"
        raise InputError(
            "graph", found, f"at most {LARGEST // LANES} nodes and {LARGEST // 2} links"
        )
    ends = network.edges.astype(np.int32)
    order = _close_together(n, ends) if n > REORDERED else None
    if order is not None:
        place = np.empty(n, dtype=np.int32)
        place[order] = np.arange(n, dtype=np.int32)
        ends = np.sort(place[ends], axis=1)
    rank = np.lexsort((ends[:, 1], ends[:, 0]))
    ends = np.ascontiguousarray(ends[rank])
    lists = _matrix(n, ends, np.arange(len(ends), dtype=np.int32))
    weight = None
    if network.weights is not None:
        weight = network.float_weights()[rank]
    return Links(n, ends, rank, weight, order, lists.indptr, lists.indices, lists.data)


def _matrix(n: int, ends: Int32s, values: Int32s) -> sparse.csr_array:
    """Symmetric matrix with a value a link, its rows in increasing order."""
    rows = np.concatenate([ends[:, 0], ends[:, 1]])
    columns = np.concatenate([ends[:, 1], ends[:, 0]])
    made = sparse.coo_array((np.concatenate([values, values]), (rows, columns)), shape=(n, n))
    found = made.tocsr()
    found.sort_indices()
    return found


def _close_together(n: int, ends: Int32s) -> Int32s:
    """Order of the nodes by reverse Cuthill-McKee."""
    lists = _matrix(n, ends, np.ones(len(ends), dtype=np.int32))
    return csgraph.reverse_cuthill_mckee(lists, symmetric_mode=True).astype(np.int32)


def rooted(n: int, ends: Int32s, link: Int32s, deep: bool = False) -> Forest:
    """Spanning forest of some links, from the lowest place of each component.

    Parameters
    ----------
    n : int
        Number of places.
    ends : ndarray of int32, shape (some, 2)
        In lexicographic order.
    link : ndarray of int32, shape (some,)
        What the forest calls them.
    deep : bool, optional
        Visit depth first, so that what lies below a place follows it at once, instead of breadth
        first.
    """
    lists = _matrix(n, ends, np.ones(len(ends), dtype=np.int32))
    count, marks = csgraph.connected_components(lists, directed=False)
    roots = np.unique(marks, return_index=True)[1].astype(np.int32)
    # one more place, linked with every root, makes one component of all
    above = np.stack([roots, np.full(count, n, dtype=np.int32)], axis=1)
    joined = _matrix(n + 1, np.concatenate([ends, above]), np.ones(len(ends) + count, np.int32))
    visit = csgraph.depth_first_order if deep else csgraph.breadth_first_order
    visited, parent = visit(joined, n, directed=False)
    order = visited[1:].astype(np.int32)
    moment = np.full(n + 1, -1, dtype=np.int32)
    moment[order] = np.arange(n, dtype=np.int32)
    parents = parent[order]
    low, high = np.minimum(order, parents), np.maximum(order, parents)
    keys = ends[:, 0].astype(np.int64) * (n + 1) + ends[:, 1]
    place = np.searchsorted(keys, low.astype(np.int64) * (n + 1) + high)
    named = np.append(link, np.int32(-1))
    found = np.where(parents == n, np.int32(-1), named[np.minimum(place, len(link))])
    return Forest(order, moment[parents], found.astype(np.int32))


def checked_active(active: ArrayLike | None, m: int, ways: int) -> NDArray[np.bool_] | None:
    """Which links carry.

    Raises
    ------
    InputError
        With the name ``active``: not one truth value a link, or, where both ways are told apart,
        two.
    """
    if active is None:
        return None
    given = np.asarray(active)
    shapes = [(m,)] if ways == 1 else [(m,), (m, 2)]
    if given.dtype != np.bool_ or given.shape not in shapes:
        found = f"{given.dtype} of shape {given.shape}"
        needed = " or ".join(map(str, shapes))
        raise InputError("active", found, f"truth values of shape {needed} are needed")
    return given
