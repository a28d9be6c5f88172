"""Bad cuts of networks that are too large to search: from coarse to fine, with exact minimum cuts.

The network is made coarse by pairing neighbours until a few thousand nodes are left. There, sweeps
along slow modes give cuts; minimum cuts in bands around them and annealing make them worse. On the
way back to the network itself each level does the same in narrower bands. Nothing here is a proof
that no cut is worse: a cut is the attained side of a bracket.

References
----------
G. Karypis and V. Kumar, "A fast and high quality multilevel scheme for partitioning irregular
graphs", SIAM Journal on Scientific Computing 20 (1998).
P. Sanders and C. Schulz, "Engineering multilevel graph partitioning algorithms", European
Symposium on Algorithms (2011): bands and minimum cuts as refinement.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from sensortrack.errors import InputError
from sensortrack.kernels import kernel
from sensortrack.networks import Network

from ..cut_problem import Aim, Hurdle, Problem, problem
from .band_cuts import band_cuts, improved
from .cut_annealing import Schedule, annealed
from .cut_graph import CutGraph, Flags, Floats, Nodes, Scales, coarser, graph_of
from .cut_lines import lines_of, worst_along

ANY_LOAD = Hurdle(0, 1)
SHRINK = 0.95
"""A pairing that leaves more than this share of the nodes is the last."""

LONG = 300_000
"""Nodes from which on everything is tried once."""


WARM = Schedule(0.4, 0.1, 50)
HOT = Schedule(0.5, 0.1, 2000)


@dataclass(frozen=True)
class Effort:
    """How much is tried.

    Parameters
    ----------
    direct : int
        Up to this size slow modes are those of the graph itself.
    coarsest : int
        Nodes that a larger graph is made coarse to.
    kept : int
        Cuts that go from level to level.
    band : int
        Most nodes of a band, beside a share of a quarter of the nodes of small graphs.
    rounds : int
        How often a cut is shaken on the coarsest level; less often on larger ones.
    tries : int
        How often the graph is made coarse anew; once if it is `LONG` or longer.
    warm : Schedule
        Annealing that shakes a cut.
    hot : Schedule
        Annealing from a random cut, on the coarsest level.
    """

    direct: int = 12_000
    coarsest: int = 4000
    kept: int = 4
    band: int = 30_000
    rounds: int = 12
    tries: int = 3
    warm: Schedule = WARM
    hot: Schedule = HOT


USUAL = Effort()
WITHOUT_COMPILER = Effort(2000, 1000, 2, 5000, 2, 1, Schedule(0.4, 0.1, 2), Schedule(0.5, 0.1, 10))
"""Interpreted loops are some hundred times slower."""


def network_cut(
    network: Network,
    gamma: Sequence[Fraction],
    *,
    conductances: Floats | None = None,
    effort: Effort | None = None,
    seed: int = 0,
) -> tuple[int, ...]:
    """A cut of large N/k of a connected network.

    Parameters
    ----------
    network : Network
        Connected, two nodes or more.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance, not negative.
    conductances : ndarray, shape (m,), optional
        Positive; small where a good routing finds little room: slow modes with these instead of
        the weights point at bottlenecks.
    effort : Effort, optional
    seed : int, optional

    Returns
    -------
    tuple of int
        Nodes of one side, increasing.

    Raises
    ------
    InputError
        The network is not connected or has one node.
    """
    if network.n < 2 or not network.is_connected():
        raise InputError("graph", "not connected", "one component of two nodes or more is needed")
    task = problem(network, gamma)
    return large_cut(task, conductances=conductances, effort=effort, seed=seed)


def large_cut(
    task: Problem,
    hurdle: Hurdle = ANY_LOAD,
    aim: Aim = Aim.RATIO,
    *,
    conductances: Floats | None = None,
    effort: Effort | None = None,
    seed: int = 0,
) -> tuple[int, ...]:
    """A cut that is hard to beat, of a connected network of any size.

    Parameters
    ----------
    task : Problem
        Two nodes or more.
    hurdle : Hurdle, optional
        Its b and c, for ``Aim.RATE``.
    aim : Aim, optional
        ``RATIO`` or ``RATE``.
    conductances : ndarray, shape (m,), optional
        As in `network_cut`.
    effort : Effort, optional
    seed : int, optional
        Of pairings and annealing.

    Returns
    -------
    tuple of int
        Nodes of one side, increasing.
    """
    if effort is None:
        effort = USUAL if kernel("mincut").library is not None else WITHOUT_COMPILER
    graph, scales = graph_of(task, hurdle, aim, conductances)
    tries = effort.tries if effort.direct < graph.n < LONG else 1
    best = _one_try(graph, scales, effort, seed)
    for turn in range(1, tries):
        other = _one_try(graph, scales, effort, seed + turn)
        best = _melted(graph, scales, best, other)
    if 2 * best.sum() > graph.n:
        best = ~best
    return tuple(np.flatnonzero(best).tolist())


def _one_try(graph: CutGraph, scales: Scales, effort: Effort, seed: int) -> Flags:
    """The worst cut that is found with one choice of pairs."""
    levels, groups = _levels(graph, effort, seed)
    pool = _begun(levels[-1], scales, effort, seed)
    pool = _worst(levels[-1], scales, pool, effort.kept)
    for level, group in zip(levels[-2::-1], groups[::-1], strict=True):
        pool = [improved(level, scales, side[group], _widest(level, effort)) for side in pool]
        pool.append(_worst_single(level, scales))
        kept = max(1, min(effort.kept, effort.band * effort.kept // level.n))
        pool = _shaken(level, scales, _worst(level, scales, pool, kept), effort, seed)
    return _worst(graph, scales, pool, 1)[0]


def _levels(graph: CutGraph, effort: Effort, seed: int) -> tuple[list[CutGraph], list[Nodes]]:
    """The graph, coarser and coarser, and the node of the next level that holds each node."""
    levels, groups = [graph], []
    while levels[-1].n > (effort.direct if len(levels) == 1 else effort.coarsest):
        coarse, group = coarser(levels[-1], effort.coarsest, 100 * seed + len(levels))
        if coarse.n > SHRINK * levels[-1].n:
            break
        levels.append(coarse)
        groups.append(group)
    return levels, groups


def _begun(graph: CutGraph, scales: Scales, effort: Effort, seed: int) -> list[Flags]:
    """Cuts of the coarsest graph, by all roads."""
    cuts = [_worst_single(graph, scales)]
    if graph.n <= 2 * effort.direct:
        swept = [worst_along(graph, scales, line) for line in lines_of(graph)]
        cuts += _worst(graph, scales, swept, 2 * effort.kept)
    chance = np.random.default_rng(seed).random(graph.n) < 0.5
    if chance.any() and not chance.all():
        cuts.append(annealed(graph, scales, chance, effort.hot, seed))
    cuts = [improved(graph, scales, side, _widest(graph, effort)) for side in cuts]
    return _shaken(graph, scales, cuts, effort, seed)


def _widest(graph: CutGraph, effort: Effort) -> int:
    """Most nodes of a band around a cut."""
    return max(min(graph.n // 4, effort.band), 50)


def _shaken(
    graph: CutGraph, scales: Scales, pool: list[Flags], effort: Effort, seed: int
) -> list[Flags]:
    """Cuts annealed a little, improved again, and melted with the worst one."""
    rounds = max(len(pool), effort.rounds * effort.direct // max(graph.n, effort.direct))
    pool = _worst(graph, scales, pool, len(pool))
    for turn in range(rounds):
        place = turn % len(pool)
        moved = annealed(graph, scales, pool[place], effort.warm, seed + turn)
        moved = improved(graph, scales, moved, _widest(graph, effort))
        moved = _melted(graph, scales, pool[0], moved)
        if scales.of(graph, moved) > scales.of(graph, pool[place]):
            pool[place] = moved
            pool = _worst(graph, scales, pool, len(pool))
    return pool


def _melted(graph: CutGraph, scales: Scales, one: Flags, other: Flags) -> Flags:
    """The worst cut between two: any of the nodes in which they differ may change sides."""
    if (one != other).sum() > graph.n / 2:
        other = ~other
    cuts = [one, other]
    value = max(scales.of(graph, side) for side in cuts)
    if 0 < value < np.inf and (one != other).any():
        cuts += band_cuts(graph, scales, one, one != other, value)
    return max(cuts, key=lambda side: scales.of(graph, side))


def _worst(graph: CutGraph, scales: Scales, cuts: list[Flags], count: int) -> list[Flags]:
    """The worst of some cuts, each once."""
    distinct = {(side if side[0] else ~side).tobytes(): side for side in cuts}.values()
    return sorted(distinct, key=lambda side: -scales.of(graph, side))[:count]


def _worst_single(graph: CutGraph, scales: Scales) -> Flags:
    degrees = np.bincount(graph.first, graph.weight, graph.n)
    degrees += np.bincount(graph.second, graph.weight, graph.n)
    single = np.zeros(graph.n, dtype=bool)
    single[int(np.argmax(scales.badness(graph, degrees, graph.size, graph.gamma)))] = True
    return single
