"""Gains for a wanted decay or noise level, and the step at which given gains decay fastest.

All coordinates are alike and only the ratios of the gains matter, so M = 1 and two numbers are
sought, as `gain_search` does.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np

from sensortrack.errors import InputError
from verification.answers import Design, Designed, Input
from verification.certificates.make import certificate
from verification.exact.evaluate import Rows, identity
from verification.exact.rationals import above, nearest
from verification.exact.spectra.stationary import covariance

from .delays import block
from .error_systems import error_system
from .gain_search import FASTEST, INSIDE, Noises, smallest, smallest_position
from .gains import definite_gains, positive_step
from .numbers import spectral_radius
from .quantities import GAINS, STEP
from .steps import decide_step, step_limit

SLACK, COARSE, ROUNDS, DIGITS = Fraction(1, 10**12), 60, 6, 14

DECAY = Input("decay", "number", "wanted: errors fall at least like exp(-decay t)", "1/s")
CHI = Input("chi", "number", "variance of a measured position, averaged", "m^2", default="1")
NU = Input("nu", "number", "variance of a measured velocity, averaged", "m^2/s^2", default="1")
NOISE = Input("noise", "number", "largest variance allowed for a coordinate of the error", "m^2")
OBJECTIVE = "smallest variance of the velocity estimate among all gains with this decay"
BEYOND = "a gain is beyond the largest double: the search for the step is one in doubles"
NONE_FOUND = "no gains with this decay keep the position variance; the smallest found is {:.6g}"


def gains_for_decay(values: Mapping[str, Any]) -> Designed:
    """Gains of the quietest velocity estimate among those with the wanted decay.

    Parameters
    ----------
    values : mapping
        ``decay`` (1/s), ``h`` (s), ``chi`` (m^2), ``nu`` (m^2/s^2): rationals, the variances those
        of the averaged measurements, one coordinate; ``noise`` (m^2), where the variance of the
        position error is limited.

    Returns
    -------
    Designed
        Without gains where none with this decay keep the limit.

    Raises
    ------
    InputError
        decay, h or noise is not positive, decay is out of one step's reach, or a variance is
        negative.
    """
    h, chi, nu = _setting(values)
    for name in ("decay", "noise"):
        if values.get(name, 1) <= 0:
            raise InputError(name, str(values[name]), "a number above 0 is needed")
    circle = math.exp(-float(values["decay"]) * float(h))
    if not FASTEST < circle < 1 - 10 * INSIDE:
        ends = (-math.log(x) / float(h) for x in (1 - 10 * INSIDE, FASTEST))
        given = f"{values['decay']}, with h = {h}"
        raise InputError("decay", given, "{:.3g} to {:.3g} is needed".format(*ends))
    noises = Noises(float(h), float(chi), float(nu))
    allowed = float(values["noise"]) * (1 - INSIDE) if "noise" in values else math.inf
    found = smallest(noises, circle * (1 - INSIDE), allowed)
    if found is None:
        least = smallest_position(noises, circle)
        return Designed(objective=OBJECTIVE, notes=(NONE_FOUND.format(least),))
    return _certified(*found, circle, values["decay"], (h, chi, nu))


def _setting(values: Mapping[str, Any]) -> tuple[Fraction, Fraction, Fraction]:
    for name, value in values.items():
        if math.isinf(nearest(value)) or (value and not nearest(value)):
            found = f"{value.numerator.bit_length() - value.denominator.bit_length()} binary digits"
            raise InputError(name, found, "a number within the range of doubles is needed")
    for name in ("chi", "nu"):
        if values[name] < 0:
            raise InputError(name, str(values[name]), "a variance of 0 or more is needed")
    if values["chi"] == values["nu"] == 0:
        raise InputError("chi", "0, and nu is 0", "one of the two noises is needed")
    return positive_step(values), values["chi"], values["nu"]


def _rounded(x: float) -> Fraction:
    """A decimal of a few digits, so that a person can type it."""
    return Fraction(f"{x:.{DIGITS}g}")


def _certified(
    a: float,
    g: float,
    circle: float,
    decay: Fraction,
    setting: tuple[Fraction, Fraction, Fraction],
) -> Designed:
    """The gains of a and g, with the certificate of their decay and variances."""
    h, chi, nu = setting
    c, k = _rounded((1 / a - 1) / float(h)), _rounded(g / (float(h) ** 2 * a))
    gains: dict[str, Rows] = {"M": identity(1), "K": ((k,),), "C": ((c,),)}
    spread = _covariance(gains, h, chi, nu)
    noise, speed = (Fraction(above(x * (1 + SLACK))) for x in (spread[0][0], spread[1][1] + nu))
    # exp is within one unit in the last place: two below are below the wanted circle
    r = Fraction(math.nextafter(math.nextafter(circle, 0.0), 0.0))
    numbers = {"h": h, "r": r, "chi": chi, "nu": nu, "noise": noise, "speed": speed}
    rows = (identity(1), block(1, 2, 0), block(1, 2, 1), spread)
    witness = [{"kind": "matrix", "rows": entry} for entry in rows]
    document = certificate("variational", "design", {**gains, **numbers}, witness)
    return Designed(
        gains={"M": Fraction(1), "K": k, "C": c, "h": h},
        objective=OBJECTIVE,
        bound={"decay": float(decay), "position": float(noise), "velocity": float(speed)},
        verdict="PROVED",
        certificate=document,
        notes=(
            "the same numbers serve every coordinate, as multiples of the identity",
            "decay and both variances are certified; that no other gains do better is a search's",
        ),
    )


def _covariance(gains: Mapping[str, Rows], h: Fraction, chi: Fraction, nu: Fraction) -> Rows:
    """Stationary covariance of (e, w), one coordinate."""
    system = error_system(gains, h)
    total: list[list[Fraction]] = [[Fraction(0)] * 2, [Fraction(0)] * 2]
    for scale, noise in ((chi, system.b_chi), (nu, system.b_nu)):
        found = covariance(system.a, noise)
        for i in (0, 1):
            for j in (0, 1):
                entry = Fraction(int(found[i, j].p), int(found[i, j].q))
                total[i][j] += scale * entry / h ** (i + j)  # the system's state is (e, hw)
    return tuple(map(tuple, total))


def step_for_gains(values: Mapping[str, Any]) -> Designed:
    """The step at which the errors of given gains shrink most in one sample.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size.

    Returns
    -------
    Designed

    Raises
    ------
    InputError
        A gain is not symmetric positive definite.
    """
    gains = definite_gains(values)
    objective = "smallest spectral radius of one step: most decay a sample"
    limit = step_limit(gains)
    if limit.value is None:
        return Designed(objective=objective, notes=limit.notes)
    rows = [row for name in "MKC" for row in gains[name]]
    if any(math.isinf(nearest(x)) for row in rows for x in row):
        return Designed(objective=objective, notes=(BEYOND,))
    step = _rounded_step(gains, float(limit.value))
    decided = decide_step({**gains, "h": step})
    radius = spectral_radius({**gains, "h": step})
    bound = {"step_limit": limit.lower}
    if radius.upper is not None:
        bound["radius"] = radius.upper
    return Designed(
        gains={**gains, "h": step},
        objective=objective,
        bound=bound,
        verdict=decided.verdict,
        certificate=decided.certificate,
        notes=radius.notes,
    )


def _rounded_step(gains: Mapping[str, Rows], limit: float) -> Fraction:
    """The best of a grid that is refined around its best step, to six digits."""
    m, k, c = (np.array([[float(x) for x in row] for row in gains[n]]) for n in "MKC")
    one = np.eye(len(m))

    def radius(h: float) -> float:
        damped = np.linalg.inv(m + h * c)
        pull, keep = damped @ k, damped @ m
        step = np.block([[one, h * one], [-h * pull, keep - h * h * pull]])
        # where floats overflow, the step is no candidate
        return float(np.abs(np.linalg.eigvals(step)).max()) if np.isfinite(step).all() else math.inf

    low, high, best = 0.0, limit, limit / 2
    for _ in range(ROUNDS):
        steps = np.linspace(low, high, COARSE)[1:-1]
        with np.errstate(all="ignore"):
            best = min(steps.tolist(), key=radius)
        width = float(steps[1] - steps[0])
        low, high = max(0.0, best - width), min(limit, best + width)
    short = Fraction(f"{best:.6g}")
    return short if short < limit else Fraction(best)


VARIANCES = (STEP, CHI, NU)
DESIGNS = (
    Design(
        "gains for a decay",
        "M, K, C of the quietest velocity estimate with the wanted decay",
        (DECAY, *VARIANCES),
        gains_for_decay,
    ),
    Design(
        "gains for a decay and a noise level",
        "the same, the position variance being limited",
        (DECAY, NOISE, *VARIANCES),
        gains_for_decay,
    ),
    Design("step for gains", "h of the fastest decay a sample", GAINS, step_for_gains),
)
