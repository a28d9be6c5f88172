"""The largest factors by which (20) hands on measurement noise, over all frequencies."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from theory.algebra.noncommuting import Form, inverse
from verification.answers import Answer
from verification.enclosures import listed
from verification.exact.evaluate import Rows, at
from verification.exact.spectra.peaks import Channel, peak
from verification.exact.spectra.spectral import Enclosure

from .error_systems import NOISY, STEP, stable_question, unbounded

Polynomial = tuple[Form, Form, Form]
"""Coefficients of 1, z, z^2, or of 1, s, s^2."""


def bilinear(polynomial: Polynomial) -> Polynomial:
    """p((1 + hs/2)/(1 - hs/2)) (1 - hs/2)^2, which takes the unit circle to the imaginary axis."""
    p0, p1, p2 = polynomial
    quarter = Fraction(1, 4) * STEP * STEP
    return p0 + p1 + p2, STEP * (p2 - p0), quarter * (p2 - p1 + p0)


def _polynomial(old: str, now: str, new: str) -> Polynomial:
    zero = Form({})
    p0, p1, p2 = (NOISY.before(name) if name else zero for name in (old, now, new))
    return p0, p1, p2


ERRORS = _polynomial("e0", "e1", "e2")
FROM_CHI = _polynomial("", "chi", "")
FROM_NU = _polynomial("nu0", "nu1", "")
VELOCITY_FROM_NU = (
    -inverse(STEP) * FROM_NU[0],
    inverse(STEP) * (FROM_NU[0] - FROM_NU[1]),
    inverse(STEP) * FROM_NU[1],
)
"""The velocity error w - nu is (e+ - e)/h."""

CHANNELS = tuple(map(bilinear, (FROM_CHI, FROM_NU, VELOCITY_FROM_NU)))


def peak_gain(values: Mapping[str, Any]) -> Answer:
    """H-infinity norms of the three maps whose traces `noise_gain` gives.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size; ``h``: a
        positive rational in the time unit of the gains.

    Returns
    -------
    Answer
        Largest singular values over all frequencies: chi to e, nu to e (s), nu to the velocity
        error. ``"inf"`` thrice where (20) is unstable. In certified bounds up to 24 coordinates.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, or h <= 0.
    """
    gains, h, stable = stable_question(values)
    if not stable:
        return unbounded(3)
    return listed(peak_bounds(gains, h))


def peak_bounds(gains: Mapping[str, Rows], h: Fraction) -> list[Enclosure]:
    """The three norms of `peak_gain`; (20) must be stable."""
    errors = _at(bilinear(ERRORS), gains, h)
    return [peak(Channel(errors, _at(channel, gains, h))) for channel in CHANNELS]


def _at(polynomial: Polynomial, gains: Mapping[str, Rows], h: Fraction) -> tuple[Rows, Rows, Rows]:
    p0, p1, p2 = (at(form, gains, h) for form in polynomial)
    return p0, p1, p2
