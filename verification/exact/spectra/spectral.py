"""Two-sided certified brackets of spectral radii.

Candidates are computed in doubles first, which settles most matrices in milliseconds, and in more
bits where a proof fails: floats lose half of their digits at a defective eigenvalue.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError

from ..evaluate import Rows, identity
from ..rationals import above, below, nearest
from .modes import Modes, candidates, integer_matrices
from .stein import proves_above, proves_below

WIDTH = Fraction(1, 10**10)
"""Relative width aimed at for spectral radii."""

WIDER = tuple(Fraction(1, 10**k) for k in (9, 8, 7, 6, 5, 4, 3, 2))
"""What is tried, each on both sides, when that width cannot be reached."""


@dataclass(frozen=True)
class Enclosure:
    """A number and certified bounds on it.

    Parameters
    ----------
    value : float
        Within the bounds where there are bounds.
    lower, upper : float or None
        Proved bounds; None if none could be proved.
    stage : str
        How the candidates of the proofs were computed, or what could not be reached.
    """

    value: float
    lower: float | None
    upper: float | None
    stage: str

    @property
    def width(self) -> float:
        """Width of the bracket relative to the value, infinite if a side is missing."""
        if self.lower is None or self.upper is None:
            return float("inf")
        if self.lower == self.upper:
            return 0.0
        return (self.upper - self.lower) / abs(self.value) if self.value else float("inf")


def spectral_radius(a: Rows) -> Enclosure:
    """Largest absolute value of an eigenvalue.

    Parameters
    ----------
    a : Rows
        Square, exact.

    Returns
    -------
    Enclosure
        Of relative width 1e-10 at most unless `stage` says otherwise.
    """
    return pencil_radius(identity(len(a)), a)


def pencil_radius(e: Rows, f: Rows) -> Enclosure:
    """Largest absolute value of an eigenvalue of E z+ = F z.

    Parameters
    ----------
    e, f : Rows
        Square of one size, exact; E not singular.

    Returns
    -------
    Enclosure
        Of relative width 1e-10 at most unless `stage` says otherwise.

    Raises
    ------
    InputError
        E is singular.
    """
    left, right = integer_matrices(e, f)
    if left.rank() < len(e):
        raise InputError("E", "a singular matrix", "E z+ = F z needs an invertible one")
    if _nilpotent(left, right):
        return Enclosure(0.0, 0.0, 0.0, "a power is zero")
    bracket = _Bracket(left, right)
    for modes in candidates(left, right):
        bracket.narrow(modes, WIDTH / 4)
        if bracket.width <= WIDTH:
            return bracket.enclosure(modes.stage)
    for width in WIDER:
        bracket.narrow(modes, width)
        if bracket.closed:
            break
    return bracket.enclosure(unreached(modes.stage))


def unreached(stage: str) -> str:
    """Words for a bracket wider than it should be."""
    return f"no narrower bracket from {stage}"


def _nilpotent(e: Any, f: Any) -> bool:
    """Is (E^-1 F)^n zero? Asked modulo a prime first, which settles nearly every no."""
    import flint

    prime = 2**61 - 1
    n = e.nrows()
    a, b = (flint.nmod_mat(n, n, [int(x) % prime for x in m.entries()], prime) for m in (e, f))
    if a.rank() == n and not _vanishes(a.solve(b), n):
        return False
    return _vanishes(flint.fmpq_mat(e).solve(flint.fmpq_mat(f)), n)


def _vanishes(matrix: Any, n: int) -> bool:
    power = 1
    while power < n:
        matrix, power = matrix * matrix, 2 * power
    return not any(x != 0 for x in matrix.entries())


class _Bracket:
    """The best bounds proved so far."""

    def __init__(self, e: Any, f: Any) -> None:
        self.e, self.f = e, f
        self.lower: Fraction | None = None
        self.upper: Fraction | None = None
        self.middle = Fraction(0)

    @property
    def closed(self) -> bool:
        return self.lower is not None and self.upper is not None

    @property
    def width(self) -> Fraction:
        if self.lower is None or self.upper is None:
            return Fraction(1)
        return (self.upper - self.lower) / self.upper

    def narrow(self, modes: Modes, width: Fraction) -> None:
        """Try to prove bounds at `width` on both sides of the modes' radius."""
        self.middle = max(modes.moduli)
        if not self.middle:
            return
        r = _short(self.middle * (1 + width))
        if (self.upper is None or r < self.upper) and proves_below(self.e, self.f, modes, r):
            self.upper = r
        r = _between(modes.moduli, width)
        if (self.lower is None or r > self.lower) and proves_above(self.e, self.f, modes, r):
            self.lower = r

    def enclosure(self, stage: str) -> Enclosure:
        lower = None if self.lower is None else below(self.lower)
        upper = None if self.upper is None else above(self.upper)
        value = nearest(self.middle)
        value = max(value, lower) if lower is not None else value
        return Enclosure(min(value, upper) if upper is not None else value, lower, upper, stage)


def _between(moduli: tuple[Fraction, ...], width: Fraction) -> Fraction:
    """A radius about `width` below the largest modulus, and not too near to any other."""
    radius = max(moduli)
    tries = [_short(radius * (1 - width * k / 4)) for k in (4, 3, 2)]
    return max(tries, key=lambda r: min(abs(modulus / r - 1) for modulus in moduli))


def _short(x: Fraction) -> Fraction:
    """The nearest number of 60 bits."""
    shift = x.denominator.bit_length() - x.numerator.bit_length() + 60
    return Fraction(round(x * Fraction(2) ** shift)) / Fraction(2) ** shift
