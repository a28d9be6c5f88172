"""Linear equations of exact rationals."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction


def solved(
    matrix: Sequence[Sequence[Fraction]], side: Sequence[Fraction]
) -> tuple[Fraction, ...] | None:
    """The x with matrix x = side, or None if the matrix is singular.

    Parameters
    ----------
    matrix : sequence of rows of Fraction
        n by n.
    side : sequence of Fraction
        n entries.

    Returns
    -------
    tuple of Fraction or None
    """
    import flint

    left = flint.fmpq_mat([[flint.fmpq(x.numerator, x.denominator) for x in row] for row in matrix])
    right = flint.fmpq_mat([[flint.fmpq(x.numerator, x.denominator)] for x in side])
    try:
        solution = left.solve(right)
    except ZeroDivisionError:
        return None
    return tuple(Fraction(int(x.p), int(x.q)) for x in solution.entries())
