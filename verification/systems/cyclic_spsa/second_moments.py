"""Solve pull(X) - alpha kick(X) = R for stable steps: exactly, or enclosed between multiples of Y.

Y is the solution for R = I. The update is stable if and only if Y exists and is positive definite,
because Y - L(Y) = alpha I and L keeps definite matrices definite; and where it is stable, -r I <= R
<= r I gives -r Y <= X <= r Y. A solution in floating point with the residual E is therefore wrong
by at most |E| Y, and Y itself lies below its approximation over 1 - |E|.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from verification.enclosures import ball
from verification.exact.balls import ball_ldl
from verification.exact.modes import doubles, middle

from .block_inputs import Block
from .moments import FLINT, Operators, double_operators, exact_operators, noise_moments
from .stacked import Stacked, places, symmetric

DIRECT_UP_TO = 12
"""Coordinates up to which a full Hessian is solved by elimination."""
BITS, ROUNDS, TOLERANCE = 256, 12, 1e-13
ENOUGH = 1e-36
"""Residual relative to the right side at which corrections stop."""


class TooClose(Exception):
    """Floating point does not tell on which side of the limit the step lies."""


@dataclass(frozen=True)
class Solution:
    """X lies between matrix - radius Y and matrix + radius Y.

    Parameters
    ----------
    matrix : flint.fmpq_mat or flint.arb_mat
    radius : flint.arb or int
        Zero where the matrix is exact.
    """

    matrix: Any
    radius: Any = 0


def trace(matrix: Any) -> Any:
    """Sum of the diagonal of a flint matrix."""
    return sum((matrix[i, i] for i in range(1, matrix.nrows())), start=matrix[0, 0])


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
            return _definite(self.unit.matrix)
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
        return trace(found.matrix)

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


def ball_operators(block: Block) -> Operators:
    """Pull and kick in `flint.arb_mat` of the precision that is set."""
    import flint

    exact = exact_operators(block)
    h, n, one = (flint.arb_mat(part) for part in (exact.hessian, exact.noise, exact.one))
    return Operators(h, n, one, FLINT)


@dataclass(frozen=True)
class BallMoments:
    """Solutions for a large full Hessian: Krylov's method in doubles, corrected and enclosed."""

    block: Block
    alpha: Fraction

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
        return _definite(self._unit[0])

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
        return trace(found.matrix) + _around(found.radius * trace(self.above))

    def kicked(self, found: Solution) -> tuple[Any, Any]:
        """kick(X), and how far it may be off in multiples of the identity."""
        slack = found.radius * _norm(self.operators.kick(self.above))
        return self.operators.kick(found.matrix), slack

    def _approximate(self, side: Any) -> tuple[Any, Any]:
        """A symmetric matrix close to the solution, and the norm of its residual."""
        import flint

        near, aim = 0 * side, _norm(side) * ENOUGH
        miss = _norm(side)
        for _ in range(ROUNDS):
            rest = middle(side - self.operators.pull(near) + self.operators.kick(near) * self.step)
            size = max(abs(x) for x in rest.entries()).mid()
            if size == 0:
                break
            part = self._doubles.solved(doubles(rest * (1 / size)))
            better = middle(near + flint.arb_mat(((part + part.T) / 2).tolist()) * size)
            left = _norm(
                side - self.operators.pull(better) + self.operators.kick(better) * self.step
            )
            if not left < miss:
                break
            near, miss = better, left
            if miss <= aim:
                break
        return near, miss

    @cached_property
    def _doubles(self) -> Krylov:
        return Krylov(self.block, self.alpha)


class Krylov:
    """Approximate solutions in doubles; the pull is undone in the Hessian's eigenvectors."""

    def __init__(self, block: Block, alpha: Fraction) -> None:
        self.operators, self.alpha = double_operators(block), float(alpha)
        values, self.basis = np.linalg.eigh(self.operators.hessian)
        self.sums = values[:, None] + values[None, :]

    def solved(self, side: Any) -> Any:
        """About the solution for a right side of doubles."""
        from scipy.sparse.linalg import LinearOperator, gmres

        n = len(side)

        def image(flat: Any) -> Any:
            x = flat.reshape(n, n)
            return (x - self.alpha * self._pulled(self.operators.kick(x))).ravel()

        operator = LinearOperator((n * n, n * n), matvec=image, dtype=float)
        start = self._pulled(side).ravel()
        found, _ = gmres(operator, start, rtol=TOLERANCE, restart=min(n * n, 200), maxiter=3)
        return found.reshape(n, n)

    def _pulled(self, side: Any) -> Any:
        turned = self.basis.T @ side @ self.basis / self.sums
        return self.basis @ turned @ self.basis.T


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
    direct = block.diagonal or block.size <= DIRECT_UP_TO
    return DirectMoments(block, alpha, exact) if direct else BallMoments(block, alpha)


def _definite(matrix: Any) -> bool:
    """Whether a symmetric matrix, exact or in balls without radii, is positive definite."""
    import flint

    n = matrix.nrows()
    if isinstance(matrix, flint.fmpq_mat):
        return all(minor > 0 for minor in _pivots(matrix))
    lower: Sequence[Sequence[Any]] = matrix.tolist()
    _, pivots = ball_ldl([list(row) for row in lower])
    if len(pivots) == n and pivots[-1] > 0:
        return True
    if pivots[-1] < 0:
        return False
    raise TooClose


def _pivots(matrix: Any) -> list[Any]:
    """Pivots of elimination without exchanges, up to the first that is not positive."""
    rows, found = [list(row) for row in matrix.tolist()], []
    for k in range(len(rows)):
        found.append(rows[k][k])
        if not rows[k][k] > 0:
            break
        for i in range(k + 1, len(rows)):
            factor = rows[i][k] / rows[k][k]
            if factor != 0:
                for j in range(k, len(rows)):
                    rows[i][j] -= factor * rows[k][j]
    return found


def _norm(matrix: Any) -> Any:
    """An upper bound on the Frobenius norm."""
    import flint

    total = sum((abs(x).upper() ** 2 for x in matrix.entries()), start=flint.arb(0))
    return total.sqrt().upper()


def _around(radius: Any) -> Any:
    """The ball around 0 with this radius."""
    import flint

    return flint.arb(0, radius.upper())
