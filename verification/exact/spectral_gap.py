"""Algebraic connectivity: the second smallest eigenvalue lambda_2 of a network's Laplacian.

Upper bounds are Rayleigh quotients of integer vectors of sum zero, lower bounds the positive
definiteness of L - s I + (s + 1) J/n, J being all ones: this matrix has the eigenvalue 1 on
constant vectors and lambda_k - s on the others.

References
----------
M. Fiedler, "Algebraic connectivity of graphs", Czechoslovak Mathematical Journal 23 (1973).
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from sensortrack.errors import SensorTrackError
from sensortrack.networks import Network

from .balls import ball_definite
from .rationals import above, below, nearest
from .roots import Algebraic, root_between

LARGEST = 200
"""Most nodes of a network whose bounds are proved: the cost grows with their cube."""

SPARSE = 1_000_000
"""Most nodes and edges of a network whose lambda_2 is computed at all, unless it is a product."""

RESIDUAL = 1e-6
"""Largest residual of an eigenvector relative to lambda_2; the value's error is its square."""

EXACT = 60
"""Most nodes of a network whose characteristic polynomial is factored."""

BITS = 200
"""Precision of the refined eigenvector, and of a proof but for what elimination loses a node."""

LOST_BITS = 3

VECTOR_BITS = 60
WIDTH = 1e-9
"""Relative width of the bracket at which no further lower bound is tried."""


class NoBracketError(SensorTrackError):
    """The bounds on lambda_2 of a network cannot be proved; the message says why."""


class Gap(NamedTuple):
    """Proved bounds on lambda_2.

    Parameters
    ----------
    lower, upper : Fraction
        Both doubles, lower < lambda_2 <= upper if the network is connected, else both 0.
    vector : tuple of int
        Has the sum zero and shows the upper bound. Empty for a large product, whose bounds are
        those of a factor.
    """

    lower: Fraction
    upper: Fraction
    vector: tuple[int, ...]


def connectivity_bracket(network: Network) -> Gap:
    """Bracket lambda_2 between two doubles, next to each other where the arithmetic allows.

    Parameters
    ----------
    network : Network
        Two nodes or more.

    Returns
    -------
    Gap

    Raises
    ------
    NoBracketError
        The network has more than `LARGEST` nodes and is no product, or no lower bound was proved.
    """
    if network.n > LARGEST and network.factors:
        gaps = [connectivity_bracket(factor) for factor in network.factors]
        return Gap(min(gap.lower for gap in gaps), min(gap.upper for gap in gaps), ())
    if network.n > LARGEST:
        raise NoBracketError(f"lambda_2 is proved for at most {LARGEST} nodes, not {network.n}")
    parts = network.components()
    if len(parts) > 1:
        return Gap(Fraction(0), Fraction(0), _step(network.n, parts[0]))
    vector = _slow_vector(network)
    quotient = rayleigh(network, vector)
    return Gap(_proved_below(network, quotient), Fraction(above(quotient)), vector)


def rayleigh(network: Network, vector: tuple[int, ...]) -> Fraction:
    """Sum of w (x_i - x_j)^2 over the edges, over the sum of x_i^2."""
    weights = network.weights or (Fraction(1),) * network.m
    pairs = network.edges.tolist()
    top = sum(
        (w * (vector[i] - vector[j]) ** 2 for (i, j), w in zip(pairs, weights, strict=True)),
        Fraction(0),
    )
    return top / sum(x * x for x in vector)


def exact_connectivity(network: Network, gap: Gap) -> Algebraic | None:
    """lambda_2 as an algebraic number.

    Parameters
    ----------
    network : Network
    gap : Gap
        As from `connectivity_bracket`.

    Returns
    -------
    Algebraic or None
        None for more than `EXACT` nodes (of the factor that decides, for a product), or if the
        bracket holds several eigenvalues.
    """
    import flint

    if gap.upper == 0:
        return Algebraic((0, 1), Fraction(0), Fraction(0), 0.0)
    if network.factors:
        return _of_factors(network, gap)
    if network.n > EXACT:
        return None
    unit = math.lcm(*(w.denominator for w in network.weights or ()))
    rows = [[int(x * unit) for x in row] for row in laplacian_rows(network)]
    polynomial = [int(c) for c in flint.fmpz_mat(rows).charpoly().coeffs()]
    scaled = [c * unit**k for k, c in enumerate(polynomial)]  # of L itself, not of unit L
    common = math.gcd(*scaled)
    return root_between([c // common for c in scaled], gap.lower, gap.upper)


def connectivity_value(network: Network) -> float | None:
    """lambda_2 in floating point, to nearly full accuracy up to `LARGEST` nodes, without a proof.

    Parameters
    ----------
    network : Network
        Two nodes or more.

    Returns
    -------
    float or None
        None if the residual of a large network's eigenvector is not small.
    """
    if network.factors:
        values = [connectivity_value(factor) for factor in network.factors]
        known = [value for value in values if value is not None]
        return min(known) if len(known) == len(values) else None
    if not network.is_connected():
        return 0.0
    if network.n <= LARGEST:
        return nearest(rayleigh(network, _slow_vector(network)))
    return _estimate(network)


def _estimate(network: Network) -> float | None:
    """lambda_2 by inverse iteration on the sparse Laplacian."""
    from scipy.sparse.linalg import eigsh

    if network.n + network.m > SPARSE:
        return None
    laplacian = network.laplacian().tocsc()
    start = np.random.default_rng(0).standard_normal(network.n)
    shift = -1e-6 * float(laplacian.diagonal().mean())
    try:
        values, vectors = eigsh(laplacian, k=2, sigma=shift, which="LM", v0=start)
    except (RuntimeError, MemoryError):
        return None
    x = vectors[:, int(np.argmax(values))]
    x = x - x.mean()
    steps = x[network.edges[:, 0]] - x[network.edges[:, 1]]
    weights = np.array([float(w) for w in network.weights]) if network.weights else 1.0
    value = float((weights * steps**2).sum() / (x @ x))  # no cancellation, unlike x'Lx
    residual = float(np.linalg.norm(laplacian @ x - value * x) / np.linalg.norm(x))
    return value if residual <= RESIDUAL * value else None


def laplacian_rows(network: Network) -> list[list[Fraction]]:
    """The Laplacian, exact."""
    rows = [[Fraction(0)] * network.n for _ in range(network.n)]
    weights = network.weights or (Fraction(1),) * network.m
    for (i, j), w in zip(network.edges.tolist(), weights, strict=True):
        rows[i][j] -= w
        rows[j][i] -= w
        rows[i][i] += w
        rows[j][j] += w
    return rows


def shifted_rows(network: Network, s: Fraction) -> list[list[Fraction]]:
    """L - s I + (s + 1) J/n, positive definite if and only if lambda_2 > s."""
    spread = (s + 1) / network.n
    rows = [[x + spread for x in row] for row in laplacian_rows(network)]
    for i, row in enumerate(rows):
        row[i] -= s
    return rows


def _of_factors(network: Network, gap: Gap) -> Algebraic | None:
    """Eigenvalues of a product are sums of one of each factor: the smallest lambda_2 decides."""
    best: Algebraic | None = None
    for factor in network.factors:
        inner = connectivity_bracket(factor)
        if inner.lower <= gap.upper:
            best = exact_connectivity(factor, inner)
            if best is None or inner.upper <= gap.upper:
                return best
    return best


def _step(n: int, part: list[int]) -> tuple[int, ...]:
    """Constant on a component and on the rest, of sum zero."""
    inside = set(part)
    return tuple(n - len(part) if i in inside else -len(part) for i in range(n))


def _slow_vector(network: Network) -> tuple[int, ...]:
    """Integer vector of sum zero close to an eigenvector of lambda_2."""
    x = np.linalg.eigh(network.laplacian().toarray())[1][:, 1]
    mids = _refined(network, [Fraction(float(v)) for v in x])
    size = max(abs(v) for v in mids)
    whole = [round(v / size * 2**VECTOR_BITS) for v in mids]
    centred = [network.n * v - sum(whole) for v in whole]
    common = math.gcd(*centred)
    return tuple(v // common for v in centred)


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


def _proved_below(network: Network, quotient: Fraction) -> Fraction:
    """The largest tried double that is proved to lie below lambda_2."""
    top = nearest(quotient)
    lower = math.nextafter(below(quotient), 0.0) if Fraction(top) == quotient else below(quotient)
    step, bits = math.ulp(lower), BITS + LOST_BITS * network.n
    while lower > 0 and (top - lower) <= WIDTH * top:
        if ball_definite(shifted_rows(network, Fraction(lower)), bits):
            return Fraction(lower)
        lower -= step
        step *= 4
    raise NoBracketError(f"no lower bound within {WIDTH:g} of lambda_2 could be proved")


def _arb(x: Fraction) -> Any:
    import flint

    return flint.arb(flint.fmpq(x.numerator, x.denominator))
