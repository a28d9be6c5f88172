"""Lists of one line an entry: what the commands that only list have in common."""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from sensortrack.errors import InputError
from verification.input_words import brief, nearest

if TYPE_CHECKING:
    from theory.system import System


def add_json(parser: argparse.ArgumentParser) -> None:
    """Add ``--json``."""
    parser.add_argument(
        "--json", action="store_true", help="print one JSON document and nothing else"
    )


def add_system(parser: argparse.ArgumentParser) -> None:
    """Add the optional name of one system, and ``--json``."""
    parser.add_argument("system", nargs="?", metavar="SYSTEM", help="of this system only")
    add_json(parser)


def chosen(name: str | None) -> tuple[System, ...]:
    """The system of that name, all systems without a name.

    Raises
    ------
    InputError
        There is no such system.
    """
    from theory.systems import SYSTEMS

    names = [system.name for system in SYSTEMS]
    if name is None:
        return SYSTEMS
    if name not in names:
        hint = nearest(name, names) or f"one of {', '.join(names)} is needed"
        raise InputError(brief(name), "no such system", hint)
    return (SYSTEMS[names.index(name)],)


def show(entries: Sequence[Mapping[str, Any]], columns: Sequence[str], as_json: bool) -> None:
    """Print entries.

    Parameters
    ----------
    entries : sequence of mapping
        All alike.
    columns : sequence of str
        Templates of the aligned columns, like ``"{nodes} nodes"``.
    as_json : bool
        As one JSON document, with all keys, instead.
    """
    if as_json:
        print(json.dumps(list(entries)))
        return
    rows = [[column.format_map(_cells(entry)) for column in columns] for entry in entries]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        print("  ".join(map(str.ljust, row, widths)).rstrip())


def _cells(entry: Mapping[str, Any]) -> dict[str, str]:
    return {name: "" if value is None else str(value) for name, value in entry.items()}
