"""Who uses whose measurements on a user's network, in which blocks, and what limits the step."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError

from ..block_inputs import Block
from .assignment import Blocks, Sources, balanced_blocks, best_sources, nearest_sources
from .inputs import Network, apart


@dataclass(frozen=True)
class Plan:
    """The schedule of one sensor.

    Parameters
    ----------
    own : int
        The sensor.
    sources : Sources
    hessian : mapping of int to Fraction
        h_i of each target that it follows.
    weights : mapping of int to Fraction
        Sum of h (1 + N) over the two coordinates of a target.
    blocks : Blocks
    """

    own: int
    sources: Sources
    hessian: Mapping[int, Fraction]
    weights: Mapping[int, Fraction]
    blocks: Blocks

    @property
    def limit(self) -> Fraction:
        """The step below which every block of the sensor is mean-square stable."""
        return 2 / self.blocks.heaviest

    @property
    def proved(self) -> bool:
        """Whether neighbours and blocks are the best ones, or were not to be."""
        return self.sources.proved and self.blocks.proved

    def schedule(self) -> dict[str, Any]:
        """Sources and blocks by names, as `sensortrack.schedules.Schedule` takes them, and k."""
        return {
            "sources": {str(i): str(q) for i, q in self.sources.sources.items()},
            "blocks": [[str(i) for i in block] for block in self.blocks.blocks],
            "k": len(self.blocks.blocks),
        }


def plans_of(network: Network) -> tuple[Plan, ...]:
    """The schedule of every sensor.

    Raises
    ------
    InputError
        A sensor and those that it hears see no target.
    """
    return tuple(plan_of(network, own) for own in range(len(network.sensors)))


def plan_of(network: Network, own: int) -> Plan:
    """The schedule of one sensor: as printed, or the best one.

    Raises
    ------
    InputError
        The sensor and those that it hears see no target.
    """
    sources = sources_of(network, own)
    if not sources.sources:
        found = f"sensor {own}, which sees no target, nor do those that it hears"
        raise InputError("sensors", found, "one with a target within reach is needed")
    hessian = {i: network.hessian(q, i) for i, q in sources.sources.items()}
    weights = {i: _weight(network, q, i, hessian[i]) for i, q in sources.sources.items()}
    if network.assignment == "best":
        blocks = balanced_blocks(weights, network.m_max)
    else:
        blocks = _in_turn(own, weights, network.m_max)
    return Plan(own, sources, hessian, weights, blocks)


def sources_of(network: Network, own: int) -> Sources:
    """Neighbours and sources of one sensor."""
    variances, heard = network.variances, network.heard(own)
    if network.assignment == "best":
        return best_sources(own, variances, heard, network.n_max)
    distances = [apart(network.sensors[own], place) for place in network.sensors]
    return nearest_sources(own, variances, distances, heard, network.n_max)


def _weight(network: Network, source: int, target: int, h: Fraction) -> Fraction:
    """Sum of h (1 + N) over both coordinates: h (2 + tr Xi/(2 beta^2) + |eta|^2/(4 beta^2))."""
    if network.instants == 1:
        return 2 * h
    spread = network.variances[source][target] or Fraction(0)
    moved = sum((x**2 for x in network.drifts[target]), Fraction(0))
    return h * (2 + spread / (2 * network.beta**2) + moved / (4 * network.beta**2))


def _in_turn(own: int, weights: Mapping[int, Fraction], m_max: int) -> Blocks:
    """The targets in their order, each sensor starting further on than the one before it."""
    seen = list(weights)
    start = own % len(seen)
    order = seen[start:] + seen[:start]
    blocks = tuple(tuple(order[i : i + m_max]) for i in range(0, len(order), m_max))
    loads = [sum((weights[i] for i in block), Fraction(0)) for block in blocks]
    return Blocks(blocks, max(loads), True, loads.index(max(loads)))


def block_of_plan(network: Network, plan: Plan, place: int) -> Block:
    """One block of a sensor, two coordinates a target, as the questions about one block have it."""
    targets = plan.blocks.blocks[place]
    size, zero = 2 * len(targets), Fraction(0)
    hessian = [[zero] * size for _ in range(size)]
    noise = [[zero] * size for _ in range(size)]
    for at, i in enumerate(targets):
        covariance = network.covariance(plan.sources.sources[i], i)
        for a in (0, 1):
            hessian[2 * at + a][2 * at + a] = plan.hessian[i]
            for b in (0, 1):
                noise[2 * at + a][2 * at + b] = covariance[a][b]
    drift = tuple(x for i in targets for x in network.drifts[i])
    rows = tuple(map(tuple, hessian))
    count = len(plan.blocks.blocks)
    return Block(rows, "h", tuple(map(tuple, noise)), drift, network.beta, network.instants, count)


def with_assignment(network: Network, assignment: str) -> Network:
    """The same network with another choice of neighbours and blocks."""
    return replace(network, assignment=assignment)
