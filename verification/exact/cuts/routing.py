"""Integer flows that carry every disturbance: an upper bound on the gain threshold.

A unit flow f^a for each node a, with divergence n - 1 at a and -1 elsewhere, carries every
disturbance u with |u_a| <= gamma_a as sum over a of u_a f^a/n, because what this leaves at each
node is u minus its mean. No edge carries more than its load, sum over a of gamma_a |f^a_e|/n, and
no cut less than its part of the disturbance: N/k is at most the largest load over an edge's weight.
Floating point only proposes flows (`flows`); conservation is restored along a tree in integers, so
that the bound is a fact about integers that are written down.

References
----------
F. T. Leighton and S. Rao, "Multicommodity max-flow min-cut theorems and their use in designing
approximation algorithms", Journal of the ACM 46 (1999): concurrent flows and sparsest cuts.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network

from ..cut_problem import Hurdle, Problem, problem
from .cut_rates import clears_all
from .flow_programs import better_flows
from .flows import Carrier, Flows, electrical_flows

UNIT_BITS = 40
"""Flows are rounded this many bits below the whole demand."""

DENOMINATORS = 360
"""Flows are tried as multiples of a unit fraction with a denominator up to this."""

NEARLY = 1e-5


def route(
    network: Network, gamma: Sequence[Fraction], cut_value: Fraction
) -> tuple[Fraction, dict[str, Any]]:
    """Route all disturbances of a connected network with small loads.

    Parameters
    ----------
    network : Network
        Connected, two nodes or more.
    gamma : sequence of Fraction
        Bound at each node, not all zero.
    cut_value : Fraction
        N/k of the best cut known. The work ends when no cut can lie above it.

    Returns
    -------
    up : Fraction
        Upper bound on the threshold.
    witness : dict
        The part ``{"kind": "routing", "unit", "flows"}`` of a certificate.
    """
    task = problem(network, gamma)
    target = task.gain_hurdle(cut_value)
    found = better_routing(task, first_routing(task), target)
    return found.up, found.part()


class Routing:
    """Integer flows, one a node, that are conserved exactly.

    Parameters
    ----------
    task : Problem
    unit : int
        Flow that stands for 1.
    flows : ndarray of int64, shape (n, m)
    """

    steps = 0
    """The checker does not count flows that are written down."""

    def __init__(self, task: Problem, unit: int, flows: NDArray[np.int64]) -> None:
        self.unit, self.flows = unit, flows
        self.up = largest_load(task, unit, flows)
        self.shares = Carrier(task).shares(flows / unit)

    def part(self) -> dict[str, Any]:
        """The witness."""
        rows = [[[int(e), int(row[e])] for e in np.flatnonzero(row)] for row in self.flows]
        return {"kind": "routing", "unit": self.unit, "flows": rows}


def first_routing(task: Problem) -> Routing:
    """Route along currents, in time n^3.

    Parameters
    ----------
    task : Problem
        Connected, bounds not all zero.
    """
    carrier = Carrier(task)
    return min(rounded(task, carrier, electrical_flows(carrier)), key=lambda routing: routing.up)


def better_routing(task: Problem, first: Routing, target: Hurdle) -> Routing:
    """Route until no cut can lie above the target, or no better routing is found.

    Parameters
    ----------
    task : Problem
        Connected, bounds not all zero.
    first : Routing
        Where to start.
    target : Hurdle
        The hurdle of the best cut known.

    Returns
    -------
    Routing
        The best that was found.
    """
    if closes(task, target, first.up):
        return first
    carrier, low = Carrier(task), task.ratio(target)

    def settled(lower: float, upper: float) -> bool:
        """Whether going on is pointless: the best routing closes, or is known not to."""
        return closes(task, target, Fraction(upper) * (1 + Fraction(1, 10**9))) or not closes(
            task, target, max(low, Fraction(lower) * (1 - Fraction(1, 10**6)))
        )

    start = first.flows / first.unit
    proposal = better_flows(carrier, start, settled)
    found = [first] if proposal is start else [first, *rounded(task, carrier, proposal)]
    return min(found, key=lambda routing: routing.up)


def closes(task: Problem, target: Hurdle, up: Fraction) -> bool:
    """Whether no cut can lie strictly above the target and not above `up`."""
    low = task.ratio(target)
    if up <= low or not task.even or low <= 0:
        return up <= low
    return clears_all(task, target, up * Fraction(task.gamma_unit, task.gamma[0]))


def largest_load(task: Problem, unit: int, flows: NDArray[np.int64]) -> Fraction:
    """Largest sum over a of gamma_a |f^a_e| over n, the unit and the weight of e.

    Parameters
    ----------
    task : Problem
    unit : int
        Flow that stands for 1.
    flows : ndarray of int64, shape (n, m)
    """
    if task.even:
        sums = [load * task.gamma[0] for load in np.abs(flows).sum(axis=0).tolist()]
    else:
        sums = (np.array(task.gamma, dtype=object) @ np.abs(flows).astype(object)).tolist()
    top = max(Fraction(load, weight) for load, weight in zip(sums, task.weights, strict=True))
    return top * Fraction(task.weight_unit, task.n * unit * task.gamma_unit)


def rounded(task: Problem, carrier: Carrier, proposal: Flows) -> list[Routing]:
    """Exact flows near a proposal: multiples of a simple fraction if it is that, and dyadic."""
    units = [2 ** max(1, UNIT_BITS - task.n.bit_length())]
    for unit in range(1, DENOMINATORS + 1):
        scaled = proposal * unit
        if np.abs(scaled - np.rint(scaled)).max() < NEARLY:
            units.insert(0, unit)
            break
    return [
        Routing(task, unit, conserved(task, carrier, unit, np.rint(proposal * unit)))
        for unit in units
    ]


def conserved(task: Problem, carrier: Carrier, unit: int, proposal: Flows) -> NDArray[np.int64]:
    """Send what a rounded flow leaves at each node along a tree.

    Parameters
    ----------
    task : Problem
    carrier : Carrier
        Holds the tree.
    unit : int
        Flow that stands for 1.
    proposal : ndarray, shape (n, m)
        Whole numbers, one flow a node.

    Returns
    -------
    ndarray of int64, shape (n, m)
        Edges leaving i minus edges entering i: unit (n [i = a] - 1) at every node i, exactly. An
        edge leaves its smaller node.

    Raises
    ------
    ArithmeticError
        The proposal is so far from a flow that 64 bits might not do.
    """
    n = task.n
    if not np.abs(proposal).max(initial=0.0) * (len(task.edges) + n) < 2.0**61:
        raise ArithmeticError("the proposed flows are not finite or too large")
    flows = proposal.astype(np.int64)
    missing = np.full((n, n), -unit, dtype=np.int64)
    missing[np.arange(n), np.arange(n)] += n * unit
    for e, (i, j) in enumerate(task.edges.tolist()):
        missing[:, i] -= flows[:, e]
        missing[:, j] += flows[:, e]
    for node, parent, edge, sign in carrier.tree:
        flows[:, edge] += sign * missing[:, node]
        missing[:, parent] += missing[:, node]
    return flows
