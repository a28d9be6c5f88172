"""Solve pull(X) - alpha kick(X) = R for stable steps: exactly, or enclosed between multiples of Y.

Y is the solution for R = I. The update is stable if and only if Y exists and is positive definite,
because Y - L(Y) = alpha I and L keeps definite matrices definite; and where it is stable, -r I <= R
<= r I gives -r Y <= X <= r Y. A solution in floating point with the residual E is therefore wrong
by at most |E| Y, and Y itself lies below its approximation over 1 - |E|.
"""

from __future__ import annotations

from fractions import Fraction
from math import lcm

from ..block_inputs import Block
from ..stability.moments import noise_moments
from ..stability.stacked import places
from .direct_moments import DirectMoments
from .enclosed_moments import BallMoments

BITS = 256
EXACT_UP_TO, DIRECT_UP_TO = 12, 6
"""Coordinates up to which a full Hessian is solved by elimination in rationals, and in balls."""
LONGEST = 100_000
"""Bits of a common denominator, times the unknowns, up to which the former is quick."""

Moments = DirectMoments | BallMoments


def moments_of(block: Block, alpha: Fraction, exact: bool = True) -> Moments:
    """The solver for a block.

    Parameters
    ----------
    block : Block
    alpha : Fraction
        Above 0.
    exact : bool, optional
        In rationals where that is bearable; else in balls of the precision that is set, for which
        `BITS` is a good one.
    """
    exact = exact and (block.diagonal or (block.size <= EXACT_UP_TO and _short(block)))
    direct = exact or block.diagonal or block.size <= DIRECT_UP_TO
    return DirectMoments(block, alpha, exact) if direct else BallMoments(block, alpha)


def _short(block: Block) -> bool:
    """Whether elimination in rationals is bearable: its numbers grow with the denominators."""
    given = (*block.hessian, *noise_moments(block))
    bits = lcm(*(x.denominator for row in given for x in row)).bit_length()
    return bits * len(places(block.size)) <= LONGEST
