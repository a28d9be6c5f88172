"""Bounds on the gain and the time of Theorem 1, compared on every connected graph on few nodes.

Thresholds come from all cuts, and lambda_2 is compared with rational numbers by the signs of the
characteristic polynomial of L - q M + J/n, whose roots are real: it has none below zero if and only
if its coefficients alternate. Nothing is rounded.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from sensortrack.networks import Network

from .small_graphs import LARGEST, connected_graphs

ROOT_DIGITS = 10**12
FORMS = ("root", "twice", "printed")
"""gamma sqrt(n/lambda_2), 2 gamma/lambda_2 and gamma sqrt(n)/lambda_2, all without the one."""


@dataclass(frozen=True)
class Compared:
    """One graph: its threshold for gamma = 1, and how the forms and the printed time compare.

    Parameters
    ----------
    network : Network
    threshold : Fraction
        Largest 2p/k of a cut.
    squared_rate : Fraction
        Smallest k^2/p of a cut: the square of the rate without disturbance at the gain 1.
    signs : dict of str to int
        For each of `FORMS` 1 if the form is above the threshold, 0 if it is equal, -1 if below.
    time : int
        The same for the rate without disturbance at the gain 1 against lambda_2, on which the
        printed time rests.
    connectivity : float
        lambda_2, for tables and figures.
    """

    network: Network
    threshold: Fraction
    squared_rate: Fraction
    signs: dict[str, int]
    time: int
    connectivity: float

    @property
    def complete(self) -> bool:
        """Whether all pairs are linked."""
        return 2 * self.network.m == self.network.n * (self.network.n - 1)

    def ratio(self, form: str) -> float:
        """The form over the threshold."""
        n, lam = self.network.n, self.connectivity
        value = {"root": math.sqrt(n / lam), "twice": 2 / lam, "printed": math.sqrt(n) / lam}
        return value[form] / float(self.threshold)


@functools.cache
def compared(largest: int = LARGEST) -> tuple[Compared, ...]:
    """Compare every connected graph from two nodes on.

    Parameters
    ----------
    largest : int, optional
        Largest number of nodes.

    Returns
    -------
    tuple of Compared
    """
    return tuple(
        compare(network) for nodes in range(2, largest + 1) for network in connected_graphs(nodes)
    )


def compare(network: Network) -> Compared:
    """Compare one graph without weights.

    Parameters
    ----------
    network : Network
        Connected, of at most some twenty nodes.

    Returns
    -------
    Compared
    """
    n = network.n
    found = [(k, Fraction(s * (n - s), n)) for k, s in all_cuts(network)]
    worst, slowest = max(2 * p / k for k, p in found), min(k * k / p for k, p in found)
    square = {"root": n / worst**2, "twice": 2 / worst}
    signs = {form: -order(network, q) for form, q in square.items()}
    signs["printed"] = -_order_root(network, n / worst**2)
    laplacian = network.laplacian().toarray()
    lam = float(np.linalg.eigvalsh(laplacian)[1])
    return Compared(network, worst, slowest, signs, -_order_root(network, slowest), lam)


def all_cuts(network: Network) -> Iterator[tuple[int, int]]:
    """Leaving links and nodes of every cut, the last node outside."""
    rows = [0] * network.n
    for i, j in network.edges.tolist():
        rows[i] |= 1 << j
        rows[j] |= 1 << i
    for code in range(1, 2 ** (network.n - 1)):
        inside = [row for i, row in enumerate(rows) if code >> i & 1]
        yield sum((row & ~code).bit_count() for row in inside), len(inside)


def order(network: Network, q: Fraction) -> int:
    """1 if lambda_2 > q, 0 if it is q, -1 if it is smaller.

    Parameters
    ----------
    network : Network
        Connected, without weights.
    q : Fraction
        Positive.

    Returns
    -------
    int
    """
    import flint

    n, (above, below) = network.n, q.as_integer_ratio()
    # n below (L - q M + 11'/n), whose eigenvalues are multiples of lambda_i - q and of 1
    rows = [[above + below - above * n * (i == j) for j in range(n)] for i in range(n)]
    for i, j in network.edges.tolist():
        rows[i][i] += n * below
        rows[j][j] += n * below
        rows[i][j] -= n * below
        rows[j][i] -= n * below
    coefficients = [int(c) for c in flint.fmpz_mat(rows).charpoly().coeffs()]
    if any(c * (-1) ** (n - k) < 0 for k, c in enumerate(coefficients)):
        return -1
    return 0 if coefficients[0] == 0 else 1


def _order_root(network: Network, square: Fraction) -> int:
    """`order` of the square root of a rational."""
    over = math.isqrt(square.numerator * ROOT_DIGITS**2 // square.denominator)
    low, high = Fraction(over, ROOT_DIGITS), Fraction(over + 1, ROOT_DIGITS)
    root = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
    if root * root == square:
        return order(network, root)
    side = order(network, low)
    if side <= 0:
        return -1
    if order(network, high) >= 0:
        return 1
    raise ArithmeticError(f"{network.label}: lambda_2 and the root of {square} are too close")


def table(largest: int = LARGEST) -> tuple[tuple[str, ...], ...]:
    """How many graphs there are, and on how many each form fails or is sharp.

    Parameters
    ----------
    largest : int, optional

    Returns
    -------
    tuple of tuple of str
        A header and a row for each number of nodes: graphs; for each form failures, equalities and
        the range of form over threshold; failures of the printed time without disturbance.
    """
    head = ["nodes", "graphs"]
    for form in FORMS:
        head += [f"{form}: fails", "sharp", "over threshold"]
    rows = [(*head, "time: fails")]
    for nodes in range(2, largest + 1):
        some = [entry for entry in compared(largest) if entry.network.n == nodes]
        cells = [str(nodes), str(len(some))]
        for form in FORMS:
            signs = [entry.signs[form] for entry in some]
            ratios = [entry.ratio(form) for entry in some]
            cells += [str(signs.count(-1)), str(signs.count(0))]
            cells.append(f"{min(ratios):.3f} to {max(ratios):.3f}")
        rows.append((*cells, str([entry.time for entry in some].count(-1))))
    return tuple(rows)
