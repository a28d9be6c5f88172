"""The spectral radius of the second-moment operator of one update, in certified bounds."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from verification.answers import Answer
from verification.exact.evaluate import Rows
from verification.exact.rationals import above, below, nearest
from verification.exact.roots import Algebraic
from verification.exact.spectra.spectral import spectral_radius as matrix_radius
from verification.input_words import positive

from ..block_inputs import Block, block_of
from .iterated import leading_multiplier
from .limits import ALGEBRAIC, BITS, DOUBLE_BITS, LARGE_BITS, MOST_STACKED, WIDTHS, rational
from .moments import exact_operators, fmpq, rows_of
from .stacked import Matrix, Stacked, whole
from .witnesses import ROUNDINGS, algebraic_radius, flint_of, multiplies

PLANE = 2
"""Coordinates up to which the operator may leave a singular second moment as it is."""

TIGHT = WIDTHS[:3]

SMALL = Fraction(1, 10**11)
"""Residual up to which a candidate is an answer."""

FLOATING = "computed in doubles; no bounds of relative width 1e-6 were proved"


def spectral_radius(values: Mapping[str, Any]) -> Answer:
    """Factor by which one update multiplies the second moments of the homogeneous error at last.

    Parameters
    ----------
    values : mapping
        The inputs of `block_inputs.BLOCK`, and ``alpha``.

    Returns
    -------
    Answer
        Exact for up to four coordinates.

    Raises
    ------
    InputError
        As `block_inputs.block_of`; alpha <= 0.
    """
    block, step = block_of(values), positive(values, "alpha", "a step")
    if block.size > MOST_STACKED:
        return _large(block, step)
    stacked = Stacked(block)
    if block.size <= PLANE:
        try:
            return _planar(stacked, step)
        except OverflowError:  # numbers beyond the range of doubles
            pass
    for bits in BITS:
        found = stacked.multiplier(step, bits)
        ends = (
            None
            if found is None
            else _proved(block, step, *found, Fraction(1, 2 ** (bits // 2 - 24)))
        )
        if found is not None and ends is not None:
            exact = algebraic_radius(stacked, step, found[0]) if block.size <= ALGEBRAIC else None
            return _answer(exact, nearest(found[0]), *ends)
    return Answer(notes=(FLOATING,), verdict="UNDECIDED")


def _planar(stacked: Stacked, step: Fraction) -> Answer:
    found = matrix_radius(rows_of(stacked.update(step)))
    if found.lower is None or found.upper is None:
        return Answer(value=found.value, notes=(found.stage,))
    exact = algebraic_radius(stacked, step, Fraction(found.value))
    low, high = Fraction(found.lower), Fraction(found.upper)
    if exact is not None and exact.low == exact.high:
        low = high = exact.low
    if not high:  # one update may leave nothing
        exact = rational(low)
    return _answer(exact, found.value, low, high)


def _answer(exact: Algebraic | None, near: float, low: Fraction, high: Fraction) -> Answer:
    return Answer(
        value=exact.nearest if exact else near,
        exact=exact.to_data() if exact else None,
        lower=below(low),
        upper=above(high),
        verdict="PROVED",
    )


def _proved(
    block: Block, step: Fraction, near: Fraction, p: Matrix, width: Fraction, least: int = 0
) -> tuple[Fraction, Fraction] | None:
    """Bounds of this relative half-width, if some rounding of P proves them."""
    low, high = near * (1 - width), near * (1 + width)
    if any(row[i] <= 0 for i, row in enumerate(p)):
        return None
    roundings: list[Rows] = [whole(p, bits) for bits in ROUNDINGS if least <= bits <= 512]
    proved = any(multiplies(block, rows, step, low, high) for rows in roundings)
    return (low, high) if proved else None


def _large(block: Block, step: Fraction) -> Answer:
    near, p = None, list[list[Fraction]]()
    for bits, widths in ((None, TIGHT), (LARGE_BITS[0], WIDTHS), (LARGE_BITS[1], WIDTHS)):
        found = leading_multiplier(block, step, bits)
        if found is None:
            continue
        near, p = found
        for width in widths:
            ends = _proved(block, step, near, p, width / 2, DOUBLE_BITS)
            if ends is not None:
                return _answer(None, nearest(near), *ends)
    if near is None or _residual(block, step, near, p) > SMALL:
        return Answer(verdict="UNDECIDED", notes=(FLOATING,))
    return Answer(value=nearest(near), notes=(FLOATING,))


def _residual(block: Block, step: Fraction, near: Fraction, p: Matrix) -> Fraction:
    """Largest entry of L(P) - near P over that of P."""
    operators, matrix = exact_operators(block), fmpq(tuple(map(tuple, p)))
    image = matrix - operators.pull(matrix) * flint_of(step)
    image = image + operators.kick(matrix) * flint_of(step) ** 2 - matrix * flint_of(near)
    missed, whole_ = (max(abs(x) for row in rows_of(m) for x in row) for m in (image, matrix))
    return missed / whole_
