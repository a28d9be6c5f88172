"""The mean of ln|Z| for a Gaussian Z, in balls of many bits.

Z^2 is its variance v times a noncentral chi-square variable of one degree of freedom, which is a
mixture of central ones with 1 + 2J degrees, J being Poisson of mean u = mu^2/(2v). Hence

    E ln|Z| = (ln(2v) + E psi(J + 1/2)) / 2.

The sum over J is cut where Bernstein's bound leaves less than the ball. For large u the sum is
long, and ln|1 + y| is expanded for the Gaussian y = Z/mu - 1 of standard deviation (2u)^(-1/2).
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt
from typing import Any

LONG = 20_000
"""Mean of J from which on the expansion is used."""

GUARD = 80


def gaussian_log_mean(mean: Fraction, variance: Fraction, bits: int = 128) -> Any:
    """E ln|Z| for a Gaussian Z.

    Parameters
    ----------
    mean, variance : Fraction
        Of Z; the variance is not negative, and not zero where the mean is.
    bits : int, optional
        Precision that is aimed at.

    Returns
    -------
    flint.arb
        A ball that holds it.

    Raises
    ------
    ValueError
        Z is zero, whose logarithm has no mean.
    """
    import flint

    if variance < 0 or (not variance and not mean):
        raise ValueError(f"variance: {variance} about the mean {mean}; Z must not be zero")
    with flint.ctx.workprec(bits + GUARD):
        if not variance:
            return abs(_ball(mean)).log()
        u = mean**2 / (2 * variance)
        if u > LONG:
            return abs(_ball(mean)).log() + _expansion(_ball(u))
        return ((2 * _ball(variance)).log() + _mixture(u, bits)) / 2


def _ball(x: Fraction) -> Any:
    import flint

    return flint.arb(flint.fmpq(x.numerator, x.denominator))


def _mixture(u: Fraction, bits: int) -> Any:
    """E psi(J + 1/2) for a Poisson J of mean u.

    With B = bits and K >= sqrt(2uB) + B, Bernstein's inequality bounds each tail beyond u - K and
    u + K by exp(-B). |psi(j + 1/2)| <= 2 + j, and the sum of j over the upper tail is u times the
    tail that starts one earlier, so that what is cut is below 2 (2 + u) exp(-B).
    """
    import flint

    mean, half = _ball(u), _ball(Fraction(1, 2))
    if not u:
        return half.digamma()
    reach = isqrt(int(2 * u * bits) + 1) + bits + 2
    first, last = max(0, int(u) - reach), int(u) + reach + 2
    weight = (-mean + first * mean.log() - flint.arb(first + 1).lgamma()).exp()
    psi, total = (first + half).digamma(), flint.arb(0)
    for j in range(first, last + 1):
        total += weight * psi
        weight, psi = weight * mean / (j + 1), psi + 1 / (j + half)
    cut = 2 * (2 + mean) * flint.arb(-bits).exp()
    return total + flint.arb(0, cut.upper())


def _expansion(u: Any) -> Any:
    """E ln|1 + y| for a Gaussian y of mean 0 and standard deviation t = (2u)^(-1/2), small.

    Up to |y| = 1/2 the series of the logarithm to y^7 leaves at most y^8/4, and its odd terms have
    mean zero. Beyond, density and moments are below (10/t) exp(-1/(16 t^2)) together: the density
    there is at most exp(-1/(8 t^2))/t, and Cauchy bounds what the even terms have in the tail.
    """
    import flint

    square = 1 / (2 * u)
    even = -square / 2 - 3 * square**2 / 4 - 15 * square**3 / 6
    tail = 10 / square.sqrt() * (-1 / (16 * square)).exp()
    rest = 105 * square**4 / 4 + tail
    return even + flint.arb(0, rest.upper())
