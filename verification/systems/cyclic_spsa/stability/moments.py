"""The derived second-moment operators with a block's matrices put in.

Matrices are `flint.fmpq_mat`, exact, or arrays of doubles; the forms of
`theory.systems.cyclic_spsa` are evaluated in whatever they are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from typing import Any

import numpy as np

from theory.algebra.noncommuting import Form
from theory.systems.cyclic_spsa.statements.stability import adjoint_pull_and_kick, pull_and_kick
from verification.exact.evaluate import Rows

from ..block_inputs import Block

PULL, KICK = pull_and_kick()
ADJOINT_PULL, ADJOINT_KICK = adjoint_pull_and_kick()


def noise_moments(block: Block) -> Rows:
    """N = E nu nu' = (2 Xi + eta eta')/(4 beta^2), zero with one measurement instant."""
    size, weight = range(block.size), Fraction(block.instants - 1) / (4 * block.beta**2)
    return tuple(
        tuple(weight * (2 * block.noise[i][j] + block.drift[i] * block.drift[j]) for j in size)
        for i in size
    )


@dataclass(frozen=True)
class Arithmetic:
    """What evaluating a form takes: products, traces, diagonal parts and rational multiples."""

    product: Callable[[Any, Any], Any]
    trace: Callable[[Any], Any]
    diagonal: Callable[[Any], Any]
    times: Callable[[Any, Fraction], Any]


def _flint_trace(a: Any) -> Any:
    return sum((a[i, i] for i in range(1, a.nrows())), start=a[0, 0])


def _flint_diagonal(a: Any) -> Any:
    n = a.nrows()
    return type(a)(n, n, [a[i, i] if i == j else 0 for i in range(n) for j in range(n)])


def _flint_times(a: Any, factor: Fraction) -> Any:
    import flint

    return a * flint.fmpq(factor.numerator, factor.denominator)


FLINT = Arithmetic(lambda a, b: a * b, _flint_trace, _flint_diagonal, _flint_times)
DOUBLES = Arithmetic(
    np.matmul, np.trace, lambda a: np.diag(np.diag(a)), lambda a, factor: a * float(factor)
)


def evaluated(form: Form, values: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
    """A form in matrices, traces ``trace(A*B)`` and diagonal parts ``diag(A)``.

    Parameters
    ----------
    form : Form
        No scalars but traces.
    values : mapping of str to matrix
        For every letter.
    arithmetic : Arithmetic
        Of these matrices.
    """

    def matrix(letter: str) -> Any:
        if letter.startswith("diag("):
            return arithmetic.diagonal(values[letter[5:-1]])
        return values[letter]

    total = None
    for (scalars, word), a in form.terms.items():
        part = arithmetic.times(reduce(arithmetic.product, map(matrix, word)), a)
        for name, _ in scalars:
            factors = (values[letter] for letter in name[6:-1].split("*"))
            part = part * arithmetic.trace(reduce(arithmetic.product, factors))
        total = part if total is None else total + part
    return total


@dataclass(frozen=True)
class Operators:
    """HP + PH and K(HPH), HZ + ZH and K*(HZH) for one block in one arithmetic.

    Parameters
    ----------
    hessian, noise, one : matrix
        H, N and the identity.
    arithmetic : Arithmetic
        Of these.
    """

    hessian: Any
    noise: Any
    one: Any
    arithmetic: Arithmetic

    def pull(self, p: Any) -> Any:
        """HP + PH."""
        return evaluated(PULL, {"H": self.hessian, "P": p}, self.arithmetic)

    def kick(self, p: Any) -> Any:
        """K(HPH)."""
        return self._kick(KICK, "Q", p)

    def adjoint_pull(self, z: Any) -> Any:
        """HZ + ZH."""
        return evaluated(ADJOINT_PULL, {"H": self.hessian, "Z": z}, self.arithmetic)

    def adjoint_kick(self, z: Any) -> Any:
        """K*(HZH)."""
        return self._kick(ADJOINT_KICK, "Y", z)

    def _kick(self, form: Form, letter: str, inner: Any) -> Any:
        product = self.arithmetic.product
        whole = product(product(self.hessian, inner), self.hessian)
        values = {letter: whole, "N": self.noise, "I": self.one}
        return evaluated(form, values, self.arithmetic)


def exact_operators(block: Block) -> Operators:
    """In `flint.fmpq_mat`."""
    size = range(block.size)
    one = tuple(tuple(Fraction(i == j) for j in size) for i in size)
    parts = (block.hessian, noise_moments(block), one)
    h, n, unit = (fmpq(rows) for rows in parts)
    return Operators(h, n, unit, FLINT)


def double_operators(block: Block) -> Operators:
    """In arrays of doubles."""
    parts = (block.hessian, noise_moments(block))
    h, n = (np.array([[float(x) for x in row] for row in rows]) for rows in parts)
    return Operators(h, n, np.eye(block.size), DOUBLES)


def fmpq(rows: Rows) -> Any:
    """Exact rows as `flint.fmpq_mat`."""
    import flint

    return flint.fmpq_mat([[flint.fmpq(x.numerator, x.denominator) for x in row] for row in rows])


def rows_of(matrix: Any) -> Rows:
    """The rows of a `flint.fmpq_mat`."""
    return tuple(tuple(Fraction(int(x.p), int(x.q)) for x in row) for row in matrix.tolist())
