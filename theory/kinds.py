"""What a formula stands for: its unit and its shape, and what functions make of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from .units import NUMBER, Unit, parse_unit

Size = int | str
SECOND = parse_unit("s")


class FormulaError(ValueError):
    """A formula that cannot be read, or whose units or shapes do not fit."""


@dataclass(frozen=True)
class Kind:
    """Unit and shape of a quantity.

    Parameters
    ----------
    unit : Unit
    shape : tuple of (int or str)
        Rows and columns; a vector has one column, a scalar is 1 by 1. A text is a dimension.
    """

    unit: Unit
    shape: tuple[Size, Size] = (1, 1)

    @property
    def scalar(self) -> bool:
        """Whether it is one number."""
        return self.shape == (1, 1)

    def __str__(self) -> str:
        """Return shape and unit for messages."""
        return f"{self.shape[0]} by {self.shape[1]} in {self.unit}"


def need(condition: bool, message: str) -> None:
    """Raise FormulaError unless the condition holds."""
    if not condition:
        raise FormulaError(message)


def _transpose(x: Kind) -> Kind:
    return Kind(x.unit, x.shape[::-1])


def _inverse(x: Kind) -> Kind:
    need(x.shape[0] == x.shape[1], f"inv of {x}; a square matrix is needed")
    return Kind(x.unit**-1, x.shape)


def _rate(x: Kind) -> Kind:
    return Kind(x.unit / SECOND, x.shape)


def _same(x: Kind) -> Kind:
    return x


def _size(x: Kind) -> Kind:
    return Kind(x.unit)


def _sign(x: Kind) -> Kind:
    return Kind(NUMBER, x.shape)


def _root(x: Kind) -> Kind:
    need(x.scalar, f"sqrt of {x}; a scalar is needed")
    return Kind(x.unit ** Fraction(1, 2))


def _angle(x: Kind) -> Kind:
    need(x == Kind(NUMBER), f"sin or cos of {x}; an angle is needed")
    return x


def _determinant(x: Kind) -> Kind:
    rows, columns = x.shape
    need(rows == columns, f"det of {x}; a square matrix is needed")
    need(isinstance(rows, int) or x.unit == NUMBER, f"det of {x}; a size is needed")
    return Kind(x.unit**rows if isinstance(rows, int) else NUMBER)


def _column(*entries: Kind) -> Kind:
    good = {entry.shape for entry in entries} == {(1, 1)} and len({*entries}) == 1
    need(good, "column of unlike entries; scalars of one unit are needed")
    return Kind(entries[0].unit, (len(entries), 1))


FUNCTIONS: Mapping[str, tuple[int | None, Callable[..., Kind]]] = {
    "T": (1, _transpose),
    "inv": (1, _inverse),
    "d": (1, _rate),
    "next": (1, _same),
    "previous": (1, _same),
    "sum": (1, _same),
    "mean": (1, _same),
    "norm": (1, _size),
    "largest": (1, _size),
    "sgn": (1, _sign),
    "sqrt": (1, _root),
    "sin": (1, _angle),
    "cos": (1, _angle),
    "det": (1, _determinant),
    "column": (None, _column),
}
"""Name to number of arguments (None: any) and what the result is."""
