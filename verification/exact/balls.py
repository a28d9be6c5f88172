"""Second engine: LDL' in ball arithmetic, which never decides wrongly but may not decide."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any


def ball_rows(rows: Sequence[Sequence[Fraction]], bits: int) -> list[list[Any]]:
    """Enclose exact entries in balls of `bits` bits, after scaling each diagonal entry to about 1.

    The scaling is a congruence by powers of two, so that definiteness is unchanged.
    """
    import flint

    flint.ctx.prec = bits
    shift = [half_exponent(rows[i][i]) for i in range(len(rows))]
    return [
        [
            flint.arb(flint.fmpq(x.numerator, x.denominator))
            * flint.arb(2) ** (-shift[i] - shift[j])
            for j, x in enumerate(row)
        ]
        for i, row in enumerate(rows)
    ]


def half_exponent(x: Fraction) -> int:
    """Half the binary exponent of a number that is not zero, rounded down."""
    return (abs(x.numerator).bit_length() - x.denominator.bit_length()) // 2


def ball_ldl(balls: list[list[Any]]) -> tuple[list[list[Any]], list[Any]]:
    """Unit lower factor and pivots of LDL', up to the first pivot that is not certainly positive.

    Returns
    -------
    lower : list of list
        Unit lower triangular; only the entries below the diagonal of finished columns are set.
    pivots : list
        All n pivots if the matrix is certainly positive definite, else fewer or a last one that is
        not positive.
    """
    n = len(balls)
    lower: list[list[Any]] = [[None] * n for _ in range(n)]
    pivots: list[Any] = []
    for j in range(n):
        column = [lower[j][k] * pivots[k] for k in range(j)]
        pivots.append(balls[j][j] - sum(a * b for a, b in zip(lower[j], column, strict=False)))
        if not pivots[j] > 0:
            break
        for i in range(j + 1, n):
            rest = balls[i][j] - sum(a * b for a, b in zip(lower[i], column, strict=False))
            lower[i][j] = rest / pivots[j]
    return lower, pivots


def ball_definite(rows: Sequence[Sequence[Fraction]], bits: int = 128) -> bool | None:
    """Tell whether a symmetric matrix is positive definite.

    Parameters
    ----------
    rows : sequence of sequence of Fraction
        Symmetric, exact.
    bits : int, optional
        Precision of the balls.

    Returns
    -------
    bool or None
        True or False for certain, None if the balls are too wide to tell.
    """
    if any(rows[i][i] <= 0 for i in range(len(rows))):
        return False
    _, pivots = ball_ldl(ball_rows(rows, bits))
    if pivots[-1] > 0:
        return True
    return False if pivots[-1] < 0 else None
