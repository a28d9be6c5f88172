"""Search for costs whose error is above what Theorem 1 of cyclic SPSA promises.

One coordinate, two instants, the cost h(x - theta - w)^2/2 with w = sigma or -sigma, equally likely
and new in every sample, and a target that moves by delta in every sample. A step takes the error x
to a + s x for each of eight signs, so that its mean and its mean square have exact limits. Points
are drawn at random within a box, the worst ones improved, and the best of these rounded to short
rationals, for which an exact test has the last word. Close to the step at which the mean square
has no limit any more every bound is violated; what is improved stays below half of that step.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np

from theory.systems.cyclic_spsa.bounds import PRINTED, table

BOX: Mapping[str, tuple[float, float]] = {
    "share": (0.01, 0.98),
    "beta": (0.01, 10.0),
    "delta": (0.01, 10.0),
    "sigma": (0.01, 10.0),
    "h": (0.1, 10.0),
}
"""Ends of what is searched, on logarithmic scales; share is alpha over its printed limit."""

DENOMINATORS = (1, 2, 3, 4, 5, 8, 10, 20, 40, 50, 100, 200, 500, 1000, 10_000)
KEPT = 0.9
"""Share of the best ratio that a rounded point has to keep."""
Number = Any
"""A float, an array of floats or a rational."""


@dataclass(frozen=True)
class Moments:
    """What a step makes of the error x: in the mean slope x + shift.

    Its mean square is keep x^2 + tilt x + fresh.
    """

    slope: Number
    shift: Number
    keep: Number
    tilt: Number
    fresh: Number

    @property
    def mean(self) -> Number:
        """Limit of the mean error."""
        return self.shift / (1 - self.slope)

    @property
    def square(self) -> Number:
        """Limit of the mean square of the error, if keep is below 1."""
        return (self.tilt * self.mean + self.fresh) / (1 - self.keep)


@dataclass(frozen=True)
class Point:
    """One cost and one step; lengths in m.

    Parameters
    ----------
    alpha, beta, delta, sigma, h : number
        Step, size of the perturbation, drift of a sample, size of the noise, Hessian.
    """

    alpha: Number
    beta: Number
    delta: Number
    sigma: Number
    h: Number

    def constants(self) -> dict[str, Number]:
        """What Assumptions 1 to 7 give, as printed: the cost at the minimum does not change."""
        known = {"d": 1, "k": 1, "mu": self.h, "M": self.h, "c2": (self.h * self.sigma) ** 2}
        known |= {"alpha": self.alpha, "beta": self.beta, "delta": self.delta}
        return known | {"c3": 0, "c4": 0, "c_v2": 0}

    def step(self, x: Number, sign: int, late: int, early: int) -> Number:
        """The error after a step, from the two costs."""
        there, before = x - 2 * self.delta, x - self.delta
        plus = there + sign * self.beta - late * self.sigma
        minus = before - sign * self.beta - early * self.sigma
        costs = self.h * (plus * plus - minus * minus) / 2
        return there - self.alpha * sign * costs / (2 * self.beta)

    def moments(self) -> Moments:
        """Means over the eight signs."""
        starts, slopes = [], []
        for signs in product((1, -1), repeat=3):
            starts.append(self.step(0, *signs))
            slopes.append(self.step(1, *signs) - starts[-1])
        pairs = list(zip(starts, slopes, strict=True))
        return Moments(
            slope=sum(slopes) / 8,
            shift=sum(starts) / 8,
            keep=sum(s * s for s in slopes) / 8,
            tilt=2 * sum(a * s for a, s in pairs) / 8,
            fresh=sum(a * a for a in starts) / 8,
        )


@dataclass(frozen=True)
class Found:
    """What a search found.

    Parameters
    ----------
    worst : Point
        Of short rationals.
    ratio : float
        Root of the mean square of its error over the printed bound.
    violated, growing, drawn : int
        Points drawn whose error is above the bound; of these, those whose error has no limit at
        all; points drawn.
    """

    worst: Point
    ratio: float
    violated: int
    growing: int
    drawn: int


def ratios(point: Point) -> Number:
    """Root of the mean square of the error over the printed bound; infinite where it grows."""
    moments = point.moments()
    square = np.where(moments.keep < 1, moments.square, np.inf)
    bound = table(PRINTED, point.constants(), np.sqrt)["bound"]
    return np.sqrt(square) / bound


def search(seed: int = 0, drawn: int = 2000, improved: int = 3) -> Found:
    """Find the point in the box whose error is the most above the printed bound.

    Parameters
    ----------
    seed : int, optional
    drawn : int, optional
        Random points.
    improved : int, optional
        How many of the worst ones with a limit are improved.

    Returns
    -------
    Found
    """
    from scipy.optimize import minimize

    rng = np.random.default_rng(seed)
    low, high = np.log(np.array([*BOX.values()])).T
    logs = rng.uniform(low, high, size=(drawn, len(BOX)))
    with np.errstate(divide="ignore", invalid="ignore"):
        found = ratios(_point(logs.T))
    eligible = np.where(_calm(_point(logs.T)), found, -1.0)

    def loss(logarithms: Any) -> float:
        inside = ((logarithms >= low) & (logarithms <= high)).all()
        point = _point(logarithms)
        return -float(ratios(point)) if inside and _calm(point) else 0.0

    starts = logs[np.argsort(-eligible)[:improved]]
    options: Any = {"maxiter": 250, "xatol": 1e-3, "fatol": 1e-3}
    ends = [minimize(loss, start, method="Nelder-Mead", options=options) for start in starts]
    best = min(ends, key=lambda end: float(end.fun))
    worst = _rounded(_point(best.x), float(-best.fun))
    return Found(
        worst=worst,
        ratio=_exact_ratio(worst),
        violated=int((found > 1).sum()),
        growing=int(np.isinf(found).sum()),
        drawn=drawn,
    )


def _calm(point: Point) -> Number:
    """Whether twice the step would still leave the mean square a limit."""
    return 1 - point.moments().keep >= point.alpha * point.h


def _point(logs: Any) -> Point:
    share, beta, delta, sigma, h = np.exp(logs)
    return Point(share / (3 * h), beta, delta, sigma, h)


def _rounded(point: Point, ratio: float) -> Point:
    """The shortest rationals near a point that keep most of its ratio."""
    short = point
    for denominator in DENOMINATORS:
        values = {
            name: Fraction(float(value)).limit_denominator(denominator)
            for name, value in vars(point).items()
            if name != "alpha"
        }
        step = Fraction(float(point.alpha)).limit_denominator(10 * denominator)
        if min(step, *values.values()) <= 0 or 3 * step * values["h"] >= 1:
            continue
        short = Point(step, **values)
        if _calm(short) and _exact_ratio(short) >= KEPT * ratio:
            return short
    return short


def _exact_ratio(point: Point) -> float:
    """The ratio of a rational point whose mean square has a limit, that limit without rounding."""
    moments = point.moments()
    values = {name: float(value) for name, value in point.constants().items()}
    return math.sqrt(moments.square) / float(table(PRINTED, values, math.sqrt)["bound"])
