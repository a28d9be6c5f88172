"""Networks taken apart into components or factors, and witnesses put together from theirs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from sensortrack.networks import Network

from ..cut_problem import Aim, Hurdle, Problem, problem
from .cut_roads import Budget, Solved, solve

Item = dict[str, Any]

SINGLE: Item = {"kind": "tree"}
"""Witness for a component of one node, which has no cut."""


@dataclass(frozen=True)
class Component:
    """A component of two nodes or more.

    Parameters
    ----------
    place : int
        Its number among all components.
    nodes : tuple of int
        Its nodes in the whole network, increasing.
    task : Problem
        Its cuts.
    """

    place: int
    nodes: tuple[int, ...]
    task: Problem

    def whole(self, cut: Sequence[int]) -> tuple[int, ...]:
        """Nodes of a cut in the numbering of the whole network."""
        return tuple(self.nodes[i] for i in cut)


def flat(network: Network) -> Network:
    """The same network without its factors."""
    if not network.factors:
        return network
    return Network(network.names, network.edges, None, (), network.label)


def even(values: Sequence[Fraction]) -> bool:
    """Whether all values are the same."""
    first = values[0]
    return all(value is first or value == first for value in values)


def by_factors(network: Network, gamma: Sequence[Fraction]) -> bool:
    """Whether the threshold is that of one of the network's factors.

    The cut of all nodes whose coordinate lies in a cut of a factor has the same N/k; and routing
    along one factor after the other loads no edge more than the factor's own routing does.
    """
    return (
        bool(network.factors)
        and even(gamma)
        and all(not factor.factors and factor.is_connected() for factor in network.factors)
    )


def components(network: Network, gamma: Sequence[Fraction]) -> list[Component]:
    """Components of two nodes or more.

    Raises
    ------
    InputError
        There is none.
    """
    found = []
    network = flat(network)
    for place, nodes in enumerate(network.components()):
        if len(nodes) > 1:
            task = problem(network.subnetwork(nodes), [gamma[i] for i in nodes])
            found.append(Component(place, tuple(nodes), task))
    if not found:
        raise InputError("graph", "no edge", "an edge between some of the nodes is needed")
    return found


def solved(
    parts: Sequence[Component], starts: Sequence[Hurdle], aim: Aim, budget: Budget
) -> list[Solved]:
    """Solve each component; the visits of all witnesses together stay within the budget."""
    found = []
    for part, start in zip(parts, starts, strict=True):
        one = solve(part.task, start, aim, budget)
        visits = one.shown.visits if one.shown else 0
        budget = replace(budget, visits=budget.visits - visits)
        found.append(one)
    return found


def clear_item(
    network: Network, parts: Sequence[Component], shown: Sequence[Item | None]
) -> Item | None:
    """Witness for all components from those for the components of two nodes or more, if all are."""
    if any(item is None for item in shown):
        return None
    items: list[Item | None] = [SINGLE] * len(network.components())
    for part, item in zip(parts, shown, strict=True):
        items[part.place] = item
    return {"kind": "cuts", "parts": items}


def cut_item(cut: Sequence[int], factor: int | None = None) -> Item:
    """Witness that a cut attains a bound."""
    place = {} if factor is None else {"factor": factor}
    return {"kind": "cut", **place, "nodes": list(cut)}


def spread(x: Sequence[Fraction]) -> Fraction:
    """|x - mean|^2."""
    return sum((v * v for v in x), Fraction(0)) - sum(x, Fraction(0)) ** 2 / len(x)
