"""The first h > 0 at which a symmetric matrix polynomial stops being positive definite."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from .definite import congruence
from .evaluate import Rows, add, quadratic, scaled
from .rationals import above, below, nearest
from .roots import Algebraic, determinant, interpolate, root_between

VECTOR_BITS = 60
EXACT_SIZE = 12


@dataclass(frozen=True)
class Threshold:
    """E(h) > 0 for 0 < h <= lower; the vector has x'E(h)x <= 0 for every h >= upper.

    Parameters
    ----------
    lower, upper : Fraction
        Doubles, one or a few units in the last place apart.
    vector : tuple of int
        Shows the upper side.
    exact : Algebraic or None
        The threshold itself where its degree is moderate.
    """

    lower: Fraction
    upper: Fraction
    vector: tuple[int, ...]
    exact: Algebraic | None


def concave_threshold(powers: Mapping[int, Rows]) -> Threshold | None:
    """Threshold of E(h) = E0 + h E1 + h^2 E2 with E0 > 0 and E2 < 0.

    x'E(h)x is concave in h, positive at 0 and eventually negative, so that it changes sign once;
    the threshold is the smallest such sign change over all x, attained at an eigenvector.

    Parameters
    ----------
    powers : mapping of int to Rows
        E0, E1 (may be missing) and E2, symmetric.

    Returns
    -------
    Threshold or None
        None if no double below the threshold could be certified within 1e-9 of it.
    """
    e0, e2 = powers[0], powers[2]
    e1 = powers.get(1, scaled(0, e0))
    x = _critical_vector(e0, e1, e2)
    upper = _sign_change(quadratic(x, e0), quadratic(x, e1), quadratic(x, e2))
    lower = math.nextafter(upper, 0.0)
    for _ in range(24):
        value = Fraction(lower)
        if congruence(add(add(e0, e1, value), e2, value * value)) is not None:
            exact = _exact(e0, e1, e2, value, Fraction(upper))
            return Threshold(value, Fraction(upper), x, exact)
        lower -= 2 * (upper - lower)
    return None


def _exact(e0: Rows, e1: Rows, e2: Rows, low: Fraction, high: Fraction) -> Algebraic | None:
    if len(e0) > EXACT_SIZE:
        return None

    def value(h: int) -> Fraction:
        return determinant(add(add(e0, e1, h), e2, h * h))

    return root_between(interpolate(value, 2 * len(e0)), low, high)


def _floats(a: Rows, size: Fraction) -> NDArray[np.float64]:
    return np.array([[float(x / size) for x in row] for row in a])


def _critical_vector(e0: Rows, e1: Rows, e2: Rows) -> tuple[int, ...]:
    """Round the vector whose form loses its sign first.

    The quadratic eigenproblem is solved in mu = 1/h, where it is hyperbolic, after E0 has been
    reduced to the identity; the root of the Rayleigh quotient then has twice the digits.
    """
    size = max(abs(x) for row in e0 for x in row)
    factor = np.linalg.cholesky(_floats(e0, size))
    first, second = (
        np.linalg.solve(factor, np.linalg.solve(factor, _floats(e, size)).T) for e in (e1, e2)
    )
    n = len(e0)
    eye = np.eye(n)
    companion = np.block([[np.zeros((n, n)), eye], [-second, -first]])
    values, vectors = np.linalg.eig(companion)
    best = int(np.argmax(values.real))
    mu = float(values[best].real)
    y = vectors[:n, best].real
    for _ in range(3):
        _, basis = np.linalg.eigh(mu * mu * eye + mu * first + second)
        y = basis[:, 0]
        a, c = float(y @ first @ y), float(y @ second @ y)
        mu = (-a + math.sqrt(a * a - 4 * c)) / 2
    x = np.linalg.solve(factor.T, y)
    x = x / np.max(np.abs(x))
    whole = [int(Fraction(float(v)) * 2**VECTOR_BITS) for v in x]
    common = math.gcd(*whole)
    return tuple(v // common for v in whole)


def _sign_change(c0: Fraction, c1: Fraction, c2: Fraction) -> float:
    """Smallest double h with c0 + c1 h + c2 h^2 <= 0, for c0 > 0 > c2."""
    square = c1 * c1 - 4 * c0 * c2
    unit = square.denominator
    shift = 2 ** max(0, 256 - square.numerator.bit_length())
    root = Fraction(math.isqrt(square.numerator * unit * shift**2), unit * shift)
    h = above((c1 + root) / (-2 * c2))
    while c0 + c1 * Fraction(h) + c2 * Fraction(h) ** 2 > 0:
        h = math.nextafter(h, math.inf)
    while c0 + c1 * Fraction(below_of(h)) + c2 * Fraction(below_of(h)) ** 2 <= 0:
        h = below_of(h)
    return h


def below_of(h: float) -> float:
    """The next smaller double."""
    return math.nextafter(h, -math.inf)


def value_of(threshold: Threshold) -> float:
    """The double nearest to the exact threshold, else the middle of the bracket."""
    if threshold.exact is not None:
        return threshold.exact.nearest
    return nearest((threshold.lower + threshold.upper) / 2)


def ends(threshold: Threshold) -> tuple[float, float]:
    """Lower and upper end as doubles that enclose the threshold."""
    return below(threshold.lower), above(threshold.upper)
