"""What a system offers to a user's question, and what it answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Input:
    """One named input of a quantity or condition.

    Parameters
    ----------
    name : str
        Name as typed after ``--set`` (``graph`` means ``--graph``).
    kind : str
        ``matrix``, ``number``, ``node numbers`` or ``graph``.
    meaning : str
        One phrase for lists and error messages.
    unit : str, optional
        SI unit, empty for a pure number.
    default : str or None, optional
        Exact text used when the input is not given; None makes it required.
    """

    name: str
    kind: str
    meaning: str
    unit: str = ""
    default: str | None = None


@dataclass(frozen=True)
class Answer:
    """A quantity's or condition's answer; the fields are those of the ``--json`` document."""

    value: Any = None
    exact: dict[str, Any] | None = None
    lower: Any = None
    upper: Any = None
    printed: float | None = None
    verdict: str = "SUPPORTED"
    certificate: dict[str, Any] | None = None
    margin: float | None = None
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Quantity:
    """Something `bound` computes; `certified` says whether it writes a certificate."""

    name: str
    summary: str
    inputs: tuple[Input, ...]
    answer: Callable[[Mapping[str, Any]], Answer]
    certified: bool


@dataclass(frozen=True)
class Condition:
    """Something `certify` decides; it always writes a certificate or a counterexample."""

    name: str
    summary: str
    inputs: tuple[Input, ...]
    answer: Callable[[Mapping[str, Any]], Answer]
