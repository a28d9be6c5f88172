"""What (20) makes of white measurement noise: stationary traces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from verification.answers import Answer
from verification.enclosures import listed
from verification.exact.evaluate import Rows
from verification.exact.rationals import above, below, nearest
from verification.exact.spectra.spectral import Enclosure
from verification.exact.spectra.stationary import Ends, covariance, diagonal, enclosed_diagonals

from .error_systems import error_system, stable_question, unbounded

EXACT_UP_TO = 6
"""Coordinates up to which the stationary covariance is solved in rationals."""
BITS = 256
NARROW = Fraction(1, 10**10)
SOLVED = "solved in rationals"
WIDE = "the covariance could not be bounded: (20) is too close to instability for floating point"


def noise_gain(values: Mapping[str, Any]) -> Answer:
    """Stationary traces for white noise of unit covariance.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size; ``h``: a
        positive rational in the time unit of the gains.

    Returns
    -------
    Answer
        Trace of cov(e) from chi, of cov(e) from nu (s^2), of the velocity error's covariance from
        nu. ``"inf"`` thrice where (20) is unstable. Solved in rationals up to six coordinates, in
        certified bounds beyond.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, or h <= 0.
    """
    gains, h, stable = stable_question(values)
    if not stable:
        return unbounded(3)
    found = trace_bounds(gains, h)
    if found is None:
        return Answer(verdict="UNDECIDED", notes=(WIDE,))
    return listed(found)


def trace_bounds(gains: Mapping[str, Rows], h: Fraction) -> list[Enclosure] | None:
    """The three traces of `noise_gain`; (20) must be stable. None where floats do not reach."""
    if len(gains["M"]) > EXACT_UP_TO:
        ends = _enclosed(gains, h)
        return None if ends is None else [_enclosure(low, high, "") for low, high in ends]
    exact = exact_traces(gains, h)
    stage = f"{SOLVED}: {', '.join(map(str, exact))}" if len(gains["M"]) == 1 else SOLVED
    return [_enclosure(x, x, stage) for x in exact]


def exact_traces(gains: Mapping[str, Rows], h: Fraction) -> list[Fraction]:
    """The three traces of `noise_gain` as rationals; (20) must be stable."""
    system = error_system(gains, h)
    n = system.n
    from_chi, from_nu = (diagonal(covariance(system.a, b)) for b in (system.b_chi, system.b_nu))
    # the newest nu is independent of w, and z holds hw
    return [sum(from_chi[:n]), sum(from_nu[:n]), sum(from_nu[n:]) / h**2 + n]  # type: ignore[list-item]


def _enclosed(gains: Mapping[str, Rows], h: Fraction) -> list[Ends] | None:
    import flint

    with flint.ctx.workprec(BITS):
        system = error_system(gains, h, exact=False)
    found = enclosed_diagonals(system.a, (system.b_chi, system.b_nu))
    if found is None:
        return None
    n, (from_chi, from_nu) = system.n, found
    low, high = _added(from_nu[n:])
    ends = [_added(from_chi[:n]), _added(from_nu[:n]), (low / h**2 + n, high / h**2 + n)]
    if any(high - low > NARROW * low for low, high in ends):
        return None
    return ends


def _added(ends: Sequence[Ends]) -> Ends:
    return sum((low for low, _ in ends), Fraction(0)), sum((high for _, high in ends), Fraction(0))


def _enclosure(low: Fraction, high: Fraction, stage: str) -> Enclosure:
    return Enclosure(nearest((low + high) / 2), below(low), above(high), stage)
