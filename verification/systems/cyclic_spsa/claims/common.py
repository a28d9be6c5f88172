"""What the decisions on claims about cyclic SPSA share: certificates of universal statements."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from theory.systems.cyclic_spsa.statements import PROOFS
from verification.certificates.derivations import Derivations

MADE = Derivations("cyclic_spsa", PROOFS)
proof, proofs, disproof, replayed = MADE.proof, MADE.proofs, MADE.disproof, MADE.replayed


def column(entries: Sequence[Fraction | int]) -> list[list[Fraction]]:
    """A vector as the checker reads it."""
    return [[Fraction(entry)] for entry in entries]
