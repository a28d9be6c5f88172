"""Read tables of a configuration file into frozen values, key by key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, fields
from difflib import get_close_matches
from typing import Any, TypeVar, get_type_hints

import numpy as np

from sensortrack.errors import InputError

T = TypeVar("T")
Vector = tuple[float, float, float]
"""Three numbers."""
Pair = tuple[str, str]
"""Two names."""
LEFT_OUT = (float, int, str)
"""What a key may be whose default is None, which says that it is left out."""


def read_table(cls: type[T], data: object, where: str) -> T:
    """Make a dataclass from a table, refusing what it does not know.

    Parameters
    ----------
    cls : type
        A frozen dataclass whose fields are the keys, annotated ``float``, ``int``, ``str``,
        ``bool``, `Vector`, `Pair`, tuples of str or of `Pair`, or one of `LEFT_OUT` or None.
    data : object
        What the file holds at this place.
    where : str
        Name of the table, for errors.

    Raises
    ------
    InputError
        A key is unknown (the nearest is suggested) or missing, or a value is of the wrong type.
    """
    if not isinstance(data, Mapping):
        raise InputError(where, f"{data!r:.60}", "a table is needed")
    known = {entry.name: entry for entry in fields(cls) if entry.init}  # type: ignore[arg-type]
    for key in data:
        if key not in known:
            near = get_close_matches(key, known, n=1, cutoff=0.5)
            hint = f"did you mean {near[0]}?" if near else f"one of {', '.join(known)} is needed"
            raise InputError(f"{where}.{key}", "no such key", hint)
    hints = get_type_hints(cls)
    values = {}
    for name, entry in known.items():
        if name in data:
            values[name] = _typed(hints[name], data[name], f"{where}.{name}")
        elif entry.default is MISSING and entry.default_factory is MISSING:
            raise InputError(f"{where}.{name}", "not given", "it is needed")
    return cls(**values)


def _typed(hint: Any, value: Any, where: str) -> Any:
    hint = next((kind for kind in LEFT_OUT if hint == kind | None), hint)
    if hint is float:
        return _number(value, where)
    if hint == Vector:
        if not isinstance(value, list) or len(value) != 3:
            raise InputError(where, f"{value!r:.60}", "a list of three numbers is needed")
        return tuple(_number(entry, where) for entry in value)
    if hint == Pair:
        return _pair(value, where)
    if hint == tuple[Pair, ...]:
        if not isinstance(value, list):
            raise InputError(where, f"{value!r:.60}", "a list of pairs of texts is needed")
        return tuple(_pair(entry, where) for entry in value)
    if hint == tuple[str, ...]:
        if not isinstance(value, list) or not all(isinstance(entry, str) for entry in value):
            raise InputError(where, f"{value!r:.60}", "a list of texts is needed")
        return tuple(value)
    if hint in (int, str, bool):
        if type(value) is not hint:
            raise InputError(where, f"{value!r:.60}", f"{_words(hint)} is needed")
        return value
    return value


def _pair(value: object, where: str) -> Pair:
    if not isinstance(value, list) or len(value) != 2 or not all(isinstance(x, str) for x in value):
        raise InputError(where, f"{value!r:.60}", "a list of two texts is needed")
    return (value[0], value[1])


def _number(value: object, where: str) -> float:
    good = isinstance(value, (int, float)) and not isinstance(value, bool) and np.isfinite(value)
    if not good:
        raise InputError(where, f"{value!r:.60}", "a finite number is needed")
    return float(value)  # type: ignore[arg-type]


def _words(hint: type) -> str:
    return {int: "a whole number", str: "a text", bool: "true or false"}[hint]
