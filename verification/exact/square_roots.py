"""Square roots of rationals: doubles on a wanted side, and as algebraic numbers."""

from __future__ import annotations

import math
from fractions import Fraction

from .rationals import nearest
from .roots import Algebraic, root_between


def square_root_beside(square: Fraction | None, down: bool) -> Fraction | None:
    """A double next to the square root, on the side that is asked for."""
    if square is None:
        return None
    shift = 2 ** max(0, 128 - square.numerator.bit_length() + square.denominator.bit_length())
    guess = nearest(Fraction(math.isqrt(square.numerator * shift**2 // square.denominator), shift))
    if down:
        while Fraction(guess) ** 2 > square:
            guess = math.nextafter(guess, 0.0)
    else:
        while Fraction(guess) ** 2 < square:
            guess = math.nextafter(guess, math.inf)
    return Fraction(guess)


def exact_square_root(square: Fraction | None) -> Algebraic | None:
    """The square root as an algebraic number."""
    if square is None:
        return None
    if square == 0:
        return Algebraic((0, 1), Fraction(0), Fraction(0), 0.0)
    low, high = (square_root_beside(square, down) or Fraction(0) for down in (True, False))
    polynomial = (-square.numerator, 0, square.denominator)
    return root_between(polynomial, low * Fraction(999, 1000), high * Fraction(1001, 1000))
