"""Settling time of sign-based consensus from given initial data."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates.make import CertificateError, certificate
from verification.exact.cuts import CutBracket, slowest
from verification.exact.rationals import above, below, nearest

from .data import (
    components,
    connectivity,
    disturbance,
    explicit,
    norm,
    parts_note,
    positive_gain,
    root_below,
)
from .thresholds import OPEN, UNSHOWN, shortest

NEVER = "the gain is at or below the threshold: a disturbance keeps two sides apart for ever"


def settling_time(values: Mapping[str, Any]) -> Answer:
    """Time by which agreement is reached whatever the disturbance, and which one attains.

    Parameters
    ----------
    values : mapping
        ``graph``, ``gamma`` (one bound a node), ``beta`` > 0, ``x0`` (one number a node, projected
        to mean zero in each component).

    Returns
    -------
    Answer
        |x0|/min over cuts of (beta k - N)/sqrt(p); "inf" if beta is at most the threshold.

    Raises
    ------
    InputError
        A bound is negative, or beta is not positive.

    References
    ----------
    J. George, Theorem 1: the printed time is |x(t0)|/lambda_2.
    """
    network = explicit(values["graph"])
    gamma, beta, x0 = disturbance(values), positive_gain(values), values["x0"]
    found = slowest(network, gamma, beta, x0)
    inputs = {"graph": network.to_data(), "gamma": shortest(gamma), "beta": beta, "x0": list(x0)}
    notes, printed = parts_note(network, "largest time"), _printed(network, x0)
    if found.infinite:
        ask = ("bearing_dac", "settling_time", inputs, [found.reaches])
        document = certificate(*ask, case="INFINITE", lower="inf", upper="inf")
        return Answer("inf", None, "inf", "inf", printed, "PROVED", document, notes=(*notes, NEVER))
    return _finite(found, inputs, notes, printed)


def _printed(network: Network, x0: tuple[Fraction, ...]) -> float | None:
    from verification.exact.spectral_gap import NoBracketError

    try:
        return max(
            norm([x0[i] for i in nodes]) / connectivity(part).value
            for part, nodes in components(network)
        )
    except NoBracketError:
        return None


def _finite(
    found: CutBracket, inputs: dict[str, Any], notes: tuple[str, ...], printed: float | None
) -> Answer:
    if found.lower is None or found.upper is None or found.clear is None:
        if found.value is None:
            return Answer(verdict="UNDECIDED", printed=printed, notes=(*notes, OPEN))
        value = nearest(root_below(found.value))
        return Answer(value, verdict="SUPPORTED", printed=printed, notes=(*notes, UNSHOWN))
    low, high = _enclosed(found.lower)[0], _enclosed(found.upper)[1]
    try:
        document = certificate(
            "bearing_dac",
            "settling_time",
            inputs,
            [found.clear, found.reaches],
            lower=low,
            upper=high,
        )
    except CertificateError as error:
        return Answer(verdict="UNDECIDED", printed=printed, notes=(*notes, f"stage: {error}"))
    ends: dict[str, Any] = {"lower": below(low), "upper": above(high), "printed": printed}
    if not found.closed:
        return Answer(verdict="UNDECIDED", certificate=document, notes=(*notes, OPEN), **ends)
    value = nearest(root_below(found.lower))
    exact = _exact(found.lower, low, high)
    return Answer(value, exact, verdict="PROVED", certificate=document, notes=notes, **ends)


def _enclosed(square: Fraction) -> tuple[Fraction, Fraction]:
    """Rationals around the root: the root itself if it is rational, else neighbouring doubles."""
    root = root_below(square)
    if root * root == square:
        return root, root
    low = Fraction(below(root))
    high = Fraction(above(root))
    while high * high < square:
        high = Fraction(above(high + Fraction(1, 2**1074) + abs(high) / 2**53))
    return low, high


def _exact(square: Fraction, low: Fraction, high: Fraction) -> dict[str, Any]:
    if low == high:
        return {"kind": "rational", "value": str(low)}
    polynomial = [-square.numerator, 0, square.denominator]
    return {"kind": "algebraic", "polynomial": polynomial, "interval": [str(low), str(high)]}
