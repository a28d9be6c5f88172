"""Second moments for a large full Hessian: approximated in doubles, corrected and enclosed.

The kick of X is 2 HXH and a diagonal matrix of D numbers r. In the Hessian's eigenvectors X -> HX +
XH - 2 alpha HXH is a multiplication, and what is left is a linear system for r. Where that
multiplication is nearly by zero, which may be so at stable steps, a Krylov method takes its place.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from verification.enclosures import ball
from verification.exact.evaluate import trace
from verification.exact.spectra.modes import doubles, middle

from ..block_inputs import Block
from ..stability.moments import DOUBLES, Operators, noise_moments
from .solutions import Solution, TooClose, around, ball_operators, definite, flint_trace, norm

ROUNDS, TOLERANCE, GAIN = 16, 1e-13, 4
"""Corrections, accuracy of the Krylov method, and what a correction has to gain."""


@dataclass(frozen=True)
class BallMoments:
    """Solutions for a large full Hessian: Krylov's method in doubles, corrected and enclosed."""

    block: Block
    alpha: Fraction
    exact: ClassVar[bool] = False

    @cached_property
    def operators(self) -> Operators:
        """Pull and kick."""
        return ball_operators(self.block)

    @cached_property
    def step(self) -> Any:
        """Alpha as a ball."""
        return ball(self.alpha)

    @cached_property
    def stable(self) -> bool:
        """Whether second moments tend to their limit.

        Raises
        ------
        TooClose
            Floating point does not tell.
        """
        _, miss = self._unit
        if not miss < 1:
            raise TooClose
        return definite(self._unit[0])

    @cached_property
    def _unit(self) -> tuple[Any, Any]:
        return self._approximate(self.operators.one)

    @cached_property
    def unit(self) -> Solution:
        """The solution Y for the identity."""
        matrix, miss = self._unit
        return Solution(matrix, miss)

    @cached_property
    def above(self) -> Any:
        """A matrix that is at least Y."""
        matrix, miss = self._unit
        return matrix * (1 / (1 - miss))

    def given(self, matrix: Any) -> Any:
        """A matrix of rationals in the arithmetic of the solutions."""
        import flint

        return flint.arb_mat(matrix)

    def solved(self, side: Any, slack: Any = 0) -> Solution:
        """X for a symmetric right side, known up to `slack` times the identity."""
        matrix, miss = self._approximate(side)
        return Solution(matrix, (miss + slack).upper())

    def trace(self, found: Solution) -> Any:
        """The trace of X."""
        return flint_trace(found.matrix) + around(found.radius * flint_trace(self.above))

    def kicked(self, found: Solution) -> tuple[Any, Any]:
        """kick(X), and how far it may be off in multiples of the identity."""
        slack = found.radius * norm(self.operators.kick(self.above))
        return self.operators.kick(found.matrix), slack

    def _approximate(self, side: Any) -> tuple[Any, Any]:
        """A symmetric matrix close to the solution, and the norm of its residual."""
        import flint

        near, rest, miss = 0 * side, side, norm(side)
        aim = miss * flint.arb(2) ** -(flint.ctx.prec // 2)
        ways = [self._doubles.direct, self._doubles.krylov]
        for _ in range(ROUNDS):
            better = self._corrected(near, middle(rest), ways[0])
            left = None if better is None else self._residual(side, better)
            gained = left is not None and norm(left) * GAIN < miss
            if gained:
                near, rest, miss = better, left, norm(left)
                if miss <= aim:
                    break
            elif len(ways) > 1:
                ways.pop(0)
            else:
                break
        return near, miss

    def _corrected(self, near: Any, rest: Any, way: Callable[[Any], Any]) -> Any | None:
        """One correction; None where doubles overflow."""
        import flint

        size = max(abs(x) for x in rest.entries()).mid()
        if size == 0:
            return near
        part = way(doubles(rest * (1 / size)))
        if not np.isfinite(part).all():
            return None
        exact = flint.arb_mat(((part + part.T) / 2).tolist())
        return middle(near + exact * (size / ball(self._doubles.unit)))

    def _residual(self, side: Any, near: Any) -> Any:
        return side - self.operators.pull(near) + self.operators.kick(near) * self.step

    @cached_property
    def _doubles(self) -> InDoubles:
        try:
            return InDoubles(self.block, self.alpha)
        except OverflowError as error:  # a number beyond the largest double
            raise TooClose from error


class InDoubles:
    """About the solution, in doubles; the Hessian is divided by `unit`, the solution multiplied."""

    def __init__(self, block: Block, alpha: Fraction) -> None:
        mean = trace(block.hessian) / block.size
        self.unit = Fraction(2) ** (mean.numerator.bit_length() - mean.denominator.bit_length())
        self.alpha = float(alpha * self.unit)
        hessian = np.array([[float(x / self.unit) for x in row] for row in block.hessian])
        noise = np.array([[float(x) for x in row] for row in noise_moments(block)])
        self.operators = Operators(hessian, noise, np.eye(block.size), DOUBLES)
        self.values, self.basis = np.linalg.eigh(hessian)

    def direct(self, side: Any) -> Any:
        """By the system for the D numbers."""
        start = self._unturned(side)
        rest = np.linalg.solve(self._coupling, np.diag(self._rest(start)))
        return start + self.alpha * self._unturned(np.diag(rest))

    def krylov(self, side: Any) -> Any:
        """By GMRES, only the pull undone."""
        from scipy.sparse.linalg import LinearOperator, gmres

        n = len(side)

        def image(flat: Any) -> Any:
            x = flat.reshape(n, n)
            return (x - self.alpha * self._unturned(self.operators.kick(x), twice=0)).ravel()

        operator = LinearOperator((n * n, n * n), matvec=image, dtype=float)
        start = self._unturned(side, twice=0).ravel()
        found, _ = gmres(operator, start, rtol=TOLERANCE, restart=min(n * n, 200), maxiter=3)
        return found.reshape(n, n)

    def _rest(self, x: Any) -> Any:
        """The diagonal matrix in kick(x)."""
        h = self.operators.hessian
        return self.operators.kick(x) - 2 * h @ x @ h

    def _unturned(self, side: Any, twice: int = 2) -> Any:
        """x with Hx + xH - twice alpha HxH = side."""
        own = self.values
        factors = own[:, None] + own[None, :] - twice * self.alpha * np.outer(own, own)
        least = np.finfo(float).eps * np.abs(factors).max()
        factors = np.where(np.abs(factors) < least, least, factors)
        turned = self.basis.T @ side @ self.basis / factors
        return self.basis @ turned @ self.basis.T

    @cached_property
    def _coupling(self) -> Any:
        """What the D numbers of the solution say about themselves."""
        one = self.operators.one
        columns = [np.diag(self._rest(self._unturned(np.outer(e, e)))) for e in one]
        return one - self.alpha * np.array(columns).T
