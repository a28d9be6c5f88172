"""What Theorem 1 promises, in rationals: roots are rounded up, which only weakens a promise."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from theory.systems.cyclic_spsa.bounds import PRINTED, Bound, table
from theory.systems.cyclic_spsa.target_bound import PRINTED_2

UNIT = 10**8
ONES, ZEROS = ("d", "k", "mu", "M"), ("delta", "c2", "c3", "c4", "c_v2")


def root_above(x: Fraction) -> Fraction:
    """The square root of a number that is not negative, rounded up to eight decimals."""
    scaled = math.ceil(x * UNIT**2)
    root = math.isqrt(scaled)
    return Fraction(root + (root * root < scaled), UNIT)


def promised(given: Mapping[str, Fraction | int], bound: Bound = PRINTED) -> dict[str, Fraction]:
    """Every line of a bound.

    Parameters
    ----------
    given : mapping of str to Fraction or int
        alpha, beta and those of the other constants that are not 1 (d, k, mu, M) or 0 (delta, c2,
        c3, c4, c_v2).
    bound : Bound, optional

    Returns
    -------
    dict of str to Fraction
        The constants and every line; ``bound`` is not below what is promised.
    """
    known = dict.fromkeys(ONES, 1) | dict.fromkeys(ZEROS, 0) | dict(given)
    return _exact(bound, known)


def promised_2(given: Mapping[str, Fraction | int]) -> dict[str, Fraction]:
    """Every line of the bound of Theorem 2.

    Parameters
    ----------
    given : mapping of str to Fraction or int
        The names of `target_bound.GIVEN_2` without roots.

    Returns
    -------
    dict of str to Fraction
        As `promised`.
    """
    return _exact(PRINTED_2, given)


def _exact(bound: Bound, given: Mapping[str, Fraction | int]) -> dict[str, Fraction]:
    exact = {name: Fraction(value) for name, value in given.items()}
    return {name: Fraction(value) for name, value in table(bound, exact, root_above).items()}
