"""Candidates for the matrices that show where mean-square stability ends; nothing here is trusted.

The limit is 1/mu with mu the spectral radius of T = (pull)^-1 (kick), which keeps positive
semidefinite matrices so. Small blocks solve for the entries of the symmetric matrix in as many bits
as it takes; large ones iterate in doubles, in the basis of the Hessian's eigenvectors, where
dividing by the sums of eigenvalues undoes the pull.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verification.exact.balls import half_exponent
from verification.exact.evaluate import Rows
from verification.exact.modes import exact, middle

from .block_inputs import Block
from .moments import double_operators, exact_operators

Floats = NDArray[np.float64]
Matrix = list[list[Fraction]]
STEPS = 60
"""Of the inverse iteration; it converges faster than linearly."""


def places(size: int) -> list[tuple[int, int]]:
    """Entries on and below the diagonal."""
    return [(i, j) for i in range(size) for j in range(i + 1)]


def _stacked(operator: Callable[[Any], Any], size: int) -> Any:
    """The matrix of an operator on symmetric matrices, entries on and below the diagonal."""
    import flint

    spots, columns = places(size), []
    for i, j in spots:
        unit = flint.fmpq_mat(size, size)
        unit[i, j] = unit[j, i] = flint.fmpq(1)
        image = operator(unit)
        columns.append([image[a, b] for a, b in spots])
    return flint.fmpq_mat(columns).transpose()


def symmetric(column: Any, size: int) -> list[list[Any]]:
    """The matrix with these entries on and below the diagonal."""
    entry = {spot: column[k, 0] for k, spot in enumerate(places(size))}
    return [[entry[max(i, j), min(i, j)] for j in range(size)] for i in range(size)]


@dataclass(frozen=True)
class Stacked:
    """The operators of a block as matrices on the D(D + 1)/2 entries of a symmetric matrix.

    Parameters
    ----------
    block : Block
    """

    block: Block

    @cached_property
    def pull(self) -> Any:
        """HP + PH, a `flint.fmpq_mat`."""
        return _stacked(exact_operators(self.block).pull, self.block.size)

    @cached_property
    def kick(self) -> Any:
        """K(HPH)."""
        return _stacked(exact_operators(self.block).kick, self.block.size)

    @cached_property
    def adjoint_kick(self) -> Any:
        """K*(HZH); the pull is its own adjoint."""
        return _stacked(exact_operators(self.block).adjoint_kick, self.block.size)

    def decaying(self, step: Fraction, bits: int) -> Matrix | None:
        """Z with HZ + ZH - step K*(HZH) = I, about; None where balls of these bits do not reach."""
        import flint

        rest = self.pull - self.adjoint_kick * flint.fmpq(step.numerator, step.denominator)
        side = flint.fmpq_mat([[flint.fmpq(int(i == j))] for i, j in places(self.block.size)])
        with flint.ctx.workprec(bits):
            found = _solved(flint.arb_mat(rest), flint.arb_mat(side))
        return None if found is None else _fractions(symmetric(found, self.block.size))

    def kept(self, bits: int) -> tuple[Fraction, Matrix] | None:
        """The limit and P with limit K(HPH) = HP + PH, about, by shifted inverse iteration.

        The shift follows the limit from below, by twice the last change of its estimate.
        """
        import flint

        spots = places(self.block.size)
        own = [k for k, (i, j) in enumerate(spots) if i == j]
        with flint.ctx.workprec(bits):
            pull, kick = flint.arb_mat(self.pull), flint.arb_mat(self.kick)
            vector = flint.arb_mat([[flint.arb(int(i == j))] for i, j in spots])
            shift, limit = flint.arb(0), flint.arb(0)
            for _ in range(STEPS):
                found = _solved(pull - kick * shift, kick * vector)
                if found is None:
                    return None
                trace = sum((found[k, 0] for k in own), start=flint.arb(0)).mid()
                before, limit = limit, (shift + len(own) / trace).mid()
                vector = middle(found * (len(own) / trace).mid())
                change = abs(limit - before)
                if change <= limit * flint.arb(2) ** (16 - bits // 2):
                    return exact(limit), _fractions(symmetric(vector, self.block.size))
                near = (limit - 2 * change).mid()
                shift = near if near > shift else shift
        return None

    def multiplier(self, step: Fraction, bits: int) -> tuple[Fraction, Matrix] | None:
        """The spectral radius r of one update and P with L(P) = rP, about, by inverse iteration.

        The shift follows r from above, by twice the last change of its estimate.
        """
        import flint

        spots = places(self.block.size)
        own = [k for k, (i, j) in enumerate(spots) if i == j]
        with flint.ctx.workprec(bits):
            update = flint.arb_mat(self.update(step))
            one = flint.arb_mat([[int(i == j) for j in spots] for i in spots])
            vector = flint.arb_mat([[flint.arb(int(i == j))] for i, j in spots])
            shift = max(sum(map(abs, row), start=flint.arb(0)).mid() for row in update.tolist())
            radius = flint.arb(0)
            for _ in range(STEPS):
                found = _solved(one * shift - update, vector)
                if found is None:
                    return None
                trace = sum((found[k, 0] for k in own), start=flint.arb(0)).mid()
                before, radius = radius, (shift - len(own) / trace).mid()
                vector = middle(found * (len(own) / trace).mid())
                change = abs(radius - before)
                if change <= abs(radius) * flint.arb(2) ** (16 - bits // 2):
                    return exact(radius), _fractions(symmetric(vector, self.block.size))
                near = (radius + 2 * change).mid()
                shift = near if near < shift else shift
        return None

    def update(self, step: Fraction) -> Any:
        """L, a `flint.fmpq_mat`."""
        import flint

        alpha, n = flint.fmpq(step.numerator, step.denominator), self.pull.nrows()
        one = flint.fmpq_mat([[int(i == j) for j in range(n)] for i in range(n)])
        return one - self.pull * alpha + self.kick * alpha**2


def _solved(a: Any, b: Any) -> Any | None:
    """A^-1 b without radii; None where A is singular for these bits."""
    try:
        return middle(a.solve(b, algorithm="approx"))
    except ZeroDivisionError:
        return None


def _fractions(matrix: list[list[Any]]) -> Matrix:
    return [[exact(x) for x in row] for row in matrix]


def leading(block: Block) -> tuple[Fraction, Matrix, Matrix] | None:
    """The limit, P and Z, in doubles; None where doubles do not reach.

    Parameters
    ----------
    block : Block

    Returns
    -------
    limit : Fraction
    P, Z : list of list of Fraction
        limit K(HPH) = HP + PH and limit K*(HZH) = HZ + ZH, about.
    """
    operators = double_operators(block)
    with np.errstate(all="ignore"):
        values, vectors = np.linalg.eigh(operators.hessian)
        if not values[0] > 0:
            return None
        sums = values[:, None] + values[None, :]

        def undone(kick: Callable[[Any], Any]) -> Callable[[Floats], Floats]:
            return lambda p: vectors @ ((vectors.T @ kick(p) @ vectors) / sums) @ vectors.T

        first = _perron(undone(operators.kick), block.size)
        second = _perron(undone(operators.adjoint_kick), block.size)
    if first is None or second is None or not 0 < first[0] < math.inf:
        return None
    return Fraction(1 / first[0]), _exact(first[1]), _exact(second[1])


def leading_multiplier(block: Block, step: Fraction) -> tuple[Fraction, Matrix] | None:
    """The spectral radius r of one update and P with L(P) = rP, in doubles."""
    operators, alpha = double_operators(block), float(step)
    with np.errstate(all="ignore"):
        found = _perron(
            lambda p: p - alpha * operators.pull(p) + alpha**2 * operators.kick(p), block.size
        )
    if found is None or not 0 < found[0] < math.inf:
        return None
    return Fraction(found[0]), _exact(found[1])


def _perron(step: Callable[[Floats], Floats], size: int) -> tuple[float, Floats] | None:
    """Spectral radius and eigenmatrix of an operator that keeps semidefinite matrices so."""
    from scipy.sparse.linalg import ArpackError, LinearOperator, eigs

    def flat(x: Floats) -> Floats:
        return step(x.reshape(size, size)).ravel()

    operator = LinearOperator((size**2, size**2), matvec=flat, dtype=float)
    try:
        values, found = eigs(operator, k=1, which="LR", v0=np.eye(size).ravel(), tol=0)
    except ArpackError:
        return None
    matrix = found[:, 0].real.reshape(size, size)
    matrix = (matrix + matrix.T) / (2 * np.trace(matrix))
    for _ in range(2):  # what rounding left of other eigenmatrices
        matrix = step(matrix)
        matrix /= np.trace(matrix)
    usable = bool(np.isfinite(matrix).all())
    return (float(values[0].real), (matrix + matrix.T) / 2) if usable else None


def _exact(matrix: Floats) -> Matrix:
    return [[Fraction(x) for x in row] for row in matrix.tolist()]


def whole(matrix: Matrix, bits: int) -> Rows:
    """A positive multiple in integers, each entry to about `bits` bits of its diagonal entries.

    Parameters
    ----------
    matrix : list of list of Fraction
        Symmetric with a positive diagonal.
    bits : int

    Returns
    -------
    Rows
    """
    halves = [half_exponent(row[i]) for i, row in enumerate(matrix)]
    least = 2 * min(halves)
    return tuple(
        tuple(
            Fraction(round(x / Fraction(2) ** (a + b - bits)) << (a + b - least))
            for x, b in zip(row, halves, strict=True)
        )
        for row, a in zip(matrix, halves, strict=True)
    )
