"""Undirected communication networks as exact, immutable values.

A :class:`Network` holds node names, an edge list whose order is kept (certificates refer to edges
by their place in it) and exact edge weights. Products of small networks (grids, tori, hypercubes)
remember their factors and list their edges only when somebody asks, so that what is decided from
the factors alone costs nothing even for millions of nodes.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from sensortrack.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from scipy.sparse import csr_matrix

MAX_EDGES = 50_000_000
"""Longest edge list that is built: 16 bytes an edge, so 0.8 GB."""


class DecimalNames(Sequence[str]):
    """The names ``"0"``, ``"1"``, … of a numbered family, made when asked for.

    Parameters
    ----------
    count : int
        How many names there are.
    """

    __slots__ = ("_count",)

    def __init__(self, count: int) -> None:
        self._count = count

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, index: int) -> str: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[str, ...]: ...
    def __getitem__(self, index: int | slice) -> str | tuple[str, ...]:
        found = range(self._count)[index]
        return str(found) if isinstance(found, int) else tuple(map(str, found))

    def __contains__(self, name: object) -> bool:
        return (
            isinstance(name, str)
            and name.isascii()
            and name.isdigit()
            and len(name) <= 18
            and name == str(int(name))
            and int(name) < self._count
        )

    def index(self, name: str, start: int = 0, stop: int | None = None) -> int:
        """Position of a name, in constant time.

        Raises
        ------
        ValueError
            If the name is not among those from `start` up to `stop`.
        """
        if name in self:
            number = int(name)
            if number in range(self._count)[slice(start, stop)]:
                return number
        raise ValueError(f"{name!r} is not in the sequence")

    def __repr__(self) -> str:
        return f"DecimalNames({self._count})"


@dataclass(frozen=True, eq=False, repr=False)
class Network:
    """A simple undirected graph with named nodes and exact edge weights.

    Parameters
    ----------
    names : sequence of str
        One name a node, all different, none empty; at least one.
    edges : ndarray of int64, shape (m, 2)
        Each undirected edge once, the smaller node number first, in the order in which it was
        read. The network keeps a read-only copy.
    weights : tuple of Fraction, optional
        One positive weight an edge, in the order of `edges`; None says that all are one.
    factors : tuple of Network, optional
        Two or more unweighted networks of which this one is the Cartesian product, numbered row
        by row: the node (i, j) of two factors has the number ``i * len(second) + j``. Empty if
        the network is not given as a product. See :meth:`product`.
    label : str, optional
        What the user typed: ``path:6``, ``edges.csv (sndlib_polska)``.

    Raises
    ------
    InputError
        With the name ``graph`` if the pieces do not make such a graph.

    Notes
    -----
    Two networks are equal only if they are the same object: comparing graphs by value is seldom
    what is meant and never cheap.
    """

    names: Sequence[str]
    edges: NDArray[np.int64]
    weights: tuple[Fraction, ...] | None = None
    factors: tuple[Network, ...] = ()
    label: str = ""

    def __post_init__(self) -> None:
        names = _checked_names(self.names)
        edges = _checked_edges(self.edges, names)
        object.__setattr__(self, "names", names)
        object.__setattr__(self, "edges", edges)
        object.__setattr__(self, "weights", _checked_weights(self.weights, len(edges)))
        object.__setattr__(self, "factors", tuple(self.factors))
        if self.factors:
            _check_factors(self)

    if not TYPE_CHECKING:  # a type checker would take __getattr__ as leave to use any name

        def __getattr__(self, name: str) -> Any:
            # Reached only by products, which are born without their edge list.
            if name != "edges":
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            edges = _product_edges(self.factors, self.label)
            object.__setattr__(self, "edges", edges)
            return edges

    @classmethod
    def product(cls, factors: Sequence[Network], label: str = "") -> Network:
        """Cartesian product of two or more unweighted networks, its edges listed when asked for.

        Parameters
        ----------
        factors : sequence of Network
            The factors; the first is the slowest (most significant) coordinate.
        label : str, optional
            What the user typed.

        Returns
        -------
        Network
            Nodes are called by their decimal numbers; edges are in lexicographic order.

        Raises
        ------
        InputError
            For fewer than two factors, or a weighted one. Asking the product for its `edges`
            raises it as well if there are more than ``MAX_EDGES``.
        """
        _check_factor_kinds(tuple(factors))
        network = object.__new__(cls)
        fields = {
            "names": DecimalNames(math.prod(factor.n for factor in factors)),
            "weights": None,
            "factors": tuple(factors),
            "label": label,
        }
        for name, value in fields.items():
            object.__setattr__(network, name, value)
        return network

    def __repr__(self) -> str:
        return f"Network({self.label!r}, n={self.n}, m={self.m})"

    @property
    def n(self) -> int:
        """Number of nodes."""
        return len(self.names)

    @property
    def m(self) -> int:
        """Number of edges."""
        if self.factors:
            return sum(factor.m * (self.n // factor.n) for factor in self.factors)
        return len(self.edges)

    def exact_weights(self) -> tuple[Fraction, ...]:
        """The weight of each of the m edges, in their order: one where none are given."""
        return self.weights or (Fraction(1),) * self.m

    def float_weights(self) -> NDArray[np.float64]:
        """The same in floating point, shape (m,)."""
        if self.weights is None:
            return np.ones(self.m)
        return np.array([float(weight) for weight in self.weights])

    def laplacian(self) -> csr_matrix:
        """Weighted Laplacian matrix.

        Returns
        -------
        csr_matrix of float64, shape (n, n)
            Degrees on the diagonal, minus the weight of each edge beside it.
        """
        from scipy.sparse import coo_matrix

        first, second = self.edges[:, 0], self.edges[:, 1]
        weights = self.float_weights()
        degrees = np.bincount(first, weights, self.n) + np.bincount(second, weights, self.n)
        diagonal = np.arange(self.n)
        rows = np.concatenate([first, second, diagonal])
        columns = np.concatenate([second, first, diagonal])
        values = np.concatenate([-weights, -weights, degrees])
        return coo_matrix((values, (rows, columns)), shape=(self.n, self.n)).tocsr()

    def components(self) -> list[list[int]]:
        """List the connected components.

        Returns
        -------
        list of list of int
            The node numbers of each component, increasing; the components ordered by their
            smallest node.
        """
        if self.factors and all(factor.is_connected() for factor in self.factors):
            return [list(range(self.n))]
        count, marks = self._marks()
        order = np.argsort(marks, kind="stable")
        ends = np.cumsum(np.bincount(marks, minlength=count))[:-1]
        return sorted((part.tolist() for part in np.split(order, ends)), key=_first)

    def is_connected(self) -> bool:
        """Whether every node can be reached from every other."""
        if self.factors:
            return all(factor.is_connected() for factor in self.factors)
        return self._marks()[0] == 1

    def is_tree(self) -> bool:
        """Whether the network is connected and has no cycle."""
        return self.m == self.n - 1 and self.is_connected()

    def subnetwork(self, nodes: Iterable[int]) -> Network:
        """Network induced by some of the nodes.

        Parameters
        ----------
        nodes : iterable of int
            Node numbers, in any order; repeating one changes nothing.

        Returns
        -------
        Network
            The nodes renumbered from 0 in increasing order, the edges between them in the order
            of this network's edge list. All the nodes give this very network.

        Raises
        ------
        InputError
            If there is no node, or a number that is no node.
        """
        kept = sorted({int(node) for node in nodes})
        if not kept or kept[0] < 0 or kept[-1] >= self.n:
            found = "no node" if not kept else f"nodes {kept[0]} to {kept[-1]}"
            raise InputError("nodes", found, f"one or more of the numbers 0 to {self.n - 1}")
        if len(kept) == self.n:
            return self
        renumbered = np.full(self.n, -1, dtype=np.int64)
        renumbered[kept] = np.arange(len(kept))
        edges = renumbered[self.edges]
        inside = (edges >= 0).all(axis=1)
        weights = self.weights
        if weights is not None:
            weights = tuple(weights[place] for place in np.flatnonzero(inside))
        return Network(tuple(self.names[i] for i in kept), edges[inside], weights, (), self.label)

    def to_data(self) -> dict[str, Any]:
        """Graph as a certificate holds it.

        Returns
        -------
        dict
            ``{"product": [...]}`` with the data of each factor, or ``{"nodes": [names],
            "edges": [[i, j], ...]}`` with ``"weights": ["1/2", ...]`` beside them unless all
            weights are one.
        """
        if self.factors:
            return {"product": [factor.to_data() for factor in self.factors]}
        data: dict[str, Any] = {"nodes": list(self.names), "edges": self.edges.tolist()}
        if self.weights is not None:
            data["weights"] = [str(weight) for weight in self.weights]
        return data

    def _marks(self) -> tuple[int, NDArray[np.int32]]:
        """Count the components and give each node the number of its own."""
        from scipy.sparse import coo_matrix
        from scipy.sparse.csgraph import connected_components

        ones = np.ones(self.m, dtype=np.int8)
        links = coo_matrix((ones, (self.edges[:, 0], self.edges[:, 1])), shape=(self.n, self.n))
        count, marks = connected_components(links, directed=False)
        return int(count), marks


def read_network(text: str, *, name: str | None = None, weight: str | None = None) -> Network:
    """Read a network from a file or make it from the name of a family.

    Parameters
    ----------
    text : str
        Path of a GraphML (``.graphml``, ``.xml``) or CSV (``.csv``) file, or a family with its
        numbers such as ``path:6`` or ``random_geometric:50,0.3,1``. A family wins over a file of
        the same name; ``./karate`` is the file.
    name : str, optional
        Which graph of a file that holds several.
    weight : str, optional
        The column or edge attribute with the edge weights; without it all are one.

    Returns
    -------
    Network
        With at least two nodes and one edge; it need not be connected.

    Raises
    ------
    InputError
        With the name ``graph`` or ``weight``.
    MissingExtra
        For ``karate`` without networkx.
    """
    from sensortrack.network_families import family_network, is_family

    if is_family(text):
        if name is not None:
            raise InputError("graph", f"the name {name!r} with a family", "a name only for a file")
        if weight is not None:
            raise InputError("weight", f"{weight!r} with a family", "a weight only for a file")
        network = family_network(text)
    else:
        from sensortrack.network_files import file_network

        network = file_network(text, name=name, weight=weight)
    if network.m == 0:
        found = f"{network.label} has {network.n} node(s) and no edge"
        raise InputError("graph", found, "two nodes or more and an edge between some of them")
    return network


def _first(part: list[int]) -> int:
    return part[0]


def _bad(found: str, needed: str, cure: str = "") -> InputError:
    return InputError("graph", found, needed, cure)


def _checked_names(names: Sequence[str]) -> Sequence[str]:
    if not isinstance(names, DecimalNames):
        if isinstance(names, str) or not all(isinstance(name, str) for name in names):
            raise _bad("node names that are not a list of texts", "one text a node")
        names = tuple(names)
        if "" in names:
            place = names.index("")
            raise _bad(f"node {place} has an empty name", "a name of one character or more")
        if len(set(names)) < len(names):
            name = Counter(names).most_common(1)[0][0]
            raise _bad(f"two nodes are called {name!r}", "a different name for every node")
    if not names:
        raise _bad("no node", "one node or more")
    return names


def _checked_edges(edges: Any, names: Sequence[str]) -> NDArray[np.int64]:
    array = np.asarray(edges)
    if array.size == 0:
        array = np.empty((0, 2), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != 2:
        raise _bad(f"an edge list of shape {array.shape}", "shape (m, 2)")
    if array.dtype.kind not in "iu":
        raise _bad(f"node numbers of type {array.dtype}", "whole numbers")
    if array.size and (array.min() < 0 or array.max() >= len(names)):
        found = f"edges between nodes {array.min()} to {array.max()}"
        raise _bad(found, f"node numbers from 0 to {len(names) - 1}")
    if array.dtype != np.int64 or array.flags.writeable:
        array = array.astype(np.int64)
        array.flags.writeable = False
    first, second = array[:, 0], array[:, 1]
    if not (first < second).all():
        place = int(np.flatnonzero(first >= second)[0])
        if first[place] == second[place]:
            found = f"edge {place} joins the node {names[int(first[place])]!r} to itself"
            raise _bad(found, "edges between different nodes")
        raise _bad(f"edge {place} is {array[place].tolist()}", "the smaller node number first")
    _check_simple(array, names)
    return array


def _check_simple(edges: NDArray[np.int64], names: Sequence[str]) -> None:
    """Refuse an edge that is listed twice."""
    keys = edges[:, 0] * len(names) + edges[:, 1]
    if (keys[1:] > keys[:-1]).all():
        return
    keys.sort()
    twice = keys[1:][keys[1:] == keys[:-1]]
    if twice.size:
        i, j = divmod(int(twice[0]), len(names))
        found = f"the edge between {names[i]!r} and {names[j]!r} is listed twice"
        raise _bad(found, "each edge once")


def _checked_weights(weights: Any, count: int) -> tuple[Fraction, ...] | None:
    if weights is None:
        return None
    weights = tuple(weights)
    if len(weights) != count:
        raise _bad(f"{len(weights)} weights for {count} edges", "one weight an edge")
    for place, weight in enumerate(weights):
        if isinstance(weight, bool) or not isinstance(weight, int | Fraction) or weight <= 0:
            raise _bad(f"edge {place} has the weight {weight!r}", "a positive whole or Fraction")
    return tuple(map(Fraction, weights))


def _check_factor_kinds(factors: tuple[Network, ...]) -> None:
    if len(factors) < 2:
        raise _bad(f"a product of {len(factors)} network(s)", "two factors or more")
    if any(factor.weights is not None for factor in factors):
        raise _bad("a product with a weighted factor", "factors without weights")


def _check_factors(network: Network) -> None:
    """Refuse factors whose product is another network: certificates rely on them."""
    _check_factor_kinds(network.factors)
    if network.weights is not None:
        raise _bad("a product with weights", "a product without weights")
    size = math.prod(factor.n for factor in network.factors)
    if size == network.n and network.m == len(network.edges):
        keys = np.sort(network.edges @ np.array([size, 1]))
        expected = _product_edges(network.factors, network.label) @ np.array([size, 1])
        if np.array_equal(keys, expected):
            return
    raise _bad("factors whose product is another network", "the factors of this network or none")


def _product_edges(factors: tuple[Network, ...], label: str) -> NDArray[np.int64]:
    """Edges of a Cartesian product in lexicographic order, read-only."""
    size = math.prod(factor.n for factor in factors)
    count = sum(factor.m * (size // factor.n) for factor in factors)
    if count > MAX_EDGES:
        found = f"{label or 'the product'} has {count} edges"
        raise _bad(found, f"at most {MAX_EDGES} where edges must be listed")
    keys = np.empty(count, dtype=np.int64)
    filled, before = 0, 1
    for factor in factors:
        after = size // (before * factor.n)
        outer = np.arange(before)[:, None, None] * (factor.n * after)
        inner = np.arange(after)[None, None, :]
        first, second = (factor.edges[None, :, k, None] * after for k in (0, 1))
        block = (outer + first + inner) * size + (outer + second + inner)
        keys[filled : filled + block.size] = block.ravel()
        filled += block.size
        before *= factor.n
    keys.sort()
    edges = np.empty((count, 2), dtype=np.int64)
    np.divmod(keys, size, out=(edges[:, 0], edges[:, 1]))
    edges.flags.writeable = False
    return edges
