"""Exact matrices that show, at a given step, that second moments decay, grow or are kept."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from verification.exact.definite import congruence
from verification.exact.evaluate import Rows
from verification.exact.roots import Algebraic, root_between

from ..block_inputs import Block
from .moments import exact_operators, fmpq, noise_moments, rows_of
from .stacked import Matrix, Stacked, symmetric, whole

ROUNDINGS = (24, 32, 40, 48, 56, 64, 80, 96, 128, 192, 256, 384, 512, 768, 1024)
"""Bits to which candidates are rounded, the first that do are kept: files stay short."""

Item = dict[str, Any]


def decays(block: Block, z: Rows, step: Fraction) -> bool:
    """Whether HZ + ZH - step K*(HZH) is positive definite."""
    operators, matrix = exact_operators(block), fmpq(z)
    rest = operators.adjoint_pull(matrix) - operators.adjoint_kick(matrix) * flint_of(step)
    return congruence(rows_of(rest)) is not None


def grows(block: Block, p: Rows, step: Fraction) -> bool:
    """Whether P and step K(HPH) - (HP + PH) are positive definite."""
    operators, matrix = exact_operators(block), fmpq(p)
    rest = operators.kick(matrix) * flint_of(step) - operators.pull(matrix)
    return congruence(p) is not None and congruence(rows_of(rest)) is not None


def multiplies(block: Block, p: Rows, step: Fraction, low: Fraction, high: Fraction) -> bool:
    """Whether P, L(P) - low P and high P - L(P) are positive definite.

    Then the spectral radius of L, which keeps semidefinite matrices so, is between low and high.
    """
    operators, matrix = exact_operators(block), fmpq(p)
    alpha = flint_of(step)
    image = matrix - operators.pull(matrix) * alpha + operators.kick(matrix) * alpha**2
    forms = (matrix, image - matrix * flint_of(low), matrix * flint_of(high) - image)
    return all(congruence(rows_of(form)) is not None for form in forms)


def flint_of(x: Fraction) -> Any:
    """A rational as a `flint.fmpq`."""
    import flint

    return flint.fmpq(x.numerator, x.denominator)


def rounded_decaying(block: Block, z: Matrix, step: Fraction, least: int = 0) -> Rows | None:
    """The shortest rounding of Z that shows decay at the step."""
    found = (whole(z, bits) for bits in ROUNDINGS if bits >= least and _positive(z))
    return next((rows for rows in found if decays(block, rows, step)), None)


def rounded_growing(block: Block, p: Matrix, step: Fraction, least: int = 0) -> Rows | None:
    """The shortest rounding of P that shows growth at the step."""
    found = (whole(p, bits) for bits in ROUNDINGS if bits >= least and _positive(p))
    return next((rows for rows in found if grows(block, rows, step)), None)


def _positive(matrix: Matrix) -> bool:
    return all(row[i] > 0 for i, row in enumerate(matrix))


def diagonal_limit(block: Block) -> Fraction:
    """2 / sum of h_i (1 + N_ii), the limit for a diagonal Hessian."""
    n = noise_moments(block)
    kicks = (block.hessian[i][i] * (1 + n[i][i]) for i in range(block.size))
    return 2 / sum(kicks, start=Fraction(0))


def diagonal_decaying(block: Block, step: Fraction) -> Matrix:
    """Z with HZ + ZH - step K*(HZH) = I, for a diagonal Hessian and a step below its limit.

    With t = tr HZH, the entry (i, j) of the equation holds Z_ij and t only, and the diagonal ones
    give t (1 - step/limit) = tr H / 2.
    """
    h, n = [block.hessian[i][i] for i in range(block.size)], noise_moments(block)
    t = sum(h, start=Fraction(0)) / 2 / (1 - step / diagonal_limit(block))

    def entry(i: int, j: int) -> Fraction:
        if i == j:
            return (step * t * (1 + n[i][i]) + 1) / (2 * h[i])
        return step * t * n[i][j] / (h[i] + h[j] - 2 * step * h[i] * h[j])

    return [[entry(i, j) for j in range(block.size)] for i in range(block.size)]


def diagonal_kept(block: Block) -> Rows:
    """H^-1, which a diagonal Hessian keeps at its limit: K(H) = (tr H + tr HN) I."""
    size = range(block.size)
    return tuple(
        tuple(1 / block.hessian[i][i] if i == j else Fraction(0) for j in size) for i in size
    )


def kept_line(block: Block) -> tuple[Fraction, tuple[int, ...]] | None:
    """The step at which the second moment of an error on a line is kept, and the line.

    There is one in the plane only: with x = (1, s), s = 1 or -1, an eigenvector of H that the noise
    does not reach, Nx = 0, the step is 1/(h_11 + s h_12).
    """
    if block.size != 2 or block.hessian[0][0] != block.hessian[1][1]:
        return None
    n = noise_moments(block)
    found = [
        (1 / (block.hessian[0][0] + s * block.hessian[0][1]), (1, s))
        for s in (1, -1)
        if all(row[0] + s * row[1] == 0 for row in n)
    ]
    return min(found, default=None)


def kept_at(stacked: Stacked, step: Fraction, near: Matrix) -> Rows | None:
    """P > 0 with step K(HPH) = HP + PH exactly, as integers; None if there is none.

    Parameters
    ----------
    stacked : Stacked
    step : Fraction
        The limit.
    near : Matrix
        About such a P.
    """
    import flint

    rest = stacked.pull - stacked.kick * flint_of(step)
    if rest.det() != 0:
        return None
    size = stacked.block.size
    reduced, rank = rest.rref()
    columns, leads = rest.ncols(), _leads(reduced, rank)
    free = [j for j in range(columns) if j not in leads]
    flat = [near[i][j] for i in range(size) for j in range(i + 1)]
    scale = max(abs(x) for x in flat)
    values = dict.fromkeys(range(columns), flint.fmpq(0))
    values |= {j: flint_of(Fraction(round(flat[j] / scale * 2**20), 2**20)) for j in free}
    if len(free) == 1:
        values[free[0]] = flint.fmpq(1)
    for i, lead in enumerate(leads):
        values[lead] = -sum((reduced[i, j] * values[j] for j in free), start=flint.fmpq(0))
    column = flint.fmpq_mat([[values[j]] for j in range(columns)])
    rows = _integers(symmetric(column, size))
    return rows if congruence(rows) is not None else None


def _integers(matrix: list[list[Any]]) -> Rows:
    """The shortest positive multiple in integers with a positive trace."""
    rows = [[Fraction(int(x.p), int(x.q)) for x in row] for row in matrix]
    unit = Fraction(lcm(*(x.denominator for row in rows for x in row)))
    common = gcd(*(int(x * unit) for row in rows for x in row)) or 1
    sign = 1 if sum(row[i] for i, row in enumerate(rows)) > 0 else -1
    return tuple(tuple(x * unit * sign / common for x in row) for row in rows)


def algebraic_limit(stacked: Stacked, near: Fraction) -> Algebraic | None:
    """The limit as a root of det(pull - alpha kick), at most 1e-9 from `near`."""
    return _root((stacked.pull.inv() * stacked.kick).charpoly(), near, -1)


def algebraic_radius(stacked: Stacked, step: Fraction, near: Fraction) -> Algebraic | None:
    """The spectral radius as a root of det(r - L), at most 1e-9 from `near`."""
    return _root(stacked.update(step).charpoly(), near, 1)


def _root(polynomial: Any, near: Fraction, order: int) -> Algebraic | None:
    coefficients = [int(c) for c in polynomial.numer().coeffs()][::order]
    slack = Fraction(1, 10**9)
    return root_between(coefficients, near * (1 - slack), near * (1 + slack))


def items(matrices: Iterable[Rows]) -> list[Item]:
    """Witness items that choose matrices."""
    return [{"kind": "matrix", "rows": rows} for rows in matrices]


def identity_of(block: Block) -> Rows:
    """The identity of the block's size."""
    return tuple(tuple(Fraction(i == j) for j in range(block.size)) for i in range(block.size))


def covariance_of(block: Block) -> tuple[Rows, Rows, Rows]:
    """F, G > 0 and f > 0 with f Xi = F G F'.

    F is the identity where Xi is definite. Else F has the columns of Xi that span the others, and G
    is a multiple of the inverse of what they have in common with their rows, in integers: the
    fractions of a triangular factor would grow from column to column.
    """
    import flint

    rank, chosen = _independent(block.noise)
    if rank == block.size:
        return identity_of(block), block.noise, ((Fraction(1),),)
    if not rank:
        return tuple((Fraction(0),) for _ in block.noise), ((Fraction(1),),), ((Fraction(1),),)
    inverse = fmpq(tuple(tuple(block.noise[i][j] for j in chosen) for i in chosen)).inv()
    unit = flint.fmpq(inverse.numer_denom()[1])
    columns = tuple(tuple(row[j] for j in chosen) for row in block.noise)
    return columns, rows_of(inverse * unit), ((Fraction(int(unit.p)),),)


def _independent(noise: Rows) -> tuple[int, list[int]]:
    """Rank, and the first columns that are independent."""
    reduced, rank = fmpq(noise).rref()
    return rank, _leads(reduced, rank)


def _leads(reduced: Any, rank: int) -> list[int]:
    """Where the rows of a reduced echelon form begin."""
    columns = range(reduced.ncols())
    return [next(j for j in columns if reduced[i, j] != 0) for i in range(rank)]


def around(block: Block, inner: Rows) -> Rows:
    """H M H."""
    h = fmpq(block.hessian)
    return rows_of(h * fmpq(inner) * h)
