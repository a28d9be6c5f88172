"""The first h > 0 at which a symmetric matrix polynomial stops being positive definite."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

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
    unit, shifts, balanced = _balanced(e0, e1, e2)
    y = _critical_vector(*balanced)
    if y is None:
        return None
    upper = _sign_change(*(quadratic(y, e) for e in balanced))
    lower = math.nextafter(upper, 0.0)
    for _ in range(24):
        low = Fraction(lower)
        if congruence(_at(balanced, low)) is not None:
            low, high = unit * low, unit * Fraction(upper)
            x = _whole([v / shift for v, shift in zip(y, shifts, strict=True)])
            return Threshold(low, high, x, _exact(e0, e1, e2, low, high))
        lower -= 2 * (upper - lower)
    return None


def _at(powers: tuple[Rows, Rows, Rows], h: Fraction | int) -> Rows:
    """E0 + h E1 + h^2 E2."""
    return add(add(powers[0], powers[1], h), powers[2], h * h)


def _balanced(
    e0: Rows, e1: Rows, e2: Rows
) -> tuple[Fraction, list[Fraction], tuple[Rows, Rows, Rows]]:
    """Change units by powers of two: E0 gets a diagonal near 1, E2 a largest entry near 1.

    Returns
    -------
    unit : Fraction
        The unit of h.
    shifts : list of Fraction
        The units of the coordinates, 1/shift each.
    balanced : three Rows
    """
    shifts = [Fraction(2) ** (_exponent(e0[i][i]) // 2) for i in range(len(e0))]
    rows = [
        tuple(
            tuple(x / (s * t) for x, t in zip(row, shifts, strict=True))
            for row, s in zip(e, shifts, strict=True)
        )
        for e in (e0, e1, e2)
    ]
    unit = Fraction(2) ** (-_exponent(max(abs(x) for row in rows[2] for x in row)) // 2)
    return unit, shifts, (rows[0], scaled(unit, rows[1]), scaled(unit**2, rows[2]))


def _exponent(x: Fraction) -> int:
    return abs(x.numerator).bit_length() - x.denominator.bit_length()


def _whole(x: list[Fraction]) -> tuple[int, ...]:
    """The shortest integer vector in the same direction."""
    den = math.lcm(*(v.denominator for v in x))
    whole = [int(v * den) for v in x]
    return tuple(v // math.gcd(*whole) for v in whole)


def _exact(e0: Rows, e1: Rows, e2: Rows, low: Fraction, high: Fraction) -> Algebraic | None:
    if len(e0) > EXACT_SIZE:
        return None

    values = partial(_at, (e0, e1, e2))
    polynomial = interpolate(lambda h: determinant(values(h)), 2 * len(e0))
    return root_between(polynomial, low, high)


def _floats(a: Rows) -> NDArray[np.float64]:
    return np.array([[float(x) for x in row] for row in a])


def _critical_vector(e0: Rows, e1: Rows, e2: Rows) -> tuple[Fraction, ...] | None:
    """Vector whose form loses its sign first, or None where doubles do not reach.

    The quadratic eigenproblem is solved in mu = 1/h, where it is hyperbolic, after E0 has been
    reduced to the identity; the root of the Rayleigh quotient then has twice the digits.
    """
    try:
        factor = np.linalg.cholesky(_floats(e0))
        first, second = (
            np.linalg.solve(factor, np.linalg.solve(factor, _floats(e)).T) for e in (e1, e2)
        )
        n = len(e0)
        eye = np.eye(n)
        companion = np.block([[np.zeros((n, n)), eye], [-second, -first]])
        mu = float(np.linalg.eigvals(companion).real.max())
        y = eye[0]
        for _ in range(3):
            y = np.linalg.eigh(mu * mu * eye + mu * first + second)[1][:, 0]
            a, c = float(y @ first @ y), float(y @ second @ y)
            mu = (-a + math.hypot(a, 2 * math.sqrt(-c))) / 2
        x = np.linalg.solve(factor.T, y)
        x = np.rint(x / np.max(np.abs(x)) * 2.0**VECTOR_BITS)
    except (np.linalg.LinAlgError, OverflowError, ValueError):
        return None
    return tuple(Fraction(int(v)) for v in x) if np.all(np.isfinite(x)) else None


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
