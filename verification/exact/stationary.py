"""Stationary covariances of z+ = A z + B noise, for white noise of unit covariance.

P = A P A' + B B' is a linear system in the entries of P on and below the diagonal; for rational
data and few states its exact solution is no more than an elimination.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
RESIDUAL = 1e-9
DOUBLINGS = 60


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


def trace_of(matrix: Any, places: Iterable[int]) -> Fraction:
    """Sum of some diagonal entries."""
    total = sum((matrix[i, i] for i in places), start=0 * matrix[0, 0])
    return Fraction(int(total.p), int(total.q))


def float_covariance(a: Floats, b: Floats) -> Floats | None:
    """The solution in floating point by doubling, None if its residual is too large.

    Parameters
    ----------
    a, b : ndarray
        m by m Schur stable, and m by any number of noises.
    """
    power, total = a, b @ b.T
    noise = total
    for _ in range(DOUBLINGS):
        total = total + power @ total @ power.T
        power = power @ power
        if np.abs(power).max() < 1e-30:
            break
    residual = np.abs(a @ total @ a.T + noise - total).max()
    if not residual <= RESIDUAL * np.abs(total).max():
        return None
    return np.asarray(total)
