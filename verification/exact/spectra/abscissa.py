"""Two-sided certified brackets of spectral abscissae, by way of the unit circle.

w = (1 + z - r)/(1 - z + r) takes the half plane Re z < r to the open unit disc, and E z' = F z to
(E - F + rE) z+ = (E + F - rE) z with the same left eigenvectors, so that the proofs of `stein`
serve as they are: their r^2 E'QE - F'QF becomes Lyapunov's -2(E'Q(F - rE) + (F - rE)'QE).
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError

from ..evaluate import Rows
from ..rationals import above, below, nearest
from .modes import Modes, candidates, integer_matrices
from .spectral import WIDER, WIDTH, Enclosure, unreached
from .stein import proves_above, proves_below, splits

ONE = Fraction(1)
INSIDE, OUTSIDE = Fraction(1, 2), Fraction(2)
"""Stand for the moduli of eigenvalues left and right of the line; only their side is used."""


def pencil_abscissa(e: Rows, f: Rows) -> Enclosure:
    """Largest real part of an eigenvalue of E z' = F z.

    Parameters
    ----------
    e, f : Rows
        Square of one size, exact; E not singular.

    Returns
    -------
    Enclosure
        Of relative width 1e-10 at most unless `stage` says otherwise; where the largest real part
        is much smaller than the largest modulus, the width is relative to the modulus.

    Raises
    ------
    InputError
        E is singular.
    """
    left, right = integer_matrices(e, f)
    if left.rank() < len(e):
        raise InputError("E", "a singular matrix", "E z' = F z needs an invertible one")
    bracket = _Bracket(left, right)
    for modes in candidates(left, right):
        bracket.narrow(modes, abs(max(modes.reals)) * WIDTH / 4)
        if bracket.width <= WIDTH:
            return bracket.enclosure(modes.stage)
    for width in (WIDTH, *WIDER):
        bracket.narrow(modes, max(modes.moduli) * width)
        if bracket.closed:
            break
    return bracket.enclosure(unreached(modes.stage))


def off_axis(e: Any, f: Any, modes: Modes) -> bool:
    """Tell whether E z' = F z is proved to have no eigenvalue on the imaginary axis.

    Parameters
    ----------
    e, f : flint.fmpz_mat
        Square, of one size.
    modes : Modes
        Candidates; whatever they are, the answer True is a proof.
    """
    return splits(*_turned(e, f, modes, Fraction(0)), ONE)


def _turned(e: Any, f: Any, modes: Modes, r: Fraction) -> tuple[Any, Any, Modes]:
    """The pencil whose unit circle is the line Re z = r, and its modes."""
    base, moved = r.denominator * e, r.denominator * f - r.numerator * e
    sides = tuple(OUTSIDE if real > r else INSIDE for real in modes.reals)
    return base - moved, base + moved, replace(modes, moduli=sides)


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
        if self.lower is None or self.upper is None or not self.middle:
            return ONE
        return (self.upper - self.lower) / abs(self.middle)

    def narrow(self, modes: Modes, width: Fraction) -> None:
        """Try to prove bounds at this distance on both sides of the modes' abscissa."""
        self.middle = max(modes.reals)
        if not width:
            return
        r = _short(self.middle + width, width)
        if (self.upper is None or r < self.upper) and proves_below(
            *_turned(self.e, self.f, modes, r), ONE
        ):
            self.upper = r
        r = _between(modes.reals, width)
        if (self.lower is None or r > self.lower) and proves_above(
            *_turned(self.e, self.f, modes, r), ONE
        ):
            self.lower = r

    def enclosure(self, stage: str) -> Enclosure:
        lower = None if self.lower is None else below(self.lower)
        upper = None if self.upper is None else above(self.upper)
        value = nearest(self.middle)
        value = max(value, lower) if lower is not None else value
        return Enclosure(min(value, upper) if upper is not None else value, lower, upper, stage)


def _between(reals: tuple[Fraction, ...], width: Fraction) -> Fraction:
    """A line about `width` left of the largest real part, and not too near to any other."""
    tries = [_short(max(reals) - width * k / 4, width) for k in (4, 3, 2)]
    return max(tries, key=lambda r: min(abs(real - r) for real in reals))


def _short(x: Fraction, width: Fraction) -> Fraction:
    """The nearest multiple of a power of two below a thousandth of the width."""
    unit = Fraction(2) ** (width.numerator.bit_length() - width.denominator.bit_length() - 11)
    return round(x / unit) * unit
