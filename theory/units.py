"""Units as exponents of base units: "kg m^2/s" and what products and powers make of it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

BASE = ("m", "kg", "s", "A", "K")
"""Base units of the SI that estimators meet."""

DERIVED: Mapping[str, Mapping[str, int]] = {
    "rad": {},
    "Hz": {"s": -1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
}
"""Coherent derived units. Prefixes and degrees carry a factor, and are refused for that reason."""

FACTOR = re.compile(r"([A-Za-z_]+)(?:\^(-?[1-9][0-9]*))?")


@dataclass(frozen=True)
class Unit:
    """A product of powers of base units.

    Parameters
    ----------
    powers : tuple of (str, Fraction)
        Base unit and its exponent, sorted, none of them zero. Empty for pure numbers.
    """

    powers: tuple[tuple[str, Fraction], ...] = ()

    def __mul__(self, other: Unit) -> Unit:
        total = dict(self.powers)
        for name, power in other.powers:
            total[name] = total.get(name, Fraction(0)) + power
        return Unit(tuple(sorted((name, power) for name, power in total.items() if power)))

    def __pow__(self, power: int | Fraction) -> Unit:
        return Unit(tuple((name, p * power) for name, p in self.powers if p * power))

    def __truediv__(self, other: Unit) -> Unit:
        return self * other**-1

    def __str__(self) -> str:
        """Return the unit in the notation that `parse_unit` reads."""
        above = [_factor(name, power) for name, power in self.powers if power > 0]
        below = [_factor(name, -power) for name, power in self.powers if power < 0]
        head = " ".join(above) or "1"
        return head + (f"/{' '.join(below)}" if below else "")


NUMBER = Unit()
"""The unit of pure numbers."""


def _factor(name: str, power: Fraction) -> str:
    return name if power == 1 else f"{name}^{power}"


def parse_unit(text: str, generic: Iterable[str] = ()) -> Unit:
    """Read a unit.

    Parameters
    ----------
    text : str
        Factors like ``kg`` or ``m^2`` separated by blanks, at most one ``/`` before those that
        divide, or ``1``: ``"kg m^2/s"``, ``"1/s^2"``, ``"rad"``.
    generic : iterable of str, optional
        Further base units, for quantities whose unit is left open.

    Returns
    -------
    Unit

    Raises
    ------
    ValueError
        The text is malformed or holds a unit that is not coherent.
    """
    above, *below = text.split("/")
    if len(below) > 1 or "1" in below:
        raise ValueError(f"unit: {text!r}; at most one '/' with units behind it is needed")
    unit = NUMBER if above == "1" else _product(above, text, set(generic))
    return unit / _product(below[0], text, set(generic)) if below else unit


def _product(factors: str, text: str, generic: set[str]) -> Unit:
    unit = NUMBER
    for factor in factors.split(" "):
        match = FACTOR.fullmatch(factor)
        name = match.group(1) if match else ""
        if match is None or (name not in DERIVED and name not in {*BASE, *generic}):
            known = ", ".join([*BASE, *DERIVED, *sorted(generic)])
            raise ValueError(f"unit: {factor!r} in {text!r}; a power of one of {known} is needed")
        powers = DERIVED.get(name, {name: 1})
        base = Unit(tuple(sorted((key, Fraction(power)) for key, power in powers.items())))
        unit = unit * base ** int(match.group(2) or 1)
    return unit
