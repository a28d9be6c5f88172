"""What solutions of pull(X) - alpha kick(X) = R have in common, exact or enclosed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from verification.exact.balls import ball_ldl

from ..block_inputs import Block
from ..stability.moments import FLINT, Operators, exact_operators


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


def flint_trace(matrix: Any) -> Any:
    """Sum of the diagonal of a flint matrix."""
    return sum((matrix[i, i] for i in range(1, matrix.nrows())), start=matrix[0, 0])


def ball_operators(block: Block) -> Operators:
    """Pull and kick in `flint.arb_mat` of the precision that is set."""
    import flint

    exact = exact_operators(block)
    h, n, one = (flint.arb_mat(part) for part in (exact.hessian, exact.noise, exact.one))
    return Operators(h, n, one, FLINT)


def definite(matrix: Any) -> bool:
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


def norm(matrix: Any) -> Any:
    """An upper bound on the Frobenius norm."""
    import flint

    total = sum((abs(x).upper() ** 2 for x in matrix.entries()), start=flint.arb(0))
    return total.sqrt().upper()


def around(radius: Any) -> Any:
    """The ball around 0 with this radius."""
    import flint

    return flint.arb(0, radius.upper())
