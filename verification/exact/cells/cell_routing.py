"""Routings of large networks by a hierarchy of cells: exact upper bounds on the gain threshold.

A disturbance u is carried in steps: first the means of u over some cells, then within each cell the
means over smaller cells, down to single nodes. One flow for each cell carries any mean, and the
mean of a cell C is at most gamma(C)/|C|, so that an edge carries at most

    sum over the levels and the cells C of a home P of gamma(C)/(|C| |P| U) |F^C_e|,

F^C being a flow within P with net outflow U (|P| [i in C] - |C|) at each node i. Potentials and
conductances are proposed in floating point (`cell_flows`) and rounded; all that follows is done in
watched integers of 64 bits, conservation being restored along a tree. With single nodes as the only
cells this is `routing`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.kernels import kernel
from sensortrack.kernels.calling import call

from ..cut_problem import Problem
from .cell_flows import WEIGHT_BITS, Level, blocks
from .laplacian_solver import Floats

Integers = NDArray[np.int64]

FLOW_BITS = 21
"""A flow of one stands for about 2^21 units."""

SHARE_BITS = 15
"""Shares of a source in a load are whole numbers of about so many bits."""

UP_BITS = 30
"""Bits of an upper bound."""


@dataclass(frozen=True)
class ExactLevel:
    """Integers of one level, nodes and edges in the network's own order.

    Parameters
    ----------
    unit : int
        What stands for one.
    places : ndarray of int32, shape (n,)
        Number of each node's cell within its home.
    weights : ndarray of int64, shape (edges of the level,)
        Conductances in units of 2^-20.
    sources : list of ndarray of int64, shape (n,), or None
        Potentials of the sources as differences along the trees; None if they were not kept.
    """

    unit: int
    places: NDArray[np.int32]
    weights: Integers
    sources: list[Integers] | None


@dataclass(frozen=True)
class CellRouting:
    """A proved upper bound on the gain threshold of a connected network.

    Parameters
    ----------
    up : Fraction
    scale : int
        Loads are counted in units of 1/scale.
    levels : tuple of ExactLevel
        Coarsest first.
    steps : int
        What the witness costs the checker, in steps of a search.
    """

    up: Fraction
    scale: int
    levels: tuple[ExactLevel, ...]
    steps: int

    @property
    def conductances(self) -> Floats:
        """What each edge conducts, shape (m,): little at bottlenecks."""
        return self.levels[0].weights / 2.0**WEIGHT_BITS

    def part(self) -> dict[str, Any] | None:
        """The part ``{"kind": "cells", "scale", "levels"}`` of a certificate, if it was kept."""
        rows = []
        for level in self.levels:
            if level.sources is None:
                return None
            sources = [source.tolist() for source in level.sources]
            rows.append([level.unit, level.places.tolist(), level.weights.tolist(), sources])
        return {"kind": "cells", "scale": self.scale, "levels": rows}


def exact_routing(
    task: Problem, levels: Sequence[Level], weights: Sequence[Integers], keep: bool
) -> CellRouting:
    """Round and repair the currents of a hierarchy, and sum their loads.

    Parameters
    ----------
    task : Problem
        Connected, bounds not all zero.
    levels : sequence of Level
        Coarsest first; the cells of the last one are single nodes.
    weights : sequence of ndarray of int64
        Conductances of each level in units of 2^-20, from 1 to 2^20.
    keep : bool
        Whether to keep the potentials, for a certificate.

    Returns
    -------
    CellRouting

    Raises
    ------
    ArithmeticError
        64 bits do not do.
    """
    units = [_unit(level) for level in levels]
    scale = _scale(task, units[0])
    sources = sum(level.sources for level in levels)
    loads = np.zeros(len(task.edges), dtype=np.int64)
    done = []
    for level, chosen, unit in zip(levels, weights, units, strict=True):
        part = np.zeros(len(level.edges), dtype=np.int64)
        kept = _add_level(task, level, chosen, unit, scale, 2**62 // sources, part, keep)
        edges = level.chart.walk[level.edges]
        loads[edges] += part
        listed = chosen[np.argsort(edges, kind="stable")]
        done.append(ExactLevel(unit, level.place[level.chart.rank], listed, kept))
    return CellRouting(_largest(task, loads, scale), scale, tuple(done), steps_of(levels))


def steps_of(levels: Sequence[Level]) -> int:
    """What the witness of some levels costs the checker, in steps of a search."""
    return sum(1 + level.sources * (level.n + len(level.edges)) // 32 for level in levels)


def _unit(level: Level) -> int:
    """A power of two that makes flows of one about 2^FLOW_BITS units."""
    mean = level.n / level.homes
    return int(2 ** max(0, round(FLOW_BITS - math.log2(mean))))


def _scale(task: Problem, unit: int) -> int:
    """Units of loads: exact where the cells are single nodes and bounds are small."""
    mean = max(1, task.total // task.n)
    fine = SHARE_BITS - mean.bit_length()
    return task.n * unit << fine if fine >= 0 else max(1, task.n * unit >> -fine)


def _largest(task: Problem, loads: Integers, scale: int) -> Fraction:
    """The largest load over a weight, rounded up."""
    shares = loads / np.array(task.weights, dtype=float)
    near = np.flatnonzero(shares >= shares.max() * (1 - 1e-9))  # one of these is the largest
    top = max(Fraction(int(loads[e]), task.weights[e]) for e in near.tolist())
    unit = Fraction(task.weight_unit, scale * task.gamma_unit)
    return rounded_up(top * unit)


def rounded_up(value: Fraction) -> Fraction:
    """A number of UP_BITS bits that is not smaller, unless the value itself is simple."""
    if value.denominator < 2**UP_BITS:
        return value
    fine = UP_BITS - (value.numerator.bit_length() - value.denominator.bit_length())
    unit = Fraction(2) ** fine
    return Fraction(math.ceil(value * unit)) / unit


def _add_level(
    task: Problem,
    level: Level,
    weights: Integers,
    unit: int,
    scale: int,
    largest: int,
    loads: Integers,
    keep: bool,
) -> list[Integers] | None:
    """Add a level's loads in place; potentials of its sources as differences, if they are kept."""
    level.solver.factorise(weights / 2.0**WEIGHT_BITS)
    mass = _sums(task.gamma, level)
    flow = np.empty(len(loads), dtype=np.int64)
    kept: list[Integers] = []
    for first, last in blocks(level):
        potentials = level.solver.solve(level.demand(first, last, plain=True))
        potentials *= (unit * level.sizes)[level.home][:, None]
        if not np.abs(potentials).max(initial=0) < 2.0**60:
            raise ArithmeticError("the proposed potentials are not finite or too large")
        counts = level.counts(first, last)
        for k, potential in enumerate(np.ascontiguousarray(potentials.T), first):
            x = np.rint(potential).astype(np.int64)
            share = _shares(mass, counts[:, k - first], level, k, unit, scale)
            net = -unit * counts[level.home, k - first]
            mine = level.place == k
            net[mine] += unit * level.sizes[level.home[mine]]
            add_exact(
                level, weights, x, share, largest // max(1, int(share.max())), net, flow, loads
            )
            if keep:
                steps = x - np.where(level.trees.roots, 0, x[level.trees.up])
                kept.append(steps[level.chart.rank])
    return kept if keep else None


def _sums(gamma: Sequence[int], level: Level) -> list[int]:
    """Sum of the bounds of each cell."""
    cells = level.cell[level.chart.rank]
    if sum(gamma) < 2**53:
        return [int(v) for v in np.bincount(cells, np.array(gamma, dtype=float))]
    sums = [0] * (int(cells.max()) + 1)
    for cell, bound in zip(cells.tolist(), gamma, strict=True):
        sums[cell] += bound
    return sums


def _shares(
    mass: list[int], counts: Integers, level: Level, k: int, unit: int, scale: int
) -> Integers:
    """Share of source k in a load in each home, rounded up, shape (homes,)."""
    share = [0] * level.homes
    for home in np.flatnonzero(counts).tolist():
        cell = level.cell_of[home, k]
        share[home] = -(-mass[cell] * scale // (int(counts[home]) * int(level.sizes[home]) * unit))
    if max(share) >= 2**62:
        raise ArithmeticError("bounds on the disturbance are too unlike each other")
    return np.array(share, dtype=np.int64)


def add_exact(
    level: Level,
    weights: Integers,
    x: Integers,
    share: Integers,
    largest: int,
    net: Integers,
    flow: Integers,
    loads: Integers,
) -> None:
    """Repair the flow of one source and add its loads, in place.

    Parameters
    ----------
    level : Level
    weights : ndarray of int64, shape (m,)
        Conductances from 1 to 2^20, m being the number of the level's edges.
    x : ndarray of int64, shape (n,)
        Potentials below 2^61.
    share : ndarray of int64, shape (homes,)
        Factor of a load in each home.
    largest : int
        Largest flow that may occur.
    net : ndarray of int64, shape (n,)
        Outflow that is due at each node; overwritten.
    flow : ndarray of int64, shape (m,)
        Room for the flow.
    loads : ndarray of int64, shape (m,)

    Raises
    ------
    ArithmeticError
        64 bits might not do, or something is left at a root.
    """
    trees, library = level.trees, kernel("cells").library
    if level.most_neighbours >= 2**20 or np.abs(net).max() >= 2**50:
        raise ArithmeticError("too many neighbours or nodes for 64 bits")
    if library is not None:
        failed = call(
            library.add_exact, level.n, len(loads), level.first, level.second, weights, x,
            trees.up, level.via, trees.sign, trees.order, level.home, share, largest,
            net, flow, loads,
        )  # fmt: skip
    else:
        failed = _add_exact(level, weights, x, share, largest, net, flow, loads)
    if failed:
        raise ArithmeticError("the proposed flows are too large for 64 bits")
    if net[trees.roots].any():
        raise ArithmeticError("a flow is not conserved")


def _add_exact(
    level: Level,
    weights: Integers,
    x: Integers,
    share: Integers,
    largest: int,
    net: Integers,
    flow: Integers,
    loads: Integers,
) -> bool:
    """`add_exact` of cells.c: whether a number is so large that another might not fit."""
    first, second, up = level.first, level.second, level.trees.up
    difference = x[first] - x[second]
    if (np.abs(difference) > 2**62 // weights).any():
        return True
    flow[:] = (weights * difference) >> WEIGHT_BITS
    np.subtract.at(net, first, flow)
    np.add.at(net, second, flow)
    for i in level.trees.order[::-1].tolist():
        j = int(up[i])
        if i == j:
            continue
        if abs(int(net[i])) > 2**40:
            return True
        flow[level.via[i]] += level.trees.sign[i] * net[i]
        net[j] += net[i]
    if (np.abs(flow) > largest).any():
        return True
    loads += share[level.home[first]] * np.abs(flow)
    return False
