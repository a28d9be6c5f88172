"""Matrices whose blocks are forms: systems of equations and energies, for blocks of any size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .noncommuting import Form
from .quadratic_forms import symmetrised


@dataclass(frozen=True)
class Blocks:
    """A matrix of forms.

    Parameters
    ----------
    rows : tuple of tuple of Form
        Rows of one length.

    Raises
    ------
    ValueError
        There is no block, or the rows differ in length.
    """

    rows: tuple[tuple[Form, ...], ...]

    def __post_init__(self) -> None:
        if not self.rows or not self.rows[0] or len({len(row) for row in self.rows}) != 1:
            raise ValueError("rows: rows of one length, above zero, are needed")

    @property
    def shape(self) -> tuple[int, int]:
        """Block rows and block columns."""
        return len(self.rows), len(self.rows[0])

    @property
    def T(self) -> Blocks:
        """The transpose."""
        return Blocks(tuple(tuple(x.T for x in column) for column in zip(*self.rows, strict=True)))

    def __add__(self, other: Blocks) -> Blocks:
        _require(self.shape == other.shape, f"a sum of {self.shape} and {other.shape}")
        pairs = zip(self.rows, other.rows, strict=True)
        return Blocks(tuple(tuple(a + b for a, b in zip(x, y, strict=True)) for x, y in pairs))

    def __neg__(self) -> Blocks:
        return Blocks(tuple(tuple(-x for x in row) for row in self.rows))

    def __sub__(self, other: Blocks) -> Blocks:
        return self + -other

    def __mul__(self, other: Blocks) -> Blocks:
        _require(self.shape[1] == other.shape[0], f"a product of {self.shape} and {other.shape}")
        columns = tuple(zip(*other.rows, strict=True))
        return Blocks(tuple(tuple(_dot(row, column) for column in columns) for row in self.rows))

    def __bool__(self) -> bool:
        """Whether any block is not zero."""
        return any(x.terms for row in self.rows for x in row)


def coefficients(equations: Sequence[Form], columns: Sequence[str]) -> Blocks:
    """The factors of some vectors in linear equations.

    Parameters
    ----------
    equations : sequence of Form
        Each a sum of products that end in a vector.
    columns : sequence of str
        The vectors.

    Returns
    -------
    Blocks
        One row an equation, one column a vector; terms of other vectors are left out.
    """
    return Blocks(tuple(tuple(line.before(name) for name in columns) for line in equations))


def hessian(form: Form, columns: Sequence[str]) -> Blocks:
    """The symmetric block matrix P of a quadratic form z'Pz.

    Parameters
    ----------
    form : Form
        1 by 1, of the second degree in the vectors.
    columns : sequence of str
        The vectors stacked in z.
    """
    even = symmetrised(form)
    return Blocks(
        tuple(tuple(even.after(f"{row}'").before(name) for name in columns) for row in columns)
    )


def _dot(row: Sequence[Form], column: Sequence[Form]) -> Form:
    total = Form({})
    for a, b in zip(row, column, strict=True):
        total = total + a * b
    return total


def _require(condition: bool, found: str) -> None:
    if not condition:
        raise ValueError(f"other: {found}; shapes that fit are needed")
