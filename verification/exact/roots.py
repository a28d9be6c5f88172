"""Real algebraic numbers: a root as an irreducible polynomial and an interval that isolates it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from .rationals import nearest

MAX_DEGREE = 12


@dataclass(frozen=True)
class Algebraic:
    """A real algebraic number.

    Parameters
    ----------
    polynomial : tuple of int
        Irreducible over the rationals, coefficients ascending, leading one positive.
    low, high : Fraction
        An interval that holds this root and no other; equal for a rational number.
    nearest : float
        The double nearest to the number.
    """

    polynomial: tuple[int, ...]
    low: Fraction
    high: Fraction
    nearest: float

    def to_data(self) -> dict[str, Any] | None:
        """The ``exact`` field of an answer; None above degree 12."""
        if len(self.polynomial) == 2:
            return {"kind": "rational", "value": str(self.low)}
        if len(self.polynomial) - 1 > MAX_DEGREE:
            return None
        interval = [_decimal(self.low), _decimal(self.high)]
        return {"kind": "algebraic", "polynomial": list(self.polynomial), "interval": interval}


def _decimal(x: Fraction) -> str:
    return str(x)


def interpolate(values: Callable[[int], Fraction], degree: int) -> tuple[int, ...]:
    """Primitive integer polynomial that is a rational multiple of the one with these values.

    Parameters
    ----------
    values : callable
        The polynomial's value at an integer.
    degree : int
        A bound on its degree.

    Returns
    -------
    tuple of int
        Coefficients ascending.
    """
    import flint

    points = range(degree + 1)
    system = flint.fmpq_mat([[flint.fmpq(k) ** j for j in points] for k in points])
    wanted = [values(k) for k in points]
    side = flint.fmpq_mat([[flint.fmpq(v.numerator, v.denominator)] for v in wanted])
    solution = system.solve(side)
    poly = flint.fmpq_poly([solution[i, 0] for i in points])
    whole = flint.fmpz_poly(poly.numer().coeffs())
    return tuple(int(c) for c in whole.coeffs())


def determinant(rows: Sequence[Sequence[Fraction]]) -> Fraction:
    """Exact determinant."""
    import flint

    value = flint.fmpq_mat(
        [[flint.fmpq(x.numerator, x.denominator) for x in row] for row in rows]
    ).det()
    return Fraction(int(value.p), int(value.q))


def root_between(polynomial: Sequence[int], low: Fraction, high: Fraction) -> Algebraic | None:
    """The only root of a polynomial in (low, high].

    Parameters
    ----------
    polynomial : sequence of int
        Coefficients ascending.
    low, high : Fraction
        Ends of a narrow interval.

    Returns
    -------
    Algebraic or None
        None if the interval holds no root or several.
    """
    import flint

    _, factors = flint.fmpz_poly(list(polynomial)).factor()
    found = [_isolated(factor, low, high) for factor, _ in factors]
    roots = [root for root in found if root is not None]
    return roots[0] if len(roots) == 1 else None


def _isolated(factor: Any, low: Fraction, high: Fraction) -> Algebraic | None:
    import flint

    coefficients = tuple(int(c) for c in factor.coeffs())
    if coefficients[-1] < 0:
        coefficients = tuple(-c for c in coefficients)
    if len(coefficients) == 2:
        value = Fraction(-coefficients[0], coefficients[1])
        inside = low < value <= high
        return Algebraic(coefficients, value, value, nearest(value)) if inside else None
    flint.ctx.prec = 256
    real = [r.real for r, _ in factor.complex_roots() if r.imag.contains(0)]
    close = [r for r in real if _arb(low) < r < _arb(high)]
    if len(close) != 1:
        return None
    root = close[0]
    decade = int(float(abs(root.mid()).log() / flint.arb(10).log()))
    for digits in range(3, 60):
        unit = Fraction(10) ** (decade - digits)
        floor = Fraction(int((root / _arb(unit)).floor().unique_fmpz() or 0)) * unit
        ceiling = floor + unit
        if sum(not (r < _arb(floor) or r > _arb(ceiling)) for r in real) == 1:
            return Algebraic(coefficients, floor, ceiling, float(root.mid()))
    return None


def _arb(x: Fraction) -> Any:
    import flint

    return flint.arb(flint.fmpq(x.numerator, x.denominator))
