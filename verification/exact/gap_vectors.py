"""Integer vectors of sum zero with a small Rayleigh quotient: upper bounds on lambda_2."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network

from .evaluate import Rows
from .slow_modes import Mode

BITS = 200
"""Precision of the refined eigenvector."""

VECTOR_BITS = 60

EXCESS_BITS = 40
"""The quotient of a rounded eigenvector exceeds lambda_2 by a share of 2^-EXCESS_BITS, or so."""


def rayleigh(network: Network, vector: tuple[int, ...]) -> Fraction:
    """Sum of w (x_i - x_j)^2 over the edges, over the sum of x_i^2."""
    if network.weights is None:
        return Fraction(_sum_of_squares(network.edges, vector), sum(x * x for x in vector))
    unit = math.lcm(*{w.denominator for w in network.weights})
    top = sum(
        w.numerator * (unit // w.denominator) * (vector[i] - vector[j]) ** 2
        for (i, j), w in zip(network.edges.tolist(), network.weights, strict=True)
    )
    return Fraction(top, unit * sum(x * x for x in vector))


def _sum_of_squares(edges: NDArray[np.int64], vector: tuple[int, ...]) -> int:
    """Sum of (x_i - x_j)^2; in 64 bits where no number and no sum leaves them."""
    if max(map(abs, vector)) >= 2**30 or len(edges) >= 2**31:
        return sum((vector[i] - vector[j]) ** 2 for i, j in edges.tolist())
    x = np.array(vector, dtype=np.int64)
    squares = (x[edges[:, 0]] - x[edges[:, 1]]) ** 2  # below 2^62
    return (int((squares >> 31).sum()) << 31) + int((squares & (2**31 - 1)).sum())


def whole_vector(network: Network, mode: Mode) -> tuple[int, ...]:
    """Integers of sum zero whose quotient is hardly larger than that of an eigenvector.

    Parameters
    ----------
    network : Network
    mode : Mode

    Returns
    -------
    tuple of int
        One a node.
    """
    x = mode.vector / np.abs(mode.vector).max()
    weight = float(network.laplacian().diagonal().sum())
    spread = max(1.0, weight / (mode.value * float(x @ x)))
    bits = min(52, math.ceil((EXCESS_BITS + math.log2(spread)) / 2))
    whole = np.rint(x * 2.0**bits).astype(np.int64)
    whole -= int(whole.sum()) // network.n
    whole[: int(whole.sum())] -= 1
    return tuple(whole.tolist())


def refined_vector(network: Network) -> tuple[int, ...]:
    """Integers of sum zero, refined by inverse iteration in many bits.

    Parameters
    ----------
    network : Network
        Connected, of some hundred nodes at most.

    Returns
    -------
    tuple of int
        One a node, without a common divisor.
    """
    x = np.linalg.eigh(network.laplacian().toarray())[1][:, 1]
    mids = _refined(network, [Fraction(float(v)) for v in x])
    size = max(abs(v) for v in mids)
    whole = [round(v / size * 2**VECTOR_BITS) for v in mids]
    centred = [network.n * v - sum(whole) for v in whole]
    common = math.gcd(*centred)
    return tuple(v // common for v in centred)


def laplacian_rows(network: Network) -> Rows:
    """The Laplacian in exact numbers, n rows of n entries."""
    rows = [[Fraction(0)] * network.n for _ in range(network.n)]
    for (i, j), w in zip(network.edges.tolist(), network.exact_weights(), strict=True):
        rows[i][j] -= w
        rows[j][i] -= w
        rows[i][i] += w
        rows[j][j] += w
    return tuple(map(tuple, rows))


def shifted_rows(network: Network, s: Fraction) -> list[list[Fraction]]:
    """L - s I + (s + 1) J/n, positive definite if and only if lambda_2 > s."""
    spread = (s + 1) / network.n
    rows = [[x + spread for x in row] for row in laplacian_rows(network)]
    for i, row in enumerate(rows):
        row[i] -= s
    return rows


def _refined(network: Network, vector: list[Fraction]) -> list[Fraction]:
    """Two steps of inverse iteration in many bits; the shift is a little below lambda_2."""
    import flint

    n = network.n
    start = _whole(vector)
    shift = rayleigh(network, start) * (1 - Fraction(1, 10**9))
    flint.ctx.prec = BITS
    matrix = flint.arb_mat([[_arb(x) for x in row] for row in shifted_rows(network, shift)])
    x = flint.arb_mat([[flint.arb(v)] for v in start])
    for _ in range(2):
        try:
            x = matrix.solve(x, algorithm="approx")
        except ZeroDivisionError:
            break
        top = max(abs(float(x[i, 0].mid())) for i in range(n))
        x = flint.arb_mat([[(x[i, 0] / top).mid()] for i in range(n)])
    scale = flint.arb(2) ** (2 * VECTOR_BITS)
    return [Fraction(int((x[i, 0] * scale).mid().floor().unique_fmpz() or 0)) for i in range(n)]


def _whole(vector: list[Fraction]) -> tuple[int, ...]:
    whole = [round(v * 2**VECTOR_BITS) for v in vector]
    return tuple(len(whole) * v - sum(whole) for v in whole)


def _arb(x: Fraction) -> Any:
    import flint

    return flint.arb(flint.fmpq(x.numerator, x.denominator))
