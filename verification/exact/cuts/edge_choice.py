"""Which further edge lowers the gain threshold of a network most.

A new edge takes part in the cuts that it crosses: N/k becomes N/(k + w) there and stays what it is
elsewhere. So every cut that is known bounds what any edge can do. Edges are tried in the order of
these bounds; the worst cut of each network that was tried joins the known cuts; and the search ends
when no bound is below the best threshold: then no other edge does better, tried or not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network

from ..cut_problem import Aim, Hurdle, Problem, problem
from .cut_components import flat
from .cut_local import Scale
from .cut_orders import laplacian_modes
from .cut_roads import Budget
from .extreme import CutBracket, threshold

Flags = NDArray[np.bool_]

TRIED_NODES = 80
"""Up to this size networks with a further edge are solved; above, cuts of sweeps bound them."""

PAIRED_NODES = 2000
"""Up to this size all pairs of nodes are candidates; above, one pair far from the cut is."""

SOLVED = 60
"""Most networks that are solved."""

QUICK = Budget(visits=200_000, search=20_000_000, flows=300_000)
"""For each of them."""


@dataclass(frozen=True)
class EdgeChoice:
    """A further edge of weight 1.

    Parameters
    ----------
    edge : tuple of int
        Its ends, the smaller first.
    least : Fraction
        The threshold with this edge is at least this: a cut attains it.
    bracket : CutBracket or None
        Threshold of the network with the edge, where it was solved.
    best : bool
        Whether no other edge can do better.
    candidates : int
        How many edges were compared, by solving or by the cuts that they leave.
    """

    edge: tuple[int, int]
    least: Fraction
    bracket: CutBracket | None
    best: bool
    candidates: int


class _Known:
    """Cuts that are known, and what they say about each candidate."""

    def __init__(self, task: Problem, pairs: NDArray[np.int64]) -> None:
        self.task, self.pairs = task, pairs
        self.seen: set[bytes] = set()
        self.values = [Fraction(0)]
        self.floors = np.zeros(len(pairs))
        self.which = np.zeros(len(pairs), dtype=np.int64)

    def add(self, side: Flags) -> None:
        """Raise the bounds of the edges that leave this cut bad."""
        side = side if side[0] else ~side
        if side.tobytes() in self.seen or side.all():
            return
        self.seen.add(side.tobytes())
        task = self.task
        k, load, _ = task.measure(np.flatnonzero(side).tolist())
        top = Fraction(load * task.weight_unit, task.n * task.gamma_unit)
        if float(top / k) <= self.floors.min():
            return
        crosses = side[self.pairs[:, 0]] != side[self.pairs[:, 1]]
        for value, mask in ((top / k, ~crosses), (top / (k + task.weight_unit), crosses)):
            raised = mask & (self.floors < float(value))
            self.floors[raised], self.which[raised] = float(value), len(self.values)
            self.values.append(value)

    def exact(self, place: int) -> Fraction:
        """What a cut shows about a candidate."""
        return self.values[int(self.which[place])]


def choose_edge(
    network: Network, gamma: Sequence[Fraction], cut: Sequence[int], budget: Budget = QUICK
) -> EdgeChoice | None:
    """The further edge that lowers the threshold most, as far as that can be told.

    Parameters
    ----------
    network : Network
        Connected.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance, not negative.
    cut : sequence of int
        Nodes of one side of the cut that attains the threshold.
    budget : Budget, optional
        For each network that is solved.

    Returns
    -------
    EdgeChoice or None
        None if all pairs of nodes are joined already, or no disturbance is there to be carried.
    """
    network = flat(network)
    if 2 * network.m == network.n * (network.n - 1) or not any(gamma):
        return None
    task = problem(network, gamma)
    critical = _flags(network.n, cut)
    if network.n > PAIRED_NODES:
        return _far(task, critical)
    # an edge that does not cross the critical cut leaves the threshold what it is
    known = _Known(task, _pairs_across(network, critical))
    if not len(known.pairs):
        return None
    for side in _some_cuts(task, critical):
        known.add(side)
    if network.n > TRIED_NODES:
        place = int(np.argmin(known.floors))
        i, j = known.pairs[place].tolist()
        return EdgeChoice((i, j), known.exact(place), None, False, len(known.pairs))
    return _tried(network, gamma, known, budget)


def with_edge(network: Network, edge: tuple[int, int]) -> Network:
    """The network with one more edge, of weight 1, at the end of its list."""
    network = flat(network)
    edges = np.concatenate([network.edges, [edge]])
    weights = None if network.weights is None else (*network.weights, Fraction(1))
    return Network(network.names, edges, weights, (), network.label)


def _tried(
    network: Network, gamma: Sequence[Fraction], known: _Known, budget: Budget
) -> EdgeChoice:
    best: EdgeChoice | None = None
    left = np.ones(len(known.pairs), dtype=bool)
    for _ in range(SOLVED):
        place = int(np.argmin(np.where(left, known.floors, np.inf)))
        if not left.any() or (best is not None and known.exact(place) >= best.least):
            break
        left[place] = False
        i, j = known.pairs[place].tolist()
        bracket = threshold(with_edge(network, (i, j)), gamma, budget)
        known.add(_flags(network.n, bracket.cut))
        least = bracket.lower or Fraction(0)
        if best is None or least < best.least:
            best = EdgeChoice((i, j), least, bracket, False, len(known.pairs))
    assert best is not None
    assert best.bracket is not None
    beaten = all(known.exact(place) >= best.least for place in np.flatnonzero(left).tolist())
    proved = beaten and best.bracket.value == best.least
    return EdgeChoice(best.edge, best.least, best.bracket, proved, best.candidates)


def _flags(n: int, cut: Sequence[int]) -> Flags:
    side = np.zeros(n, dtype=bool)
    side[list(cut)] = True
    return side


def _pairs_across(network: Network, side: Flags) -> NDArray[np.int64]:
    """Pairs of nodes on both sides that are not joined, lexicographically."""
    one, other = np.flatnonzero(side), np.flatnonzero(~side)
    pairs = np.stack(np.meshgrid(one, other, indexing="ij"), axis=-1).reshape(-1, 2)
    pairs.sort(axis=1)
    keys = np.sort(pairs[:, 0] * network.n + pairs[:, 1])
    joined = network.edges[:, 0] * network.n + network.edges[:, 1]
    keys = keys[~np.isin(keys, joined)]
    return np.stack(np.divmod(keys, network.n), axis=-1)


def _some_cuts(task: Problem, critical: Flags) -> list[Flags]:
    """The critical cut, the best sweeps along slow modes, and the cuts of one node."""
    scale = Scale(task, Hurdle(0, 1), Aim.RATIO)
    modes = laplacian_modes(task, 4).slow
    return [critical, *(scale.sweep(mode) for mode in modes.T), *np.eye(task.n, dtype=bool)]


def _far(task: Problem, critical: Flags) -> EdgeChoice | None:
    """An edge between nodes that are far from the critical cut on its two sides."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    first, second = task.edges[:, 0], task.edges[:, 1]
    links = coo_array((np.ones(len(first)), (first, second)), shape=(task.n, task.n)).tocsr()
    leaves = critical[first] != critical[second]
    rim = np.unique(np.concatenate([first[leaves], second[leaves]]))
    depth = dijkstra(links, directed=False, indices=rim, unweighted=True, min_only=True)
    inner, outer = (
        np.argsort(np.where(mask, -depth, 1.0), kind="stable")[: int(mask.sum())]
        for mask in (critical, ~critical)
    )
    for start in inner.tolist():
        near = np.concatenate([second[first == start], first[second == start]])
        free = outer[~np.isin(outer, near)]
        if len(free):
            k, load, _ = task.measure(np.flatnonzero(critical).tolist())
            units = (k + task.weight_unit) * task.n * task.gamma_unit
            least = Fraction(load * task.weight_unit, units)
            edge = min(start, int(free[0])), max(start, int(free[0]))
            return EdgeChoice(edge, least, None, False, 1)
    return None
