"""Search for the gains of one coordinate, in floating point; `design` certifies what it finds.

With M = 1, a = 1/(1 + hc) and g = h^2 k a, the errors obey z^2 - (1 + a - g) z + a = 0; both roots
lie within |z| <= r iff a <= r^2 and (1 - r)(1 - a/r) <= g <= (1 + r)(1 + a/r) (Jury).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

INSIDE = 1e-6
"""Roots are kept inside the wanted circle by this, so that rounding leaves them there."""
FASTEST = 1e-3
"""Least spectral radius that is sought."""
GRID, ROUNDS, HALVINGS = 200, 6, 60


@dataclass(frozen=True)
class Noises:
    """White noise of the averaged measurements, one coordinate, and the step h."""

    h: float
    chi: float
    nu: float

    def of_position(self, a: float, g: float) -> float:
        """Stationary variance of the position error."""
        by_position = g * g * (1 + a) * self.chi
        by_velocity = self.h**2 * ((1 + a) * (1 - a) ** 2 + 2 * a * g) * self.nu
        return (by_position + by_velocity) / ((1 - a) * g * (2 + 2 * a - g))

    def of_velocity(self, a: float, g: float) -> float:
        """Stationary variance of the velocity error; it grows with g."""
        spread = g * (1 + a) * self.nu + 2 * g * g / self.h**2 * self.chi
        return self.nu + spread / ((1 - a) * (2 + 2 * a - g))

    def quietest(self, a: float) -> float:
        """The g at which `of_position` has its one minimum."""
        square, slope = (1 + a) * self.chi, self.h**2 * 2 * a * self.nu
        rest, width = self.h**2 * (1 + a) * (1 - a) ** 2 * self.nu, 2 + 2 * a
        bend = square * width + slope
        return (math.sqrt(rest * rest + bend * rest * width) - rest) / bend


def _pull(noises: Noises, a: float, r: float, allowed: float) -> float | None:
    """The least g with both roots within r and the position variance allowed."""
    low, high = (1 - r) * (1 - a / r), (1 + r) * (1 + a / r)
    if noises.of_position(a, low) <= allowed:
        return low
    quiet = min(max(noises.quietest(a), low), high)
    if noises.of_position(a, quiet) > allowed:
        return None
    for _ in range(HALVINGS):
        middle = (low + quiet) / 2
        if noises.of_position(a, middle) > allowed:
            low = middle
        else:
            quiet = middle
    return quiet


def smallest(noises: Noises, r: float, allowed: float) -> tuple[float, float] | None:
    """The a and g of the smallest velocity variance, on a grid that is refined around its best.

    Parameters
    ----------
    noises : Noises
    r : float
        Both roots lie within this circle.
    allowed : float
        Largest position variance.

    Returns
    -------
    tuple of (float, float), or None
        None if no point of the grid keeps the position variance.
    """
    low, high = 0.0, r * r
    best: tuple[float, float, float] | None = None
    for _ in range(ROUNDS):
        for a in np.linspace(low, high, GRID)[1:].tolist():
            g = _pull(noises, a, r, allowed)
            if g is not None:
                entry = (noises.of_velocity(a, g), a, g)
                best = entry if best is None else min(best, entry)
        if best is None:
            return None
        width = (high - low) / GRID * 2
        low, high = max(0.0, best[1] - width), min(r * r, best[1] + width)
    return best and best[1:]


def smallest_position(noises: Noises, r: float) -> float:
    """The smallest position variance on the grid, whatever the velocity variance."""
    steps = np.linspace(0.0, r * r, GRID)[1:].tolist()
    return min(noises.of_position(a, noises.quietest(a)) for a in steps)
