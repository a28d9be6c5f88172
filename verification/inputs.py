"""The inputs of a question, read from what a user gave for them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from sensortrack.errors import InputError

from .answers import Input
from .input_kinds import KINDS, Kind
from .input_numbers import Setting
from .input_words import brief, nearest, shown

if TYPE_CHECKING:
    from sensortrack.networks import Network


SQUARE, ROWS = ("matrix", "diagonal"), ("vector", "list")
"""Kinds that stand for a square matrix, and those with one number a coordinate."""


@dataclass(frozen=True)
class Reading:
    """The inputs of a question.

    Parameters
    ----------
    values : dict
        Exact typed values, as the quantity takes them.
    texts : dict
        The same as they were given, rationals as text, ready for JSON.
    """

    values: dict[str, Any]
    texts: dict[str, Any]


def read_inputs(
    inputs: Sequence[Input],
    given: Mapping[str, object],
    network: Network | None = None,
    question: str = "the question",
) -> Reading:
    """Read the inputs of one question.

    Parameters
    ----------
    inputs : sequence of Input
        What the question takes.
    given : mapping of str to object
        JSON-like data by name: numbers are ints, Fractions or texts (``"0.1"``, ``"1/3"``); lists
        and objects hold such numbers.
    network : Network, optional
        The network, where one was given.
    question : str, optional
        What to call the question in errors.

    Returns
    -------
    Reading

    Raises
    ------
    InputError
        With the input's name: it is unknown, missing, of the wrong type or shape, or not finite.
    """
    _known(inputs, given, network, question)
    exact = {
        entry.name: _kind(entry).read(entry.name, given.get(entry.name, entry.default))
        for entry in inputs
        if entry.kind != "graph" and not (entry.optional and entry.name not in given)
    }
    setting = Setting(network, _size(inputs, exact))
    values: dict[str, Any] = {}
    texts: dict[str, Any] = {}
    for entry in inputs:
        if entry.kind == "graph":
            values[entry.name] = network
            texts[entry.name] = network.label if network else None
        elif entry.name not in exact:
            values[entry.name] = texts[entry.name] = None
        else:
            values[entry.name] = _kind(entry).fit(entry.name, exact[entry.name], setting)
            texts[entry.name] = as_text(exact[entry.name])
    return Reading(values, texts)


def as_text(data: Any) -> Any:
    """Exact data ready for JSON, rationals as text."""
    if isinstance(data, tuple):
        return [as_text(entry) for entry in data]
    if isinstance(data, dict):
        return {name: as_text(entry) for name, entry in data.items()}
    return str(data)


def form_of(entry: Input) -> str:
    """How to give an input, in words."""
    if entry.kind == "graph":
        return "--graph FILE or family"
    return f"--set {entry.name}=VALUE, VALUE being {_kind(entry).form}"


def _known(
    inputs: Sequence[Input], given: Mapping[str, object], network: Network | None, question: str
) -> None:
    """Refuse names that the question does not take, and ask for those that it lacks."""
    names = [entry.name for entry in inputs]
    takes = f"{question} takes {', '.join(names)}"
    kinds = {entry.name: entry.kind for entry in inputs}
    for name, value in given.items():
        if name not in kinds:
            hint = nearest(name, names)
            raise InputError(brief(name), "no such input", hint or takes, hint and takes)
        if kinds[name] == "graph":
            raise InputError(name, f"{shown(value)} given as a value", "--graph is needed for it")
    if network is not None and "graph" not in kinds.values():
        raise InputError("graph", "given", takes)
    missing = [
        entry
        for entry in inputs
        if entry.default is None
        and not entry.optional
        and entry.name not in given
        and not (entry.kind == "graph" and network is not None)
    ]
    if missing:
        cure = "\n".join(f"{entry.name}, {entry.meaning}: {form_of(entry)}" for entry in missing)
        raise InputError(missing[0].name, "not given", takes, cure)


def _kind(entry: Input) -> Kind:
    return KINDS[entry.kind]


def _size(inputs: Sequence[Input], exact: Mapping[str, Any]) -> int:
    """Common size of the matrices and diagonals that are given entry by entry, else of the rest."""
    matrices = {e.name: exact[e.name] for e in inputs if e.kind in SQUARE and e.name in exact}
    sizes = {name: len(rows) for name, rows in matrices.items() if isinstance(rows, tuple)}
    if not sizes:
        rows = {e: len(exact[e.name]) for e in inputs if e.kind in ROWS and e.name in exact}
        vectors = [length for e, length in rows.items() if e.kind == "vector"]
        return max(vectors or rows.values(), default=1)
    size = Counter(sizes.values()).most_common(1)[0][0]
    like = next(name for name in sizes if sizes[name] == size)
    for name, found in sizes.items():
        if found != size:
            needed = f"{size} x {size} is needed, the size of {like}"
            raise InputError(name, f"{found} x {found}", needed)
    return size
