"""Decide positive definiteness of exact symmetric matrices, with a witness either way.

Positive: an integer matrix G such that G E G' is strictly diagonally dominant. Negative: an integer
vector x, not 0, with x' E x <= 0. One of the two exists for every symmetric rational matrix.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import numpy as np

from .balls import ball_ldl, ball_rows, half_exponent
from .evaluate import Rows, quadratic

PRECISIONS = (64, 160, 400, 1000, 2500)
WITNESS_BITS = (4, 8, 12, 16, 24, 32, 48, 64, 96, 160, 320, 640, 1280, 2560)


def asymmetry(rows: Rows) -> tuple[int, int] | None:
    """The first (i, j) with unlike entries across the diagonal, or None."""
    n = len(rows)
    return next(
        ((i, j) for i in range(n) for j in range(i + 1, n) if rows[i][j] != rows[j][i]), None
    )


def integers(rows: Rows) -> list[list[int]]:
    """The same matrix times its common denominator."""
    unit = lcm(*(x.denominator for row in rows for x in row))
    return [[int(x * unit) for x in row] for row in rows]


def congruence(rows: Rows) -> list[list[int]] | None:
    """Witness that a symmetric matrix is positive definite.

    Parameters
    ----------
    rows : Rows
        Symmetric, exact.

    Returns
    -------
    list of list of int, or None
        Lower triangular G with G E G' strictly diagonally dominant; None if the matrix is not
        positive definite, or so close to singular that 2500 bits do not tell.
    """
    import flint

    n = len(rows)
    if any(rows[i][i] <= 0 for i in range(n)):
        return None
    exact = flint.fmpz_mat(integers(rows))
    for bits in PRECISIONS:
        lower, pivots = ball_ldl(ball_rows(rows, bits))
        if pivots[-1] < 0:
            return None
        if not (len(pivots) == n and pivots[-1] > 0):
            continue
        factor = _inverse_factor(lower, pivots, rows, bits)
        for keep in (b for b in WITNESS_BITS if b <= bits):
            g = _rounded(factor, keep)
            if _dominant(flint.fmpz_mat(g) * exact * flint.fmpz_mat(g).transpose()):
                return g
    return None


def _inverse_factor(
    lower: list[list[Any]], pivots: list[Any], rows: Rows, bits: int
) -> list[list[Any]]:
    """D^(-1/2) L^(-1) with the diagonal scaling of `ball_rows` put back, as midpoints."""
    import flint

    n = len(pivots)
    flint.ctx.prec = bits
    inverse: list[list[Any]] = []
    for i in range(n):
        row = [flint.arb(0)] * n
        row[i] = flint.arb(1)
        for k in range(i):
            weight = lower[i][k].mid()
            for j in range(k + 1):
                row[j] -= weight * inverse[k][j]
        inverse.append([x.mid() for x in row])
    shift = [flint.arb(2) ** -half_exponent(rows[j][j]) for j in range(n)]
    return [
        [(x * s / d.mid().sqrt()).mid() for x, s in zip(row, shift, strict=True)]
        for row, d in zip(inverse, pivots, strict=True)
    ]


def _rounded(factor: list[list[Any]], keep: int) -> list[list[int]]:
    """Entries times a power of two, such that about `keep` bits of the largest remain a row."""
    import flint

    sizes = [max(float(abs(x).log()) for x in row if x != 0) for row in factor]
    scale = flint.arb(2) ** (keep - int(np.floor(min(sizes) / np.log(2.0))))
    return [[int((x * scale).mid().floor().unique_fmpz() or 0) for x in row] for row in factor]


def _dominant(product: Any) -> bool:
    return all(2 * row[i] > sum(abs(x) for x in row) for i, row in enumerate(product.tolist()))


ENTRIES = 4
"""Entries a coefficient, from which a combination is guessed before all entries are compared."""


def combination(
    rows: Sequence[Sequence[Fraction]], proved: Mapping[int, Sequence[Sequence[Fraction]]]
) -> list[tuple[int, Fraction]]:
    """Write a matrix as a sum of proved ones with coefficients that are not negative.

    Parameters
    ----------
    rows : sequence of sequence of Fraction
        The matrix.
    proved : mapping of int to rows
        Matrices by index.

    Returns
    -------
    list of (index, coefficient)
        Empty if there is no such sum.
    """
    same = {k: m for k, m in proved.items() if len(m) == len(rows)}
    entries = [(i, j) for i in range(len(rows)) for j in range(i + 1)]
    few = entries[:: max(1, len(entries) // (ENTRIES * len(same) + 1))]
    for places in (few, entries):  # a few entries nearly always fix the coefficients
        equations = [[m[i][j] for m in same.values()] + [rows[i][j]] for i, j in places]
        coefficients = _solved(equations, len(same))
        if coefficients is None or any(c < 0 for c in coefficients) or not any(coefficients):
            return []
        found = [(k, c) for k, c in zip(same, coefficients, strict=True) if c]
        if _adds_up(rows, [(c, same[k]) for k, c in found]):
            return found
    return []


def _adds_up(
    rows: Sequence[Sequence[Fraction]],
    parts: Sequence[tuple[Fraction, Sequence[Sequence[Fraction]]]],
) -> bool:
    """Tell whether the matrix is this sum."""
    return all(
        row[j] == sum((c * m[i][j] for c, m in parts), Fraction(0))
        for i, row in enumerate(rows)
        for j in range(i + 1)
    )


def _solved(equations: list[list[Fraction]], unknowns: int) -> list[Fraction] | None:
    """A solution of an overdetermined linear system, if it has one."""
    pivots: dict[int, list[Fraction]] = {}
    for equation in equations:
        row = equation
        for column, pivot in pivots.items():
            if row[column]:
                row = [a - row[column] * b for a, b in zip(row, pivot, strict=True)]
        lead = next((j for j in range(unknowns) if row[j]), None)
        if lead is None:
            if row[-1]:
                return None
            continue
        row = [a / row[lead] for a in row]
        for column, pivot in pivots.items():
            pivots[column] = [a - pivot[lead] * b for a, b in zip(pivot, row, strict=True)]
        pivots[lead] = row
    return [pivots[j][-1] if j in pivots else Fraction(0) for j in range(unknowns)]


def negative_vector(rows: Rows) -> tuple[int, ...] | None:
    """An integer vector x, not 0, with x' E x <= 0.

    Parameters
    ----------
    rows : Rows
        Symmetric, exact.

    Returns
    -------
    tuple of int, or None
        None if the matrix is positive definite.
    """
    if congruence(rows) is not None:
        return None
    x = _float_vector(rows) or _exact_vector(rows)
    return tuple(v // gcd(*x) for v in x) if x else None


def is_definite(rows: Rows) -> bool:
    """Is the symmetric matrix positive definite? Exact for every rational matrix."""
    return negative_vector(rows) is None


def _float_vector(rows: Rows) -> tuple[int, ...] | None:
    """Round the eigenvector of the smallest eigenvalue and keep it if it does the job exactly."""
    size = max(abs(x) for row in rows for x in row) or Fraction(1)
    values, vectors = np.linalg.eigh(np.array([[float(x / size) for x in row] for row in rows]))
    if not np.isfinite(values[0]):
        return None
    for keep in (4, 8, 16, 30, 50):
        x = tuple(int(v) for v in np.rint(vectors[:, 0] * 2.0**keep))
        if any(x) and quadratic(x, rows) <= 0:
            return x
    return None


def _exact_vector(rows: Rows) -> tuple[int, ...] | None:
    """From the first leading block that is not positive definite: x = (-A^{-1} b, 1)."""
    import flint

    n = len(rows)
    whole = flint.fmpq_mat([[flint.fmpq(x.numerator, x.denominator) for x in row] for row in rows])
    for k in range(n):
        x = [Fraction(0)] * k + [Fraction(1)]
        if k:
            block = flint.fmpq_mat([[whole[i, j] for j in range(k)] for i in range(k)])
            side = flint.fmpq_mat([[-whole[i, k]] for i in range(k)])
            solution = block.solve(side)
            x[:k] = [Fraction(int(solution[i, 0].p), int(solution[i, 0].q)) for i in range(k)]
        full = tuple(x) + (Fraction(0),) * (n - k - 1)
        if quadratic(full, rows) <= 0:
            unit = lcm(*(v.denominator for v in full))
            return tuple(int(v * unit) for v in full)
    return None


def as_rows(values: Sequence[Sequence[Fraction | int]]) -> Rows:
    """Exact rows from nested sequences."""
    return tuple(tuple(Fraction(x) for x in row) for row in values)
