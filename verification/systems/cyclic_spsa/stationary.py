"""Mean and mean square of the error right after an update, once both have settled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from sensortrack.errors import InputError
from theory.algebra.moments.laws import SymmetricLaw, gaussian, two_point
from theory.systems.cyclic_spsa.stationary import excess, kick_of_mean, kick_of_noise
from verification.answers import Answer, Input
from verification.enclosures import enclosure, ends, listed, single
from verification.exact.definite import congruence
from verification.exact.evaluate import dot
from verification.exact.matrix_roots import root_enclosure
from verification.exact.rationals import text
from verification.exact.solving import solved
from verification.input_kinds import positive

from .block_inputs import ALPHA, BLOCK, Block, block_of
from .moments import FLINT, evaluated, exact_operators, fmpq
from .second_moments import BITS, Moments, moments_of
from .solutions import TooClose

LAWS: Mapping[str, SymmetricLaw] = {"gaussian": gaussian(1), "two_point": two_point(1)}
"""Law of the entries of e, the noise being xi = Xi^(1/2) e."""
LAW = Input("law", "word", "law of the measured positions: gaussian or two_point", "", "gaussian")
MEAN = (*BLOCK, ALPHA)
MEAN_SQUARE = (*BLOCK, ALPHA, LAW)
BEST = (*BLOCK, LAW)
KICK_OF_MEAN, KICK_OF_NOISE = kick_of_mean(), kick_of_noise()
LONGEST = 400
"""Digits of a rational that an answer carries."""

GROWS = "the second moments grow at this step"
MEAN_GROWS = "the mean itself grows at this step: alpha times the largest eigenvalue of H is >= 2"
SPREADS = "the mean settles, but the second moments grow at this step"
NO_WORD = "floating point does not tell whether this step is stable: it is too close to the limit"


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
    def by_drift(self) -> Any:
        """R0, a `flint.fmpq_mat`."""
        square = fmpq(tuple(tuple(x * y for y in self.move) for x in self.move))
        return self._kicked(KICK_OF_MEAN, square)

    @cached_property
    def by_noise(self) -> Any:
        """R2 without its part beyond Gaussian noise."""
        chi = self._exact.hessian * fmpq(self.block.noise) * self._exact.hessian
        return self._kicked(KICK_OF_NOISE, chi) * fmpq(((Fraction(1, self.block.instants),),))[0, 0]

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


def stationary_mean(values: Mapping[str, Any]) -> Answer:
    """Limit of the mean of theta_hat - theta right after an update.

    Parameters
    ----------
    values : mapping
        The inputs of a block, and ``alpha``, above 0.

    Returns
    -------
    Answer
        D numbers in m, each the double nearest to the exact rational; ``"inf"`` for all of them
        where the mean has no limit. It may have one where second moments do not.

    Raises
    ------
    InputError
        An input of the block or alpha is out of range.
    """
    import flint

    block, alpha = block_of(values), positive(values, "alpha")
    if not mean_settles(block, alpha):
        return Answer(value=["inf"] * block.size, verdict="PROVED", notes=(MEAN_GROWS,))
    found = Settling(block).mean(alpha)
    notes = (f"exact: {', '.join(map(text, found))}",) if _short(found) else ()
    with flint.ctx.workprec(BITS):
        if is_stable(moments_of(block, alpha)) is False:
            notes = (*notes, SPREADS)
    return listed([enclosure(x, x) for x in found], notes)


def stationary_mse(values: Mapping[str, Any]) -> Answer:
    """Limit of E|theta_hat - theta|^2 right after an update.

    Parameters
    ----------
    values : mapping
        The inputs of a block; ``alpha``, above 0; ``law`` of the noise, of `LAWS`.

    Returns
    -------
    Answer
        In m^2, in certified bounds, and exact where the noise is Gaussian or its covariance
        diagonal, for a diagonal Hessian or up to eight coordinates; ``"inf"`` where second moments
        grow; no value where floating point does not tell.

    Raises
    ------
    InputError
        An input of the block, alpha or the law is out of range.
    """
    import flint

    block, alpha, law = block_of(values), positive(values, "alpha"), law_of(values)
    with flint.ctx.workprec(BITS):
        moments = moments_of(block, alpha)
        stable = is_stable(moments)
        if stable is None:
            return Answer(verdict="UNDECIDED", notes=(NO_WORD,))
        if not stable:
            return Answer(value="inf", verdict="PROVED", notes=(GROWS,))
        return _mean_square_answer(mean_square(Settling(block, law), moments))


def mean_square(settling: Settling, moments: Moments) -> Any:
    """E|theta_hat - theta|^2 right after an update, for a stable step.

    Returns
    -------
    flint.fmpq or flint.arb
        Exact, or a ball that holds it, at the precision that is set.
    """
    import flint

    step = moments.step
    drift, noise = (moments.given(part) for part in (settling.by_drift, settling.by_noise))
    side = drift * (1 / step) + noise * step
    spread = moments.trace(moments.solved(side))
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
    kicked, slack = moments.kicked(moments.solved(drift * (1 / step) + noise * step))
    found = moments.trace(moments.solved(kicked - drift * (1 / step**2) + noise, slack))
    if settling.beyond != 0:
        rise = moments.trace(moments.solved(*moments.kicked(moments.unit)))
        found = found + settling.beyond * (moments.trace(moments.unit) + step * rise)
    inner = 2 * dot(settling.lag, settling.shift) - 2 * dot(settling.lag, settling.lag) / (
        moments.alpha
    )
    rest = inner / moments.alpha**2
    return found + flint.fmpq(rest.numerator, rest.denominator)


def mean_settles(block: Block, alpha: Fraction) -> bool:
    """Whether the mean tends to a limit from every start: alpha H < 2 I."""
    rest = tuple(
        tuple(2 * (i == j) - alpha * x for j, x in enumerate(row))
        for i, row in enumerate(block.hessian)
    )
    return congruence(rest) is not None


def law_of(values: Mapping[str, Any]) -> str:
    """The law of the noise.

    Raises
    ------
    InputError
        There is none of that name.
    """
    law: str = values["law"]
    if law not in LAWS:
        raise InputError("law", repr(law), f"one of {', '.join(LAWS)} is needed")
    return law


def is_stable(moments: Moments) -> bool | None:
    """Whether second moments tend to their limit; None where floating point does not tell."""
    try:
        return moments.stable
    except TooClose:
        return None


def _mean_square_answer(found: Any) -> Answer:
    import flint

    if not isinstance(found, flint.fmpq):
        return single(enclosure(*ends(found)))
    exact = Fraction(int(found.p), int(found.q))
    data = {"kind": "rational", "value": text(exact)} if _short((exact,)) else None
    return single(enclosure(exact, exact), exact=data)


def _short(numbers: tuple[Fraction, ...]) -> bool:
    """Whether a reader can bear these rationals."""
    bits = sum(x.numerator.bit_length() + x.denominator.bit_length() for x in numbers)
    return bits <= LONGEST * 3
