"""Mean and covariance of the position that (13) computes from a noisy bearing and range."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from theory.systems.cyclic_spsa.measurement_errors import (
    ACROSS_SQUARE,
    ALONG,
    ALONG_SQUARE,
    Powers,
)
from verification.answers import Answer, Input
from verification.enclosures import ball, enclosure, ends, listed

MEASUREMENT = (
    Input("sigma_bearing_rad", "number", "standard deviation of the angle", "rad"),
    Input("sigma_range_rel", "number", "standard deviation of the range over the range", ""),
)
LARGEST_ANGLE = Fraction(355, 113)
"""A rational above pi."""
GUARD_BITS = 256


def measurement_moments(values: Mapping[str, Any]) -> Answer:
    """Mean radial error, radial and tangential variance of (13) at range 1, Gaussian errors.

    Parameters
    ----------
    values : mapping
        ``sigma_bearing_rad``, ``sigma_range_rel``: rationals of at least 0.

    Returns
    -------
    Answer
        exp(-p^2/2) - 1, in ranges, and the two variances in squared ranges; to be multiplied by
        the range and its square. The mean tangential error and the covariance are 0.

    Raises
    ------
    InputError
        A number is negative, or the angle's standard deviation exceeds pi.
    """
    import flint

    angle, distance = (values[entry.name] for entry in MEASUREMENT)
    for name in (entry.name for entry in MEASUREMENT):
        if values[name] < 0:
            raise InputError(name, f"{values[name]}", "a number of at least 0 is needed")
    if angle > LARGEST_ANGLE:
        cure = "radians of at most pi are needed; is it an angle in degrees?"
        raise InputError("sigma_bearing_rad", f"{angle}", cure)
    with flint.ctx.workprec(GUARD_BITS + _lost(angle)):
        scale = 1 + ball(distance) ** 2
        along = _mean(ALONG, angle)
        radial = scale * _mean(ALONG_SQUARE, angle) - along**2
        found = (along - 1, radial, scale * _mean(ACROSS_SQUARE, angle))
        return listed([enclosure(*ends(x)) for x in found])


def _lost(angle: Fraction) -> int:
    """Bits that differences of means lose where the angle is small."""
    return 8 * max(0, angle.denominator.bit_length() - angle.numerator.bit_length())


def _mean(powers: Powers, angle: Fraction) -> Any:
    """A combination of powers of exp(-p^2/2)."""
    import flint

    terms = (ball(c) * (ball(-n * angle**2 / 2)).exp() for n, c in powers.items())
    return sum(terms, flint.arb(0))
