"""Moments of quadratic forms in vectors of independent entries with one symmetric law.

Everything follows from the fourth moments. Where an index occurs once, or three times beside
another, the mean is zero, so that with m = E x^2 and e = E x^4 - 3m^2

    E x_i x_j x_k x_l = m^2 (d_ij d_kl + d_ik d_jl + d_il d_jk) + e d_ijkl,

d being 1 where its indices are equal and 0 elsewhere. `agrees` goes through all ways in which four
indices can coincide, so that this holds for vectors of every length.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import prod
from typing import NamedTuple

from .laws import SymmetricLaw

Rows = Sequence[Sequence[Fraction]]


class Fourth(NamedTuple):
    """Coefficients of the fourth moments: of each of the three pairings, and of all four equal."""

    pair: Fraction
    all: Fraction

    def of(self, indices: Sequence[int]) -> Fraction:
        """E x_i x_j x_k x_l for four indices."""
        i, j, k, m = indices
        pairs = (i == j and k == m) + (i == k and j == m) + (i == m and j == k)
        return self.pair * pairs + self.all * (i == j == k == m)


class Sandwich(NamedTuple):
    """E x x'(x'Qx) = trace tr(Q) I + whole Q + diagonal diag(Q), for every symmetric Q."""

    trace: Fraction
    whole: Fraction
    diagonal: Fraction


def coincidences(count: int) -> Iterator[tuple[int, ...]]:
    """All ways in which `count` indices coincide, as indices numbered by first occurrence."""
    ways: list[tuple[int, ...]] = [()]
    for _ in range(count):
        ways = [(*way, new) for way in ways for new in range(max(way, default=-1) + 2)]
    yield from ways


def direct(law: SymmetricLaw, indices: Sequence[int]) -> Fraction:
    """Mean of the product of these entries of x: equal ones are powers, others independent."""
    return prod((law.moment(n) for n in Counter(indices).values()), start=Fraction(1))


def fourth(law: SymmetricLaw) -> Fourth:
    """The fourth moments of a vector of independent entries.

    Raises
    ------
    ValueError
        The law is not known to the fourth moment.
    """
    found = Fourth(law.variance**2, law.excess)
    if not agrees(found, law):
        raise ValueError(f"law: {law.name} is not symmetric; it has to be")
    return found


def agrees(found: Fourth, law: SymmetricLaw) -> bool:
    """Whether the formula is right in each of the 15 ways in which four indices coincide."""
    return all(found.of(way) == direct(law, way) for way in coincidences(4))


def sandwich(law: SymmetricLaw) -> Sandwich:
    """E x x'(x'Qx): multiply the fourth moments by Q_kl and sum over k and l.

    The pairing (ij)(kl) leaves d_ij tr Q, the other two Q_ij and Q_ji, and d_ijkl leaves Q_ii.
    """
    pair, four = fourth(law)
    return Sandwich(pair, 2 * pair, four)


def mean_square(q: Rows, law: SymmetricLaw) -> Fraction:
    """E (x'Qx)^2 for a symmetric Q: the trace of Q times the sandwich."""
    size = range(len(q))
    c = sandwich(law)
    trace = sum((q[i][i] for i in size), start=Fraction(0))
    whole = sum((q[i][j] ** 2 for i in size for j in size), start=Fraction(0))
    own = sum((q[i][i] ** 2 for i in size), start=Fraction(0))
    return c.trace * trace**2 + c.whole * whole + c.diagonal * own


def variance(q: Rows, law: SymmetricLaw) -> Fraction:
    """Variance of x'Qx for a symmetric Q."""
    trace = sum((q[i][i] for i in range(len(q))), start=Fraction(0))
    return mean_square(q, law) - (law.variance * trace) ** 2
