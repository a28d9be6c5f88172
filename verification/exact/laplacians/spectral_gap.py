"""Algebraic connectivity: the second smallest eigenvalue lambda_2 of a network's Laplacian.

Upper bounds are Rayleigh quotients of integer vectors of sum zero. Lower bounds are eliminations of
L - s I in integers with one negative pivot at most (`elimination`); a product has those of its
factors, and large complete networks, stars and complete bipartite networks a closed form.

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

from ..rationals import above, below, nearest
from ..roots import Algebraic, root_between
from .elimination import CHECKED, EliminationError, Matrix, negatives
from .gap_vectors import laplacian_rows, rayleigh, refined_vector, whole_vector
from .slow_modes import Mode, lanczos_mode, slow_mode
from .sparse_ldl import FactorError, Symbolic, analyse

LARGEST = 200
"""Most nodes of a network whose bounds are made neighbouring doubles; its matrix is dense."""

STORED = 600_000_000
"""Most entries of a sparse factor: 5 GB."""

WORK = 2e11
"""Most multiplications of an elimination in integers: minutes in C."""

RESIDUAL = 1e-6
"""Largest residual of an eigenvector relative to lambda_2; the value's error is its square."""

EXACT = 60
"""Most nodes of a network whose characteristic polynomial is factored."""

WIDTH = 1e-9
"""Relative width of a small network's bracket at which no further lower bound is tried."""

DISTANCES = (2.0**-35, 2.0**-28, 2.0**-24, 2.0**-20, 2.0**-14, 2.0**-8)
"""How far below a large network's Rayleigh quotient lower bounds are tried, relative to it."""


class NoBracketError(SensorTrackError):
    """The bounds on lambda_2 of a network cannot be proved; the message says why."""


class Gap(NamedTuple):
    """Proved bounds on lambda_2.

    Parameters
    ----------
    lower, upper : Fraction
        lower <= lambda_2 <= upper; doubles unless they are equal.
    vector : tuple of int
        Has the sum zero and shows the upper bound, of a product for the factor `place`.
    above : dict
        The certificate's witness for the lower bound; empty if the network is not connected, or if
        the bounds are a closed form.
    steps : float
        Multiplications that checking the lower bound takes.
    place : int or None
        Which factor the vector belongs to, where the network is a product.
    """

    lower: Fraction
    upper: Fraction
    vector: tuple[int, ...]
    above: dict[str, Any]
    steps: float = 0.0
    place: int | None = None

    @property
    def below(self) -> dict[str, Any]:
        """The certificate's witness for the upper bound."""
        factor = {} if self.place is None else {"factor": self.place}
        return {"kind": "vector", **factor, "x": list(self.vector)}


def connectivity_bracket(network: Network) -> Gap:
    """Bracket lambda_2 by a proof in integers.

    Parameters
    ----------
    network : Network
        Two nodes or more. Up to `LARGEST` nodes the bounds are neighbouring doubles, or nearly so.

    Returns
    -------
    Gap

    Raises
    ------
    NoBracketError
        The network is too large, or no lower bound was proved.
    """
    if network.factors:
        return _of_a_product([connectivity_bracket(factor) for factor in network.factors])
    parts = network.components()
    if len(parts) > 1:
        return Gap(Fraction(0), Fraction(0), _step(network.n, parts[0]), {})
    if network.n <= LARGEST:
        return _dense_bracket(network)
    closed = _closed_form(network)
    long = closed is not None and network.n * closed.upper**2 > CHECKED
    return closed if closed is not None and long else _sparse_bracket(network)


def _of_a_product(gaps: list[Gap]) -> Gap:
    """The eigenvalues of a product are the sums of one of each factor."""
    place = min(range(len(gaps)), key=lambda k: gaps[k].upper)
    lower = min(gap.lower for gap in gaps)
    above = {"kind": "product", "parts": [gap.above for gap in gaps]}
    steps = sum(gap.steps for gap in gaps)
    return Gap(lower, gaps[place].upper, gaps[place].vector, above, steps, place)


def _closed_form(network: Network) -> Gap | None:
    """lambda_2 of a complete network, and of one that joins all of a part to all of the rest.

    With its complement the network is complete, n on all vectors of sum zero. So lambda_2 is n less
    the largest eigenvalue of the complement: 0 if that is empty, and if the d nodes outside a set
    of n - d >= d nodes without links between them are all joined to it (a star, a complete
    bipartite network), n - d, the complement being complete on the set and without links to others.
    """
    n, edges = network.n, network.edges
    if network.weights is not None:
        return None
    degree = np.bincount(edges.ravel(), minlength=n)
    least, first = int(degree.min()), int(degree.argmin())
    inside = np.ones(n, dtype=bool)
    inside[edges[(edges == first).any(axis=1)].ravel()] = False
    inside[first] = True
    between = inside[edges].all(axis=1).any()
    other = n - 1 - int(inside[::-1].argmax())
    if network.m == n * (n - 1) // 2:
        value, other = n, n - 1 if first == 0 else 0
    elif between or (degree[inside] != least).any() or n < 2 * least or other == first:
        return None
    else:
        value = least
    x = [0] * n
    x[first], x[other] = 1, -1
    return Gap(Fraction(value), Fraction(value), tuple(x), {})


def _dense_bracket(network: Network) -> Gap:
    """Two doubles, next to each other where the arithmetic allows."""
    closed = _closed_form(network)
    vector = closed.vector if closed else refined_vector(network)
    quotient = rayleigh(network, vector)
    symbolic = analyse(network.n, network.edges)
    top = nearest(quotient)
    lower = math.nextafter(below(quotient), 0.0) if Fraction(top) == quotient else below(quotient)
    step = math.ulp(lower)
    bits = 64 + network.n.bit_length() + _excess(network, step)
    while lower > 0 and (top - lower) <= WIDTH * top:
        matrix = Matrix(network, Fraction(lower), bits)
        if _proves(symbolic, matrix):
            above_item = _witness(symbolic, bits)
            upper = Fraction(above(quotient))
            return Gap(Fraction(lower), upper, vector, above_item, symbolic.operations)
        lower -= step
        step *= 4
    raise NoBracketError(f"no lower bound within {WIDTH:g} of lambda_2 could be proved")


def _sparse_bracket(network: Network) -> Gap:
    """Bounds within a few billionths of each other, or as close as can be proved."""
    symbolic = _analysed(network)
    if symbolic.operations > WORK:
        raise NoBracketError(f"an elimination of {symbolic.operations:.0e} steps is too long")
    closed = _closed_form(network)
    vector = closed.vector if closed else whole_vector(network, _mode(network, symbolic))
    quotient = rayleigh(network, vector)
    reason = "no pivots of the right signs"
    for distance in DISTANCES:
        lower = Fraction(below(quotient * (1 - Fraction(distance))))
        bits = _enough_bits(network, symbolic, distance * float(quotient))
        try:
            if _proves(symbolic, Matrix(network, lower, bits)):
                witness = _witness(symbolic, bits)
                upper = Fraction(above(quotient))
                return Gap(lower, upper, vector, witness, symbolic.operations)
        except EliminationError as error:
            reason = str(error)
    raise NoBracketError(f"no lower bound on lambda_2 could be proved: {reason}")


def _proves(symbolic: Symbolic, matrix: Matrix) -> bool:
    return negatives(symbolic, matrix) <= 1


def _witness(symbolic: Symbolic, bits: int) -> dict[str, Any]:
    return {"kind": "sparse_ldl", "order": symbolic.order.tolist(), "bits": bits}


def _analysed(network: Network) -> Symbolic:
    symbolic = analyse(network.n, network.edges)
    if symbolic.entries > STORED:
        raise NoBracketError(f"a factor of {symbolic.entries} entries is too large")
    return symbolic


def _mode(network: Network, symbolic: Symbolic) -> Mode:
    try:
        return slow_mode(network, symbolic)
    except (FactorError, MemoryError) as error:
        raise NoBracketError(f"lambda_2 could not be computed: {error}") from error


def _excess(network: Network, share: float) -> int:
    """Bits by which the root of the heaviest node, a column's unit, exceeds a share of lambda_2."""
    heaviest = float(network.laplacian().diagonal().max())
    return max(0, math.ceil(math.log2(heaviest) / 2 - math.log2(share)))


def _enough_bits(network: Network, symbolic: Symbolic, room: float) -> int:
    """Bits with which rounding costs less than `room`: each entry of a column a unit at the most.

    The units are those of square roots of diagonal entries.
    """
    columns = symbolic.entries / network.n if symbolic.entries else network.n / 4
    heaviest = float(network.laplacian().diagonal().max())
    return max(8, math.ceil(3 + math.log2(columns * math.sqrt(heaviest) / room)))


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

    if gap.upper == gap.lower:
        value = gap.upper
        return Algebraic((-value.numerator, value.denominator), value, value, nearest(value))
    if network.factors:
        return _of_factors(network, gap)
    if network.n > EXACT:
        closed = _closed_form(network)
        return exact_connectivity(network, closed) if closed else None
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
    closed = _closed_form(network)
    if closed is not None:
        return nearest(closed.upper)
    if network.n <= LARGEST:
        return nearest(rayleigh(network, refined_vector(network)))
    symbolic = analyse(network.n, network.edges)
    try:
        long = symbolic.entries > STORED or symbolic.operations > WORK
        mode = lanczos_mode(network) if long else _mode(network, symbolic)
    except NoBracketError:
        return None
    return mode.value if mode.residual <= RESIDUAL else None


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
