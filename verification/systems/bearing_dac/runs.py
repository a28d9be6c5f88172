"""How long agreement takes: the exact time of one run, and what discrete steps are worth."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates.make import CertificateError, certificate
from verification.exact.cuts.cut_components import spread
from verification.exact.cuts.extreme import CutBracket, slowest
from verification.exact.rationals import above, below, nearest, root
from verification.exact.runs.filippov import LongRunError, Run, filippov_run
from verification.input_words import positive

from .brackets import NO_WITNESS, OPEN, SYSTEM, TOO_LONG
from .gains import reaches_printed_gain
from .network_inputs import (
    Numbers,
    bounds_of,
    component_notes,
    gain_of,
    graph_data,
    network_of,
    node_data,
    pieces,
)
from .rates import LONGEST, printed_time

LARGEST = 20_000
"""Nodes and edges of a network whose run is followed."""

NEVER = "beta is at most the threshold: a disturbance keeps the sides of a cut apart"
COMPUTED = "the formula is proved in the manual; its value is computed, not certified"


def disagreement_time(values: Mapping[str, Any]) -> Answer:
    """When the error is zero for the first time, without disturbance.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``beta``: a positive rational; ``x0``: tuple of Fraction, one a node,
        projected to mean zero in each component.

    Returns
    -------
    Answer
        Rational, with a certificate where one is short enough, beside the printed time if the
        gain is at least the printed one.

    Raises
    ------
    InputError
        The network has no edge, or beta <= 0.

    References
    ----------
    George, Theorem 1.
    """
    network, beta = network_of(values), gain_of(values)
    x0: Numbers = values["x0"]
    notes = component_notes(network, LONGEST)
    if network.n + network.m > LARGEST:
        return Answer(verdict="UNDECIDED", notes=(*notes, "runs of smaller networks are followed"))
    try:
        run = filippov_run(network, beta, x0)
    except LongRunError as error:
        return Answer(verdict="UNDECIDED", notes=(*notes, str(error)))
    time = run.times[-1]
    exact = {"kind": "rational", "value": str(time)}
    inputs = {"graph": graph_data(network), "beta": beta, "x0": list(x0)}
    try:
        document = certificate(
            SYSTEM, "disagreement_time", inputs, [trajectory(run)], lower=time, upper=time
        )
    except CertificateError as error:
        notes = (*notes, f"no certificate: {error}")
        return Answer(nearest(time), exact, printed=_printed(network, beta, x0), notes=notes)
    ends = below(time), above(time) or 0.0  # no negative zero
    printed = _printed(network, beta, x0)
    return Answer(nearest(time), exact, *ends, printed, "PROVED", document, None, notes)


def _printed(network: Network, beta: Fraction, x0: Numbers) -> float | None:
    """The printed time, where Theorem 1 promises it."""
    if not reaches_printed_gain(network, (Fraction(0),) * network.n, beta):
        return None
    return printed_time(network, [spread([x0[i] for i in nodes]) for nodes in pieces(network)])


def trajectory(run: Run) -> dict[str, Any]:
    """The witness that a run is one: signs stand component by component."""
    return {
        "kind": "trajectory",
        "pieces": [
            {
                "duration": piece.duration,
                "disturbance": piece.disturbance,
                "signs": [piece.signs[k] for k in by_component(piece.network)],
            }
            for piece in run.pieces
        ],
    }


def by_component(network: Network) -> list[int]:
    """Edge numbers, those of each component together, components by their smallest nodes."""
    home = {i: k for k, nodes in enumerate(network.components()) for i in nodes}
    heads = network.edges[:, 0].tolist()
    return sorted(range(network.m), key=lambda k: home[heads[k]])


def implicit_steps(values: Mapping[str, Any]) -> Answer:
    """Number of implicit steps to exact agreement: |x0|/(h r), rounded up.

    Parameters
    ----------
    values : mapping
        ``graph``, ``gamma``, ``beta``, ``x0`` as in `settling_time`; ``h``: a positive rational.

    Returns
    -------
    Answer
        An integer, with a certificate where one is short enough; infinite at small gains.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, beta <= 0 or h <= 0.
    """
    network, gamma, beta = network_of(values), bounds_of(values), gain_of(values)
    h = positive(values, "h", "a step")
    x0: Numbers = values["x0"]
    found = slowest(network, gamma, beta, x0)
    inputs = {
        "graph": graph_data(network),
        "gamma": node_data(gamma),
        "beta": beta,
        "h": h,
        "x0": list(x0),
        "least": Fraction(0),
    }
    notes = component_notes(network, "the largest number counts")
    if found.infinite:
        ends = {"lower": "inf", "upper": "inf"}
        document = certificate(
            SYSTEM, "implicit_steps", inputs, [found.reaches], "INFINITE", **ends
        )
        inf = math.inf
        return Answer(inf, None, inf, inf, None, "PROVED", document, None, (*notes, NEVER))
    return _counted(inputs, found, h, notes)


def _counted(
    inputs: dict[str, Any], found: CutBracket, h: Fraction, notes: tuple[str, ...]
) -> Answer:
    """The number of steps if both ends of the settling time's bracket give the same one."""
    lower, upper = (
        None if square is None else _rounded_up(square / h**2)
        for square in (found.lower, found.upper)
    )
    known = None if found.value is None else _rounded_up(found.value / h**2)
    if lower is None or lower != upper or found.clear is None:
        if known is None:
            reason = NO_WITNESS if found.clear is None else OPEN
            return Answer(lower=lower, upper=upper, verdict="UNDECIDED", notes=(*notes, reason))
        return Answer(known, _whole(known), notes=(*notes, TOO_LONG))
    inputs["least"] = _above(found.lower / h**2, lower - 1) if found.lower else Fraction(0)
    witness, end = [found.clear, found.reaches], Fraction(lower)
    try:
        document = certificate(SYSTEM, "implicit_steps", inputs, witness, lower=end, upper=end)
    except CertificateError as error:
        return Answer(lower, _whole(lower), notes=(*notes, f"no certificate: {error}"))
    return Answer(lower, _whole(lower), lower, lower, None, "PROVED", document, None, notes)


def _whole(number: int) -> dict[str, Any]:
    return {"kind": "rational", "value": str(number)}


def _rounded_up(square: Fraction) -> int:
    """The smallest integer whose square is at least this."""
    whole = math.ceil(square)
    return math.isqrt(whole - 1) + 1 if whole else 0


def _above(square: Fraction, floor: int) -> Fraction:
    """A rational above `floor` whose square is at most this; the root is above `floor`."""
    bits = 8
    while (guess := root(square, bits)) <= floor:
        bits *= 2
    return guess


def chattering_bound(values: Mapping[str, Any]) -> Answer:
    """What the error of the explicit step is at most in the long run.

    h max(s, s^2/(2 r)) with r the smallest (beta k - N)/sqrt(p) of a cut and
    s = beta sqrt(sum of squared degrees) + |gamma|; a larger error shrinks.

    Parameters
    ----------
    values : mapping
        ``graph``, ``gamma``, ``beta`` as in `settling_time`; ``h``: a positive rational.

    Returns
    -------
    Answer
        SUPPORTED, in floating point; infinite at gains up to the threshold.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, beta <= 0 or h <= 0.
    """
    network, gamma, beta = network_of(values), bounds_of(values), gain_of(values)
    h = positive(values, "h", "a step")
    notes = component_notes(network, "the largest bound counts")
    bounds = []
    for nodes in pieces(network):
        own = [gamma[i] for i in nodes]
        bound = _chattering(network.subnetwork(nodes), own, beta)
        if bound is None:
            return Answer(verdict="UNDECIDED", notes=(*notes, NO_WITNESS))
        bounds.append(bound)
    if math.isinf(max(bounds)):
        return Answer(math.inf, notes=(*notes, NEVER))
    return Answer(nearest(h) * max(bounds), notes=(*notes, COMPUTED))


def _chattering(network: Network, gamma: list[Fraction], beta: Fraction) -> float | None:
    """The bound of a connected network for a step of length 1; None if no rate is known."""
    start = [Fraction(1), *[Fraction(0)] * (network.n - 1)]
    found = slowest(network, gamma, beta, start)
    if found.infinite:
        return math.inf
    square = found.upper if found.value is None else found.value
    if square is None:
        return None
    rate = math.sqrt(nearest((1 - Fraction(1, network.n)) / square))
    degrees = [Fraction(0)] * network.n
    for ends, weight in zip(network.edges.tolist(), network.exact_weights(), strict=True):
        for i in ends:
            degrees[i] += weight
    pull = nearest(beta) * math.hypot(*map(nearest, degrees))
    speed = pull + math.hypot(*map(nearest, gamma))
    return max(speed, speed**2 / (2 * rate))
