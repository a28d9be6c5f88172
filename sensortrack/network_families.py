"""Families of networks by name: ``path:6``, ``grid:3,4``, ``hypercube:10``.

Nodes are numbered from 0 and called by their numbers; edges are in lexicographic order.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from sensortrack.errors import InputError, MissingExtra
from sensortrack.networks import MAX_EDGES, DecimalNames, Network

if TYPE_CHECKING:
    from numpy.typing import NDArray

MAX_NODES = 50_000_000
"""Largest number of nodes that a family may have."""

_TEXTS: dict[type, re.Pattern[str]] = {
    int: re.compile(r"[0-9]{1,40}"),
    float: re.compile(r"([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?"),
}
"""What numbers look like: no sign, underscore, nan or inf."""


@dataclass(frozen=True)
class Family:
    """How a family is typed and made.

    Parameters
    ----------
    usage : str
        What to type, ``grid:a,b``.
    takes : str
        Which numbers it takes, in words.
    kinds : tuple of type
        ``int`` or ``float`` for each number.
    fits : callable
        Whether numbers of these kinds will do.
    build : callable
        Makes the network from the label and the numbers.
    """

    usage: str
    takes: str
    kinds: tuple[type, ...]
    fits: Callable[..., bool]
    build: Callable[..., Network]

    def numbers(self, arguments: list[str]) -> list[float] | None:
        """Read the numbers, or return None if the family does not take them."""
        if len(arguments) != len(self.kinds):
            return None
        pairs = list(zip(self.kinds, arguments, strict=True))
        if not all(_TEXTS[kind].fullmatch(argument) for kind, argument in pairs):
            return None
        numbers = [kind(argument) for kind, argument in pairs]
        return numbers if self.fits(*numbers) else None


def is_family(text: str) -> bool:
    """Whether the part of `text` before the colon is the name of a family."""
    return _kind(text) in FAMILIES


def family_network(text: str) -> Network:
    """Network of a family.

    Parameters
    ----------
    text : str
        The family and its numbers, as the usages in `FAMILIES` say.

    Returns
    -------
    Network
        Labelled by `text` without spaces. Grids, tori and hypercubes carry their factors unless a
        factor would be a single node.

    Raises
    ------
    InputError
        With the name ``graph``, saying what the family takes.
    MissingExtra
        For ``karate`` without networkx.
    """
    kind, (_, colon, rest) = _kind(text), text.partition(":")
    if kind not in FAMILIES:
        raise unknown_graph(text)
    family = FAMILIES[kind]
    arguments = [argument.strip() for argument in rest.split(",")] if colon else []
    numbers = family.numbers(arguments)
    if numbers is None:
        needed = f"{kind} takes {family.takes}"
        raise InputError("graph", _quoted(text), needed, f"Type {family.usage}")
    return family.build(kind + colon + ",".join(arguments), *numbers)


def unknown_graph(text: str) -> InputError:
    """Error for a text that is neither a family nor a file, with the nearest family."""
    from difflib import get_close_matches

    usages = {kind: family.usage for kind, family in FAMILIES.items()}
    near = get_close_matches(_kind(text).lower(), usages, n=1)
    lines = [f"Did you mean {usages[near[0]]}?"] if near else []
    lines.append("Families: " + " ".join(usages.values()))
    lines.append("Files: GraphML (.graphml, .xml) or CSV with the columns source,target (.csv)")
    found = f"{_quoted(text)} is not a family, and there is no such file"
    return InputError("graph", found, "a family or a file that exists", "\n".join(lines))


def _kind(text: str) -> str:
    return text.partition(":")[0].strip()


def _quoted(text: str) -> str:
    return repr(text if len(text) <= 100 else text[:100] + "…")


def _network(label: str, n: int, edges: NDArray[np.int64]) -> Network:
    edges.flags.writeable = False  # spares the network its own copy
    return Network(DecimalNames(n), edges, None, (), label)


def _check_size(label: str, n: int, m: int) -> None:
    if n > MAX_NODES or m > MAX_EDGES:
        needed = f"at most {MAX_NODES} nodes and {MAX_EDGES} edges"
        raise InputError("graph", f"{label} has {n} nodes and {m} edges", needed)


def _path(label: str, n: int) -> Network:
    _check_size(label, n, n - 1)
    return _network(label, n, np.column_stack([np.arange(n - 1), np.arange(1, n)]))


def _cycle(label: str, n: int) -> Network:
    _check_size(label, n, n)
    edges = np.empty((n, 2), dtype=np.int64)
    edges[0], edges[1] = (0, 1), (0, n - 1)
    edges[2:, 0] = np.arange(1, n - 1)
    edges[2:, 1] = np.arange(2, n)
    return _network(label, n, edges)


def _complete(label: str, n: int) -> Network:
    _check_size(label, n, n * (n - 1) // 2)
    after = np.arange(n - 1, -1, -1)  # how many nodes come after each
    first = np.repeat(np.arange(n), after)
    starts = np.repeat(np.cumsum(after) - after, after)
    second = first + 1 + np.arange(len(first)) - starts
    return _network(label, n, np.column_stack([first, second]))


def _star(label: str, n: int) -> Network:
    _check_size(label, n, n - 1)
    return _network(label, n, np.column_stack([np.zeros(n - 1, np.int64), np.arange(1, n)]))


def _bipartite(label: str, a: int, b: int) -> Network:
    _check_size(label, a + b, a * b)
    first, second = np.repeat(np.arange(a), b), np.tile(np.arange(a, a + b), a)
    return _network(label, a + b, np.column_stack([first, second]))


def _grid(label: str, a: int, b: int) -> Network:
    if min(a, b) == 1:
        return _path(label, a * b)
    _check_size(label, a * b, 0)
    return Network.product([_path(f"path:{a}", a), _path(f"path:{b}", b)], label)


def _torus(label: str, a: int, b: int) -> Network:
    _check_size(label, a * b, 0)
    return Network.product([_cycle(f"cycle:{a}", a), _cycle(f"cycle:{b}", b)], label)


def _hypercube(label: str, d: int) -> Network:
    if d == 1:
        return _path(label, 2)
    return Network.product([_path("path:2", 2)] * d, label)


def _petersen(label: str) -> Network:
    around = np.arange(5)
    outer = np.column_stack([around, (around + 1) % 5])
    spokes = np.column_stack([around, around + 5])
    inner = np.column_stack([around + 5, (around + 2) % 5 + 5])
    return _network(label, 10, _sorted(np.concatenate([outer, spokes, inner])))


def _karate(label: str) -> Network:
    """Zachary's karate club [1]_ without its weights, as networkx numbers it.

    References
    ----------
    .. [1] W. W. Zachary, "An information flow model for conflict and fission in small groups",
       Journal of Anthropological Research 33(4), 1977.
    """
    try:
        from networkx import karate_club_graph
    except ImportError as missing:
        raise MissingExtra("networkx", "verify") from missing
    return _network(label, 34, _sorted(np.array(list(karate_club_graph().edges()))))


def _random_geometric(label: str, n: int, radius: float, seed: int) -> Network:
    """Points drawn in the unit square, joined where their distance is at most the radius.

    The distance is computed once an edge, ``sqrt(dx*dx + dy*dy)`` in float64, and compared with
    the radius as it is; the tree only proposes pairs, a little too generously.
    """
    from scipy.spatial import cKDTree

    _check_size(label, n, 0)
    points = np.random.default_rng(seed).random((n, 2))
    tree = cKDTree(points)
    generous = min(radius, 2.0) * (1 + 1e-9)  # no two points are farther apart than sqrt 2
    _check_size(label, n, (int(tree.count_neighbors(tree, generous)) - n) // 2)
    pairs = tree.query_pairs(generous, output_type="ndarray").astype(np.int64)
    dx, dy = (points[pairs[:, 0]] - points[pairs[:, 1]]).T
    return _network(label, n, _sorted(pairs[np.sqrt(dx * dx + dy * dy) <= radius]))


def _sorted(edges: NDArray[np.int64]) -> NDArray[np.int64]:
    """Edges with the smaller node first, in lexicographic order."""
    edges = np.sort(edges, axis=1)
    return edges[np.lexsort((edges[:, 1], edges[:, 0]))]


_FAMILIES = (
    Family("path:n", "a whole number n >= 2", (int,), lambda n: n >= 2, _path),
    Family("cycle:n", "a whole number n >= 3", (int,), lambda n: n >= 3, _cycle),
    Family("complete:n", "a whole number n >= 2", (int,), lambda n: n >= 2, _complete),
    Family("star:n", "a whole number n >= 2, the hub 0 counted", (int,), lambda n: n >= 2, _star),
    Family(
        "bipartite:a,b", "two whole numbers >= 1", (int, int), lambda a, b: a * b >= 1, _bipartite
    ),
    Family(
        "grid:a,b", "two whole numbers >= 1, not both 1", (int, int), lambda a, b: a * b >= 2, _grid
    ),
    Family(
        "torus:a,b",
        "two whole numbers >= 3 (a ring of 1 or 2 nodes would need a loop or a double edge)",
        (int, int),
        lambda a, b: min(a, b) >= 3,
        _torus,
    ),
    Family(
        "hypercube:d", "a whole number d from 1 to 24", (int,), lambda d: 1 <= d <= 24, _hypercube
    ),
    Family("petersen", "no numbers", (), lambda: True, _petersen),
    Family("karate", "no numbers", (), lambda: True, _karate),
    Family(
        "random_geometric:n,radius,seed",
        "a whole number n >= 2, a positive finite radius and a whole seed >= 0",
        (int, float, int),
        lambda n, radius, _: n >= 2 and 0 < radius < math.inf,
        _random_geometric,
    ),
)
FAMILIES: dict[str, Family] = {_kind(family.usage): family for family in _FAMILIES}
"""The families by name."""
