"""Networks from files: CSV here, GraphML in :mod:`sensortrack.network_graphml`.

A file is data from a stranger: it is read whole up to a size limit, as UTF-8 only, and whatever
does not say exactly one simple undirected graph is refused with the place where it goes wrong.
"""

from __future__ import annotations

import csv
import io
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from fractions import Fraction
from pathlib import Path
from stat import S_ISREG

import numpy as np

from sensortrack.errors import InputError
from sensortrack.networks import Network

MAX_BYTES = 200_000_000
"""Largest file that is read."""

_DECIMAL = re.compile(r"\+?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE]([+-]?[0-9]{1,3}))?")
_RATIO = re.compile(r"[0-9]+/[0-9]+")
_LONGEST_WEIGHT = 400
_LARGEST_EXPONENT = 300


@dataclass(frozen=True, slots=True)
class Link:
    """One line of an edge list.

    Parameters
    ----------
    source, target : int
        Node numbers.
    where : str
        Where the file says it, for messages.
    weight : Fraction, optional
        Its weight, if the graph is weighted.
    directed : bool, optional
        Whether it is an arc: an arc and its reverse make one edge.
    """

    source: int
    target: int
    where: str
    weight: Fraction | None = None
    directed: bool = False


def file_network(text: str, *, name: str | None = None, weight: str | None = None) -> Network:
    """Network from a GraphML or CSV file.

    Parameters
    ----------
    text : str
        Path of the file; its ending (``.graphml``, ``.xml``, ``.csv``) says what it holds.
    name : str, optional
        Which graph of a file that holds several: an entry of the CSV column ``graph``, or the id
        of a GraphML ``<graph>``.
    weight : str, optional
        The CSV column or GraphML edge attribute with the edge weights; without it all are one.

    Returns
    -------
    Network
        Labelled by the file's name, and the graph's in brackets if the file names its graphs.

    Raises
    ------
    InputError
        With the name ``graph``, or ``weight`` where the weights are at fault.
    """
    from sensortrack.network_families import unknown_graph
    from sensortrack.network_graphml import graphml_network

    if not text.strip():  # Path("") is the current directory
        raise unknown_graph(text)
    path = Path(text)
    try:
        regular = S_ISREG(path.stat().st_mode)
    except (FileNotFoundError, NotADirectoryError, ValueError) as error:
        raise unknown_graph(text) from error
    except OSError as error:
        raise _unreadable(path, error) from error
    if not regular:
        raise InputError("graph", f"{text!r} is no regular file", "a GraphML or CSV file")
    ending = path.suffix.lower()
    if ending == ".csv":
        return csv_network(_content(path), printable(path.name), name=name, weight=weight)
    if ending in (".graphml", ".xml"):
        return graphml_network(_content(path), printable(path.name), name=name, weight=weight)
    needed = "a file called .graphml, .xml or .csv, by what it holds"
    raise InputError("graph", f"{text!r} ends in {ending or 'nothing'!r}", needed)


def csv_network(
    content: str, label: str, *, name: str | None = None, weight: str | None = None
) -> Network:
    """Network from the text of a CSV file with the columns ``source`` and ``target``.

    Parameters
    ----------
    content : str
        The text: commas, double quotes, a header line. Other columns may stand beside, in any
        order; blanks around a field and blank lines do not count.
    label : str
        What to call the file.
    name : str, optional
        Which graph, where a column ``graph`` tells several apart.
    weight : str, optional
        The column with the weights.

    Returns
    -------
    Network
        Nodes in the order of first appearance, source before target.

    Raises
    ------
    InputError
        With the name ``graph``, or ``weight`` where the weights are at fault.
    """
    header, rows = _csv_table(content, label)
    for needed in ("source", "target"):
        if needed not in header:
            found = f"{label} has the columns {', '.join(map(repr, header))}"
            raise InputError("graph", found, f"a column {needed!r}", "Line 1 must name the columns")
    graph = header.index("graph") if "graph" in header else None
    if graph is not None:
        name = chosen(_distinct(rows, graph, label), name, label)
        rows = [(line, row) for line, row in rows if row[graph] == name]
        label = f"{label} ({printable(name)})"
    elif name is not None:
        found = f"the name {name!r}, but {label} has no column 'graph'"
        raise InputError("graph", found, "a name only where that column tells graphs apart")
    if not rows:
        raise InputError("graph", f"{label} has no line below its header", "one line an edge")
    weights = None if weight is None else _weight_column(header, weight, label)
    ends = (header.index("source"), header.index("target"))
    nodes: dict[str, int] = {}
    links = []
    for line, row in rows:
        where = f"{label}, line {line}"
        source, target = (_number(nodes, row[end], where, header[end]) for end in ends)
        value = None if weights is None else exact_weight(row[weights], where)
        links.append(Link(source, target, where, value))
    return linked_network(list(nodes), links, label)


def linked_network(names: Sequence[str], links: Iterable[Link], label: str) -> Network:
    """Network from its node names and the lines of its edge list.

    Parameters
    ----------
    names : sequence of str
        One name a node.
    links : iterable of Link
        The lines in their order; either all have a weight or none.
    label : str
        The network's label.

    Returns
    -------
    Network
        Its edges in the order of the lines.

    Raises
    ------
    InputError
        For a self-loop, an edge that is listed twice, or an arc and its reverse that differ in
        weight.
    """
    edges: dict[tuple[int, int], Link] = {}
    paired: set[tuple[int, int]] = set()
    for link in links:
        i, j = key = (min(link.source, link.target), max(link.source, link.target))
        if i == j:
            found = f"{link.where}: an edge from {names[i]!r} to itself"
            raise InputError("graph", found, "edges between different nodes")
        first = edges.setdefault(key, link)
        if first is link:
            continue
        pair = f"{names[i]!r} and {names[j]!r}"
        reverse = first.directed and link.directed and first.source == link.target
        if not reverse or key in paired:
            found = f"{link.where}: a second edge between {pair} (the first: {first.where})"
            raise InputError("graph", found, "each edge once")
        if first.weight != link.weight:
            found = f"{link.where}: the arcs between {pair} weigh {first.weight} and {link.weight}"
            raise InputError("weight", found, "the same weight in both directions")
        paired.add(key)
    weights = [link.weight for link in edges.values() if link.weight is not None]
    pairs = np.array(list(edges), dtype=np.int64).reshape(-1, 2)
    return Network(names, pairs, tuple(weights) if weights else None, (), label)


def exact_weight(text: str, where: str) -> Fraction:
    """Read the exact value of a weight's decimal text or fraction.

    Parameters
    ----------
    text : str
        Such as ``0.1`` (which is 1/10), ``2.5e-3`` or ``1/3``.
    where : str
        Where it stands, for messages.

    Raises
    ------
    InputError
        With the name ``weight`` unless it is a number from 1e-300 to 1e300.
    """
    text = text.strip()
    if len(text) <= _LONGEST_WEIGHT:
        decimal = _DECIMAL.fullmatch(text)
        # Asked before the number is made: 1e999999999 would fill the memory.
        small = decimal is not None and abs(int(decimal[1] or 0)) <= _LARGEST_EXPONENT
        ratio = _RATIO.fullmatch(text) is not None and int(text.partition("/")[2]) > 0
        value = Fraction(text) if small or ratio else Fraction(0)
        if Fraction(1, 10**_LARGEST_EXPONENT) <= value <= 10**_LARGEST_EXPONENT:
            return value
    shown = repr(text if len(text) <= 40 else text[:40] + "…")
    needed = "a decimal number or a fraction p/q, positive, from 1e-300 to 1e300"
    raise InputError("weight", f"{where}: the weight {shown}", needed)


def check_weight(weight: str, known: Sequence[str], lacks: str) -> None:
    """Refuse the name of a weight that is not among those that a file knows.

    Raises
    ------
    InputError
        With the name ``weight``, suggesting the nearest.
    """
    if weight not in known:
        near = get_close_matches(weight, known, n=1)
        needed = f"one of {', '.join(map(repr, known))}" if known else "a file with weights"
        cure = f"Did you mean {printable(near[0])}?" if near else ""
        raise InputError("weight", f"{lacks} {weight!r}", needed, cure)


def chosen(names: Sequence[str], name: str | None, label: str) -> str:
    """Pick the name of the graph to read among those that a file holds.

    Raises
    ------
    InputError
        If the file holds several and no name is given, or none of that name.
    """
    if name is None and len(names) == 1:
        return names[0]
    if name is not None and name in names:
        return name
    listed = ", ".join(map(printable, names[:20])) + (", …" if len(names) > 20 else "")
    if name is None:
        found, cure = f"{label} holds {len(names)} graphs", f"Choose by --graph-name: {listed}"
    else:
        near = get_close_matches(name, names, n=1)
        found = f"{label} holds no graph {name!r}"
        cure = "".join(f"Did you mean {printable(one)}?\n" for one in near) + f"It holds: {listed}"
    raise InputError("graph", found, "the name of one of its graphs", cure)


def printable(text: str) -> str:
    """Text as it is, or quoted if it holds what could play tricks with a terminal."""
    return text if text.isprintable() else repr(text)


def _unreadable(path: Path, error: OSError) -> InputError:
    found = f"{str(path)[:100]!r} cannot be read ({error.strerror})"
    return InputError("graph", found, "a file that may be read")


def _content(path: Path) -> str:
    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except OSError as error:
        raise _unreadable(path, error) from error
    if len(data) > MAX_BYTES:
        raise InputError(
            "graph", f"{printable(path.name)} is larger", f"at most {MAX_BYTES // 10**6} MB"
        )
    try:
        content = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        found = f"{printable(path.name)} is not UTF-8 (byte {error.start})"
        raise InputError("graph", found, "a text file", "Save it with encoding UTF-8") from error
    if not content.strip():
        raise InputError("graph", f"{printable(path.name)} is empty", "a graph")
    return content


def _csv_table(content: str, label: str) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """Read the header, and the other rows with their line numbers, all of the same length."""
    rows = list(_csv_rows(content, label))
    if not rows:
        raise InputError("graph", f"{label} is empty", "a header with source,target")
    header = rows[0][1]
    column, times = Counter(header).most_common(1)[0]
    if times > 1:
        found = f"{label} has {times} columns {column!r}"
        raise InputError("graph", found, "a different name for every column")
    for line, row in rows[1:]:
        if len(row) != len(header):
            found = f"{label}, line {line}: {len(row)} fields below {len(header)} columns"
            raise InputError("graph", found, "a field for every column", "Separate by commas")
    return header, rows[1:]


def _csv_rows(content: str, label: str) -> Iterator[tuple[int, list[str]]]:
    reader = csv.reader(io.StringIO(content, newline=""), strict=True)
    try:
        for row in reader:
            fields = [field.strip() for field in row]
            if fields not in ([], [""]):
                yield reader.line_num, fields
    except csv.Error as error:
        found = f"{label}, line {reader.line_num}: {error}"
        raise InputError("graph", found, "comma-separated values") from error


def _distinct(rows: list[tuple[int, list[str]]], column: int, label: str) -> list[str]:
    found: dict[str, None] = {}
    for line, row in rows:
        if not row[column]:
            raise InputError("graph", f"{label}, line {line}: no graph", "the graph's name")
        found[row[column]] = None
    return list(found)


def _weight_column(header: list[str], weight: str, label: str) -> int:
    others = [column for column in header if column not in ("source", "target", "graph")]
    check_weight(weight, others, f"{label} has no column")
    return header.index(weight)


def _number(nodes: dict[str, int], name: str, where: str, column: str) -> int:
    if not name:
        raise InputError("graph", f"{where}: the field {column!r} is empty", "the name of a node")
    return nodes.setdefault(name, len(nodes))
