"""Put exact matrices into the formulas of `theory`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import reduce

from theory.algebra.block_matrices import Blocks
from theory.algebra.noncommuting import Form

Rows = tuple[tuple[Fraction, ...], ...]
"""An exact matrix, by rows."""

ZERO = Fraction(0)


def dot(x: Sequence[Fraction | int], y: Sequence[Fraction]) -> Fraction:
    """x' y."""
    return sum((b * a for a, b in zip(x, y, strict=True)), ZERO)


def multiply(a: Rows, b: Rows) -> Rows:
    """Matrix product."""
    columns = tuple(zip(*b, strict=True))
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def add(a: Rows, b: Rows, factor: Fraction | int = 1) -> Rows:
    """a + factor b."""
    return tuple(
        tuple(x + factor * y for x, y in zip(left, right, strict=True))
        for left, right in zip(a, b, strict=True)
    )


def scaled(factor: Fraction | int, a: Rows) -> Rows:
    """factor a."""
    return tuple(tuple(factor * x for x in row) for row in a)


def trace(a: Rows) -> Fraction:
    """Sum of the diagonal."""
    return sum((row[i] for i, row in enumerate(a)), ZERO)


def identity(n: int) -> Rows:
    """The n by n identity."""
    return tuple(tuple(Fraction(i == j) for j in range(n)) for i in range(n))


def quadratic(x: Sequence[Fraction | int], a: Rows) -> Fraction:
    """x' a x."""
    return dot(x, [dot(x, row) for row in zip(*a, strict=True)])


def matrices(form: Form, values: Mapping[str, Rows], scalar: str = "h") -> dict[int, Rows]:
    """Coefficients of the powers of one scalar in a form, with matrices put in for its letters.

    Parameters
    ----------
    form : Form
        A polynomial in `scalar` and letters.
    values : mapping of str to Rows
        A square matrix for every letter, all of one size.
    scalar : str, optional
        The scalar whose powers are kept apart.

    Returns
    -------
    dict of int to Rows
        Power of `scalar` to matrix; powers that do not occur are left out.
    """
    n = len(next(iter(values.values())))
    out: dict[int, Rows] = {}
    for (scalars, word), a in form.terms.items():
        powers = dict(scalars)
        factors = [
            tuple(zip(*values[letter[:-1]], strict=True))
            if letter.endswith("'")
            else values[letter]
            for letter in word
        ]
        product = scaled(a, reduce(multiply, factors) if factors else identity(n))
        power = powers.get(scalar, 0)
        out[power] = add(out[power], product) if power in out else product
    return out


def at(form: Form, values: Mapping[str, Rows], h: Fraction) -> Rows:
    """The form's value with matrices put in for its letters and h for its scalar ``h``."""
    n = len(next(iter(values.values())))
    total = scaled(0, identity(n))
    for power, rows in matrices(form, values).items():
        total = add(total, rows, h**power)
    return total


def assembled(blocks: Blocks, values: Mapping[str, Rows], h: Fraction) -> Rows:
    """A block matrix of forms with matrices put in for its letters and h for its scalar ``h``."""
    parts = [[at(form, values, h) for form in row] for row in blocks.rows]
    return tuple(
        tuple(x for block in row for x in block[i]) for row in parts for i in range(len(row[0]))
    )
