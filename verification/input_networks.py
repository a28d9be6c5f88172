"""Inputs about the nodes and links of a network: from what was given to exact data."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from sensortrack.errors import InputError

from .input_numbers import Setting, entry, number
from .input_words import nearest, shown

if TYPE_CHECKING:
    from sensortrack.networks import Network

ALL_LINKS = "all"
"""Stands for one list with all links of the graph."""


def node_numbers(name: str, given: object) -> Fraction | tuple[Fraction, ...] | dict[str, Fraction]:
    """One number for all nodes, a list, or numbers by the names of nodes."""
    if isinstance(given, list):
        return tuple(entry(name, f"number {i}", value) for i, value in enumerate(given, start=1))
    if isinstance(given, dict):
        return {node: entry(name, f"node {shown(node)}", v) for node, v in given.items()}
    return number(name, given)


def one_a_node(name: str, data: Any, setting: Setting) -> tuple[Fraction, ...]:
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


def links(name: str, given: object) -> str | tuple[tuple[tuple[str, str], ...], ...]:
    """Lists of links by the names of their ends; the text ``all`` for those of the graph."""
    if given == ALL_LINKS:
        return ALL_LINKS
    needed = 'lists of links are needed, as in [[["a", "b"], ["b", "c"]], [["a", "c"]]]'
    if not isinstance(given, list) or not given:
        raise InputError(name, shown(given), needed)
    for k, some in enumerate(given, start=1):
        if not isinstance(some, list):
            raise InputError(name, f"list {k} is {shown(some)}", needed)
        for i, link in enumerate(some, start=1):
            plain = isinstance(link, list) and len(link) == 2
            if not plain or any(isinstance(end, (list, dict, bool)) or end is None for end in link):
                found = f"link {i} of list {k} is {shown(link)}"
                raise InputError(name, found, "two names of nodes are needed")
    return tuple(tuple((str(a), str(b)) for a, b in some) for some in given)


def links_of_graph(name: str, data: Any, setting: Setting) -> tuple[tuple[int, ...], ...]:
    """Places in the graph's edge list, a tuple for each list of links."""
    network = setting.network
    if network is None:
        raise InputError("graph", "not given", f"{name} are links of --graph")
    if data == ALL_LINKS:
        return (tuple(range(network.m)),)
    numbers = {node: i for i, node in enumerate(network.names)}
    place = {edge: k for k, edge in enumerate(map(tuple, network.edges.tolist()))}
    lists = []
    for k, some in enumerate(data, start=1):
        places = [_place(name, link, numbers, place, network) for link in some]
        if len(set(places)) < len(places):
            raise InputError(name, f"list {k} has a link twice", "each link once is needed")
        lists.append(tuple(sorted(places)))
    return tuple(lists)


def _place(
    name: str,
    link: tuple[str, str],
    numbers: Mapping[str, int],
    place: Mapping[tuple[int, ...], int],
    network: Network,
) -> int:
    for node in link:
        if node not in numbers:
            needed = f"names of {network.label or 'the graph'}'s nodes are needed"
            hint = nearest(node, network.names[:1000])
            raise InputError(name, f"no node is called {shown(node)}", needed, hint)
    ends = tuple(sorted(numbers[node] for node in link))
    if ends not in place:
        found = f"{shown(list(link))} is no link of {network.label or 'the graph'}"
        raise InputError(name, found, "links of --graph, which has all that may hold, are needed")
    return place[ends]
