"""Flows of smallest largest load, by linear programming in floating point.

Small networks: one program with a flow on every edge in both directions for every node. Larger
ones: column generation, whose master mixes for each node the flows it starts from and trees of
shortest paths, and whose dual prices are the lengths along which the next trees are grown.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix, hstack, identity, kron

from .flows import Carrier, Flows

ONE_PROGRAM = 12_000
"""Largest n m for the program with all flows at once."""

MIXTURES = 70_000
"""Largest n m for column generation."""

ROUNDS = 40
KEPT = 6
"""For how many rounds a tree stays in the master without being used."""

INERTIA = 0.6
"""Share of the former lengths that is kept, which calms the prices."""


@dataclass
class _Columns:
    """Flows of the linear program with the node that each belongs to and its last round of use."""

    flows: list[Flows]
    nodes: list[int]
    used: list[int]

    def add(self, flows: Flows, active: list[int], round_: int) -> None:
        self.flows += [flows[a] for a in active]
        self.nodes += active
        self.used += [round_] * len(active)

    def forget(self, share: Flows, round_: int) -> None:
        """Drop what has not been used for some rounds."""
        for place in np.flatnonzero(share > 1e-12):
            self.used[place] = max(self.used[place], round_)
        keep = [place for place, used in enumerate(self.used) if used > round_ - KEPT]
        self.flows = [self.flows[place] for place in keep]
        self.nodes = [self.nodes[place] for place in keep]
        self.used = [self.used[place] for place in keep]


def better_flows(carrier: Carrier, start: Flows, settled: Callable[[float, float], bool]) -> Flows:
    """Make the largest load as small as the size of the network allows.

    Parameters
    ----------
    carrier : Carrier
    start : ndarray, shape (n, m)
        Conserved flows, one a node.
    settled : callable
        Told a lower bound on the largest load of any routing and the largest load reached; True
        ends the work.

    Returns
    -------
    ndarray, shape (n, m)
    """
    shares = carrier.shares(start)
    top = float(shares.max())
    centre = (shares / top) ** 8 + 1e-3
    trees = [carrier.trees(length) for length in (centre, np.sqrt(centre), centre**2)]
    lower = max(bound for _, bound in trees)
    size = carrier.n * carrier.m
    if size > MIXTURES or settled(lower * carrier.value, top * carrier.value):
        return start
    if size <= ONE_PROGRAM:
        found = _all_flows(carrier)
        return start if found is None else found
    return _mixtures(carrier, start, [flows for flows, _ in trees], centre, settled)


def _mixtures(
    carrier: Carrier,
    start: Flows,
    trees: list[Flows],
    centre: Flows,
    settled: Callable[[float, float], bool],
) -> Flows:
    """Column generation from some trees and from lengths that suit them."""
    active = [a for a in range(carrier.n) if carrier.gamma[a] > 0]
    columns = _Columns([], [], [])
    columns.add(start, active, ROUNDS)
    best, best_load, lower = start, float(carrier.shares(start).max()), 0.0
    for round_ in range(ROUNDS):
        for flows in trees:
            columns.add(flows, active, round_)
        solved = _master(carrier, columns)
        if solved is None:
            break
        mixed, share, prices = solved
        mixed[carrier.gamma == 0] = start[carrier.gamma == 0]
        load = float(carrier.shares(mixed).max())
        if load < best_load:
            best, best_load = mixed, load
        columns.forget(share, round_)
        centre = INERTIA * centre / (centre @ carrier.capacity) + (1 - INERTIA) * prices
        grown = [
            carrier.trees(length + 1e-9 * length.max())
            for length in (centre, prices + 1e-6 * centre)
        ]
        trees = [flows for flows, _ in grown]
        lower = max(lower, *(bound for _, bound in grown))
        if settled(lower * carrier.value, best_load * carrier.value):
            break
    return best


def _master(carrier: Carrier, columns: _Columns) -> tuple[Flows, Flows, Flows] | None:
    """Best mixture of the columns.

    Returns
    -------
    flows : ndarray, shape (n, m)
    share : ndarray
        Of each column.
    prices : ndarray, shape (m,)
        Dual prices of the edges' capacities.
    """
    count, m = len(columns.nodes), carrier.m
    nodes = np.array(columns.nodes)
    matrix = csc_matrix(np.abs(np.array(columns.flows)).T)
    load = matrix.multiply(carrier.gamma[nodes][None, :] / carrier.n)
    limits = hstack([load, csc_matrix(-carrier.capacity[:, None])], format="csc")
    places, rows = np.unique(nodes, return_inverse=True)
    shape = (len(places), count + 1)
    mixtures = coo_matrix((np.ones(count), (rows, np.arange(count))), shape=shape).tocsc()
    cost = np.zeros(count + 1)
    cost[-1] = 1
    found = _solved(cost, limits, mixtures, np.ones(len(places)))
    if found is None:
        return None
    solution, prices = found
    share = np.maximum(solution[:-1], 0)
    share /= np.bincount(rows, share)[rows]
    flows = np.zeros((carrier.n, m))
    for place in np.flatnonzero(share):
        flows[nodes[place]] += share[place] * columns.flows[place]
    return flows, share, prices / (prices @ carrier.capacity)


def _all_flows(carrier: Carrier) -> Flows | None:
    """The best flows, by one program with two variables for each node and edge."""
    n, m = carrier.n, carrier.m
    incidence = csc_matrix(carrier.incidence[1:])  # the first node's balance follows
    one = kron(identity(n), incidence, format="csc")
    balance = hstack([one, -one, csc_matrix((n * (n - 1), 1))], format="csc")
    load = kron(carrier.gamma[None, :] / n, identity(m), format="csc")
    limits = hstack([load, load, csc_matrix(-carrier.capacity[:, None])], format="csc")
    cost = np.zeros(2 * n * m + 1)
    cost[-1] = 1
    found = _solved(cost, limits, balance, (n * np.eye(n) - 1)[:, 1:].ravel())
    if found is None:
        return None
    forward, backward = found[0][: n * m], found[0][n * m : 2 * n * m]
    return (forward - backward).reshape(n, m)


def _solved(
    cost: Flows, limits: csc_matrix, balance: csc_matrix, wanted: Flows
) -> tuple[Flows, Flows] | None:
    """x >= 0 of least cost with limits x <= 0 and balance x = wanted, and prices of the limits."""
    from scipy.optimize import linprog

    arguments: dict[str, Any] = {"A_ub": limits, "A_eq": balance, "b_eq": wanted}
    found: Any = linprog(cost, b_ub=np.zeros(limits.shape[0]), method="highs", **arguments)
    if not found.success:
        return None
    prices = np.maximum(-found.ineqlin.marginals, 0)
    return np.asarray(found.x, dtype=np.float64), np.asarray(prices, dtype=np.float64)
