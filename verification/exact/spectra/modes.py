"""Approximate eigenvalues and left eigenvectors of E z+ = F z, as integers for exact proofs.

Nothing here is trusted: the numbers are candidates, and `spectral` proves what follows from them.
The first candidate comes from doubles; the following ones have more bits and a small generic
perturbation, because a matrix without a basis of eigenvectors is near one that has it: with a
perturbation of size s, an m-fold defective eigenvalue moves by about s^(1/m), and the eigenvectors
are no worse conditioned than s^(1/m - 1).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Any

import numpy as np

from ..evaluate import Rows

GUARD_BITS = 64
LADDER = (160, 320, 640, 1280)
SWEEPS = 8
ZERO = -(1 << 40)
"""Binary exponent that stands for the number 0."""

LARGE = 40
"""Above this size the last steps of the ladder would take minutes."""


@dataclass(frozen=True)
class Modes:
    """Candidates for the modes of a pencil.

    Parameters
    ----------
    moduli, reals : tuple of Fraction
        Absolute values and real parts of the eigenvalues.
    real, imaginary : flint.fmpz_mat
        Row i is a left vector g with g F = z_i g E, after column j was divided by 2**shifts[j].
    shifts : tuple of int
        Exponents, the smallest being 0; a common power of two of each row is dropped.
    stage : str
        Where the numbers come from.
    """

    moduli: tuple[Fraction, ...]
    reals: tuple[Fraction, ...]
    real: Any
    imaginary: Any
    shifts: tuple[int, ...]
    stage: str


def integer_matrices(*matrices: Rows) -> list[Any]:
    """The same matrices times one common denominator, as `flint.fmpz_mat`."""
    import flint

    unit = lcm(*(x.denominator for rows in matrices for row in rows for x in row))
    return [flint.fmpz_mat([[int(x * unit) for x in row] for row in rows]) for rows in matrices]


def rows_of(matrix: Any) -> Rows:
    """Exact rows of a `flint.fmpz_mat`."""
    return tuple(tuple(Fraction(int(x)) for x in row) for row in matrix.tolist())


def candidates(e: Any, f: Any) -> Iterator[Modes]:
    """Ever better modes of E z+ = F z.

    Parameters
    ----------
    e, f : flint.fmpz_mat
        Square, E not singular.

    Yields
    ------
    Modes
        From doubles, then from 160 bits and more.
    """
    modes = _modes_of_doubles(e, f)
    if modes is not None:
        yield modes
    for bits in ladder(e.nrows()):
        yield _modes_of_bits(e, f, bits)


def ladder(n: int) -> tuple[int, ...]:
    """Precisions to try at size n."""
    return LADDER if n <= LARGE else LADDER[:2]


def _modes_of_bits(e: Any, f: Any, bits: int) -> Modes:
    """Modes of the perturbed pencil."""
    import flint

    n = e.nrows()
    noise = flint.arb_mat(np.random.default_rng(0).standard_normal((n, n)).tolist())
    with flint.ctx.workprec(bits + GUARD_BITS):
        balanced, back = _balanced(e, f, bits)
        size = max(abs(x) for x in balanced.entries()) * flint.arb(2) ** -(3 * bits // 4)
        near = flint.acb_mat(middle(balanced + noise * size))
        values, left = near.eig(left=True, algorithm="approx")
        sizes = tuple(exact(abs(z.mid())) for z in values), tuple(exact(z.real) for z in values)
        return _rounded(*sizes, _unit_rows(left) * flint.acb_mat(back), bits, f"{bits} bits")


def _modes_of_doubles(e: Any, f: Any) -> Modes | None:
    import flint

    with flint.ctx.workprec(2 * GUARD_BITS):
        balanced, back = _balanced(e, f, GUARD_BITS)
        size = max(abs(x) for x in balanced.entries()).mid()
        if size == 0:
            return None
        try:
            values, vectors = np.linalg.eig(doubles(balanced * (1 / size)).T)
        except np.linalg.LinAlgError:  # no convergence
            return None
        moduli = tuple(Fraction(abs(z)) * exact(size) for z in values.tolist())
        reals = tuple(Fraction(z) * exact(size) for z in values.real.tolist())
        left = flint.acb_mat([[complex(z) for z in row] for row in vectors.T.tolist()])
        return _rounded(moduli, reals, left * flint.acb_mat(back), 53, "doubles")


def _balanced(e: Any, f: Any, bits: int) -> tuple[Any, Any]:
    """D^-1 (E^-1 F) D and D^-1 E^-1 for the diagonal D of `_balance`."""
    import flint

    back = inverse(e, bits)
    step = middle(back * flint.arb_mat(f))
    powers = _balance([[_head(x) for x in row] for row in step.tolist()])
    n = len(powers)
    diagonal = [flint.arb(2) ** powers[i] * (i == j) for i in range(n) for j in range(n)]
    inverted = [flint.arb(2) ** -powers[i] * (i == j) for i in range(n) for j in range(n)]
    left = flint.arb_mat(n, n, inverted)
    return middle(left * step * flint.arb_mat(n, n, diagonal)), middle(left * back)


def _balance(heads: list[list[int]]) -> list[int]:
    """Exponents d such that rows and columns of 2^(heads_ij - d_i + d_j) have like maxima.

    Osborne's iteration in the maximum norm, on binary exponents: whatever the units are, it leaves
    the range of doubles no sooner than the balanced matrix does.
    """
    n = len(heads)
    powers = [0] * n
    for _ in range(SWEEPS):
        for i in range(n):
            others = [j for j in range(n) if j != i]
            row = max((heads[i][j] + powers[j] for j in others), default=ZERO)
            column = max((heads[j][i] - powers[j] for j in others), default=ZERO)
            if row > ZERO // 2 and column > ZERO // 2:
                powers[i] = (row - column) // 2
    return powers


def inverse(e: Any, bits: int) -> Any:
    """Midpoint of the inverse to `bits` correct bits of its largest entry; E is not singular."""
    import flint

    precision = bits + GUARD_BITS
    while True:
        with flint.ctx.workprec(precision):
            try:
                balls = flint.arb_mat(e).inv()
                size = max(abs(x.mid()) for x in balls.entries()) * flint.arb(2) ** -bits
                if all(x.rad() <= size for x in balls.entries()):
                    return middle(balls)
            except ZeroDivisionError:  # the balls are too wide to tell E from a singular matrix
                pass
        precision *= 2


def middle(matrix: Any) -> Any:
    """The same matrix of balls without its radii."""
    import flint

    entries = [x.mid() for x in matrix.entries()]
    return flint.arb_mat(matrix.nrows(), matrix.ncols(), entries)


def doubles(matrix: Any) -> Any:
    """The midpoints of a matrix of balls."""
    return np.array([[float(x.mid()) for x in row] for row in matrix.tolist()])


def _unit_rows(matrix: Any) -> Any:
    import flint

    rows = []
    for row in matrix.tolist():
        size = max(abs(z.mid()) for z in row).mid()
        rows.append([z.mid() / size for z in row])
    return flint.acb_mat(rows)


def exact(x: Any) -> Fraction:
    """The midpoint of a ball."""
    mantissa, exponent = x.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _rounded(
    moduli: tuple[Fraction, ...], reals: tuple[Fraction, ...], left: Any, bits: int, stage: str
) -> Modes:
    """Keep about `bits` bits of the largest entry in each column."""
    import flint

    parts = [[z.real.mid() for z in left.entries()], [z.imag.mid() for z in left.entries()]]
    n = left.ncols()
    heads = [max(_head(x) for part in parts for x in part[j::n]) for j in range(n)]
    real, imaginary = (
        flint.fmpz_mat(left.nrows(), n, [fixed(x, bits - heads[k % n]) for k, x in enumerate(part)])
        for part in parts
    )
    return Modes(moduli, reals, real, imaginary, tuple(head - min(heads) for head in heads), stage)


def _head(x: Any) -> int:
    """Exponent of the leading bit, very small for 0."""
    mantissa, exponent = x.man_exp()
    return int(mantissa).bit_length() + int(exponent) if mantissa else ZERO


def fixed(x: Any, shift: int) -> int:
    """Midpoint times 2^shift, rounded down."""
    mantissa, exponent = x.man_exp()
    shift += int(exponent)
    return int(mantissa) << shift if shift >= 0 else int(mantissa) >> -shift
