"""What a user gave: ``--set``, ``--params`` and ``--graph``, as names and JSON-like data.

Numbers stay texts here, so that a decimal is exactly that rational and nobody computes with a
number of a million digits before it is looked at.
"""

from __future__ import annotations

import argparse
import json
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sensortrack.errors import InputError
from verification.input_words import shown

if TYPE_CHECKING:
    from sensortrack.networks import Network
    from verification.answers import Input

MAX_BYTES = 64_000_000
"""Largest file of parameters that is read."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options that every question takes."""
    group = parser.add_argument_group("input")
    group.add_argument(
        "--set",
        action="append",
        default=[],
        dest="settings",
        metavar="NAME=VALUE",
        help='one input, in JSON or as a text like 1/3; --set "K=[[5, 1], [1, 2]]"',
    )
    group.add_argument(
        "--params", metavar="FILE", help="inputs by name, from an object in .json or .toml"
    )
    group.add_argument(
        "--graph", metavar="GRAPH", help="a .graphml or .csv file, or a family like path:6"
    )
    group.add_argument("--graph-name", metavar="NAME", help="which of several graphs in the file")
    group.add_argument("--weight", metavar="COLUMN", help="where the file has the edge weights")


def given_values(options: argparse.Namespace) -> dict[str, object]:
    """Inputs by name, from ``--set`` and ``--params``.

    Raises
    ------
    InputError
        A text or file cannot be read, or a name is given twice.
    """
    values = _from_file(Path(options.params)) if options.params is not None else {}
    origin = dict.fromkeys(values, "--params")
    for text in options.settings:
        name, value = _setting(text)
        if name in values:
            found = f"given twice, with {origin[name]} and --set"
            raise InputError(name, found, "one value is needed")
        values[name], origin[name] = value, "--set"
    return values


def given_network(
    options: argparse.Namespace, inputs: Sequence[Input], question: str
) -> Network | None:
    """The network of ``--graph``, or None if there is none.

    Raises
    ------
    InputError
        It cannot be read, or the question takes none.
    """
    if options.graph is None:
        for option in ("--graph-name", "--weight"):
            if getattr(options, option[2:].replace("-", "_")) is not None:
                raise InputError(option, "given without --graph", "--graph FILE is needed")
        return None
    if all(entry.kind != "graph" for entry in inputs):
        takes = ", ".join(entry.name for entry in inputs)
        raise InputError("graph", "given", f"{question} takes {takes}")
    from sensortrack.data import load_network, real_networks
    from sensortrack.networks import read_network

    if options.graph in real_networks():
        for option in ("graph_name", "weight"):
            if getattr(options, option) is not None:
                found = f"given with the shipped network {options.graph}"
                raise InputError(f"--{option.replace('_', '-')}", found, "a file has it")
        return load_network(options.graph)
    return read_network(options.graph, name=options.graph_name, weight=options.weight)


class Once(dict[str, Any]):
    """A JSON object that remembers a key given twice."""

    def __init__(self, pairs: list[tuple[str, Any]]) -> None:
        super().__init__(pairs)
        seen: set[str] = set()
        self.twice: list[str] = []
        for key, _ in pairs:
            if key in seen:
                self.twice.append(key)
            seen.add(key)


def _setting(text: str) -> tuple[str, Any]:
    name, sign, value = text.partition("=")
    name = name.strip()
    if not sign or not name:
        raise InputError("--set", shown(text), "NAME=VALUE is needed, as in --set h=0.1")
    try:
        found = _json(value)
    except (json.JSONDecodeError, RecursionError):
        return name, value
    _refuse_twice(name, found)
    return name, found


def _from_file(path: Path) -> dict[str, Any]:
    ending = path.suffix.lower()
    if ending not in (".json", ".toml"):
        raise InputError("--params", shown(str(path)), "a file called .json or .toml is needed")
    values = _content(path, ending)
    if not isinstance(values, dict):
        raise InputError("--params", f"{path} holds {shown(values)}", "an object is needed")
    for name in getattr(values, "twice", ()):
        raise InputError(name, f"given twice in {path}", "one value is needed")
    for name, value in values.items():
        _refuse_twice(name, value)
    return values


def _content(path: Path, ending: str) -> Any:
    """Data of a file, with numbers as texts."""
    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
        if len(data) > MAX_BYTES:
            found = f"{path} is larger than {MAX_BYTES} bytes"
            raise InputError("--params", found, "a smaller file is needed")
        text = data.decode("utf-8-sig")
        return _json(text) if ending == ".json" else _toml(text)
    except OSError as error:
        found = f"{path}: {error.strerror or error}"
        raise InputError("--params", found, "a file that can be read is needed") from None
    except RecursionError:
        found = f"{path}: nested too deeply"
        raise InputError("--params", found, "rows of numbers are needed") from None
    except ValueError as error:  # what decoding and both parsers raise is one
        found = f"{path}: {error}"
        raise InputError("--params", found, f"{ending[1:].upper()} is needed") from None


def _refuse_twice(name: str, value: object) -> None:
    """Refuse an object of numbers by node that names a node twice."""
    if isinstance(value, Once) and value.twice:
        raise InputError(name, f"{shown(value.twice[0])} given twice", "one number is needed")


def _json(text: str) -> Any:
    return json.loads(
        text, parse_float=str, parse_int=str, parse_constant=str, object_pairs_hook=Once
    )


def _toml(text: str) -> dict[str, Any]:
    return tomllib.loads(text, parse_float=lambda number: number.replace("_", ""))
