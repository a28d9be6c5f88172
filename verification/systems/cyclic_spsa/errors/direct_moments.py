"""Second moments by elimination: a diagonal Hessian of any size, or a small full one."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

from ..block_inputs import Block
from ..stability.moments import Operators, exact_operators, noise_moments
from ..stability.stacked import Stacked, places, symmetric
from .solutions import Solution, TooClose, ball_operators, definite, flint_trace


@dataclass(frozen=True)
class DirectMoments:
    """Solutions by elimination: a diagonal Hessian of any size, or a small full one.

    Parameters
    ----------
    block : Block
    alpha : Fraction
    exact : bool, optional
        In rationals, else in balls of the precision that is set.
    """

    block: Block
    alpha: Fraction
    exact: bool = True

    @cached_property
    def operators(self) -> Operators:
        """Pull and kick."""
        return exact_operators(self.block) if self.exact else ball_operators(self.block)

    @cached_property
    def step(self) -> Any:
        """Alpha in the arithmetic of the matrices."""
        import flint

        step = flint.fmpq(self.alpha.numerator, self.alpha.denominator)
        return step if self.exact else flint.arb(step)

    @cached_property
    def stable(self) -> bool:
        """Whether second moments tend to their limit.

        Raises
        ------
        TooClose
            The balls are too wide to tell.
        """
        if self.block.diagonal:
            return bool(_exact_share(self.block, self.alpha) < 1)
        try:
            return definite(self.unit.matrix)
        except ZeroDivisionError as error:
            if self.exact:  # a second moment is kept for ever
                return False
            raise TooClose from error

    @cached_property
    def unit(self) -> Solution:
        """The solution Y for the identity."""
        return self.solved(self.operators.one)

    def given(self, matrix: Any) -> Any:
        """A matrix of rationals in the arithmetic of the solutions."""
        import flint

        return matrix if self.exact else flint.arb_mat(matrix)

    def solved(self, side: Any, slack: Any = 0) -> Solution:
        """X for a symmetric right side; it has no slack.

        Raises
        ------
        ZeroDivisionError
            There is no solution, or more than one, or the balls are too wide to tell.
        """
        del slack
        return Solution(self._diagonal(side) if self.block.diagonal else self._full(side))

    def trace(self, found: Solution) -> Any:
        """The trace of X."""
        return flint_trace(found.matrix)

    def kicked(self, found: Solution) -> tuple[Any, Any]:
        """kick(X), and how far it may be off in multiples of the identity."""
        return self.operators.kick(found.matrix), 0

    @cached_property
    def _stacked(self) -> Any:
        parts = _stacks(self.block)
        return self.given(parts.pull) - self.given(parts.kick) * self.step

    def _full(self, side: Any) -> Any:
        size, kind = self.block.size, type(side)
        column = kind([[side[i, j]] for i, j in places(size)])
        return kind(symmetric(self._stacked.solve(column), size))

    def _diagonal(self, side: Any) -> Any:
        """Off the diagonal each entry stands alone; on it they share one unknown, alpha t.

        The terms with 2 alpha h_i^2 cancel on the diagonal: X_ii = (R_ii + alpha t)/(2 h_i) with t
        = tr(HXH) + tr(HXHN).
        """
        n, alpha, found = self.block.size, self.step, side * 0
        h = [self.operators.hessian[i, i] for i in range(n)]
        noise = self.operators.noise
        for i in range(n):
            for j in range(n):
                if i != j:
                    found[i, j] = side[i, j] / (h[i] + h[j] - 2 * alpha * h[i] * h[j])
        own = [h[i] * (1 + noise[i, i]) for i in range(n)]
        t = sum((own[i] * side[i, i] / 2 for i in range(n)), start=alpha * 0)
        for i in range(n):
            t += sum(h[i] * h[j] * noise[i, j] * found[i, j] for j in range(n) if i != j)
        t /= 1 - alpha * sum(own, start=alpha * 0) / 2
        for i in range(n):
            found[i, i] = (side[i, i] + alpha * t) / (2 * h[i])
        return found


@lru_cache(maxsize=4)
def _stacks(block: Block) -> Stacked:
    """The operators as matrices, kept for the next step size."""
    return Stacked(block)


def _exact_share(block: Block, alpha: Fraction) -> Fraction:
    """alpha/2 times the sum of h_i (1 + N_ii), which is 1 at the limit of a diagonal Hessian."""
    noise = noise_moments(block)
    return alpha / 2 * sum(row[i] * (1 + noise[i][i]) for i, row in enumerate(block.hessian))
