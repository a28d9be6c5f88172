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
from verification.exact.evaluate import dot, trace
from verification.exact.rationals import nearest

from ..block_inputs import Block, block_of
from ..stability.moments import noise_moments
from .second_moments import BITS, moments_of
from .settling import Settling, mean_square, slope
from .stationary import is_stable, law_of

STILL = "without drift the error is the smaller, the smaller the step is: no step is the best"
ONLY = "the only minimum: the derivative changes its sign once"
AT_ONCE = "one update removes the whole error, the only step that does: alpha = 1/h"
THERE = "the error is that at the step's value"
UNREACHED = "the sign of the derivative could not be told on both sides of {}"
HALVINGS, SMALLEST = 100, 1e-290
"""Steps of the search, and the smallest part of the largest step that it looks at."""
Sides = tuple[Fraction, Fraction]
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
    step = at_once(settling.block)
    if step is not None:
        return listed([enclosure(step, step), enclosure(Fraction(0), Fraction(0))], (AT_ONCE,))
    guess, sides = _found(settling)
    if sides is None:
        reason = UNREACHED.format(nearest(guess))
        return Answer(value=None, verdict="UNDECIDED", notes=(reason,))
    with flint.ctx.workprec(BITS):
        error = flint.arb(mean_square(settling, moments_of(settling.block, guess, exact=False)))
        root = error.sqrt() if error > 0 else error.abs_upper().sqrt().union(flint.arb(0))
        return listed([enclosure(*sides), enclosure(*ends(root))], (ONLY, THERE))


def at_once(block: Block) -> Fraction | None:
    """The step with which one update removes the whole error; None but for one coordinate."""
    still = block.size == 1 and not block.noise[0][0] and not noise_moments(block)[0][0]
    return 1 / block.hessian[0][0] if still else None


def _found(settling: Settling) -> tuple[Fraction, Sides | None]:
    """About the step at which the derivative vanishes, and steps on both sides of it."""
    import flint

    guess, sides = Fraction(0), None
    for bits in (BITS // 2, BITS):
        with flint.ctx.workprec(bits):
            guess = _root(settling)
        with flint.ctx.workprec(BITS):
            sides = _sides(settling, guess)
        if sides is not None:
            break
    return guess, sides


def _root(settling: Settling) -> Fraction:
    """About the step at which the derivative vanishes."""
    from scipy.optimize import brentq

    unit = _unit(settling)

    def value(x: float) -> float:
        found = _scaled(settling, unit * Fraction(x))
        return math.inf if found is None else float(found.mid())

    low, high = 0.5, 1.0
    while value(low) > 0:
        if low < SMALLEST:
            return unit * Fraction(low)
        low, high = low / 16, low
    for _ in range(HALVINGS):
        if high <= 2 * low and not math.isinf(value(high)):
            return unit * Fraction(brentq(value, low, high, xtol=1e-16 * low, rtol=1e-15))
        middle = math.sqrt(low * high)
        low, high = (middle, high) if value(middle) < 0 else (low, middle)
    return unit * Fraction(low)


def _unit(settling: Settling) -> Fraction:
    """A power of two above the limit of stability, which is at most 2 over H's largest eigenvalue.

    That eigenvalue is at least the mean of the diagonal.
    """
    hessian = settling.block.hessian
    mean = trace(hessian) / len(hessian)
    return Fraction(2) ** (2 + (mean.denominator.bit_length() - mean.numerator.bit_length()) + 1)


def _scaled(settling: Settling, alpha: Fraction) -> Any | None:
    """The derivative of the mean square times alpha^3/A, which starts at -2; None if unstable."""
    import flint

    moments = moments_of(settling.block, alpha, exact=False)
    if not is_stable(moments):
        return None
    scale = alpha**3 / dot(settling.lag, settling.lag)
    return flint.arb(slope(settling, moments)) * ball(scale)


def _sides(settling: Settling, guess: Fraction) -> Sides | None:
    """Steps close to each other at which the derivative has either sign, for certain."""
    for width in WIDTHS:
        low, high = guess * (1 - width), guess * (1 + width)
        before, after = (_scaled(settling, alpha) for alpha in (low, high))
        if before is not None and after is not None and before < 0 and after > 0:
            return low, high
    return None
