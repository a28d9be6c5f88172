"""Currents that carry the means of cells, congested edges conducting less and less.

Nothing here is believed: `cell_routing` rounds potentials and conductances to integers and restores
conservation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.kernels import kernel
from sensortrack.kernels.calling import call
from verification.progress import tell

from .cells import places
from .charts import Chart
from .laplacian_solver import Floats, Grounded
from .wiring import Forest, Nodes

COLUMNS = 16
"""How many sources are treated at a time."""

WEIGHT_BITS = 20
"""Conductances are whole multiples of 2^-20, at most 1."""


@dataclass(frozen=True)
class Schedule:
    """How conductances follow congestion.

    Parameters
    ----------
    exponent, floor : float
        The aim is the (2 - exponent)-th power of the relative load, which counts as no less than
        the floor.
    rounds : int
        How often they do.
    """

    exponent: float
    floor: float
    rounds: int


class Level:
    """One step of a hierarchy: homes, and the cells in each.

    The k-th cells of all homes are carried together, source k: homes share no edge.

    Parameters
    ----------
    chart : Chart
        Nodes and edges are numbered as in its `wires`.
    home, cell : ndarray of int32, shape (n,)
        Numbers from 0 on; each cell lies in one home, and homes are connected.
    gamma : ndarray of float64, shape (n,)
        Bounds on the disturbance, in any unit.
    capacity : ndarray of float64, shape (m,)
        Weights of the edges, in any unit.
    """

    def __init__(
        self, chart: Chart, home: Nodes, cell: Nodes, gamma: Floats, capacity: Floats
    ) -> None:
        wires, self.chart = chart.wires, chart
        self.n, self.home, self.cell = wires.n, home, cell
        self.edges = np.flatnonzero(home[wires.first] == home[wires.second])
        self.first, self.second = wires.first[self.edges], wires.second[self.edges]
        self.capacity = capacity[self.edges]
        self.place = places(home, cell)
        self.sources = int(self.place.max()) + 1
        self.trees: Forest = chart.trees(home)
        self.homes = int(home.max()) + 1
        self.sizes = np.bincount(home)
        self.means = np.bincount(cell, gamma) / np.bincount(cell)
        self.by_home = home[self.first]
        self.edge_order = np.argsort(self.by_home, kind="stable")
        number = np.full(len(wires.first), -1, dtype=np.int32)
        number[self.edges] = np.arange(len(self.edges))
        self.via = np.where(self.trees.roots, np.int32(-1), number[self.trees.via])
        self.cell_of = np.full((self.homes, self.sources), -1, dtype=np.int32)
        self.cell_of[home, self.place] = cell
        self.most_neighbours = wires.most_neighbours
        self.solver = Grounded(
            self.n, self.first, self.second, self.trees.roots, np.arange(self.n, dtype=np.int32)
        )
        heads = np.flatnonzero(np.diff(self.by_home[self.edge_order], prepend=-1))
        self.heads, self.occupied = heads, self.by_home[self.edge_order][heads]

    def counts(self, first: int, last: int) -> NDArray[np.int64]:
        """Nodes of the cells number first, ..., last - 1 of each home, shape (homes, number)."""
        width = last - first
        mine = (self.place >= first) & (self.place < last)
        keys = self.home[mine].astype(np.int64) * width + (self.place[mine] - first)
        return np.bincount(keys, minlength=self.homes * width).reshape(self.homes, width)

    def demand(self, first: int, last: int, plain: bool = False) -> Floats:
        """What sources first, ..., last - 1 send out at each node, shape (n, number).

        The indicator of the cell less its mean over the home, times the mean bound of the cell
        unless it shall be plain.
        """
        means = np.ones_like(self.means) if plain else self.means
        width = last - first
        mine = np.flatnonzero((self.place >= first) & (self.place < last))
        table = np.zeros((self.homes, width))
        inside = self.place[mine] - first
        table[self.home[mine], inside] = means[self.cell[mine]]
        spread = table * self.counts(first, last) / self.sizes[:, None]
        demand = -spread[self.home]
        demand[mine, inside] += means[self.cell[mine]]
        return demand

    def largest(self, values: Floats) -> Floats:
        """Largest entry in each home, shape (homes,), of one an edge; 0 where there is no edge."""
        found = np.zeros(self.homes)
        if len(values):
            found[self.occupied] = np.maximum.reduceat(values[self.edge_order], self.heads)
        return found


@dataclass(frozen=True)
class Currents:
    """Conductances of one level and what they come to.

    Parameters
    ----------
    weights : ndarray of int64, shape (edges of the level,)
        In units of 2^-20, from 1 to 2^20.
    loads : ndarray of float64, shape (edges of the level,)
        Sum over the sources of what the edge carries.
    """

    weights: NDArray[np.int64]
    loads: Floats


def blocks(level: Level) -> Iterator[tuple[int, int]]:
    """Sources in groups of a few."""
    for first in range(0, level.sources, COLUMNS):
        yield first, min(first + COLUMNS, level.sources)


def reweighted(level: Level, base: Floats, schedules: tuple[Schedule, ...]) -> Currents:
    """Find conductances whose currents, with what the edges carry already, leave no edge crowded.

    Parameters
    ----------
    level : Level
    base : ndarray, shape (edges of the level,)
        What the levels below load each edge with.
    schedules : tuple of Schedule

    Returns
    -------
    Currents
        In each home, those of the round with the smallest largest load over capacity.
    """
    conductance = level.capacity / np.maximum(level.largest(level.capacity), 1e-300)[level.by_home]
    best = np.full(level.homes, np.inf)
    kept = Currents(np.ones(len(base), dtype=np.int64), np.zeros(len(base)))
    for schedule in schedules:
        step = 1 / (schedule.exponent - 1)
        for turn in range(schedule.rounds):
            tell(f"flows within {level.homes} cells: round {turn + 1} of {schedule.rounds}")
            weights = quantised(level, conductance)
            loads = current_loads(level, weights)
            share = (base + loads) / level.capacity
            top = level.largest(share)
            better = (top < best)[level.by_home]
            best = np.minimum(best, top)
            kept = Currents(
                np.where(better, weights, kept.weights), np.where(better, loads, kept.loads)
            )
            relative = share / np.maximum(top, 1e-300)[level.by_home]
            aim = level.capacity * np.maximum(relative, schedule.floor) ** (2 - schedule.exponent)
            conductance = conductance ** (1 - step) * aim**step
    return kept


def quantised(level: Level, conductance: Floats) -> NDArray[np.int64]:
    """Conductances as whole numbers up to 2^20, in each home."""
    top = level.largest(conductance)[level.by_home]
    whole = np.rint(conductance / top * 2.0**WEIGHT_BITS)
    return np.clip(whole, 1, 2**WEIGHT_BITS).astype(np.int64)


def current_loads(level: Level, weights: NDArray[np.int64]) -> Floats:
    """What each edge carries, all sources together, shape (edges of the level,)."""
    conductance = weights / 2.0**WEIGHT_BITS
    level.solver.factorise(conductance)
    ends, loads = (level.first, level.second), np.zeros(len(weights))
    for first, last in blocks(level):
        add_loads(ends, conductance, level.solver.solve(level.demand(first, last)), loads)
    return loads


def add_loads(
    ends: tuple[Nodes, Nodes], conductance: Floats, potential: Floats, loads: Floats
) -> None:
    """Add to the loads, in place, what the currents of some potentials carry.

    Parameters
    ----------
    ends : tuple of ndarray of int32, shape (m,)
    conductance, loads : ndarray, shape (m,)
    potential : ndarray, shape (n, k)
        One column a source.
    """
    library, columns = kernel("cells").library, potential.shape[1]
    if library is not None:
        potential = np.ascontiguousarray(potential)
        arrays = (*ends, conductance, potential, loads)
        call(library.add_loads, len(loads), columns, *arrays, returns=None)
        return
    sums = [np.zeros(len(loads)) for _ in range(4)]
    for k in range(columns):
        sums[k % 4] += np.abs(potential[ends[0], k] - potential[ends[1], k])
    loads += conductance * ((sums[0] + sums[1]) + (sums[2] + sums[3]))
