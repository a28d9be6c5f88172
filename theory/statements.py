"""Statements that certificates prove: closed expressions that a checker evaluates by itself."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

BRACKET: Mapping[str, str | None] = {"lower": None, "upper": None}
"""The ends of a certified interval; None means that the certificate states the number."""


@dataclass(frozen=True)
class Case:
    """One way in which a statement can come out.

    Parameters
    ----------
    verdict : str
        ``PROVED`` or ``REFUTED``.
    words : str
        The case in words that a reader can compare with the paper.
    show : tuple of str
        Predicates in the checker's language, all of which must hold.
    ends : mapping, optional
        Names among ``lower`` and ``upper`` that the predicates use; a text instead of None fixes
        the value (``inf``, ``0``).
    """

    verdict: str
    words: str
    show: tuple[str, ...]
    ends: Mapping[str, str | None] = field(default_factory=dict)


@dataclass(frozen=True)
class Statement:
    """What a certificate of one quantity, condition or claim proves.

    Parameters
    ----------
    system, name : str
        Short name of the system; name of the quantity, condition or claim.
    cases : mapping of str to Case
        Usually ``PROVED`` and ``REFUTED``.
    inputs : mapping of str to str
        Data of the certificate: name to ``matrix``, ``number``, ``nodes``, ``graph`` or
        ``unweighted graph``.
    symbols : mapping of str to str
        Letters of a universal statement, like ``"matrix: n m"``, ``"positive definite: n"``,
        ``"vector: n"``, ``"positive"``.
    given : tuple of str
        Expressions in the symbols that are zero by hypothesis.
    relies_on : tuple of str
        Theorems of the literature between the predicates and the words.
    """

    system: str
    name: str
    cases: Mapping[str, Case]
    inputs: Mapping[str, str] = field(default_factory=dict)
    symbols: Mapping[str, str] = field(default_factory=dict)
    given: tuple[str, ...] = ()
    relies_on: tuple[str, ...] = ()

    def to_data(self) -> dict[str, Any]:
        """Return the entry of ``statements.json``, without its digest."""
        cases = {
            key: {
                "verdict": case.verdict,
                "words": case.words,
                "show": list(case.show),
                "ends": dict(case.ends),
            }
            for key, case in self.cases.items()
        }
        return {
            "cases": cases,
            "inputs": dict(self.inputs),
            "symbols": dict(self.symbols),
            "given": list(self.given),
            "relies_on": list(self.relies_on),
        }

    @property
    def digest(self) -> str:
        """SHA-256 of the statement's canonical text, in hexadecimal."""
        text = json.dumps(self.to_data(), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()
