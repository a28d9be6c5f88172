"""Cuts of one connected network, scaled to integers.

A cut is a set S of s of the n nodes, neither empty nor whole. It has the weight k of the edges that
leave it, the disturbance N = (1 - s/n) gamma(S) + (s/n) gamma(not S) that can drive its sides apart
and p = s (n - s)/n. Three questions are asked about all cuts of a network:

- the smallest gain b with b k >= N (largest N/k);
- the smallest k^2/p, the square of the rate that the gain above the threshold is worth;
- the smallest (beta k - N)/sqrt(p), the rate at which the error falls at the gain beta.

Only sets S that are connected and have a connected complement matter for each of them: k, N and
sqrt(p) of a cut are bounded by the sums over its connected parts in the direction that the mediant
and triangle inequalities need. On a tree these are the cuts of a single edge.

References
----------
J. George, "Distributed tracking of maneuvering target: a finite-time algorithm", Theorem 1.
D. W. Matula and F. Shahrokhi, "Sparsest cuts and bottlenecks in graphs", Discrete Applied
Mathematics 27 (1990): largest p/k, and that only connected sides matter.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network

Table = NDArray[Any]


class Aim(IntEnum):
    """What a search looks for."""

    FAILURE = 0
    """One cut that is not clear."""
    RATIO = 1
    """The cut of largest load/k."""
    RATE = 2
    """The cut of smallest (b k - c load)^2/(s (n - s)) at fixed b and c."""


@dataclass(frozen=True)
class Hurdle:
    """What a cut has to clear: D = b k - c load >= 0 and D^2 q >= d^2 s (n - s)."""

    b: int
    c: int
    q: int = 1
    d: int = 0

    def clears(self, n: int, k: int, load: int, s: int) -> bool:
        """Whether a cut of s nodes with this weight and load is clear."""
        gap = self.b * k - self.c * load
        return gap >= 0 and gap * gap * self.q >= self.d * self.d * s * (n - s)

    def marked(self, aim: Aim, n: int, k: int, load: int, s: int) -> Hurdle | None:
        """The hurdle that this cut just clears; None if the cut leaves no rate above 0."""
        if aim is Aim.RATIO:
            common = math.gcd(load, k)
            return Hurdle(load // common, k // common)
        gap = self.b * k - self.c * load
        return Hurdle(self.b, self.c, s * (n - s), gap) if gap > 0 else None


@dataclass(frozen=True)
class Problem:
    """A connected network with integer edge weights and integer bounds on the disturbance.

    Parameters
    ----------
    n : int
        Number of nodes.
    edges : ndarray of int64, shape (m, 2)
    weights : tuple of int
        One an edge: the exact weight times `weight_unit`.
    gamma : tuple of int
        One a node: the exact bound times `gamma_unit`.
    weight_unit, gamma_unit : int
        Common denominators.
    """

    n: int
    edges: NDArray[np.int64]
    weights: tuple[int, ...]
    gamma: tuple[int, ...]
    weight_unit: int
    gamma_unit: int

    @cached_property
    def near(self) -> tuple[dict[int, int], ...]:
        """Neighbours of each node with the weight of the edge to them."""
        rows: tuple[dict[int, int], ...] = tuple({} for _ in range(self.n))
        for (i, j), weight in zip(self.edges.tolist(), self.weights, strict=True):
            rows[i][j] = rows[j][i] = weight
        return rows

    @cached_property
    def total(self) -> int:
        """Sum of the disturbance's bounds."""
        return sum(self.gamma)

    @cached_property
    def even(self) -> bool:
        """Whether all nodes have the same bound."""
        return len(set(self.gamma)) == 1

    def with_unit_bounds(self) -> Problem:
        """The same network with the bound one at every node."""
        return replace(self, gamma=(1,) * self.n, gamma_unit=1)

    @cached_property
    def largest_loads(self) -> tuple[int, ...]:
        """Largest load of a cut of s nodes, s = 0, ..., n."""
        ranked = sorted(self.gamma, reverse=True)
        heads = [0]
        for bound in ranked:
            heads.append(heads[-1] + bound)
        inside = [
            heads[s] if 2 * s < self.n else self.total - heads[self.n - s]
            for s in range(self.n + 1)
        ]
        return tuple(self.load(s, inside[s]) for s in range(self.n + 1))

    @cached_property
    def worst(self) -> Table:
        """Largest load of a cut of low, ..., high nodes, shape (n + 1, n + 1)."""
        small = max(self.largest_loads) < 2**62
        loads: Table = np.array(self.largest_loads, dtype=np.int64 if small else np.object_)
        table: Table = np.zeros((self.n + 1, self.n + 1), dtype=loads.dtype)
        for low in range(self.n + 1):
            table[low, low:] = np.maximum.accumulate(loads[low:])
        return table

    def load(self, s: int, inside: int) -> int:
        """N times n and `gamma_unit`, of a cut of s nodes with these bounds inside."""
        return (self.n - 2 * s) * inside + s * self.total

    def measure(self, cut: Sequence[int]) -> tuple[int, int, int]:
        """Weight, load and size of a cut, given by its nodes."""
        inside = np.zeros(self.n, dtype=bool)
        inside[list(cut)] = True
        leaves = np.flatnonzero(inside[self.edges[:, 0]] != inside[self.edges[:, 1]])
        k = sum(self.weights[place] for place in leaves.tolist())
        s = int(inside.sum())
        return k, self.load(s, sum(self.gamma[i] for i in cut)), s

    def gain_hurdle(self, b: Fraction) -> Hurdle:
        """The hurdle b k >= N."""
        left, right = b.numerator * self.n * self.gamma_unit, b.denominator * self.weight_unit
        common = math.gcd(left, right)
        return Hurdle(left // common, right // common)

    def ratio(self, hurdle: Hurdle) -> Fraction:
        """The gain b of a hurdle b k >= N."""
        return Fraction(hurdle.b * self.weight_unit, hurdle.c * self.n * self.gamma_unit)

    def margin_squared(self, hurdle: Hurdle) -> Fraction:
        """The bound on k^2/p of a hurdle of the weights alone (b = 1, c = 0)."""
        return Fraction(hurdle.d**2 * self.n, hurdle.q * self.weight_unit**2)

    def rate_squared(self, hurdle: Hurdle) -> Fraction:
        """The bound on (beta k - N)^2/p of a hurdle whose b and c come from `gain_hurdle(beta)`."""
        # D is beta k - N times beta's denominator, n and both units, over a common factor: what is
        # left of all these is c, n and the unit of gamma
        return Fraction(hurdle.d**2 * self.n, hurdle.q * (hurdle.c * self.n * self.gamma_unit) ** 2)


def problem(network: Network, gamma: Sequence[Fraction]) -> Problem:
    """Scale a connected network to integers.

    Parameters
    ----------
    network : Network
        Connected, n nodes.
    gamma : sequence of Fraction, length n
        Bound on the disturbance's rate at each node, not negative.

    Returns
    -------
    Problem
    """
    weight_unit = 1
    weights = (1,) * network.m
    if network.weights is not None:
        weight_unit = math.lcm(*(weight.denominator for weight in network.weights))
        weights = tuple(int(weight * weight_unit) for weight in network.weights)
    gamma_unit = math.lcm(*{bound.denominator for bound in gamma})
    bounds = tuple(bound.numerator * (gamma_unit // bound.denominator) for bound in gamma)
    return Problem(network.n, network.edges, weights, bounds, weight_unit, gamma_unit)
