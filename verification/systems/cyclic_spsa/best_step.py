"""The step with the smallest stationary mean-square error of a block that drifts.

There is exactly one, or none without drift. With the solution of `second_moments` written as a
series in the step, the mean square is

    A/alpha^2 - B/alpha + e_0 + e_1 alpha + e_2 alpha^2 + ...,   A = |H^-1 c|^2,

where every e_j with j >= 1 is a trace of positive semidefinite matrices, hence not negative. Its
derivative times alpha^3 is -2A + B alpha + e_1 alpha^3 + 2 e_2 alpha^4 + ..., whose coefficients
change sign once whatever the sign of B is: it vanishes once, from minus to plus. The mean square
grows beyond all bounds at the limit of stability, but for one coordinate without any noise.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from verification.answers import Answer
from verification.enclosures import ball, enclosure, ends, listed
from verification.exact.evaluate import dot
from verification.exact.rationals import nearest

from .block_inputs import block_of
from .second_moments import BITS, moments_of
from .stationary import Settling, is_stable, law_of, mean_square, slope

STILL = "without drift the error is the smaller, the smaller the step is: no step is the best"
ONLY = "the only minimum: the derivative changes its sign once"
THERE = "the error is that at the step's value"
UNREACHED = "the sign of the derivative could not be told on both sides of {}"
WIDTHS = tuple(Fraction(4**k, 2**52) for k in range(8))
"""Relative half-widths that are tried for the bounds on the step."""


def best_step(values: Mapping[str, Any]) -> Answer:
    """The step with the least stationary mean-square error, and its root-mean-square error.

    Parameters
    ----------
    values : mapping
        The inputs of a block; ``law`` of the noise.

    Returns
    -------
    Answer
        [alpha, root of E|theta_hat - theta|^2 right after an update, in m], the step between two
        at which the derivative has either sign. [0, 0] without drift.

    Raises
    ------
    InputError
        An input of the block or the law is out of range.
    """
    import flint

    settling = Settling(block_of(values), law_of(values))
    if not any(settling.move):
        return Answer(value=[0.0, 0.0], verdict="PROVED", notes=(STILL,))
    with flint.ctx.workprec(BITS):
        guess = _root(settling)
        sides = _sides(settling, guess)
        if sides is None:
            reason = UNREACHED.format(nearest(guess))
            return Answer(value=None, verdict="UNDECIDED", notes=(reason,))
        error = flint.arb(mean_square(settling, moments_of(settling.block, guess, exact=False)))
        root = error.sqrt() if error > 0 else error.abs_upper().sqrt().union(flint.arb(0))
        return listed([enclosure(*sides), enclosure(*ends(root))], (ONLY, THERE))


def _root(settling: Settling) -> Fraction:
    """About the step at which the derivative vanishes."""
    from scipy.optimize import brentq

    unit = _unit(settling)

    def value(x: float) -> float:
        return _sign_and_size(settling, unit * Fraction(x))

    low, high = 0.5, 1.0
    while value(low) > 0:
        low, high = low / 16, low
    while math.isinf(value(high)) or high > 2 * low:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if value(middle) < 0 else (low, middle)
    return unit * Fraction(brentq(value, low, high, xtol=1e-16 * low, rtol=1e-15))


def _unit(settling: Settling) -> Fraction:
    """A power of two above the limit of stability, which is at most 2 over H's largest eigenvalue.

    That eigenvalue is at least the mean of the diagonal.
    """
    hessian = settling.block.hessian
    trace = sum((hessian[i][i] for i in range(len(hessian))), start=Fraction(0))
    mean = trace / len(hessian)
    return Fraction(2) ** (2 + (mean.denominator.bit_length() - mean.numerator.bit_length()) + 1)


def _sign_and_size(settling: Settling, alpha: Fraction) -> float:
    """The derivative of the mean square times alpha^3/A, which starts at -2; inf if unstable."""
    moments = moments_of(settling.block, alpha, exact=False)
    if not is_stable(moments):
        return math.inf
    return float(_scaled(settling, alpha).mid())


def _scaled(settling: Settling, alpha: Fraction) -> Any:
    import flint

    scale = alpha**3 / dot(settling.lag, settling.lag)
    return flint.arb(slope(settling, moments_of(settling.block, alpha, exact=False))) * ball(scale)


def _sides(settling: Settling, guess: Fraction) -> tuple[Fraction, Fraction] | None:
    """Steps close to each other at which the derivative has either sign, for certain."""
    for width in WIDTHS:
        low, high = guess * (1 - width), guess * (1 + width)
        if not is_stable(moments_of(settling.block, high, exact=False)):
            continue
        if _scaled(settling, low) < 0 and _scaled(settling, high) > 0:
            return low, high
    return None
