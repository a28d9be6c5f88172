"""Find where mean-square stability of an update ends, with matrices that prove both sides."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from fractions import Fraction

from verification.exact.evaluate import Rows
from verification.exact.rationals import above, below, nearest
from verification.exact.roots import Algebraic

from ..block_inputs import Block
from .iterated import leading
from .stacked import Matrix, Stacked
from .witnesses import (
    Item,
    algebraic_limit,
    around,
    covariance_of,
    diagonal_decaying,
    diagonal_kept,
    diagonal_limit,
    identity_of,
    items,
    kept_at,
    kept_line,
    rounded_decaying,
    rounded_growing,
)

MOST_STACKED = 16
"""Coordinates up to which the equations are solved in many bits."""

ALGEBRAIC = 4
"""Coordinates up to which the limit is given as the root of a polynomial."""

BITS = (128, 192, 320, 640, 1280)
WIDTHS = tuple(Fraction(1, 10**k) for k in (12, 11, 10, 9, 8, 7, 6))
DOUBLE_BITS = 40
LARGE_BITS = (256, 512)
NARROW = Fraction(1, 10**10)
CLOSE = Fraction(1, 2**52)
"""Beside a number beyond the range of doubles, a bound may be so far away."""


@dataclass(frozen=True)
class Limit:
    """Stable at and below `lower`, not at `upper` and above.

    Parameters
    ----------
    lower, upper : Fraction
        Doubles, except where `upper` is the limit itself, or there are none.
    exact : Algebraic or None
        The limit.
    decaying : Rows
        Z for `lower`.
    case : str
        How the upper side is shown.
    kept : tuple of Rows
        P and Q, or x and Q, for `upper`.
    """

    lower: Fraction
    upper: Fraction
    exact: Algebraic | None
    decaying: Rows
    case: str
    kept: tuple[Rows, Rows]

    @property
    def value(self) -> float:
        """The double nearest to the limit, or the middle of the bracket."""
        return self.exact.nearest if self.exact else nearest(self.centre)

    @property
    def centre(self) -> Fraction:
        """The limit where it is rational, else the middle of the bracket."""
        known = self.exact is not None and self.exact.low == self.exact.high
        return self.exact.low if self.exact and known else (self.lower + self.upper) / 2

    def witness(self, block: Block) -> list[Item]:
        """In the order of the statement."""
        z = self.decaying
        chosen = (identity_of(block), z, around(block, z), *self.kept)
        return items((*chosen, *covariance_of(block)))


def limit_of(block: Block) -> Limit | None:
    """Find and prove the limit; None where no bracket of relative width 1e-6 is proved."""
    if block.diagonal:
        return _at_rational(block, diagonal_limit(block), diagonal_kept(block))
    if block.size > MOST_STACKED:
        return _from_iteration(block)
    stacked = Stacked(block)
    for bits in BITS:
        found = stacked.kept(bits)
        limit = None if found is None else _from_bits(stacked, *found, bits)
        if limit is not None:
            return limit
    return None


def rational(x: Fraction) -> Algebraic:
    """A rational number as an algebraic one."""
    return Algebraic((-x.numerator, x.denominator), x, x, nearest(x))


def _under(x: Fraction) -> Fraction:
    """The largest double below x, which is positive, or a number below where there is none."""
    low = below(x)
    low = low if low < x else math.nextafter(low, -math.inf)
    return Fraction(low) if sys.float_info.min < low < sys.float_info.max else x * (1 - CLOSE)


def _over(x: Fraction) -> Fraction:
    """The smallest double above x, which is positive, or a number above where there is none."""
    high = above(x)
    high = high if x < high else math.nextafter(high, math.inf)
    return Fraction(high) if sys.float_info.min < high < math.inf else x * (1 + CLOSE)


def _at_rational(
    block: Block, limit: Fraction, kept: Rows, line: tuple[int, ...] = ()
) -> Limit | None:
    """The limit is known, and what is kept at it."""
    lower = _under(limit)
    z = decaying_at(block, lower)
    if z is None:
        return None
    first = tuple((Fraction(x),) for x in line) if line else kept
    case = "PROVED line" if line else "PROVED exact"
    return Limit(lower, limit, rational(limit), z, case, (first, around(block, kept)))


def decaying_at(block: Block, step: Fraction) -> Rows | None:
    """Z that shows decay at a step below the limit."""
    if block.diagonal:
        return rounded_decaying(block, diagonal_decaying(block, step), step)
    stacked = Stacked(block)
    for bits in BITS:
        z = stacked.decaying(step, bits)
        rows = None if z is None else rounded_decaying(block, z, step)
        if rows is not None:
            return rows
    return None


def _outer(x: tuple[int, ...]) -> Rows:
    return tuple(tuple(Fraction(a * b) for b in x) for a in x)


def _from_bits(stacked: Stacked, near: Fraction, p: Matrix, bits: int) -> Limit | None:
    block = stacked.block
    exact = algebraic_limit(stacked, near) if block.size <= ALGEBRAIC else None
    if exact is not None and exact.low == exact.high:
        kept = _kept_exactly(stacked, exact.low, p)
        if kept is not None:
            return _at_rational(block, exact.low, *kept)
    slack = near / 2 ** (bits // 2)
    lower, upper = _under(near - slack), _over(near + slack)
    z, rows = decaying_at(block, lower), rounded_growing(block, p, upper)
    if z is None or rows is None:
        return None
    return Limit(lower, upper, exact, z, "PROVED", (rows, around(block, rows)))


def _kept_exactly(
    stacked: Stacked, limit: Fraction, near: Matrix
) -> tuple[Rows, tuple[int, ...]] | None:
    """What a rational limit keeps: the second moment of errors on a line, or a definite one."""
    line = kept_line(stacked.block)
    if line is not None and line[0] == limit:
        return _outer(line[1]), line[1]
    found = kept_at(stacked, limit, near)
    return None if found is None else (found, ())


def _from_iteration(block: Block) -> Limit | None:
    """A large block: doubles, and many bits where they leave the bracket wide."""
    widths = WIDTHS
    best = None
    for bits in (None, *LARGE_BITS):
        best = _bracket(block, bits, widths) or best
        if best is not None:
            widths = tuple(w for w in WIDTHS if w < (best.upper - best.lower) / best.upper / 2)
            if best.upper - best.lower <= NARROW * best.upper:
                return best
    return best


def _bracket(block: Block, bits: int | None, widths: tuple[Fraction, ...]) -> Limit | None:
    """The narrowest bracket that matrices of so many bits prove."""
    found = leading(block, bits)
    if found is None:
        return None
    near, p, z = found.limit, found.kept, found.decaying
    for width in widths:
        lower, upper = _under(near * (1 - width / 2)), _over(near * (1 + width / 2))
        rows = rounded_decaying(block, z, lower, DOUBLE_BITS)
        growing = None if rows is None else rounded_growing(block, p, upper, DOUBLE_BITS)
        if rows is not None and growing is not None:
            return Limit(lower, upper, None, rows, "PROVED", (growing, around(block, growing)))
    return None
