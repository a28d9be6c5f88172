"""Leading second moments of a large block by Krylov iteration, in doubles or in more bits.

The limit of the step is 1/mu with mu the spectral radius of T = (pull)^-1 (kick), which keeps
positive semidefinite matrices so. In the basis of the Hessian's eigenvectors, dividing by the sums
of its eigenvalues undoes the pull. What is found is a candidate: nothing here is trusted.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verification.exact.spectra.modes import exact, middle

from ..block_inputs import Block
from .moments import Operators, double_operators, exact_operators
from .stacked import Matrix

Floats = NDArray[np.float64]
Step = Callable[[Any], Any]
DIRECTIONS, RESTARTS = 24, 10
"""Of the Krylov iteration in many bits."""


@dataclass(frozen=True)
class Leading:
    """About where stability ends.

    Parameters
    ----------
    limit : Fraction
    kept, decaying : Matrix
        P with limit K(HPH) = HP + PH, and Z with limit K*(HZH) = HZ + ZH.
    """

    limit: Fraction
    kept: Matrix
    decaying: Matrix


def leading(block: Block, bits: int | None = None) -> Leading | None:
    """Where stability ends, in doubles or in so many bits; None where that does not reach.

    Parameters
    ----------
    block : Block
    bits : int or None
    """
    found = _in_doubles(block) if bits is None else _in_bits(block, bits)
    if found is None or not found[0][0] > 0:
        return None
    (radius, p), (_, z) = found
    return Leading(1 / radius, p, z)


def leading_multiplier(
    block: Block, step: Fraction, bits: int | None = None
) -> tuple[Fraction, Matrix] | None:
    """About the spectral radius r of one update, and P with L(P) = rP."""
    if bits is None:
        doubles = double_operators(block)
        with np.errstate(all="ignore"):
            return _perron(partial(_update, doubles, float(step)), block.size)
    import flint

    with flint.ctx.workprec(bits):
        alpha = flint.arb(flint.fmpq(step.numerator, step.denominator))
        return _krylov(partial(_update, _balls(block), alpha), block.size, bits)


def _update(operators: Operators, alpha: Any, p: Any) -> Any:
    return p - operators.pull(p) * alpha + operators.kick(p) * alpha**2


Pair = tuple[Fraction, Matrix]


def _in_doubles(block: Block) -> tuple[Pair, Pair] | None:
    operators = double_operators(block)
    with np.errstate(all="ignore"):
        values, vectors = np.linalg.eigh(operators.hessian)
        if not values[0] > 0:
            return None
        sums = values[:, None] + values[None, :]

        def undone(kick: Step) -> Step:
            return lambda p: vectors @ ((vectors.T @ kick(p) @ vectors) / sums) @ vectors.T

        first = _perron(undone(operators.kick), block.size)
        second = _perron(undone(operators.adjoint_kick), block.size)
    return None if first is None or second is None else (first, second)


def _perron(step: Callable[[Floats], Floats], size: int) -> Pair | None:
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
    radius = float(values[0].real)
    if not (np.isfinite(matrix).all() and math.isfinite(radius)):
        return None
    rows = ((matrix + matrix.T) / 2).tolist()
    return Fraction(radius), [[Fraction(x) for x in row] for row in rows]


def _balls(block: Block) -> Operators:
    """The operators in `flint.arb_mat` at the current precision."""
    import flint

    found = exact_operators(block)
    parts = (middle(flint.arb_mat(m)) for m in (found.hessian, found.noise, found.one))
    return Operators(*parts, found.arithmetic)  # type: ignore[call-arg]


def _in_bits(block: Block, bits: int) -> tuple[Pair, Pair] | None:
    import flint

    with flint.ctx.workprec(bits):
        operators = _balls(block)
        values, right = flint.acb_mat(operators.hessian).eig(right=True, algorithm="approx")
        basis = flint.arb_mat([[x.real.mid() for x in row] for row in right.tolist()])
        try:
            back = middle(basis.inv())
        except ZeroDivisionError:
            return None
        sums = [(a + b).real.mid() for a in values for b in values]
        if not all(x > 0 for x in sums):
            return None

        def undone(kick: Step) -> Step:
            def step(p: Any) -> Any:
                inner = back * middle(kick(p)) * back.transpose()
                shares = [(x / s).mid() for x, s in zip(inner.entries(), sums, strict=True)]
                found = basis * flint.arb_mat(block.size, block.size, shares) * basis.transpose()
                return middle(found)

            return step

        first = _krylov(undone(operators.kick), block.size, bits)
        second = _krylov(undone(operators.adjoint_kick), block.size, bits)
    return None if first is None or second is None else (first, second)


def _krylov(step: Step, size: int, bits: int) -> Pair | None:
    """Spectral radius and eigenmatrix by restarted Arnoldi iteration from the identity."""
    import flint

    unit = [int(i == j) for i in range(size) for j in range(size)]
    start, radius = flint.arb_mat(1, size**2, unit), flint.arb(0)
    for _ in range(RESTARTS):
        basis, inner, left = _arnoldi(step, start, size)
        values, right = flint.acb_mat(inner).eig(right=True, algorithm="approx")
        k = max(range(len(values)), key=lambda i: values[i].real.mid())
        share = _unit(flint.arb_mat([[right[i, k].real.mid() for i in range(inner.nrows())]]))
        start, radius = middle(share * basis), values[k].real.mid()
        if abs(left * share.entries()[-1]) <= abs(radius) * flint.arb(2) ** (-bits // 3):
            break
    rows = [[exact(start[0, i * size + j]) for j in range(size)] for i in range(size)]
    sign = 1 if sum(row[i] for i, row in enumerate(rows)) > 0 else -1
    even = [[sign * (rows[i][j] + rows[j][i]) / 2 for j in range(size)] for i in range(size)]
    return exact(radius), even


def _arnoldi(step: Step, start: Any, size: int) -> tuple[Any, Any, Any]:
    """Orthonormal directions as rows, the operator on them, and the size of what is left."""
    import flint

    rows, columns = [_unit(start)], list[list[Any]]()
    for _ in range(DIRECTIONS):
        image = step(flint.arb_mat(size, size, rows[-1].entries()))
        rest = flint.arb_mat(1, size**2, image.entries())
        basis = flint.arb_mat([row.entries() for row in rows])
        column = [flint.arb(0)] * len(rows)
        for _ in range(2):  # twice is enough
            share = middle(basis * rest.transpose())
            rest = middle(rest - share.transpose() * basis)
            column = [(a + b).mid() for a, b in zip(column, share.entries(), strict=True)]
        left = _length(rest)
        columns.append([*column, left])
        if left <= max(map(abs, column)) * flint.arb(2) ** (8 - flint.ctx.prec):
            break
        rows.append(_unit(rest))
    m = len(columns)
    inner = [[columns[j][i] if i <= j + 1 else flint.arb(0) for j in range(m)] for i in range(m)]
    return flint.arb_mat([row.entries() for row in rows[:m]]), flint.arb_mat(inner), columns[-1][-1]


def _length(row: Any) -> Any:
    return (row * row.transpose())[0, 0].sqrt().mid()


def _unit(row: Any) -> Any:
    return middle(row * (1 / _length(row)))
