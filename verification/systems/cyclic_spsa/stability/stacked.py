"""Second moments of a small block as solutions of linear equations in as many bits as it takes.

The unknowns are the entries on and below the diagonal of a symmetric matrix. What is found is a
candidate: nothing here is trusted.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from verification.exact.balls import half_exponent
from verification.exact.evaluate import Rows
from verification.exact.spectra.modes import exact, middle

from ..block_inputs import Block
from .moments import exact_operators

Matrix = list[list[Fraction]]
STEPS = 100
"""Of the inverse iteration; it converges faster than linearly."""
NOISE = 1e-9
"""Room for the rounding of doubles in eigenvalues of matrices with ones on the diagonal."""


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
        """The limit and P with limit K(HPH) = HP + PH, about, by shifts from below."""
        import flint

        with flint.ctx.workprec(bits):
            pull, kick = flint.arb_mat(self.pull), flint.arb_mat(self.kick)

            def solved(shift: Any, vector: Any) -> Any | None:
                return _solved(pull - kick * shift, kick * vector)

            return self._leading(solved, flint.arb(0), 1, bits)

    def multiplier(self, step: Fraction, bits: int) -> tuple[Fraction, Matrix] | None:
        """The spectral radius r of one update and P with L(P) = rP, about, by shifts from above."""
        import flint

        with flint.ctx.workprec(bits):
            update = flint.arb_mat(self.update(step))
            n = update.nrows()
            one = flint.arb_mat([[int(i == j) for j in range(n)] for i in range(n)])
            above = max(sum(map(abs, row), start=flint.arb(0)).mid() for row in update.tolist())

            def solved(shift: Any, vector: Any) -> Any | None:
                return _solved(one * shift - update, vector)

            return self._leading(solved, above, -1, bits)

    def _leading(
        self, solved: Callable[[Any, Any], Any], safe: Any, sign: int, bits: int
    ) -> tuple[Fraction, Matrix] | None:
        """A leading value and its matrix by inverse iteration.

        The shift follows the value by twice the last change of its estimate. On the safe side, and
        only there, what is solved for a positive definite matrix is positive definite, because
        the operators are positive: where it is not, the shift goes back half of the way.
        """
        import flint

        spots = places(self.block.size)
        own = [k for k, (i, j) in enumerate(spots) if i == j]
        vector = flint.arb_mat([[flint.arb(int(i == j))] for i, j in spots])
        shift, value = safe, flint.arb(0)
        for _ in range(STEPS):
            found = solved(shift, vector)
            if found is None or not _semidefinite(symmetric(found, self.block.size)):
                shift = ((shift + safe) / 2).mid()
                continue
            safe, trace = shift, sum((found[k, 0] for k in own), start=flint.arb(0)).mid()
            before, value = value, (shift + sign * len(own) / trace).mid()
            vector = middle(found * (len(own) / trace).mid())
            change = abs(value - before)
            if change <= abs(value) * flint.arb(2) ** (16 - bits // 2):
                return exact(value), _fractions(symmetric(vector, self.block.size))
            near = (value - sign * 2 * change).mid()
            shift = near if sign * near > sign * shift else shift
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


def _semidefinite(matrix: list[list[Any]]) -> bool:
    """Whether a symmetric matrix is positive semidefinite, as far as doubles can tell."""
    sizes = [row[i].mid() for i, row in enumerate(matrix)]
    if min(sizes) <= 0:
        return False
    roots = [size.sqrt().mid() for size in sizes]
    even = [
        [float((x / (a * b)).mid()) for x, b in zip(row, roots, strict=True)]
        for row, a in zip(matrix, roots, strict=True)
    ]
    return bool(np.linalg.eigvalsh(even)[0] >= -NOISE)


def _fractions(matrix: list[list[Any]]) -> Matrix:
    return [[exact(x) for x in row] for row in matrix]


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
