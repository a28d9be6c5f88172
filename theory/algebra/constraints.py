"""Linear constraints Hx = q: an exact basis of what they leave free, and the reduced problem.

Letters of the identities: ``H`` (l x d), ``N`` (d x m, a basis of the kernel of H), ``W`` and ``Y``
(inverses of N'N and of HH'), ``x`` (a point), ``q``, ``y`` (a reduced point).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from .identities import ONE, Identity, hypotheses, identity
from .noncommuting import letters

Row = list[Fraction]
Matrix = list[Row]


@dataclass(frozen=True)
class Reduction:
    """How points of a linear constraint are written with fewer numbers.

    h(x) = W N'x takes a point to its reduced one, and g(y) = N y + H'Y q takes it back.

    Parameters
    ----------
    basis : list of list of Fraction
        N, d x (d - l): its columns span the kernel of H.
    gram_inverse : list of list of Fraction
        W, the inverse of N'N.
    row_inverse : list of list of Fraction
        Y, the inverse of HH'.
    """

    basis: Matrix
    gram_inverse: Matrix
    row_inverse: Matrix


def _product(a: Matrix, b: Matrix) -> Matrix:
    columns = list(zip(*b, strict=True))
    return [
        [sum((x * y for x, y in zip(r, c, strict=True)), Fraction(0)) for c in columns] for r in a
    ]


def _transposed(a: Matrix) -> Matrix:
    return [list(column) for column in zip(*a, strict=True)]


def reduced_rows(rows: Sequence[Sequence[Fraction | int]]) -> tuple[Matrix, list[int]]:
    """Gauss-Jordan elimination: rows that are not zero, and the columns of their leading ones."""
    matrix, pivots, at = [[Fraction(x) for x in row] for row in rows], list[int](), 0
    for column in range(len(matrix[0]) if matrix else 0):
        found = next((i for i in range(at, len(matrix)) if matrix[i][column]), None)
        if found is None:
            continue
        matrix[at], matrix[found] = matrix[found], matrix[at]
        lead = matrix[at][column]
        matrix[at] = [x / lead for x in matrix[at]]
        for i, row in enumerate(matrix):
            if i != at and row[column]:
                factor = row[column]
                matrix[i] = [x - factor * y for x, y in zip(row, matrix[at], strict=True)]
        pivots.append(column)
        at += 1
    return matrix[:at], pivots


def null_space(rows: Sequence[Sequence[Fraction | int]]) -> Matrix:
    """Basis of the kernel of a matrix, exactly.

    Parameters
    ----------
    rows : sequence of sequence of rational
        l x d.

    Returns
    -------
    list of list of Fraction
        d x (d - rank); no columns (d empty rows) if the kernel is zero.

    Raises
    ------
    ValueError
        There is no row, or the rows differ in length.
    """
    if not rows or len({len(row) for row in rows}) != 1:
        raise ValueError("rows: of a matrix, one at least and all of one length, are needed")
    lead, pivots = reduced_rows(rows)
    d = len(rows[0])
    free = [k for k in range(d) if k not in pivots]
    basis = [[Fraction(0)] * len(free) for _ in range(d)]
    for j, column in enumerate(free):
        basis[column][j] = Fraction(1)
        for row, pivot in zip(lead, pivots, strict=True):
            basis[pivot][j] = -row[column]
    return basis


def inverse(rows: Matrix) -> Matrix:
    """Inverse of a square matrix, exactly.

    Raises
    ------
    ValueError
        It has none.
    """
    n = len(rows)
    wide = [[*row, *(Fraction(i == j) for j in range(n))] for i, row in enumerate(rows)]
    lead, pivots = reduced_rows(wide)
    if pivots != list(range(n)):
        raise ValueError("rows: a matrix without inverse")
    return [row[n:] for row in lead]


def reduction(rows: Sequence[Sequence[Fraction | int]]) -> Reduction:
    """The functions h and g of a constraint Hx = q with independent rows.

    Parameters
    ----------
    rows : sequence of sequence of rational
        H, l x d with l < d.

    Returns
    -------
    Reduction

    Raises
    ------
    ValueError
        The rows are dependent, or as many as the columns, so that nothing is left free.
    """
    basis, matrix = null_space(rows), [[Fraction(x) for x in row] for row in rows]
    d, left = len(basis), len(basis[0])
    if left != d - len(rows):
        raise ValueError(f"rows: rank {d - left} of {len(rows)} rows; independent ones are needed")
    if left == 0:
        raise ValueError(f"rows: {d} independent ones of {d} columns leave nothing free")
    gram = inverse(_product(_transposed(basis), basis))
    return Reduction(basis, gram, inverse(_product(matrix, _transposed(matrix))))


def reduced() -> tuple[Identity, ...]:
    """g and h are inverse to each other between the constraint set and the reduced space.

    Returns
    -------
    tuple of Identity
        The letters of the module, ``z`` (any reduced point).
    """
    h, n, w, y, x, q, z = letters("H N W Y x q z", ("W", "Y"))
    relations = (
        n * w * n.T + h.T * y * h - ONE,
        h * x - q,
        h * n,
        h * h.T * y - ONE,
        w * n.T * n - ONE,
    )
    complete, on, kernel, rows, gram = hypotheses(relations)
    back = n * z + h.T * y * q
    return (
        identity(
            "g(h(x)) = x on the constraint set",
            n * w * n.T * x + h.T * y * q - x,
            relations,
            complete.before(x) - on.after(h.T * y),
        ),
        identity(
            "g(z) is on the constraint set",
            h * back - q,
            relations,
            kernel.before(z) + rows.before(q),
        ),
        identity(
            "h(g(z)) = z",
            w * n.T * back - z,
            relations,
            gram.before(z) + kernel.T.between(w, y * q),
        ),
    )
