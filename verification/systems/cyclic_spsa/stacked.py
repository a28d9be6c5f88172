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

from verification.exact.balls import half_exponent
from verification.exact.evaluate import Rows
from verification.exact.modes import exact, middle

from .block_inputs import Block
from .moments import exact_operators

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

        The shift follows the limit from below, by twice the last change of its estimate, and goes
        back down where it has passed it.
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
                shift = near if near > shift or shift > limit else shift
        return None

    def multiplier(self, step: Fraction, bits: int) -> tuple[Fraction, Matrix] | None:
        """The spectral radius r of one update and P with L(P) = rP, about, by inverse iteration.

        The shift follows r from above, by twice the last change of its estimate, and goes back up
        where it has fallen below.
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
                shift = near if near < shift or shift < radius else shift
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
