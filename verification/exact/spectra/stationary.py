"""Stationary covariances of z+ = A z + B noise, for white noise of unit covariance.

P = A P A' + B B' is a linear system in the entries of P on and below the diagonal; for rational
data and few states its exact solution is no more than an elimination. For many states P is computed
in floating point, corrected, and enclosed: if S - A S A' >= I/2 and the residual R of an
approximate X has |R| <= r, then P - X, the sum of the A^k R A'^k, lies between -2rS and 2rS.

References
----------
R. A. Smith, "Matrix equation XA + BX = C", SIAM J. Appl. Math. 16 (1968) 198-201 (the doubling).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .modes import doubles, exact, middle

Floats = NDArray[np.float64]
Ends = tuple[Fraction, Fraction]
DOUBLINGS, ROUNDS, BITS = 64, 4, 192
HALF = Fraction(1, 2)


def covariance(a: Any, b: Any) -> Any:
    """The exact solution of P = A P A' + B B'.

    Parameters
    ----------
    a, b : flint.fmpq_mat
        m by m, and m by any number of noises; A is Schur stable.

    Returns
    -------
    flint.fmpq_mat
        m by m, symmetric.
    """
    import flint

    m = a.nrows()
    places = {(i, j): k for k, (i, j) in enumerate((i, j) for i in range(m) for j in range(i + 1))}
    noise = b * b.transpose()
    rows = []
    for (i, j), place in places.items():
        row = [flint.fmpq(0)] * len(places)
        row[place] += 1
        for p in range(m):
            if a[i, p] == 0:
                continue
            for q in range(m):
                row[places[max(p, q), min(p, q)]] -= a[i, p] * a[j, q]
        rows.append(row)
    side = flint.fmpq_mat([[noise[i, j]] for i, j in places])
    found = flint.fmpq_mat(rows).solve(side)
    return flint.fmpq_mat(
        [[found[places[max(i, j), min(i, j)], 0] for j in range(m)] for i in range(m)]
    )


def diagonal(matrix: Any) -> list[Fraction]:
    """The diagonal of a `flint.fmpq_mat`."""
    return [Fraction(int(x.p), int(x.q)) for x in (matrix[i, i] for i in range(matrix.nrows()))]


def enclosed_diagonals(a: Any, noises: Sequence[Any]) -> list[list[Ends]] | None:
    """Bounds on the variances of a Schur stable system with many states.

    Parameters
    ----------
    a : flint.arb_mat
        Encloses an m by m matrix that is known to be Schur stable.
    noises : sequence of flint.arb_mat
        Each encloses a B, m by any number of noises.

    Returns
    -------
    list of list of (Fraction, Fraction), or None
        For each B, bounds on the diagonal entries of P; None where floats do not reach the bounds.
    """
    import flint

    m = a.nrows()
    with flint.ctx.workprec(BITS):
        one = flint.arb_mat([[int(i == j) for j in range(m)] for i in range(m)])
        spread = _solved(a, one)
        if spread is None or not _norm(_residual(a, one, spread)) <= HALF:
            return None
        found = []
        for b in noises:
            noise = b * b.transpose()
            near = _solved(a, noise)
            if near is None:
                return None
            slack = 2 * _norm(_residual(a, noise, near))
            found.append(
                [
                    (x - slack * s, x + slack * s)
                    for x, s in ((exact(near[i, i]), abs(exact(spread[i, i]))) for i in range(m))
                ]
            )
    return found


def _residual(a: Any, noise: Any, near: Any) -> Any:
    """A X A' + B B' - X, as balls."""
    return a * near * a.transpose() + noise - near


def _norm(matrix: Any) -> Fraction:
    """An upper bound on the Frobenius norm."""
    import flint

    total = sum((abs(x).upper() ** 2 for x in matrix.entries()), start=flint.arb(0))
    return exact(total.sqrt().upper())


def _solved(a: Any, noise: Any) -> Any | None:
    """A symmetric X close to the solution, as balls of radius 0; None where floats overflow."""
    import flint

    powers = _powers(doubles(a))
    near = 0 * noise
    for _ in range(ROUNDS):
        rest = middle(_residual(a, noise, near))
        size = max(abs(x) for x in rest.entries()).mid()
        if size == 0:
            break
        part = _summed(powers, doubles(rest * (1 / size)))
        if not np.isfinite(part).all():
            return None
        near = middle(near + flint.arb_mat(((part + part.T) / 2).tolist()) * size)
    return near


def _powers(a: Floats) -> list[Floats]:
    """A, A^2, A^4, ... until they vanish."""
    powers = [a]
    with np.errstate(over="ignore", invalid="ignore"):
        while len(powers) < DOUBLINGS and np.abs(powers[-1]).max() > 1e-20:
            powers.append(powers[-1] @ powers[-1])
    return powers


def _summed(powers: Sequence[Floats], noise: Floats) -> Floats:
    """The sum of the A^k N A'^k, by doubling."""
    total = noise
    with np.errstate(over="ignore", invalid="ignore"):
        for power in powers:
            total = total + power @ total @ power.T
    return total
