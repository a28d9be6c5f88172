"""Candidates for the vector at which x'Sx / x'Px is largest, P being positive definite.

Nothing here is trusted: the quotient at any vector is an exact lower bound of the maximum. Near the
maximum its error is of second order in the error of the vector.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from .modes import GUARD_BITS, doubles, fixed, inverse, ladder, middle


def quotient(x: Any, s: Any, p: Any) -> Fraction:
    """x'Sx / x'Px for a column of integers and integer matrices of `flint`."""
    row = x.transpose()
    return Fraction(int((row * s * x)[0, 0]), int((row * p * x)[0, 0]))


def candidate_vectors(s: Any, p: Any) -> Iterator[tuple[Any, str]]:
    """Ever better vectors.

    Parameters
    ----------
    s, p : flint.fmpz_mat
        Symmetric, P positive definite.

    Yields
    ------
    flint.fmpz_mat
        Column of integers, not all 0.
    str
        How it was computed.
    """
    import flint
    from scipy.linalg import LinAlgError, eigh

    n = s.nrows()
    halves = [int(p[i, i]).bit_length() // 2 for i in range(n)]
    with flint.ctx.workprec(2 * GUARD_BITS):
        pair = [_scaled(flint.arb_mat(m), halves) for m in (s, p)]
        size = max(abs(x) for x in pair[0].entries()).mid()
        pair[0] = pair[0] * (1 / size)
    try:
        _, vectors = eigh(*map(doubles, pair), subset_by_index=(n - 1, n - 1))
        yield _column([flint.arb(float(x)) for x in vectors[:, 0]], halves, 53), "doubles"
    except LinAlgError:  # P is numerically singular
        pass
    for bits in ladder(n):
        yield _column(_vector_of_bits(s, p, halves, bits), halves, bits), f"{bits} bits"


def _vector_of_bits(s: Any, p: Any, halves: list[int], bits: int) -> list[Any]:
    """Eigenvector of P^-1 S after scaling, as balls."""
    import flint

    with flint.ctx.workprec(bits + GUARD_BITS):
        whole, weight = (_scaled(flint.arb_mat(m), halves) for m in (s, p))
        step = flint.acb_mat(middle(inverse(weight, bits) * whole))
        values, right = step.eig(right=True, algorithm="approx")
        largest = max(range(len(values)), key=lambda i: values[i].real.mid())
        column = [row[largest].mid() for row in right.tolist()]
        lead = max(column, key=lambda z: abs(z).mid())
        return [(z / lead).real.mid() for z in column]


def _scaled(matrix: Any, halves: list[int]) -> Any:
    """D M D with D = diag(2^-halves): the diagonal of P becomes about 1."""
    import flint

    n = matrix.nrows()
    entries = [
        x * flint.arb(2) ** -(halves[k // n] + halves[k % n])
        for k, x in enumerate(matrix.entries())
    ]
    return flint.arb_mat(n, n, entries)


def _column(scaled: list[Any], halves: list[int], bits: int) -> Any:
    """Integers proportional to D y, D as in `_scaled`."""
    import flint

    most = max(halves)
    entries = [fixed(y, bits) << (most - half) for y, half in zip(scaled, halves, strict=True)]
    return flint.fmpz_mat(len(entries), 1, entries)
