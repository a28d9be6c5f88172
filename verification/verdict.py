"""The five verdicts, and the decision on one claim."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from .figure import Plot


class Verdict(StrEnum):
    """What was found out about a printed statement."""

    PROVED = "PROVED"
    """The printed statement holds; an exact certificate was re-validated."""
    CORRECTED = "CORRECTED"
    """A counterexample replays, and a repaired statement is proved."""
    REFUTED = "REFUTED"
    """A counterexample replays; no repair is proved."""
    SUPPORTED = "SUPPORTED"
    """Statistics or a residual-checked float computation only."""
    UNDECIDED = "UNDECIDED"
    """Neither proof nor counterexample; the reason names the stage that stopped."""


@dataclass(frozen=True)
class Decision:
    """How one printed claim was decided.

    Parameters
    ----------
    verdict : Verdict
    reason : str
        How it was decided: one sentence that a reviewer could attack.
    printed, sharp : str
        The printed and the sharp value as text, empty where the claim has none.
    printed_value, sharp_value : float or None
        The same as numbers, for the margin axis.
    margin_text : str
        How far apart they are, in words.
    repair, repair_formula : str
        What is true instead, in words and in LaTeX.
    relies_on : tuple of str
        Theorems of the literature that the proof uses without re-deriving them.
    certificates : mapping of str to dict
        File stem to certificate document.
    replay : tuple of tuple of str
        A small table (header first) that a reader can follow by hand.
    figure : Plot, optional
        Why it came out so, as a picture.
    """

    verdict: Verdict
    reason: str
    printed: str = ""
    sharp: str = ""
    printed_value: float | None = None
    sharp_value: float | None = None
    margin_text: str = ""
    repair: str = ""
    repair_formula: str = ""
    relies_on: tuple[str, ...] = ()
    certificates: Mapping[str, dict[str, Any]] = field(default_factory=dict)
    replay: tuple[tuple[str, ...], ...] = ()
    figure: Plot | None = None
