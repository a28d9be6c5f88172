"""Where the error of a block settles, as far as the data decide it, and how that varies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from theory.algebra.moments.laws import SymmetricLaw, gaussian, two_point
from theory.systems.cyclic_spsa.stationary import excess, kick_of_mean, kick_of_noise
from verification.exact.evaluate import dot
from verification.exact.solving import solved
from verification.exact.spectra.matrix_roots import root_enclosure

from ..block_inputs import Block
from ..stability.moments import FLINT, evaluated, exact_operators, fmpq
from .second_moments import BITS, Moments

LAWS: Mapping[str, SymmetricLaw] = {"gaussian": gaussian(1), "two_point": two_point(1)}
"""Law of the entries of e, the noise being xi = Xi^(1/2) e."""
KICK_OF_MEAN, KICK_OF_NOISE = kick_of_mean(), kick_of_noise()


@dataclass(frozen=True)
class Settling:
    """What decides where the error of a block settles, whatever the step is.

    Parameters
    ----------
    block : Block
    law : str
        Of `LAWS`.
    """

    block: Block
    law: str = "gaussian"

    @cached_property
    def move(self) -> tuple[Fraction, ...]:
        """c = 2k eta: how far the target moves between two updates of the block."""
        return tuple(2 * self.block.blocks * x for x in self.block.drift)

    @cached_property
    def lag(self) -> tuple[Fraction, ...]:
        """H^-1 c: the mean error settles at it over -alpha, before `shift`."""
        found = solved(self.block.hessian, self.move)
        assert found is not None  # H is positive definite
        return found

    @cached_property
    def shift(self) -> tuple[Fraction, ...]:
        """The error right after an update, less a: (2k - 1/2) eta, or 2k eta for one instant.

        The next update's a counts from where the target is then, and with two instants from the
        middle of the two positions.
        """
        back = Fraction(self.block.instants - 1, 2)
        return tuple(c - back * x for c, x in zip(self.move, self.block.drift, strict=True))

    def mean(self, alpha: Fraction) -> tuple[Fraction, ...]:
        """The mean error right after an update."""
        return tuple(w - x / alpha for w, x in zip(self.shift, self.lag, strict=True))

    @cached_property
    def moved(self) -> Any:
        """cc', a `flint.fmpq_mat`."""
        return fmpq(tuple(tuple(x * y for y in self.move) for x in self.move))

    @cached_property
    def by_drift(self) -> Any:
        """R0, a `flint.fmpq_mat`."""
        return self._kicked(KICK_OF_MEAN, self.moved)

    @cached_property
    def shaken(self) -> Any:
        """HZH, Z being the covariance of chi."""
        import flint

        hessian = self._exact.hessian
        return hessian * fmpq(self.block.noise) * hessian * flint.fmpq(1, self.block.instants)

    @cached_property
    def by_noise(self) -> Any:
        """R2 without its part beyond Gaussian noise."""
        return self._kicked(KICK_OF_NOISE, self.shaken)

    @cached_property
    def beyond(self) -> Any:
        """Part of R2 beyond Gaussian noise: this times the identity; exact or a ball."""
        import flint

        weight = excess(LAWS[self.law]) / self.block.beta**2
        if self.block.instants == 1 or not weight:
            return flint.fmpq(0)
        factor = flint.fmpq(weight.numerator, weight.denominator)
        return factor * self._fourth

    @cached_property
    def _fourth(self) -> Any:
        """Sum of the B_ii^2, B = Xi^(1/2) H Xi^(1/2)."""
        import flint

        noise, n = self.block.noise, self.block.size
        if all(not noise[i][j] for i in range(n) for j in range(i)):
            own = (noise[i][i] * self.block.hessian[i][i] for i in range(n))
            total = sum((x**2 for x in own), start=Fraction(0))
            return flint.fmpq(total.numerator, total.denominator)
        with flint.ctx.workprec(BITS):
            root = root_enclosure(noise)
            inner = root * flint.arb_mat(fmpq(self.block.hessian)) * root
            return sum((inner[i, i] ** 2 for i in range(n)), start=flint.arb(0))

    @cached_property
    def _exact(self) -> Any:
        return exact_operators(self.block)

    def _kicked(self, form: Any, inner: Any) -> Any:
        values = {"Q": inner, "N": self._exact.noise, "I": self._exact.one}
        return evaluated(form, values, FLINT)


def right_side(settling: Settling, moments: Moments) -> Any:
    """R0/alpha + alpha R2, without the part beyond Gaussian noise."""
    drift, noise = (moments.given(part) for part in (settling.by_drift, settling.by_noise))
    return drift * (1 / moments.step) + noise * moments.step


def mean_square(settling: Settling, moments: Moments) -> Any:
    """E|theta_hat - theta|^2 right after an update, for a stable step.

    Returns
    -------
    flint.fmpq or flint.arb
        Exact, or a ball that holds it, at the precision that is set.
    """
    import flint

    step = moments.step
    spread = moments.trace(moments.solved(right_side(settling, moments)))
    if settling.beyond != 0:
        spread = spread + settling.beyond * step * moments.trace(moments.unit)
    mean = settling.mean(moments.alpha)
    square = sum((x**2 for x in mean), start=Fraction(0))
    return spread + flint.fmpq(square.numerator, square.denominator)


def slope(settling: Settling, moments: Moments) -> Any:
    """Derivative of `mean_square` by the step, for a stable step.

    With pull(X) - alpha kick(X) = R, the derivative of X solves the same equation for kick(X) and
    the derivative of R; the mean's part is that of |shift - lag/alpha|^2.
    """
    import flint

    step = moments.step
    drift, noise = (moments.given(part) for part in (settling.by_drift, settling.by_noise))
    kicked, slack = moments.kicked(moments.solved(right_side(settling, moments)))
    found = moments.trace(moments.solved(kicked - drift * (1 / step**2) + noise, slack))
    if settling.beyond != 0:
        rise = moments.trace(moments.solved(*moments.kicked(moments.unit)))
        found = found + settling.beyond * (moments.trace(moments.unit) + step * rise)
    inner = 2 * dot(settling.lag, settling.shift) - 2 * dot(settling.lag, settling.lag) / (
        moments.alpha
    )
    rest = inner / moments.alpha**2
    return found + flint.fmpq(rest.numerator, rest.denominator)
