"""Matrices that depend affinely on named unknown matrices, with exact coefficients."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Any

from verification.exact.evaluate import Rows, add, identity, scaled


@dataclass(frozen=True)
class Unknown:
    """A matrix to be found.

    Parameters
    ----------
    name : str
        Key of its value.
    rows, columns : int
        Shape.
    symmetric : bool
        Equal to its transpose.
    """

    name: str
    rows: int
    columns: int
    symmetric: bool


@dataclass(frozen=True)
class Term:
    """left X right, or left X' right, for one unknown X."""

    left: Rows
    unknown: Unknown
    flipped: bool
    right: Rows

    def at(self, value: Rows) -> Rows:
        """The term for one value of its unknown."""
        return product(product(self.left, _transpose(value) if self.flipped else value), self.right)


@dataclass(frozen=True)
class Affine:
    """A constant matrix plus terms left X right.

    Sums, multiples by rationals, transposes (``.T``) and products with constants (``@``) are again
    affine, so that an inequality is written as it is printed: ``r**2 * P - A.T @ P @ A``.

    Parameters
    ----------
    constant : Rows
        Exact.
    terms : tuple of Term
        All of the constant's shape.
    """

    constant: Rows
    terms: tuple[Term, ...] = ()

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return len(self.constant), len(self.constant[0])

    @property
    def unknowns(self) -> dict[str, Unknown]:
        """The unknowns that occur, by name."""
        return {term.unknown.name: term.unknown for term in self.terms}

    @property
    def T(self) -> Affine:
        """The transpose."""
        terms = (
            Term(
                _transpose(term.right),
                term.unknown,
                not (term.flipped or term.unknown.symmetric),
                _transpose(term.left),
            )
            for term in self.terms
        )
        return Affine(_transpose(self.constant), tuple(terms))

    def __add__(self, other: Affine) -> Affine:
        if self.shape != other.shape:
            raise ValueError(f"shapes {self.shape} and {other.shape}; a sum needs like shapes")
        return Affine(add(self.constant, other.constant), self.terms + other.terms)

    def __mul__(self, factor: int | Fraction) -> Affine:
        terms = (Term(scaled(factor, t.left), t.unknown, t.flipped, t.right) for t in self.terms)
        return Affine(scaled(factor, self.constant), tuple(terms))

    __rmul__ = __mul__

    def __neg__(self) -> Affine:
        return self * -1

    def __sub__(self, other: Affine) -> Affine:
        return self + -other

    def __matmul__(self, other: Affine) -> Affine:
        if self.terms and other.terms:
            raise ValueError("a product of two unknown matrices; one factor must be constant")
        if self.shape[1] != other.shape[0]:
            raise ValueError(f"shapes {self.shape} and {other.shape}; they do not multiply")
        left = (
            Term(t.left, t.unknown, t.flipped, product(t.right, other.constant)) for t in self.terms
        )
        right = (
            Term(product(self.constant, t.left), t.unknown, t.flipped, t.right) for t in other.terms
        )
        return Affine(product(self.constant, other.constant), (*left, *right))

    def at(self, values: Mapping[str, Rows]) -> Rows:
        """The exact matrix for exact values of the unknowns."""
        total = self.constant
        for term in self.terms:
            total = add(total, term.at(values[term.unknown.name]))
        return total

    def expression(self, variables: Mapping[str, Any]) -> Any:
        """The same in doubles, for variables of cvxpy or arrays of numpy."""
        import numpy as np

        def doubles(rows: Rows) -> Any:
            return np.array([[float(x) for x in row] for row in rows])

        total = doubles(self.constant)
        for term in self.terms:
            x = variables[term.unknown.name]
            total = total + doubles(term.left) @ (x.T if term.flipped else x) @ doubles(term.right)
        return total


def known(rows: Rows) -> Affine:
    """A constant matrix."""
    return Affine(rows)


def symmetric(name: str, n: int) -> Affine:
    """An unknown symmetric n x n matrix."""
    return _unknown(Unknown(name, n, n, True))


def rectangular(name: str, rows: int, columns: int) -> Affine:
    """An unknown matrix without structure."""
    return _unknown(Unknown(name, rows, columns, False))


def block(parts: Sequence[Sequence[Affine]]) -> Affine:
    """Put affine matrices side by side and below each other.

    Parameters
    ----------
    parts : sequence of sequence of Affine
        Block rows; the parts of a row have like heights, those of a column like widths.
    """
    heights = [row[0].shape[0] for row in parts]
    widths = [part.shape[1] for part in parts[0]]
    total = Affine(scaled(0, _unit_rows(sum(heights), sum(widths), 0)))
    for i, row in enumerate(parts):
        if len(row) != len(widths):
            raise ValueError(f"block row {i + 1} has {len(row)} parts; {len(widths)} are needed")
        for j, part in enumerate(row):
            if part.shape != (heights[i], widths[j]):
                raise ValueError(
                    f"block {i + 1},{j + 1} is {part.shape}; ({heights[i]}, {widths[j]}) is needed"
                )
            down = _unit_rows(sum(heights), heights[i], sum(heights[:i]))
            along = _transpose(_unit_rows(sum(widths), widths[j], sum(widths[:j])))
            total = total + known(down) @ part @ known(along)
    return total


def product(a: Rows, b: Rows) -> Rows:
    """Matrix product in whole numbers of `flint`, which keeps n = 60 quick."""
    if a == identity(len(b)):
        return b
    if b == identity(len(a[0])):
        return a
    (left, above), (right, below) = _whole(a), _whole(b)
    unit = above * below
    return tuple(tuple(Fraction(int(x), unit) for x in row) for row in (left * right).tolist())


def _whole(a: Rows) -> tuple[Any, int]:
    """Integers and their common denominator."""
    import flint

    unit = lcm(*(x.denominator for row in a for x in row))
    return flint.fmpz_mat([[int(x * unit) for x in row] for row in a]), unit


def _unknown(unknown: Unknown) -> Affine:
    zero = tuple((Fraction(0),) * unknown.columns for _ in range(unknown.rows))
    term = Term(identity(unknown.rows), unknown, False, identity(unknown.columns))
    return Affine(zero, (term,))


def _unit_rows(rows: int, columns: int, first: int) -> Rows:
    """Zeros with the identity from row `first` on."""
    return tuple(tuple(Fraction(i - first == j) for j in range(columns)) for i in range(rows))


def _transpose(a: Rows) -> Rows:
    return tuple(zip(*a, strict=True))
