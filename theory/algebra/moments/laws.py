"""Laws of a random number that are symmetric about zero, by their moments."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

Number = Fraction | int


@dataclass(frozen=True)
class SymmetricLaw:
    """A law that gives x and -x the same weight.

    Parameters
    ----------
    name : str
        In a word or two.
    even : callable
        ``even(k)`` is E x^(2k).
    """

    name: str
    even: Callable[[int], Fraction]

    def moment(self, order: int) -> Fraction:
        """E x^order; zero for every odd order.

        Raises
        ------
        ValueError
            The order is negative, or the law is not known to this order.
        """
        if order < 0:
            raise ValueError(f"order: {order}; 0 or more is needed")
        return Fraction(0) if order % 2 else self.even(order // 2)

    @property
    def variance(self) -> Fraction:
        """E x^2."""
        return self.moment(2)

    @property
    def excess(self) -> Fraction:
        """E x^4 - 3 (E x^2)^2, which is zero for a Gaussian law."""
        return self.moment(4) - 3 * self.variance**2


def two_point(size: Number) -> SymmetricLaw:
    """Plus or minus `size`, each with probability one half."""
    return SymmetricLaw("two points", lambda k: Fraction(size) ** (2 * k))


RADEMACHER = two_point(1)
"""Plus or minus 1, each with probability one half."""


def gaussian(variance: Number) -> SymmetricLaw:
    """The Gaussian law of mean 0: E x^(2k) = 1 * 3 * ... * (2k - 1) variance^k.

    Raises
    ------
    ValueError
        The variance is negative.
    """
    if variance < 0:
        raise ValueError(f"variance: {variance}; 0 or more is needed")

    def even(k: int) -> Fraction:
        found = Fraction(1)
        for odd in range(1, 2 * k, 2):
            found *= odd * Fraction(variance)
        return found

    return SymmetricLaw("Gaussian", even)


def symmetric(moments: Sequence[Number]) -> SymmetricLaw:
    """Any symmetric law, given by E x^2, E x^4, ...

    Parameters
    ----------
    moments : sequence of Fraction or int

    Raises
    ------
    ValueError
        No law has these: one is negative, or (E x^2k)^2 > E x^(2k-2) E x^(2k+2) for some k.
    """
    known = [Fraction(1), *(Fraction(m) for m in moments)]
    for k, m in enumerate(known):
        if m < 0:
            raise ValueError(f"moments: E x^{2 * k} is {m}; 0 or more is needed")
    for k in range(1, len(known) - 1):
        if known[k] ** 2 > known[k - 1] * known[k + 1]:
            raise ValueError(f"moments: E x^{2 * k + 2} is {known[k + 1]}; Cauchy asks for more")

    def even(k: int) -> Fraction:
        if k >= len(known):
            raise ValueError(f"moments: up to E x^{2 * len(known) - 2}; E x^{2 * k} is asked")
        return known[k]

    return SymmetricLaw("symmetric", even)
