"""Whose measurements a sensor uses, and which targets share a block: small exact optimisations.

A sensor sees some targets (the matrix B_t), may talk to some sensors (C_t), listens to at most
n_max of them, and updates at most m_max targets at a time. Neighbours are chosen such that as few
targets as possible remain without a measurement, then for the smallest sum of variances, then for
the smallest largest one. The targets are divided into as few blocks as m_max allows, such that the
heaviest block is as light as possible: the step is limited by 2 over its weight.

Both search all choices but those that a bound rules out, and say so if they had to stop before.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import lcm
from typing import TypeVar

T = TypeVar("T")
VISITS = 20_000
"""Divisions that are looked at before a search stops without a proof."""

DEEPEST = 300
"""Targets up to which divisions are searched."""

WORK = 4_000_000
"""Variances that a search for neighbours compares before it stops without a proof."""

Score = tuple[int, Fraction, Fraction]
"""Targets without a measurement, sum of variances, largest variance."""

Table = Sequence[Sequence[Fraction | None]]
"""A variance for each sensor and target; None where the sensor does not see the target."""


@dataclass(frozen=True)
class Sources:
    """Whose measurement of each target a sensor uses.

    Parameters
    ----------
    neighbours : tuple of int
        Sensors that it listens to, in increasing order.
    sources : mapping of int to int
        Target to sensor.
    score : tuple
        Targets that remain without a measurement, sum and maximum of the variances.
    proved : bool
        Whether no other choice has a smaller score.
    """

    neighbours: tuple[int, ...]
    sources: Mapping[int, int]
    score: Score
    proved: bool


@dataclass(frozen=True)
class Blocks:
    """Targets that are updated together.

    Parameters
    ----------
    blocks : tuple of tuple of int
        The targets of each, in increasing order.
    heaviest : Fraction
        The largest sum of weights of a block.
    proved : bool
        Whether no division into as many blocks has a lighter heaviest one.
    critical : int
        Place of the heaviest block, the first of them.
    """

    blocks: tuple[tuple[int, ...], ...]
    heaviest: Fraction
    proved: bool
    critical: int


def best_sources(
    own: int, variances: Table, reachable: Sequence[int], n_max: int, work: int = WORK
) -> Sources:
    """The neighbours whose measurements leave the smallest score.

    Parameters
    ----------
    own : int
        The sensor.
    variances : sequence of rows of (Fraction or None)
        For each sensor and target.
    reachable : sequence of int
        Sensors that it may listen to.
    n_max : int
        Neighbours at most.
    work : int, optional
        Variances compared before it stops without a proof.

    Notes
    -----
    A neighbour whose measurements are not used is no neighbour.
    """
    candidates = [
        q for q in sorted({*reachable} - {own}) if any(x is not None for x in variances[q])
    ]
    search = _SourceSearch(own, variances, candidates, n_max, work)
    found = _sources(own, variances, search.best, search.left > 0)
    return replace(found, neighbours=tuple(sorted({*found.sources.values()} - {own})))


def nearest_sources(
    own: int, variances: Table, distances: Sequence[Fraction], reachable: Sequence[int], n_max: int
) -> Sources:
    """The paper's choice: the n_max nearest sensors, and of these and the own one the best.

    Parameters
    ----------
    own, variances, reachable, n_max
        As for `best_sources`.
    distances : sequence of Fraction
        From the sensor to each sensor, or any number that grows with it.
    """
    order = sorted({*reachable} - {own}, key=lambda q: (distances[q], q))
    return _sources(own, variances, tuple(order[:n_max]), True)


def _sources(own: int, variances: Table, chosen: Sequence[int], proved: bool) -> Sources:
    sources = {}
    for i in range(len(variances[own])):
        seen = [(x, q != own, q) for q in (own, *chosen) if (x := variances[q][i]) is not None]
        if seen:
            sources[i] = min(seen)[2]
    used = [variances[q][i] for i, q in sources.items()]
    return Sources(
        tuple(sorted(chosen)), sources, _score([*used, *_holes(variances, own, sources)]), proved
    )


def _holes(variances: Table, own: int, sources: Mapping[int, int]) -> list[None]:
    return [None] * (len(variances[own]) - len(sources))


def _score(least: Sequence[Fraction | None]) -> Score:
    known = [x for x in least if x is not None]
    return len(least) - len(known), sum(known, Fraction(0)), max(known, default=Fraction(0))


class _SourceSearch:
    """Every set of at most n_max candidates, but those that cannot beat the best so far.

    A missing measurement counts as a variance above all sums, so that a set's score is the sum of
    its least variances and the largest of them. What several sensors gain together is at most the
    sum of what each of them gains: a set of r more is no better than the r largest gains say.
    """

    def __init__(
        self, own: int, variances: Table, candidates: list[int], n_max: int, work: int
    ) -> None:
        known = [x for row in variances for x in row if x is not None]
        unit = lcm(*(x.denominator for x in known))  # integers are quicker
        self.hole = hole = int(sum(known, Fraction(1)) * unit) + 1
        rows = {q: [hole if x is None else int(x * unit) for x in variances[q]] for q in candidates}
        start = [hole if x is None else int(x * unit) for x in variances[own]]
        alone = {q: (self._total(_lower(start, row)), q) for q, row in rows.items()}
        self.candidates = sorted(candidates, key=alone.__getitem__)  # good choices are met early
        self.rows, self.n_max, self.left = rows, n_max, work
        self.best: tuple[int, ...] = ()
        self.score = self._total(start)
        self._greedy(start)
        self.visit(0, (), start)

    def _total(self, least: list[int]) -> tuple[int, int]:
        """Sum, and the largest variance that there is."""
        return sum(least), max((x for x in least if x < self.hole), default=0)

    def _greedy(self, least: list[int]) -> None:
        while len(self.best) < self.n_max:
            found = [(self._total(_lower(least, self.rows[q])), q) for q in self.candidates]
            if not found or min(found)[0] >= self.score:
                return
            self.score, q = min(found)
            self.best, least = (*self.best, q), _lower(least, self.rows[q])

    def visit(self, place: int, chosen: tuple[int, ...], least: list[int]) -> None:
        """Look at all sets that contain `chosen` and further candidates from a place on."""
        score = self._total(least)
        if score < self.score:
            self.best, self.score = chosen, score
        more = self.n_max - len(chosen)
        reached = {q: _lower(least, self.rows[q]) for q in self.candidates[place:] if more}
        for at, (q, lower) in enumerate(reached.items(), start=place):
            if self.left <= 0 or self._bound(score[0], reached, at - place, more) >= self.score:
                return
            self.visit(at + 1, (*chosen, q), lower)

    def _bound(
        self, total: int, reached: Mapping[int, list[int]], skipped: int, more: int
    ) -> tuple[int, int]:
        """What no set of some more candidates can be below, the first ones being skipped."""
        rows = list(reached.values())[skipped:]
        self.left -= len(rows) * len(rows[0])
        gains = sorted((total - sum(row) for row in rows), reverse=True)
        # with the same sum, the largest variance may still be smaller
        largest = max(min(column) for column in zip(*rows, strict=True))
        return total - sum(gains[:more]), largest if largest < self.hole else 0


def _lower(least: list[int], more: list[int]) -> list[int]:
    """Target by target, the smaller variance."""
    return list(map(min, least, more))


def balanced_blocks(weights: Mapping[int, Fraction], m_max: int, visits: int = VISITS) -> Blocks:
    """As few blocks as m_max allows, the heaviest of them as light as possible.

    Parameters
    ----------
    weights : mapping of int to Fraction
        Target to what it adds to its block: h_i (2 + tr Xi_i/(2 beta^2)) for two instants.
    m_max : int
        Targets of a block at most.
    visits : int, optional
        Divisions looked at before it stops without a proof.
    """
    order = sorted(weights, key=lambda i: (-weights[i], i))
    count = -(-len(order) // m_max)
    unit = lcm(*(weights[i].denominator for i in order))  # integers are quicker
    search = _BlockSearch([int(weights[i] * unit) for i in order], count, m_max, visits)
    if len(order) <= DEEPEST:
        search.visit(0, [0] * count, [0] * count)
    else:
        search.left = 0
    places = search.best
    blocks = sorted(
        tuple(sorted(i for i, place in zip(order, places, strict=True) if place == u))
        for u in range(count)
    )
    loads = [sum((weights[i] for i in block), Fraction(0)) for block in blocks]
    heaviest = max(loads, default=Fraction(0))
    proved = search.left > 0 or search.heaviest <= search.least
    return Blocks(tuple(blocks), heaviest, proved, loads.index(heaviest) if loads else 0)


class _BlockSearch:
    """Every division into blocks, the heaviest targets first, but those that are no better."""

    def __init__(self, weights: list[int], count: int, m_max: int, visits: int) -> None:
        self.weights, self.m_max, self.left = weights, m_max, visits
        self.placed: list[int] = []
        self.least = max(-(-sum(weights) // count), weights[0]) if weights else 0
        self.best, self.heaviest = self._greedy(count)

    def _greedy(self, count: int) -> tuple[list[int], int]:
        """Each target into the lightest block that has room."""
        loads, sizes, places = [0] * count, [0] * count, []
        for weight in self.weights:
            u = min((x, u) for u, x in enumerate(loads) if sizes[u] < self.m_max)[1]
            loads[u] += weight
            sizes[u] += 1
            places.append(u)
        return places, max(loads, default=0)

    def visit(self, place: int, loads: list[int], sizes: list[int]) -> None:
        """Put the target at a place into each block that differs from the others."""
        self.left -= 1
        if place == len(self.weights):
            self.best, self.heaviest = list(self.placed), max(loads, default=0)
            return
        tried = set()
        for u in sorted(range(len(loads)), key=loads.__getitem__):
            weight = self.weights[place]
            state = (loads[u], sizes[u])
            known = state in tried or sizes[u] == self.m_max
            if known or self.heaviest <= self.least or self.left <= 0:
                continue
            if loads[u] + weight >= self.heaviest:
                continue
            tried.add(state)
            loads[u] += weight
            sizes[u] += 1
            self.placed.append(u)
            self.visit(place + 1, loads, sizes)
            self.placed.pop()
            loads[u] -= weight
            sizes[u] -= 1


def pieces(choices: Sequence[T], key: Callable[[T], object]) -> list[tuple[int, T]]:
    """The choices of successive samples, joined where they do not change.

    Parameters
    ----------
    choices : sequence
        One a sample, for B_t and C_t of that sample.
    key : callable
        Two choices are the same where this is.

    Returns
    -------
    list of (int, choice)
        From which sample on a choice holds.
    """
    found: list[tuple[int, T]] = []
    for t, choice in enumerate(choices):
        if not found or key(choice) != key(found[-1][1]):
            found.append((t, choice))
    return found
