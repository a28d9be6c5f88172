"""Integer vectors of sum zero with a small Rayleigh quotient: upper bounds on lambda_2."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network

from ..evaluate import Rows
from .slow_modes import Mode

BITS = 200
"""Precision of the refined eigenvector."""

VECTOR_BITS = 60

UNLIKE_BITS = 40
"""Bits from lambda_2 to the heaviest node beyond which vectors need more bits than those."""

CLEAR = 1e-6
"""Share of the heaviest node from which on lambda_2 is not lost in the rounding of doubles."""

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
    start, value = _start(network)
    extra = max(0, math.ceil(math.log2(float(_heaviest(network)) / value)) - UNLIKE_BITS)
    mids = _refined(network, start, value, extra)
    size = max(abs(v) for v in mids)
    whole = [round(v / size * 2 ** (VECTOR_BITS + extra // 2)) for v in mids]
    centred = [network.n * v - sum(whole) for v in whole]
    common = math.gcd(*centred)
    return tuple(v // common for v in centred)


def _heaviest(network: Network) -> Fraction:
    """Largest entry of the Laplacian's diagonal, which is at least half of every eigenvalue."""
    degrees = [Fraction(0)] * network.n
    for (i, j), w in zip(network.edges.tolist(), network.exact_weights(), strict=True):
        degrees[i] += w
        degrees[j] += w
    return max(degrees)


def _start(network: Network) -> tuple[list[Fraction], float]:
    """An eigenvector to the accuracy of doubles, and lambda_2 for it."""
    values, vectors = np.linalg.eigh(network.laplacian().toarray())
    x, value = vectors[:, 1], float(values[1])
    if value > CLEAR * float(_heaviest(network)):
        start = [Fraction(float(v)) for v in x]
        return start, float(rayleigh(network, _whole(start)))
    values, vectors = np.linalg.eigh(_inverse(network))
    return [Fraction(float(v)) for v in vectors[:, -1]], 1 / float(values[-1])


def _inverse(network: Network) -> NDArray[np.float64]:
    """Pseudo-inverse of the Laplacian: of its eigenvalues, doubles keep that of lambda_2 best."""
    import flint

    n, level = network.n, _heaviest(network)
    unlike = math.log2(level / min(network.exact_weights()))
    flint.ctx.prec = BITS + 2 * math.ceil(unlike)
    rows = [[_arb(x + level / n) for x in row] for row in laplacian_rows(network)]
    one = flint.arb_mat([[int(i == j) for j in range(n)] for i in range(n)])
    found = flint.arb_mat(rows).solve(one, algorithm="approx")
    rest = _arb(1 / (level * n))
    return np.array([[float((found[i, j] - rest).mid()) for j in range(n)] for i in range(n)])


def laplacian_rows(network: Network) -> Rows:
    """The Laplacian in exact numbers, n rows of n entries."""
    rows = [[Fraction(0)] * network.n for _ in range(network.n)]
    for (i, j), w in zip(network.edges.tolist(), network.exact_weights(), strict=True):
        rows[i][j] -= w
        rows[j][i] -= w
        rows[i][i] += w
        rows[j][j] += w
    return tuple(map(tuple, rows))


def _shifted_rows(network: Network, s: Fraction) -> list[list[Fraction]]:
    """L - s I and enough on the constant vectors: positive if and only if lambda_2 > s."""
    spread = (s + _heaviest(network)) / network.n
    rows = [[x + spread for x in row] for row in laplacian_rows(network)]
    for i, row in enumerate(rows):
        row[i] -= s
    return rows


def _refined(network: Network, start: list[Fraction], value: float, extra: int) -> list[Fraction]:
    """Two steps of inverse iteration in many bits; the shift is a little below lambda_2."""
    import flint

    n = network.n
    shift = Fraction(value) * (1 - Fraction(1, 10**9))
    flint.ctx.prec = BITS + 2 * extra
    matrix = flint.arb_mat([[_arb(x) for x in row] for row in _shifted_rows(network, shift)])
    x = flint.arb_mat([[flint.arb(v)] for v in _whole(start)])
    for _ in range(2):
        try:
            x = matrix.solve(x, algorithm="approx")
        except ZeroDivisionError:
            break
        top = max(abs(x[i, 0].mid()) for i in range(n))
        x = flint.arb_mat([[(x[i, 0] / top).mid()] for i in range(n)])
    scale = flint.arb(2) ** (2 * (VECTOR_BITS + extra // 2))
    return [Fraction(int((x[i, 0] * scale).mid().floor().unique_fmpz() or 0)) for i in range(n)]


def _whole(vector: list[Fraction]) -> tuple[int, ...]:
    whole = [round(v * 2**VECTOR_BITS) for v in vector]
    return tuple(len(whole) * v - sum(whole) for v in whole)


def _arb(x: Fraction) -> Any:
    import flint

    return flint.arb(flint.fmpq(x.numerator, x.denominator))
