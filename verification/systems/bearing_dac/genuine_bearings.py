"""Counterexamples with genuine bearings: three sensors, all linked, and a target that rests.

One sensor sees the target under one bearing, the two others under another, so that every averaged
entry starts on the ray of one node and moves along it: the node by twice the gain, the others by
the gain, until all agree. Cosines and sines are rational, and so is everything else.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

from sensortrack.networks import Network, read_network
from verification.certificates.make import certificate

SYSTEM, NODES = "bearing_dac", 3
SINGLE = (Fraction(1), Fraction(0), Fraction(0))
SHARE = Fraction(NODES - 1, NODES)
"""p of the cut of one node; its k is 2."""
MOST_LATE, MOST_SINGULAR = 100, 65
"""Largest denominators of the cosines that are tried."""
Bearing = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Late:
    """A position that is wrong after the printed time.

    Parameters
    ----------
    bearing : (Fraction, Fraction)
        Cosine and sine under which one sensor sees the target, the others with the sine negated.
    distance : Fraction
        First coordinate of the target, the second is zero.
    beta, gamma, t : Fraction
        A gain that the theorem allows, a bound on the rates (which are zero), and the time.
    printed, sharp : float
        The printed time and that of agreement.
    position : (float, float)
        What the one sensor computes at the time t.
    document : dict
        The certificate.
    """

    bearing: Bearing
    distance: Fraction
    beta: Fraction
    gamma: Fraction
    t: Fraction
    printed: float
    sharp: float
    position: tuple[float, float]
    document: dict[str, Any]


def small_bearings(most: int) -> list[Bearing]:
    """Cosine and sine of bearings below an eighth of a turn, denominators up to `most`."""
    found = []
    for m in range(2, math.isqrt(most) + 1):
        for n in range(1, m):
            unit = m * m + n * n
            if math.gcd(m, n) == 1 and (m - n) % 2 and unit <= most:
                legs = sorted((m * m - n * n, 2 * m * n))
                found.append((Fraction(legs[1], unit), Fraction(legs[0], unit)))
    return sorted(found, key=lambda bearing: bearing[0].denominator)


def triangle() -> Network:
    """Three sensors, all linked: lambda_2 = 3."""
    return read_network("complete:3")


def linked() -> dict[str, Any]:
    """The three sensors as a certificate's graph."""
    return triangle().to_data() | {"nodes": ["a", "b", "c"]}


def ray(length: Fraction) -> list[Fraction]:
    """length times the indicator of the first sensor, less its mean."""
    return [length * SHARE, *[-length / NODES] * (NODES - 1)]


def along(length: Fraction, speed: Fraction, t: Fraction) -> dict[str, Any]:
    """Run of one entry whose error starts at ray(length), undisturbed."""
    arrival = abs(length) / speed
    sign = 0 if not length else 1 if length > 0 else -1
    edges = [sign * ((i == 0) - (j == 0)) for i, j in triangle().edges.tolist()]
    parts = ((min(t, arrival), edges), (t - arrival, [0] * NODES))
    pieces = [
        {"duration": span, "disturbance": [0] * NODES, "signs": signs}
        for span, signs in parts
        if span > 0
    ]
    return {"kind": "trajectory", "pieces": pieces}


def left(length: Fraction, speed: Fraction, t: Fraction) -> Fraction:
    """What is left of a length that falls at this speed."""
    rest = max(abs(length) - speed * t, Fraction(0))
    return rest if length > 0 else -rest


def late_position(distance: Fraction = Fraction(100)) -> Late | None:
    """Search for bearings with which the printed time of Theorem 2 is too early.

    Parameters
    ----------
    distance : Fraction, optional
        Of the target from the origin.

    Returns
    -------
    Late or None
        None if no bearing of a denominator up to `MOST_LATE` will do.
    """
    gamma, lam = Fraction(1, 1000), Fraction(2999, 1000)
    root = Fraction(math.isqrt(NODES * 10**12) + 1, 10**6)
    beta = 1 + Fraction(math.ceil(gamma * root / lam * 1000), 1000)
    speed = beta * (NODES - 1) / SHARE
    for c, s in small_bearings(MOST_LATE):
        whole = 2 * distance * s * c / speed
        square = NODES * (1 + distance**2 * s**2)
        t = Fraction(math.floor(math.sqrt(square) / 3) + 1)
        if square < (t * lam) ** 2 and t < whole and 2 * s * c <= speed * t:
            return _late(distance, (c, s), gamma, beta, lam, t, float(whole))
    return None


def _late(
    distance: Fraction,
    bearing: Bearing,
    gamma: Fraction,
    beta: Fraction,
    lam: Fraction,
    t: Fraction,
    whole: float,
) -> Late:
    (c, s), speed = bearing, beta * (NODES - 1) / SHARE
    start = -2 * s * c
    printed = math.sqrt(NODES * (1 + distance**2 * s**2)) / 3
    y = ray(left(distance * start, speed, t))
    inputs = {
        "graph": linked(),
        "a": list(SINGLE),
        "beta": beta,
        "t": t,
        "gamma": gamma,
        "lambda_2": lam,
        "c": c,
        "s": s,
        "k": distance,
        "y": y,
    }
    cut = {"kind": "cut", "nodes": [0]}
    runs = [along(start, speed, t), along(distance * start, speed, t)]
    document = certificate(SYSTEM, "theorem_2_time", inputs, [cut, *runs], "REFUTED")
    mean = s * c * (1 - Fraction(2, NODES))
    determinant = s * s * c * c - mean * mean
    position = distance - mean * y[0] / determinant, s * s * y[0] / determinant
    found = float(position[0]), float(position[1])
    return Late(bearing, distance, beta, gamma, t, printed, whole, found, document)


@dataclass(frozen=True)
class Singular:
    """A matrix P_x that loses its inverse after the start.

    Parameters
    ----------
    one, others : (Fraction, Fraction)
        Cosine and sine under which the first sensor and the others see the target.
    beta, t : Fraction
        Gain, and the time at which the first sensor's P_x is singular.
    document : dict
        The certificate.
    """

    one: Bearing
    others: Bearing
    beta: Fraction
    t: Fraction
    document: dict[str, Any]

    def entries(self, t: Fraction) -> tuple[Fraction, Fraction]:
        """P_11 and P_12 of the first sensor's P_x at a time."""
        speed = self.beta * (NODES - 1) / SHARE
        own, theirs = information(self.one), information(self.others)
        first, second = (
            theirs[k] + (own[k] - theirs[k]) / NODES + ray(left(own[k] - theirs[k], speed, t))[0]
            for k in (0, 1)
        )
        return first, second

    @property
    def agreement(self) -> Fraction:
        """The time from which on all entries agree."""
        own, theirs = information(self.one), information(self.others)
        return max(abs(own[k] - theirs[k]) for k in (0, 1)) * SHARE / (self.beta * (NODES - 1))

    def determinant(self, t: Fraction) -> Fraction:
        """Determinant of the first sensor's P_x at a time."""
        first, second = self.entries(t)
        return first * (1 - first) - second * second


def information(bearing: Bearing) -> tuple[Fraction, Fraction]:
    """P_11 and P_12."""
    c, s = bearing
    return s * s, -s * c


def singular_later(beta: Fraction = Fraction(1)) -> Singular | None:
    """Search for bearings with which P_x has an inverse for a while and loses it again.

    Parameters
    ----------
    beta : Fraction, optional

    Returns
    -------
    Singular or None
        The one whose determinant swings most; None if no two bearings of denominators up to
        `MOST_SINGULAR` will do.
    """
    around = [
        (x, y)
        for c, s in small_bearings(MOST_SINGULAR)
        for a, b in ((c, s), (s, c))
        for x, y in product((a, -a), (b, -b))
        if x > 0
    ]
    pairs = {(one, others): _return(one, others, beta) for one, others in product(around, repeat=2)}
    found = {pair: times for pair, times in pairs.items() if times is not None}
    if not found:
        return None
    one, others = max(found, key=lambda pair: _swing(*found[pair]))
    t, _ = found[one, others]
    return Singular(one, others, beta, t, _singular_document(one, others, beta, t))


def _swing(t: Fraction, arrival: Fraction) -> Fraction:
    """The smaller of the determinant's rise before `t` and fall after, both up to one factor."""
    return min(t * t / 4, arrival * (arrival - t))


def _return(one: Bearing, others: Bearing, beta: Fraction) -> tuple[Fraction, Fraction] | None:
    """When the determinant, positive after the start, is zero again, and when an entry arrives."""
    own, theirs = information(one), information(others)
    apart = [own[k] - theirs[k] for k in (0, 1)]
    if not all(apart):
        return None
    speed = beta * (NODES - 1)
    signs = [-1 if gap > 0 else 1 for gap in apart]
    t = (signs[0] * (1 - 2 * own[0]) - 2 * signs[1] * own[1]) / (2 * speed)
    arrival = min(abs(gap) for gap in apart) * SHARE / speed
    return (t, arrival) if 0 < t < arrival else None


def _singular_document(
    one: Bearing, others: Bearing, beta: Fraction, t: Fraction
) -> dict[str, Any]:
    own, theirs = information(one), information(others)
    lengths = [own[k] - theirs[k] for k in (0, 1)]
    speed = beta * (NODES - 1) / SHARE
    y, z = (ray(left(length, speed, t)) for length in lengths)
    inputs = {
        "graph": linked(),
        "a": list(SINGLE),
        "beta": beta,
        "t": t,
        "d": one[0],
        "e": one[1],
        "c": others[0],
        "s": others[1],
        "y": y,
        "z": [-x for x in z],
    }
    witness = [{"kind": "cut", "nodes": [0]}, *(along(length, speed, t) for length in lengths)]
    return certificate(SYSTEM, "algorithm_1_line_12_later", inputs, witness, "REFUTED")
