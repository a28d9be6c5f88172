"""Exact runs of sign-based consensus, read in Filippov's sense, from one event to the next.

The error of the consensus obeys the inclusion x' in -beta B W SGN(B'x) + M u. While u is constant
it is the gradient flow of the convex function beta TV(x) - u'Mx, so that exactly one run starts at
each point, and its velocity is the element of smallest norm of the right-hand side. Neighbours with
equal values that stay together form a group and have one velocity. The edges between groups pull
with all their strength; inside a set of neighbours of equal value the velocity is what remains of
the pull after the edges have evened it out as far as they can, which is the same problem as the
implicit step: `levelled` solves it, tells which nodes stay together, and gives the edge signs.

Between events all moves along straight lines; an event is the meeting of neighbours. Only the
groups that meet are solved again. There are finitely many events: the right-hand side keeps its old
velocity v as an element when values meet, so that the new one, if it differs, is strictly shorter,
and there are finitely many velocities in all.

References
----------
H. Brezis, *Opérateurs maximaux monotones* (1973), theorem 3.1: smallest element.
A. F. Filippov, *Differential Equations with Discontinuous Righthand Sides* (1988).
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TypeVar

from sensortrack.errors import SensorTrackError
from sensortrack.networks import Network

from ..rationals import nearest
from .prox import Numbers, centred, levelled

Key = TypeVar("Key", bound=Hashable)
Point = tuple[Fraction, ...]
End = tuple[Fraction, tuple["Group", ...]]
Phase = tuple[Fraction, Numbers] | tuple[Fraction, Numbers, Network]
"""How long it lasts, the disturbance at each node, and the links meanwhile if they are others."""

LONGEST = 10**6
"""Nodes of all the sets that are solved, one after the other."""

BITS = 10**4
"""Of a denominator."""


class LongRunError(SensorTrackError):
    """The run has more or longer events than are followed."""


@dataclass(frozen=True)
class Piece:
    """A straight piece of a run.

    Parameters
    ----------
    duration : Fraction
        Positive.
    disturbance : tuple of Fraction
        u, one number a node.
    signs : tuple of Fraction
        The selection of the edges' signs, from -1 to 1.
    network : Network
        Whose edges these are.
    """

    duration: Fraction
    disturbance: Point
    signs: Point
    network: Network


@dataclass(frozen=True, eq=False)
class Group:
    """Neighbours that move together: at the time t they are at start + rate t."""

    nodes: Sequence[int]
    start: Fraction
    rate: Fraction

    def at(self, time: Fraction) -> Fraction:
        """Where they are."""
        return self.start + self.rate * time


@dataclass(frozen=True)
class Run:
    """A run of the error in straight pieces.

    Parameters
    ----------
    start : tuple of Fraction
        The error at the start, of mean zero in each component.
    pieces : tuple of Piece
    ends : tuple of (Fraction, tuple of Group)
        The end of each piece, on the clock of its disturbance, and the group of each node.
    """

    start: Point
    pieces: tuple[Piece, ...]
    ends: tuple[End, ...]

    @cached_property
    def points(self) -> tuple[Point, ...]:
        """The error at the start and at the end of each piece."""
        return (self.start, *(_point(*end) for end in self.ends))

    @property
    def times(self) -> tuple[Fraction, ...]:
        """When the run is at each of the points."""
        times = [Fraction(0)]
        for piece in self.pieces:
            times.append(times[-1] + piece.duration)
        return tuple(times)

    @property
    def agreement(self) -> Fraction | None:
        """When the error is zero for the first time; None if it never is."""
        pairs = zip(self.times, self.points, strict=True)
        return next((time for time, point in pairs if not any(point)), None)

    def at(self, time: Fraction) -> Point:
        """The error at a time within the run.

        Raises
        ------
        ValueError
            The run is shorter, or the time negative.
        """
        times = self.times
        for k, piece in enumerate(self.pieces):
            if times[k] <= time <= times[k + 1]:
                share = (time - times[k]) / piece.duration
                ends = zip(self.points[k], self.points[k + 1], strict=True)
                return tuple(a + share * (b - a) for a, b in ends)
        if time != times[-1]:
            raise ValueError(f"time: {time}; from 0 to {times[-1]} is known")
        return self.points[-1]


def filippov_run(
    network: Network,
    beta: Fraction,
    x0: Numbers,
    phases: Iterable[Phase] | None = None,
    longest: int = LONGEST,
) -> Run:
    """Follow the error from a start.

    Parameters
    ----------
    network : Network
        Of any number of components, each on its own.
    beta : Fraction
        Gain, positive.
    x0 : sequence of Fraction, length n
        Projected to mean zero in each component.
    phases : iterable of (Fraction, sequence of Fraction) or with a Network, optional
        Durations and constant disturbances, one after the other, each with its own links between
        the same nodes if these switch: M still belongs to `network`. Without phases there is no
        disturbance, and the run ends when the last component has come to agree.
    longest : int, optional
        Nodes of all the sets that may be solved, one after the other.

    Returns
    -------
    Run

    Raises
    ------
    LongRunError
        The run has more events, or its numbers more digits, than are followed.
    """
    x = start = tuple(centred(network, x0))
    pieces: list[Piece] = []
    ends: list[End] = []
    zero = (Fraction(0),) * network.n
    for duration, u, *others in [(None, zero)] if phases is None else phases:
        (links,) = others or (network,)
        motion = _Motion(links, beta, x, centred(network, u), longest)
        for span, end, signs in motion.events(duration):
            pieces.append(Piece(span, tuple(u), signs, links))
            ends.append(end)
        longest = motion.left
        x = _point(*ends[-1]) if ends else x
    return Run(start, tuple(pieces), tuple(ends))


def _point(time: Fraction, groups: Sequence[Group]) -> Point:
    """Where the nodes are."""
    values = {group: group.at(time) for group in groups}
    return tuple(values[group] for group in groups)


class _Motion:
    """The motion under one disturbance; velocities are counted in multiples of 1/unit."""

    def __init__(
        self, network: Network, beta: Fraction, x: Numbers, push: Numbers, longest: int
    ) -> None:
        self.left = longest
        self.edges: list[list[int]] = network.edges.tolist()
        self.near: list[list[int]] = [[] for _ in x]
        for e, ends in enumerate(self.edges):
            for i in ends:
                self.near[i].append(e)
        capacities = [beta * w for w in network.exact_weights()]
        self.unit = math.lcm(*(v.denominator for v in (*capacities, *push)))
        self.capacity = [int(c * self.unit) for c in capacities]
        self.push = [int(v * self.unit) for v in push]
        self.signs = [Fraction((x[i] > x[j]) - (x[i] < x[j])) for i, j in self.edges]
        self.group = [Group((i,), value, Fraction(0)) for i, value in enumerate(x)]
        self.meetings: list[tuple[float, Fraction, int, int, Group, Group]] = []
        self.count = itertools.count()
        level = [e for e, sign in enumerate(self.signs) if not sign]
        self._solve(self._sets(level, self.group), Fraction(0))

    def events(self, duration: Fraction | None) -> Iterator[tuple[Fraction, End, Point]]:
        """Each piece's length, end and signs, up to a time or to the end of all motion."""
        time = Fraction(0)
        while self.meetings and (duration is None or self.meetings[0][1] < duration):
            then = self.meetings[0][1]
            met = []
            while self.meetings and self.meetings[0][1] == then:
                *_, e, one, other = heapq.heappop(self.meetings)
                if [one, other] == self._ends(e):
                    met.append(e)
            if met:
                yield then - time, (then, tuple(self.group)), tuple(self.signs)
                time = then
                self._solve(self._sets(met), then)
        if duration is not None and duration > time:
            yield duration - time, (duration, tuple(self.group)), tuple(self.signs)

    def _ends(self, e: int) -> list[Group]:
        return [self.group[i] for i in self.edges[e]]

    def _sets(self, met: Sequence[int], alone: Sequence[Group] = ()) -> list[list[int]]:
        """Nodes of the groups that edges with level ends join, and of groups by themselves."""
        near: dict[Group, list[Group]] = {group: [] for group in alone}
        for e in met:
            one, other = self._ends(e)
            near.setdefault(one, []).append(other)
            near.setdefault(other, []).append(one)
        return [[i for group in found for i in group.nodes] for found in _components(near)]

    def _solve(self, sets: Sequence[list[int]], time: Fraction) -> None:
        """Give each set of level neighbours its new groups, and note whom these will meet."""
        changed = [group for nodes in sets for group in self._solved(nodes, time)]
        seen: set[int] = set()
        for group in changed:
            for e in (e for i in group.nodes for e in self.near[i]):
                one, other = self._ends(e)
                closing = self.signs[e] * (other.rate - one.rate)
                if one is not other and closing > 0 and e not in seen:
                    seen.add(e)
                    then = (one.start - other.start) / (other.rate - one.rate)
                    key = nearest(then), then, next(self.count)  # doubles are compared first
                    heapq.heappush(self.meetings, (*key, e, one, other))

    def _solved(self, nodes: list[int], time: Fraction) -> list[Group]:
        """New groups of a set of neighbours with one value."""
        self.left -= len(nodes)
        if self.left < 0:
            raise LongRunError("the run has more events than are followed")
        at = {node: place for place, node in enumerate(nodes)}
        pull, inner = [self.push[i] for i in nodes], []
        for i in nodes:
            for e in self.near[i]:
                first, second = self.edges[e]
                if first in at and second in at:
                    if i == first:
                        inner.append(e)
                else:
                    pull[at[i]] -= int(self.signs[e]) * self.capacity[e] * (1 if i == first else -1)
        links = [(at[self.edges[e][0]], at[self.edges[e][1]], self.capacity[e]) for e in inner]
        found = levelled(links, pull)
        near: dict[int, list[int]] = {i: [] for i in nodes}
        for e, (i, j, capacity), flow in zip(inner, links, found.flows, strict=True):
            self.signs[e] = flow / capacity
            if found.values[i] == found.values[j]:
                near[nodes[i]].append(nodes[j])
                near[nodes[j]].append(nodes[i])
        value, groups = self.group[nodes[0]].at(time), []
        if value.denominator.bit_length() > BITS:
            raise LongRunError(f"the run's numbers have more than {BITS} binary digits")
        for members in _components(near):
            rate = found.values[at[members[0]]] / self.unit
            groups.append(Group(tuple(members), value - rate * time, rate))
            for i in members:
                self.group[i] = groups[-1]
        return groups


def _components(near: Mapping[Key, Sequence[Key]]) -> list[list[Key]]:
    """Connected sets of a graph given by the neighbours of each node."""
    seen: set[Key] = set()
    found = []
    for start in near:
        if start not in seen:
            seen.add(start)
            walk = [start]
            for node in walk:
                for other in near[node]:
                    if other not in seen:
                        seen.add(other)
                        walk.append(other)
            found.append(walk)
    return found
