"""How errors about inputs name what was given."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError

LONGEST = 60
"""Characters of a user's text that an error repeats."""


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
