"""What the decisions on claims about cyclic SPSA share: certificates of universal statements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from theory.systems.cyclic_spsa.statements import PROOFS
from verification.certificates.derivations import Derivations

from ..stability.steps import step_limit

MADE = Derivations("cyclic_spsa", PROOFS)
proof, proofs, disproof, replayed = MADE.proof, MADE.proofs, MADE.disproof, MADE.replayed


def limit_document(at: Mapping[str, Any]) -> tuple[float, dict[str, Any]]:
    """The limit of the step, and its certificate.

    Raises
    ------
    ValueError
        There is none: a claim that names one must not be decided without it.
    """
    found = step_limit(at)
    if found.certificate is None:
        raise ValueError("h: the limit has no certificate; fewer coordinates are needed")
    return float(found.value), found.certificate


def column(entries: Sequence[Fraction | int]) -> list[list[Fraction]]:
    """A vector as the checker reads it."""
    return [[Fraction(entry)] for entry in entries]
