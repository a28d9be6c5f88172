"""Networks from GraphML, read without any help that could follow what a hostile file says.

Only the graph itself is taken: nodes, edges, one name a node and the chosen edge weight, the
latter as exact text. Document type and entity declarations, nested graphs, hyperedges and ports
are refused.

References
----------
.. [1] U. Brandes, M. Eiglsperger, J. Lerner, C. Pich, "Graph Markup Language (GraphML)", in
   Handbook of Graph Drawing and Visualization, CRC Press, 2013.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple
from xml.etree import ElementTree

from sensortrack.errors import InputError
from sensortrack.network_files import (
    Link,
    check_weight,
    chosen,
    exact_weight,
    linked_network,
    printable,
)
from sensortrack.networks import Network

_CHUNK = 1 << 16
_PARENTS = {"graph": "graphml", "node": "graph", "edge": "graph"}
_NAMES = ("label", "name")


def graphml_network(
    content: str, label: str, *, name: str | None = None, weight: str | None = None
) -> Network:
    """Network from the text of a GraphML file.

    Parameters
    ----------
    content : str
        The document.
    label : str
        What to call the file.
    name : str, optional
        The id of the ``<graph>`` where there are several.
    weight : str, optional
        The edge attribute (``attr.name`` of a ``<key>``) with the weights; a default that the
        key declares counts.

    Returns
    -------
    Network
        Nodes in the order of ``<node>``, isolated ones too. They are called by the attribute
        ``label`` if every node has one and all differ, else by ``name`` under the same condition,
        else by their ids.

    Raises
    ------
    InputError
        With the name ``graph``, or ``weight`` where the weights are at fault.

    Notes
    -----
    A directed graph is read as undirected: a single arc is an edge, and an arc together with its
    reverse is one edge (of one weight), not two.
    """
    if "<!DOCTYPE" in content or "<!ENTITY" in content:
        found = f"{label} has a DOCTYPE or ENTITY declaration"
        raise _bad(found, "GraphML without it", "Remove the declaration")
    reader = _Reader(label, weight)
    reader.read(content)
    if not reader.graphs:
        raise _bad(f"{label} has no <graph>", "one graph or more")
    if weight is not None:
        known = [key.name for key in reader.keys.values() if key.owner in ("edge", "all")]
        check_weight(weight, known, f"{label} has no edge attribute")
    ids = [graph.id for graph in reader.graphs]
    if name is None and len(ids) == 1:
        return _network(reader.graphs[0], label, weight)
    if len(set(ids)) < len(ids):
        raise _bad(f"{label} holds graphs of the same id", "a different id for every graph")
    picked = chosen(ids, name, label)
    return _network(reader.graphs[ids.index(picked)], f"{label} ({printable(picked)})", weight)


class _Key(NamedTuple):
    """A declared attribute: whose it is, its name, and its default."""

    owner: str
    name: str
    default: str | None


class _Edge(NamedTuple):
    source: str
    target: str
    where: str
    directed: bool
    weight: str | None


@dataclass
class _Graph:
    """What one ``<graph>`` says, before anything is made of it."""

    id: str
    directed: bool
    nodes: dict[str, int] = field(default_factory=dict)
    titles: dict[str, list[str]] = field(default_factory=lambda: {key: [] for key in _NAMES})
    edges: list[_Edge] = field(default_factory=list)


class _Reader:
    """Takes the elements of a document as they end, and drops them."""

    def __init__(self, label: str, weight: str | None) -> None:
        self.label = label
        self.weight = weight
        self.home = ""  # the namespace of the root, with its braces
        self.keys: dict[str, _Key] = {}
        self.graphs: list[_Graph] = []
        self.open: list[ElementTree.Element] = []

    def read(self, content: str) -> None:
        """Read the whole document."""
        # Fed with text instead of bytes, the parser ignores the encoding that the file claims.
        parser: ElementTree.XMLPullParser[Any] = ElementTree.XMLPullParser(("start", "end"))
        try:
            for start in range(0, len(content), _CHUNK):
                parser.feed(content[start : start + _CHUNK])
                self._take(parser.read_events())
            parser.close()
            self._take(parser.read_events())
        except ElementTree.ParseError as error:
            raise _bad(f"{self.label} is no well-formed XML ({error})", "GraphML") from error

    def _take(self, events: Iterable[Any]) -> None:
        for event, element in events:
            if event == "start":
                self._start(element)
                self.open.append(element)
            else:
                self.open.pop()
                self._end(element)

    def _local(self, element: ElementTree.Element) -> str:
        """Name of an element of GraphML itself, or nothing for one of another namespace."""
        space, _, local = element.tag.rpartition("}")
        return local if space == self.home else ""

    def _start(self, element: ElementTree.Element) -> None:
        if not self.open:
            self.home, _, root = element.tag.rpartition("}")
            if root != "graphml":
                raise _bad(f"{self.label} is XML with the root <{root}>", "the root <graphml>")
            return
        local = self._local(element)
        parent = self._local(self.open[-1])
        if local in ("hyperedge", "port") and parent in ("graph", "node"):
            raise _bad(f"{self.label} has a <{local}>", "nodes and edges only")
        if local in _PARENTS and parent != _PARENTS[local] and not self._inside_data():
            kind = "a nested graph" if local == "graph" else f"a <{local}> inside <{parent}>"
            raise _bad(f"{self.label} has {kind}", f"every <{local}> inside <{_PARENTS[local]}>")
        if local == "graph" and parent == "graphml":
            directed = element.get("edgedefault") == "directed"
            self.graphs.append(_Graph(element.get("id", ""), directed))

    def _inside_data(self) -> bool:
        return any(self._local(element) == "data" for element in self.open)

    def _end(self, element: ElementTree.Element) -> None:
        parent = self._local(self.open[-1]) if self.open else ""
        local = self._local(element)
        if local == "key" and parent == "graphml":
            self._key(element)
        elif local == "node" and parent == "graph" and not self._inside_data():
            self._node(element)
        elif local == "edge" and parent == "graph" and not self._inside_data():
            self._edge(element)
        else:
            return
        self.open[-1].clear()  # its attributes have been read; this frees what has ended inside

    def _key(self, element: ElementTree.Element) -> None:
        default = next((child for child in element if self._local(child) == "default"), None)
        text = None if default is None else (default.text or "").strip()
        id_ = element.get("id", "")
        self.keys[id_] = _Key(element.get("for", "all"), element.get("attr.name", id_), text)

    def _node(self, element: ElementTree.Element) -> None:
        graph = self.graphs[-1]
        name = element.get("id", "")
        if not name or name in graph.nodes:
            what = f"two nodes with the id {name!r}" if name else "a node without an id"
            raise _bad(f"{self.label} has {what}", "a different id for every node")
        graph.nodes[name] = len(graph.nodes)
        titles = {key: text for key, text in self._data(element, "node") if key in _NAMES}
        for key in _NAMES:
            graph.titles[key].append(titles.get(key, ""))

    def _edge(self, element: ElementTree.Element) -> None:
        graph = self.graphs[-1]
        number = len(graph.edges) + 1
        id_ = element.get("id")
        where = f"{self.label}, edge {number}" if id_ is None else f"{self.label}, edge {id_!r}"
        if "sourceport" in element.attrib or "targetport" in element.attrib:
            raise _bad(f"{where} ends at a port", "nodes and edges only")
        weights = [text for key, text in self._data(element, "edge") if key == self.weight]
        if len(weights) > 1:
            raise InputError("weight", f"{where} has {len(weights)} of them", "one an edge")
        weights = weights or [
            key.default
            for key in self.keys.values()
            if key.owner in ("edge", "all") and key.name == self.weight and key.default is not None
        ]
        directed = {"true": True, "false": False}.get(element.get("directed", ""), graph.directed)
        source, target = element.get("source", ""), element.get("target", "")
        weight = weights[0] if weights else None
        graph.edges.append(_Edge(source, target, where, directed, weight))

    def _data(self, element: ElementTree.Element, owner: str) -> Iterator[tuple[str, str]]:
        """Yield attribute names and texts of a node or an edge."""
        for child in element:
            if self._local(child) != "data":
                continue
            key = self.keys.get(child.get("key", ""))
            if key is None:
                found = f"{self.label} has data with the key {child.get('key')!r}"
                raise _bad(found, "keys that are declared before the graph")
            if key.owner in (owner, "all"):
                yield key.name, (child.text or "").strip()


def _network(graph: _Graph, label: str, weight: str | None) -> Network:
    names = list(graph.nodes)
    if not names:
        raise _bad(f"{label} has no node", "nodes and edges")
    for key in _NAMES:
        titles = graph.titles[key]
        if all(titles) and len(set(titles)) == len(titles):
            names = titles
            break
    return linked_network(names, _links(graph, weight), label)


def _links(graph: _Graph, weight: str | None) -> Iterator[Link]:
    for edge in graph.edges:
        for end in (edge.source, edge.target):
            if end not in graph.nodes:
                found = f"{edge.where} ends at {end!r}" if end else f"{edge.where} lacks an end"
                raise _bad(found, "the ids of two nodes of its graph")
        value = None
        if weight is not None:
            if edge.weight is None:
                found = f"{edge.where} has no attribute {weight!r}"
                raise InputError("weight", found, "a weight for every edge")
            value = exact_weight(edge.weight, edge.where)
        ends = graph.nodes[edge.source], graph.nodes[edge.target]
        yield Link(*ends, edge.where, value, edge.directed)


def _bad(found: str, needed: str, cure: str = "") -> InputError:
    return InputError("graph", found, needed, cure)
