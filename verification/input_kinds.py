"""Kinds of inputs: how what a user gave becomes exact data, and data become values.

A kind is an entry of `KINDS`: one function that reads what was given into exact data, and one that
fits these data to the rest of the question (the size of the other matrices, the nodes of the
network).
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from sensortrack.errors import InputError

from .exact.rationals import parse_exact

if TYPE_CHECKING:
    from sensortrack.networks import Network

Rows = tuple[tuple[Fraction, ...], ...]
ALL_LINKS = "all"
"""Stands for one list with all links of the graph."""

LONGEST = 60
"""Characters of a user's text that an error repeats."""


@dataclass(frozen=True)
class Setting:
    """What the other inputs of the same question say.

    Parameters
    ----------
    network : Network or None
        The network of ``--graph``.
    size : int
        Rows of the question's matrices and diagonals; where all of them are given as numbers, that
        of its vectors, where there are none that of its lists, else 1.
    """

    network: Network | None
    size: int


@dataclass(frozen=True)
class Kind:
    """How one kind of input is read.

    Parameters
    ----------
    form : str
        What the user has to write, for lists and errors.
    read : callable
        ``read(name, given)`` returns exact data in the shape given.
    fit : callable
        ``fit(name, data, setting)`` returns the value that the quantity gets.
    """

    form: str
    read: Callable[[str, object], Any]
    fit: Callable[[str, Any, Setting], Any]


def brief(text: str) -> str:
    """A user's text on one line of bearable length, for errors."""
    plain = repr(text)[1:-1]
    return plain if len(plain) <= LONGEST else plain[:LONGEST] + "…"


def shown(given: object) -> str:
    """What was given, as JSON in short, for errors."""
    if isinstance(given, str):
        return f"'{brief(given)}'"
    return brief(json.dumps(given, default=str))


def nearest(name: str, known: Sequence[str]) -> str:
    """A question that suggests the known name nearest to `name`, or empty."""
    folded = {entry.casefold(): entry for entry in known}
    near = get_close_matches(name.casefold(), folded, n=1, cutoff=0.5)
    return f"did you mean {folded[near[0]]}?" if near else ""


def positive(values: Mapping[str, Any], name: str, what: str = "a number") -> Fraction:
    """The number of that name, after checking that it is above zero.

    Raises
    ------
    InputError
        It is zero or negative.
    """
    value: Fraction = values[name]
    if value <= 0:
        raise InputError(name, f"{value}", f"{what} above 0 is needed")
    return value


def _number(name: str, given: object) -> Fraction:
    if isinstance(given, (bool, list, dict)) or given is None:
        raise InputError(name, shown(given), "a number is needed")
    if isinstance(given, str) and not given.strip():
        raise InputError(name, "an empty text", "a number is needed")
    if isinstance(given, str) and given.lstrip()[0] in "[{":
        raise InputError(name, f"{shown(given)}, which is no JSON", "JSON is needed")
    return parse_exact(given, name)


def _entry(name: str, where: str, given: object) -> Fraction:
    """One number of a list; the error says where it stands."""
    try:
        return _number(name, given)
    except InputError as error:
        raise InputError(name, f"{where} is {error.found}", error.needed) from None


def _matrix(name: str, given: object) -> Fraction | Rows:
    if not isinstance(given, list):
        return _number(name, given)
    needed = "a number or a square list of rows is needed"
    if not given:
        raise InputError(name, "an empty list", needed)
    for i, row in enumerate(given, start=1):
        if not isinstance(row, list):
            raise InputError(name, f"row {i} is {shown(row)}", needed)
        if len(row) != len(given[0]):
            found = f"row {i} has {len(row)} numbers, row 1 has {len(given[0])}"
            raise InputError(name, found, needed)
    if len(given) != len(given[0]):
        raise InputError(name, f"{len(given)} x {len(given[0])}", needed)
    return tuple(
        tuple(_entry(name, f"entry {i},{j}", value) for j, value in enumerate(row, start=1))
        for i, row in enumerate(given, start=1)
    )


def _matrices(name: str, given: object) -> tuple[Rows, ...]:
    """A list of matrices; a number is one of one row."""
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), "a list of matrices is needed")
    found = []
    for number, entry in enumerate(given, start=1):
        try:
            read = _matrix(name, entry)
        except InputError as error:
            raise InputError(name, f"matrix {number}: {error.found}", error.needed) from None
        found.append(read if isinstance(read, tuple) else ((read,),))
    return tuple(found)


def _multiple(_: str, data: Fraction | Rows, setting: Setting) -> Rows:
    """A number as that multiple of the identity."""
    if isinstance(data, tuple):
        return data
    size, zero = range(setting.size), Fraction(0)
    return tuple(tuple(data if i == j else zero for j in size) for i in size)


def _node_numbers(
    name: str, given: object
) -> Fraction | tuple[Fraction, ...] | dict[str, Fraction]:
    if isinstance(given, list):
        return tuple(_entry(name, f"number {i}", value) for i, value in enumerate(given, start=1))
    if isinstance(given, dict):
        return {node: _entry(name, f"node {shown(node)}", v) for node, v in given.items()}
    return _number(name, given)


def _by_node(name: str, data: Any, setting: Setting) -> tuple[Fraction, ...]:
    """One number a node, in the network's order."""
    network = setting.network
    if network is None:
        raise InputError("graph", "not given", f"{name} has one number a node of --graph")
    if isinstance(data, Fraction):
        return (data,) * network.n
    if isinstance(data, tuple):
        if len(data) != network.n:
            needed = f"{network.n} are needed, one a node in the order of the graph"
            raise InputError(name, f"{len(data)} numbers", needed)
        return data
    names = set(network.names)
    for node in data:
        if node not in names:
            hint = nearest(node, network.names[:1000])
            needed = f"names of {network.label or 'the graph'}'s nodes are needed"
            raise InputError(name, f"no node is called {shown(node)}", needed, hint)
    missing = [node for node in network.names if node not in data]
    if missing:
        more = f" and {len(missing) - 1} further nodes" if len(missing) > 1 else ""
        raise InputError(name, f"no number for node {missing[0]!r}{more}", "one a node is needed")
    return tuple(data[node] for node in network.names)


def _planar(name: str, data: Fraction | Rows, _: Setting) -> Rows:
    """A matrix of two coordinates; a number as that multiple of the identity."""
    if isinstance(data, tuple) and len(data) != 2:
        raise InputError(name, f"{len(data)} x {len(data)}", "two coordinates, 2 x 2, are needed")
    return _multiple(name, data, Setting(None, 2))


def _vector(name: str, given: object) -> tuple[Fraction, ...]:
    if not isinstance(given, list):
        return (_number(name, given),)
    if not given:
        raise InputError(name, "an empty list", "a number for each coordinate is needed")
    return tuple(_entry(name, f"number {i}", value) for i, value in enumerate(given, start=1))


def _coordinates(name: str, data: tuple[Fraction, ...], setting: Setting) -> tuple[Fraction, ...]:
    """One number a coordinate."""
    if len(data) != setting.size:
        needed = f"{setting.size} are needed, one a coordinate of the matrices"
        raise InputError(name, f"{len(data)} number{'s' if len(data) > 1 else ''}", needed)
    return data


def _point(name: str, given: object) -> tuple[Fraction, ...]:
    if not isinstance(given, list) or len(given) != 2:
        raise InputError(name, shown(given), "a list of two numbers is needed")
    return tuple(_entry(name, f"number {i}", value) for i, value in enumerate(given, start=1))


def _points(name: str, given: object) -> tuple[tuple[Fraction, ...], ...]:
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), "a list of points of two numbers is needed")
    return tuple(_point_of(name, i, value) for i, value in enumerate(given, start=1))


def _point_of(name: str, place: int, given: object) -> tuple[Fraction, ...]:
    """One point of a list; the error says which."""
    try:
        return _point(name, given)
    except InputError as error:
        raise InputError(name, f"point {place}: {error.found}", error.needed) from None


def _links(name: str, given: object) -> str | tuple[tuple[tuple[str, str], ...], ...]:
    """Lists of links by the names of their ends; the text ``all`` for those of the graph."""
    if given == ALL_LINKS:
        return ALL_LINKS
    needed = 'lists of links are needed, as in [[["a", "b"], ["b", "c"]], [["a", "c"]]]'
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), needed)
    for k, entry in enumerate(given, start=1):
        if not isinstance(entry, list):
            raise InputError(name, f"list {k} is {shown(entry)}", needed)
        for i, link in enumerate(entry, start=1):
            plain = isinstance(link, list) and len(link) == 2
            if not plain or any(isinstance(end, (list, dict, bool)) or end is None for end in link):
                found = f"link {i} of list {k} is {shown(link)}"
                raise InputError(name, found, "two names of nodes are needed")
    return tuple(tuple((str(a), str(b)) for a, b in entry) for entry in given)


def _links_of_graph(name: str, data: Any, setting: Setting) -> tuple[tuple[int, ...], ...]:
    """Places in the graph's edge list, a tuple for each list of links."""
    network = setting.network
    if network is None:
        raise InputError("graph", "not given", f"{name} are links of --graph")
    if data == ALL_LINKS:
        return (tuple(range(network.m)),)
    number = {node: i for i, node in enumerate(network.names)}
    place = {edge: k for k, edge in enumerate(map(tuple, network.edges.tolist()))}
    lists = []
    for k, entry in enumerate(data, start=1):
        places = [_place(name, link, number, place, network) for link in entry]
        if len(set(places)) < len(places):
            raise InputError(name, f"list {k} has a link twice", "each link once is needed")
        lists.append(tuple(sorted(places)))
    return tuple(lists)


def _place(
    name: str,
    link: tuple[str, str],
    number: Mapping[str, int],
    place: Mapping[tuple[int, ...], int],
    network: Network,
) -> int:
    for node in link:
        if node not in number:
            needed = f"names of {network.label or 'the graph'}'s nodes are needed"
            hint = nearest(node, network.names[:1000])
            raise InputError(name, f"no node is called {shown(node)}", needed, hint)
    ends = tuple(sorted(number[node] for node in link))
    if ends not in place:
        found = f"{shown(list(link))} is no link of {network.label or 'the graph'}"
        raise InputError(name, found, "links of --graph, which has all that may hold, are needed")
    return place[ends]


def _blocks(name: str, given: object) -> tuple[tuple[int, ...], ...]:
    """Lists of places, counted from 0."""
    needed = "lists of whole numbers are needed, as in [[0, 1], [2, 3]]"
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), needed)
    for k, entry in enumerate(given, start=1):
        if not isinstance(entry, list) or not entry:
            raise InputError(name, f"list {k} is {shown(entry)}", needed)
    return tuple(tuple(_place_of(name, k, x) for x in entry) for k, entry in enumerate(given, 1))


def _place_of(name: str, k: int, given: object) -> int:
    """One place of list k."""
    found = _entry(name, f"a number of list {k}", given)
    if found.denominator != 1 or found < 0:
        raise InputError(name, f"list {k} has {found}", "whole numbers from 0 on are needed")
    return int(found)


def _word(name: str, given: object) -> str:
    if not isinstance(given, str):
        raise InputError(name, shown(given), "a word is needed")
    return given


def _as_read(_: str, data: Any, __: Setting) -> Any:
    return data


KINDS: Mapping[str, Kind] = {
    "number": Kind('a number (0.1, "1/3")', _number, _as_read),
    "matrix": Kind("a number or a list of rows", _matrix, _multiple),
    "matrices": Kind("a list of numbers or of lists of rows", _matrices, _as_read),
    "planar matrix": Kind("a number or two rows of two numbers", _matrix, _planar),
    "vector": Kind("a number or a list of numbers", _vector, _coordinates),
    "diagonal": Kind("a number or a list of numbers", _vector, _as_read),
    "list": Kind("a number or a list of numbers", _vector, _as_read),
    "word": Kind("a word", _word, _as_read),
    "point": Kind("a list of two numbers", _point, _as_read),
    "points": Kind("a list of lists of two numbers", _points, _as_read),
    "blocks": Kind("a list of lists of whole numbers", _blocks, _as_read),
    "links": Kind("lists of links [a, b]", _links, _links_of_graph),
    "node numbers": Kind("a number, a list or {node: number}", _node_numbers, _by_node),
}
