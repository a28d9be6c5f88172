"""Search for runs that agree later than Theorem 1 promises, each followed exactly.

Every cut S offers a start, M 1_S, and a disturbance that pulls its two sides apart; random starts
and random disturbances at their bounds stand beside them. What counts is the time of agreement over
the printed time |x(t0)|/lambda_2, at the printed gain.

References
----------
J. George, "Distributed tracking of maneuvering target: a finite-time algorithm", Theorem 1.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

import numpy as np

from sensortrack.networks import Network
from verification.exact.laplacians.spectral_gap import connectivity_bracket
from verification.exact.runs.filippov import filippov_run
from verification.exact.runs.prox import centred

FOLLOWED = 100
"""For how many printed times a run is followed."""

ROOT_DIGITS = 10**9

Start = tuple[list[Fraction], list[Fraction]]
"""Error at the start and disturbance."""


@dataclass(frozen=True)
class TimedRun:
    """One run at the printed gain, rounded up.

    Parameters
    ----------
    network : Network
    beta : Fraction
    x0, disturbance : tuple of Fraction
        One number a node.
    time : Fraction or None
        Of agreement; None if there is none within a hundred printed times.
    late : bool
        Whether `time` is above |x0|/lambda_2 for certain.
    ratio : float
        `time` over |x0|/lambda_2; infinite if there is no time.
    """

    network: Network
    beta: Fraction
    x0: tuple[Fraction, ...]
    disturbance: tuple[Fraction, ...]
    time: Fraction | None
    late: bool
    ratio: float


def latest(network: Network, gamma: Fraction, tries: int = 0, seed: int = 0) -> TimedRun:
    """Find the run that agrees latest among those of all cuts and some random ones.

    Parameters
    ----------
    network : Network
        Connected, without weights; all its cuts are tried.
    gamma : Fraction
        Bound on the disturbance at every node, not negative.
    tries : int, optional
        How many random runs are tried besides.
    seed : int, optional

    Returns
    -------
    TimedRun
    """
    starts = [*_of_cuts(network, gamma), *_random(network, gamma, tries, seed)]
    return max((timed(network, gamma, *start) for start in starts), key=lambda run: run.ratio)


def timed(
    network: Network, gamma: Fraction, x0: list[Fraction], disturbance: list[Fraction]
) -> TimedRun:
    """Follow one run at the gain 1 + gamma sqrt(n)/lambda_2.

    Parameters
    ----------
    network : Network
        Connected, without weights.
    gamma : Fraction
    x0 : list of Fraction, length n
        Not all the same.
    disturbance : list of Fraction, length n
        At most gamma in size.

    Returns
    -------
    TimedRun
    """
    gap = connectivity_bracket(network)
    root = Fraction(math.isqrt(network.n * ROOT_DIGITS**2) + 1, ROOT_DIGITS)
    beta = 1 + gamma * root / gap.lower
    start = centred(network, x0)
    square = sum((v * v for v in start), Fraction(0))
    long = math.ceil(FOLLOWED * math.sqrt(square) / gap.lower) + 1
    time = filippov_run(network, beta, start, [(Fraction(long), disturbance)]).agreement
    late = time is None or time**2 * gap.lower**2 > square
    ratio = math.inf if time is None else float(time * gap.upper) / math.sqrt(square)
    return TimedRun(network, beta, tuple(start), tuple(disturbance), time, late, ratio)


def _of_cuts(network: Network, gamma: Fraction) -> Iterator[Start]:
    """Each cut's indicator, and the disturbance that drives its sides apart."""
    for size in range(1, network.n // 2 + 1):
        for inside in combinations(range(network.n), size):
            yield _driven([i in inside for i in range(network.n)], gamma)


def _driven(inside: list[bool], gamma: Fraction) -> Start:
    return [Fraction(side) for side in inside], [gamma if side else -gamma for side in inside]


def _random(network: Network, gamma: Fraction, tries: int, seed: int) -> Iterator[Start]:
    rng = np.random.default_rng(seed)
    for _ in range(tries):
        start = [Fraction(int(v)) for v in rng.integers(-9, 10, network.n)]
        start[0] += (max(start) == min(start)) * 1
        yield start, [gamma * int(v) for v in rng.choice([-1, 1], network.n)]
