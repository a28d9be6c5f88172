"""Decide positive semidefiniteness of exact symmetric matrices, with a witness either way."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from .evaluate import Rows

ZERO, ONE = Fraction(0), Fraction(1)


@dataclass(frozen=True)
class Split:
    """What elimination with symmetric pivots finds of a symmetric matrix A of n rows.

    Parameters
    ----------
    factor : Rows or None
        n by r with A = L diag(D) L', D > 0; None if A is not positive semidefinite. For A = 0 one
        column of zeros.
    pivots : tuple of Fraction
        D.
    rows : tuple of int
        The rows of the pivots: A restricted to them is positive definite, of the rank of A.
    kernel : Rows
        Vectors that span the kernel of A, a row each.
    vector : tuple of Fraction or None
        x with x'Ax < 0 where A is not positive semidefinite.
    """

    factor: Rows | None
    pivots: tuple[Fraction, ...] = ()
    rows: tuple[int, ...] = ()
    kernel: Rows = ()
    vector: tuple[Fraction, ...] | None = None


def split(rows: Rows) -> Split:
    """Factor a symmetric matrix, or find a vector at which its form is negative.

    Parameters
    ----------
    rows : Rows
        Symmetric, exact.
    """
    size = range(len(rows))
    left = [list(row) for row in rows]
    # steps[i] is x with x'A y = (row i of left) y for what is left of A
    steps = [[ONE if i == j else ZERO for j in size] for i in size]
    live, columns, chosen = list(size), [], []
    while live:
        negative = _negative(left, live)
        if negative is not None:
            x = [sum((c * steps[i][j] for i, c in negative), ZERO) for j in size]
            return Split(None, vector=tuple(x))
        pivot = next((i for i in live if left[i][i] > 0), None)
        if pivot is None:
            break
        live.remove(pivot)
        ratio = {i: left[i][pivot] / left[pivot][pivot] for i in live}
        columns.append([ONE if i == pivot else ratio.get(i, ZERO) for i in size])
        chosen.append(pivot)
        for i, factor in ratio.items():
            if factor:
                left[i] = [a - factor * b for a, b in zip(left[i], left[pivot], strict=True)]
                steps[i] = [a - factor * b for a, b in zip(steps[i], steps[pivot], strict=True)]
    kernel = tuple(tuple(steps[i]) for i in live)
    if not chosen:
        return Split(tuple((ZERO,) for _ in size), (ONE,), kernel=kernel)
    pivots = tuple(left[i][i] for i in chosen)
    return Split(tuple(zip(*columns, strict=True)), pivots, tuple(chosen), kernel)


def _negative(left: list[list[Fraction]], live: list[int]) -> list[tuple[int, Fraction]] | None:
    """Multiples of rows, at whose sum the form of what is left is negative."""
    for i in live:
        if left[i][i] < 0:
            return [(i, ONE)]
        if left[i][i]:
            continue
        for j in live:
            if left[i][j]:  # |t x_i + x_j|: 2 t a_ij + a_jj is -1 for this t
                return [(i, -(left[j][j] + 1) / (2 * left[i][j])), (j, ONE)]
    return None
