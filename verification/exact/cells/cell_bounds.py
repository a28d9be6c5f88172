"""Upper bounds on the gain threshold of large networks: which cells, and how much work.

Networks that look flat are split into some dozens of cells, these again, and so on: each further
level costs little, because a cell's own threshold is much smaller than the whole network's. In
networks that expand no cells are good, and every node is a cell of its own as far as that can be
afforded.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

import numpy as np

from verification.progress import tell

from ..cut_problem import Problem
from .cell_flows import Level, Schedule, reweighted
from .cell_routing import CellRouting, Integers, exact_routing, steps_of
from .cells import hierarchy, numbered
from .charts import Chart, chart
from .laplacian_solver import Floats
from .wiring import Nodes

CELLS = 48
"""Cells of the first level."""

BRANCHES = 40
"""Most cells of a cell on further levels, about."""

SMALLEST = 16
"""Cells of about so many nodes are split into single nodes."""

EVERY = 1500
"""Up to so many nodes each is a cell of its own."""

FINE = 10_000
"""Up to so many nodes many small cells are tried where some large ones do not do."""

SINGLE = 5000
"""Up to so many nodes each may be a cell of its own where that does not do either."""

LOOSE, VAGUE = Fraction(5, 4), Fraction(2)
"""Ratios of bound and best cut from which on something does not do."""

LONG = 300_000
"""Nodes from which on there are fewer rounds."""

LOCAL = (Schedule(16, 0.4, 8),)
GLOBAL = (Schedule(16, 0.4, 6), Schedule(48, 0.65, 14))
LOCAL_FEWER = (Schedule(16, 0.4, 3),)
FEWER = (Schedule(16, 0.4, 6), Schedule(48, 0.65, 8))

CROWDED, USUAL = 0.6, 1.5
"""A cell whose own load exceeds this part of the best cut known, and so many times what nine cells
in ten have, is replaced by its parts."""

KEPT = 5_000_000
"""Most potentials of a certificate, some nine bytes each."""


@dataclass
class Plan:
    """A hierarchy of cells and what the edges carry.

    Parameters
    ----------
    task : Problem
    chart : Chart
    partitions : list of ndarray of int32, shape (n,)
        All nodes in one, cells, single nodes, in the chart's order.
    """

    task: Problem
    chart: Chart
    partitions: list[Nodes]
    gamma: Floats = field(init=False)
    capacity: Floats = field(init=False)

    def __post_init__(self) -> None:
        self.gamma = _scaled(self.task.gamma)[self.chart.order]
        self.capacity = _scaled(self.task.weights)[self.chart.walk]

    def level(self, depth: int) -> Level:
        """Homes and cells of one step, 0 the coarsest."""
        home, cell = self.partitions[depth : depth + 2]
        return Level(self.chart, home, cell, self.gamma, self.capacity)

    @property
    def depth(self) -> int:
        """Number of steps."""
        return len(self.partitions) - 1


def _scaled(numbers: Sequence[int]) -> Floats:
    """Whole numbers over the largest of them, in doubles."""
    top = max(numbers) or 1
    if top < 2**53:
        return np.array(numbers, dtype=np.float64) / top
    return np.array([number / top for number in numbers])


def sizes(n: int, cells: int = CELLS) -> list[int]:
    """About how many nodes the cells of each level have."""
    top = n // cells
    if top <= 2 * SMALLEST:
        return [max(1, top), 1] if top > 1 else [1]
    levels = math.ceil(math.log(top / SMALLEST) / math.log(BRANCHES))
    ratio = (top / SMALLEST) ** (1 / levels)
    return [*(round(top / ratio**level) for level in range(levels + 1)), 1]


def route_by_cells(task: Problem, low: Fraction, steps: int) -> CellRouting:
    """Carry all disturbances of a large network with small loads.

    Parameters
    ----------
    task : Problem
        Connected, bounds not all zero.
    low : Fraction
        Load over weight of the best cut known, in the unit of the threshold.
    steps : int
        Most steps that a certificate may cost the checker; none is kept if that does not do.

    Returns
    -------
    CellRouting

    Raises
    ------
    ArithmeticError
        Weights or bounds are too unlike each other for doubles or 64 bits.
    """
    if task.even and (task.gamma[0], task.gamma_unit) != (1, 1):  # as the checker: rounded once
        gamma = Fraction(task.gamma[0], task.gamma_unit)
        found = route_by_cells(task.with_unit_bounds(), low / gamma, steps)
        return replace(found, up=found.up * gamma)
    numbers = chart(task.n, task.edges)
    unit = max(task.gamma) * Fraction(task.weight_unit, max(task.weights) * task.gamma_unit)
    goal = float(low / unit)
    if task.n <= EVERY:
        return _routed(task, numbers, [1], goal, steps, GLOBAL)
    rounds = GLOBAL if task.n < LONG else FEWER
    found = _routed(task, numbers, sizes(task.n), goal, steps, rounds)
    if task.n > FINE or found.up <= LOOSE * low:
        return found
    most = min(3 * KEPT // (4 * task.n), 32 * steps // (2 * (task.n + len(task.edges))))
    fine = [math.ceil(task.n / max(1, most)), 1] if most < task.n else [1]
    tries = [fine] if task.n > SINGLE else [fine, [1]]
    for cell_sizes in tries:
        other = _routed(task, numbers, cell_sizes, goal, steps, FEWER)
        found = min(found, other, key=lambda one: one.up)
        if found.up <= VAGUE * low:
            break
    return found


def _routed(
    task: Problem,
    numbers: Chart,
    cell_sizes: list[int],
    low: float,
    steps: int,
    schedules: tuple[Schedule, ...],
) -> CellRouting:
    """Route with cells of these sizes; `low` is over the largest bound and weight."""
    tell(f"{task.n} nodes: cells of {', '.join(map(str, cell_sizes))} nodes")
    plan = Plan(task, numbers, hierarchy(numbers.wires, cell_sizes))
    levels: list[Level] = []
    weights: list[Integers] = []
    base = np.zeros(len(plan.capacity))
    for depth in range(plan.depth - 1, 0, -1):
        level, chosen = _local(plan, depth, base, low)
        levels.insert(0, level)
        weights.insert(0, chosen)
    levels.insert(0, plan.level(0))
    found = reweighted(levels[0], base, schedules)
    weights.insert(0, found.weights)
    tell("exact flows")
    return exact_routing(task, levels, weights, _cost(levels) <= steps)


def _local(plan: Plan, depth: int, base: Floats, low: float) -> tuple[Level, Integers]:
    """Route within the homes of one level, replacing crowded homes by their cells; base grows."""
    level, local = plan.level(depth), LOCAL if plan.task.n < LONG else LOCAL_FEWER
    found = reweighted(level, base[level.edges], local)
    top = level.largest((base[level.edges] + found.loads) / level.capacity)
    crowded = top > max(CROWDED * low, USUAL * float(np.quantile(top, 0.9)))
    if crowded.any():
        home, cell = plan.partitions[depth : depth + 2]
        plan.partitions[depth] = numbered(np.where(crowded[home], cell + len(crowded), home))
        level = plan.level(depth)
        found = reweighted(level, base[level.edges], local)
    base[level.edges] += found.loads
    return level, found.weights


def _cost(levels: Sequence[Level]) -> float:
    """Steps that a certificate costs the checker; infinite if it is too long to be written."""
    if sum(level.sources * level.n for level in levels) > KEPT:
        return math.inf
    return steps_of(levels)
