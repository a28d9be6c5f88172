"""How far agents may drift while links are down."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from sensortrack.networks import Network
from verification.answers import Answer
from verification.exact.rationals import above
from verification.exact.square_roots import exact_square_root

from .network_inputs import bounds_of, usable_numbers

SUMS = 3_000_000
"""Sums of signed bounds that are looked at for the smallest."""

ANY_LINKS = "whatever links are left meanwhile; attained where none are"


def outage_growth(values: Mapping[str, Any]) -> Answer:
    """Most that |x| can grow while links are down: tau times the largest |M u|, |u_i| <= gamma_i.

    Parameters
    ----------
    values : mapping
        ``graph``: Network, of which the agents count only; ``gamma``: tuple of Fraction, one a
        node; ``tau``: a rational of at least 0, seconds.

    Returns
    -------
    Answer
        With equal bounds 2 gamma tau sqrt(floor(n^2/4)/n). |M u|^2 is the sum of the gamma_i^2
        less the square of the smallest signed sum of the gamma_i over n; where there are too many
        of these, the value is an upper bound only.

    Raises
    ------
    InputError
        A bound or tau is negative, or a number is not of usable size.
    """
    usable_numbers(values)
    network: Network = values["graph"]
    gamma = bounds_of(values)
    tau: Fraction = values["tau"]
    if tau < 0:
        raise InputError("tau", f"{tau}", "a time of at least 0 is needed")
    rest = smallest_signed_sum(gamma)
    notes = [ANY_LINKS]
    if rest is None:
        notes.append("an upper bound: the bounds are too unlike for the exact value")
    square: Fraction = (
        sum((bound**2 for bound in gamma), Fraction(0)) - (rest or Fraction(0)) ** 2 / network.n
    )
    found = exact_square_root(square * tau**2)
    assert found is not None
    if rest is None:
        upper = above(Fraction(found.nearest) * (1 + Fraction(1, 2**50)))
        return Answer(None, None, None, upper, None, "UNDECIDED", notes=tuple(notes))
    return Answer(value=found.nearest, exact=found.to_data(), notes=tuple(notes))


def smallest_signed_sum(gamma: Sequence[Fraction]) -> Fraction | None:
    """Smallest |sum of s_i gamma_i| over signs s_i, or None if there are too many sums."""
    unit = math.lcm(*{bound.denominator for bound in gamma})
    bounds = sorted((int(bound * unit) for bound in gamma), reverse=True)
    if bounds[0] == bounds[-1]:
        return Fraction(len(bounds) % 2 * bounds[0], unit)
    rest, left, work = {0}, sum(bounds), 0
    for bound in bounds:
        left -= bound
        sums = {abs(value + sign * bound) for value in rest for sign in (1, -1)}
        beyond = [value for value in sums if value > left]  # the others cannot make up for these
        rest = {value for value in sums if value <= left} | ({min(beyond)} if beyond else set())
        work += len(rest)
        if work > SUMS:
            return None
    return Fraction(min(rest), unit)
