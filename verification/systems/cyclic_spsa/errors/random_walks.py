"""Where the error of a block settles if its target makes independent Gaussian steps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from verification.answers import Answer, Input
from verification.exact.evaluate import Rows, add, identity, scaled
from verification.input_words import positive

from ..block_inputs import ALPHA, BETA, BLOCKS, HESSIAN, NOISE, READING, Block, block_of, covariance
from ..stability.moments import fmpq
from .second_moments import BITS, moments_of
from .settling import Settling
from .solutions import flint_trace
from .stationary import GROWS, NO_WORD, is_stable, mean_square_answer

STEPS = Input("W", "matrix", "covariance of a step of the target, one a sample", "m^2")
WALK = (*HESSIAN, NOISE, STEPS, BETA, READING, BLOCKS, ALPHA)


def random_walk_mse(values: Mapping[str, Any]) -> Answer:
    """Limit of E|theta_hat - theta|^2 right after an update, for a target that walks at random.

    Parameters
    ----------
    values : mapping
        The inputs of a block without drift; ``W``, the covariance of the target's move from sample
        to sample; ``alpha``, above 0. Noise and moves are Gaussian and independent.

    Returns
    -------
    Answer
        As `stationary.stationary_mse`.

    Raises
    ------
    InputError
        An input of the block, W or alpha is out of range.
    """
    import flint

    block, alpha = block_of({**values, "eta": (Fraction(0),)}), positive(values, "alpha")
    steps = covariance("W", values["W"], block.size)
    with flint.ctx.workprec(BITS):
        moments = moments_of(_as_noise(block, steps), alpha)
        stable = is_stable(moments)
        if stable is None:
            return Answer(verdict="UNDECIDED", notes=(NO_WORD,))
        if not stable:
            return Answer(value="inf", verdict="PROVED", notes=(GROWS,))
        side = _right_side(block, steps, Settling(moments.block), alpha)
        found = moments.solved(moments.given(side))
        later = 2 * block.blocks + 1 - block.instants
        return mean_square_answer(moments.trace(found) - later * flint_trace(fmpq(steps)))


def _as_noise(block: Block, steps: Rows) -> Block:
    """A block at rest with the N of this one: two instants see (2 Xi + W)/(4 beta^2)."""
    if block.instants == 1:
        return block
    return replace(block, noise=add(block.noise, scaled(Fraction(1, 2), steps)))


def _right_side(block: Block, steps: Rows, rest: Settling, alpha: Fraction) -> Any:
    """What moves and noise add to the second moment before an update, over alpha."""
    import flint

    step, walk = flint.fmpq(alpha.numerator, alpha.denominator), fmpq(steps)
    side = rest.by_noise * step + walk * (2 * block.blocks / step)
    if block.instants == 1:
        return side
    hessian = fmpq(block.hessian)
    pulled = hessian * walk
    beta = flint.fmpq(block.beta.numerator, block.beta.denominator)
    fourth = (flint_trace(pulled * pulled) + flint_trace(pulled) ** 2) / (16 * beta**2)
    half = flint.fmpq(1, 2)
    one = fmpq(identity(block.size))
    return side - (pulled + walk * hessian) * half + one * (fourth * step)
