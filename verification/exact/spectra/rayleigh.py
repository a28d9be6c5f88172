"""Two-sided certified brackets of the largest x'Sx / x'Px, P being positive definite.

The exact quotient at any vector is a lower bound, whose error is of second order in the error of
the vector; the definiteness of r P - S proves that r is an upper bound.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from sensortrack.errors import InputError

from ..evaluate import Rows
from ..rationals import above, below, nearest
from .modes import (
    GUARD_BITS,
    doubles,
    fixed,
    integer_matrices,
    inverse,
    ladder,
    middle,
)
from .spectral import WIDER, Enclosure, unreached
from .stein import proved_definite

RATIO_WIDTH = Fraction(1, 10**12)
"""Relative width aimed at for generalised eigenvalues."""


def generalized_ratio(s: Rows, p: Rows) -> Enclosure:
    """Largest eigenvalue of the pencil (S, P): the maximum of x'Sx / x'Px.

    The lower side is the exact ratio at one vector, the upper side the definiteness of r P - S.

    Parameters
    ----------
    s : Rows
        Symmetric, exact.
    p : Rows
        Symmetric positive definite, exact, of the same size.

    Returns
    -------
    Enclosure
        Of relative width 1e-12 at most unless `stage` says otherwise.

    Raises
    ------
    InputError
        P is not positive definite.
    """
    top, bottom = integer_matrices(s, p)
    if not proved_definite(bottom):
        raise InputError("P", "a matrix that is not positive definite", "x'Px > 0 is needed")
    return _largest(top, bottom)


def image_ratio(e: Rows, f: Rows, p: Rows) -> Enclosure:
    """Largest growth factor of x'Px in one step of E z+ = F z.

    Parameters
    ----------
    e, f, p : Rows
        Square of one size, exact; E not singular, P symmetric positive definite.

    Returns
    -------
    Enclosure
        Largest eigenvalue of (A'PA, P), A = E^-1 F, of relative width 1e-12 at most unless `stage`
        says otherwise.
    """
    import flint

    left, right = integer_matrices(e, f)
    (weight,) = integer_matrices(p)
    step, unit = flint.fmpq_mat(left).solve(flint.fmpq_mat(right)).numer_denom()
    return _largest(step.transpose() * weight * step, unit**2 * weight)


def _largest(top: Any, bottom: Any) -> Enclosure:
    """Bracket the largest eigenvalue of (top, bottom), bottom being positive definite."""
    if not any(x != 0 for x in top.entries()):
        return Enclosure(0.0, 0.0, 0.0, "S is zero")
    lower = max(Fraction(int(top[i, i]), int(bottom[i, i])) for i in range(top.nrows()))
    stage = "the diagonal"
    for x, stage in candidate_vectors(top, bottom):
        lower = max(lower, quotient(x, top, bottom))
        upper = lower + abs(lower) * RATIO_WIDTH / 2
        if lower and _dominates(top, bottom, upper):
            return Enclosure(nearest(lower), below(lower), above(upper), stage)
    size = max(abs(Fraction(int(top[i, i]), int(bottom[i, i]))) for i in range(top.nrows()))
    for width in (RATIO_WIDTH, *WIDER):
        upper = lower + max(abs(lower), size) * width
        if _dominates(top, bottom, upper):
            return Enclosure(nearest(lower), below(lower), above(upper), unreached(stage))
    return Enclosure(nearest(lower), below(lower), None, unreached(stage))


def _dominates(top: Any, bottom: Any, r: Fraction) -> bool:
    """Tell whether r P - S is proved to be positive definite."""
    return proved_definite(r.numerator * bottom - r.denominator * top)


def quotient(x: Any, s: Any, p: Any) -> Fraction:
    """x'Sx / x'Px for a column of integers and integer matrices of `flint`."""
    row = x.transpose()
    return Fraction(int((row * s * x)[0, 0]), int((row * p * x)[0, 0]))


def candidate_vectors(s: Any, p: Any) -> Iterator[tuple[Any, str]]:
    """Ever better vectors where x'Sx / x'Px is nearly largest; none of them is trusted.

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

    n = s.nrows()
    halves = [int(p[i, i]).bit_length() // 2 for i in range(n)]
    with flint.ctx.workprec(2 * GUARD_BITS):
        pair = [_scaled(flint.arb_mat(m), halves) for m in (s, p)]
        size = max(abs(x) for x in pair[0].entries()).mid()
        pair[0] = pair[0] * (1 / size)
    try:
        factor = np.linalg.inv(np.linalg.cholesky(doubles(pair[1])))
        _, vectors = np.linalg.eigh(factor @ doubles(pair[0]) @ factor.T)
        column = factor.T @ vectors[:, -1]
        yield (
            _column([flint.arb(float(x)) for x in column / abs(column).max()], halves, 53),
            "doubles",
        )
    except np.linalg.LinAlgError:  # P is numerically singular
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
