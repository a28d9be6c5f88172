"""Depth-first search over all cuts of a network, in C where the numbers fit, else in Python.

Nodes are decided one after the other: in S or not, the first node in S, because a cut and its
complement are the same. What is decided gives a lower bound on the weight of every completion: the
edges between the decided nodes on both sides, and for each undecided node the lighter of its links
to the two sides. Together with the largest load and the largest s (n - s) of the sizes that are
still possible this clears whole branches. Of two neighbours in the order that can be swapped
(twins) the second is in S only if the first is: the other cuts are images of these.

The road in C and the road in Python visit the same nodes in the same order.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.kernels import kernel

from ..cut_problem import Aim, Hurdle, Problem

LARGEST = 600
"""Most nodes of a network whose cuts are searched."""


@dataclass(frozen=True)
class Found:
    """What a search came to.

    Parameters
    ----------
    done : bool
        Whether all cuts were looked at (or, for ``Aim.FAILURE``, a cut was found).
    cut : tuple of int or None
        The last cut that was not clear: nodes in increasing order.
    hurdle : Hurdle
        The hurdle that all cuts pass if the search is done and not for a failure.
    visits : int
        Nodes of the search tree that were visited.
    covered : float
        Estimated share of the search tree that was visited.
    """

    done: bool
    cut: tuple[int, ...] | None
    hurdle: Hurdle
    visits: int
    covered: float


class Walk:
    """A network's cuts in one order of its nodes.

    Parameters
    ----------
    task : Problem
    order : sequence of int
        All nodes once.
    """

    def __init__(self, task: Problem, order: Sequence[int]) -> None:
        self.task, self.order = task, tuple(order)
        place = {node: i for i, node in enumerate(self.order)}
        self.later = [
            [(place[j], w) for j, w in task.near[node].items() if place[j] > i]
            for i, node in enumerate(self.order)
        ]
        self.gamma = [task.gamma[node] for node in self.order]
        self.twin = [
            i > 0 and twins(task, self.order[i - 1], node) for i, node in enumerate(self.order)
        ]

    def search(self, hurdle: Hurdle, aim: Aim, limit: int) -> Found:
        """Look for cuts that are not clear.

        Parameters
        ----------
        hurdle : Hurdle
            What a cut has to pass. Unless a failure is looked for, each cut that does not pass
            replaces it by the hurdle that it just passes.
        aim : Aim
        limit : int
            Most nodes of the search tree to visit.

        Returns
        -------
        Found
        """
        library = kernel("cuts").library
        if library is not None and self._fits(hurdle, aim):
            return self._search_in_c(library, hurdle, aim, limit)
        return self._search_in_python(hurdle, aim, limit)

    def runs_in_c(self, hurdle: Hurdle, aim: Aim) -> bool:
        """Whether a search would run in C, some hundred times as fast."""
        return kernel("cuts").library is not None and self._fits(hurdle, aim)

    def _fits(self, hurdle: Hurdle, aim: Aim) -> bool:
        """Whether no product in C leaves 127 bits and no number 62."""
        task = self.task
        k, load = sum(task.weights), max(task.largest_loads)
        b, c = hurdle.b, hurdle.c
        if aim is Aim.RATIO:
            b, c = max(b, load), max(c, k)
        gap = max(b * k, c * load)
        q = max(hurdle.q, task.n**2)
        squares = gap**2 * q if hurdle.d or aim is Aim.RATE else 0
        return (
            max(b, c, k, load, hurdle.d, q) < 2**62
            and gap < 2**126
            and max(squares, hurdle.d**2 * task.n**2) < 2**126
        )

    def _search_in_c(self, library: ctypes.CDLL, hurdle: Hurdle, aim: Aim, limit: int) -> Found:
        run = _Search(self, hurdle, aim, limit)
        status = library.sensortrack_search_cuts(ctypes.byref(run.struct))
        cut = None
        if run.struct.found:
            cut = self._cut(run.best.tolist())
        final = Hurdle(*map(int, run.struct.hurdle))
        done = status != _LIMIT
        return Found(done, cut, final, int(run.struct.visits), float(run.struct.covered))

    def _cut(self, best: Sequence[int]) -> tuple[int, ...]:
        return tuple(sorted(node for node, side in zip(self.order, best, strict=True) if side))

    def _search_in_python(self, hurdle: Hurdle, aim: Aim, limit: int) -> Found:
        """The same walk with an explicit stack and integers of any size."""
        task, n = self.task, self.task.n
        link = [[0] * n, [0] * n]
        side = [-1] * n
        cut: tuple[int, ...] | None = None
        visits, covered = 0, 0.0
        # an entry with choice -1 enters a node of the tree, any other tries a choice or undoes it
        stack = [(0, -1, 0, 0, 0, 0, 1.0)]
        while stack:
            i, choice, count, inside, k, extra, share = stack.pop()
            if choice >= 0:
                more = extra
                for u, w in self.later[i]:
                    more -= min(link[0][u], link[1][u])
                    link[choice][u] += w
                    more += min(link[0][u], link[1][u])
                side[i] = choice
                stack.append((i, choice - 4, 0, 0, 0, 0, 0.0))
                k += link[1 - choice][i]
                inside += self.gamma[i] * choice
                stack.append((i + 1, -1, count + choice, inside, k, more, share))
                continue
            if choice < -1:
                for u, w in self.later[i]:
                    link[choice + 4][u] -= w
                continue
            if visits >= limit:
                return Found(False, cut, hurdle, visits, covered)
            visits += 1
            if i == n:
                covered += share
                load = task.load(count, inside)
                if count == n or hurdle.clears(n, k, load, count):
                    continue
                cut = self._cut(side)
                better = None if aim is Aim.FAILURE else hurdle.marked(aim, n, k, load, count)
                if better is None:
                    return Found(True, cut, hurdle, visits, covered)
                hurdle = better
                continue
            high = min(n - i + count, n - 1)
            worst = int(task.worst[count, high])
            if i and hurdle.clears(n, k + extra, worst, min(max(count, n // 2), high)):
                covered += share
                continue
            extra -= min(link[0][i], link[1][i])
            choices = [c for c in (0, 1) if self._may(i, c, side)]
            # in S comes first: it is pushed last
            stack.extend((i, c, count, inside, k, extra, share / len(choices)) for c in choices)
        return Found(True, cut, hurdle, visits, covered)

    def _may(self, i: int, choice: int, side: list[int]) -> bool:
        if choice:
            return not self.twin[i] or side[i - 1] == 1
        return i > 0


def twins(task: Problem, i: int, j: int) -> bool:
    """Whether swapping two nodes leaves the network and the bounds as they are."""
    if task.gamma[i] != task.gamma[j]:
        return False
    first, second = task.near[i], task.near[j]
    if len(first) != len(second):
        return False
    return all(second.get(u) == w for u, w in first.items() if u != j)


_LIMIT = 2


class _Struct(ctypes.Structure):
    """``struct search`` of cuts.c."""

    _fields_ = (
        ("n", ctypes.c_int32),
        ("first", ctypes.c_void_p),
        ("later", ctypes.c_void_p),
        ("weight", ctypes.c_void_p),
        ("gamma", ctypes.c_void_p),
        ("twin", ctypes.c_void_p),
        ("worst", ctypes.c_void_p),
        ("total", ctypes.c_int64),
        ("mode", ctypes.c_int32),
        ("limit", ctypes.c_int64),
        ("hurdle", ctypes.c_int64 * 4),
        ("visits", ctypes.c_int64),
        ("covered", ctypes.c_double),
        ("side", ctypes.c_void_p),
        ("best", ctypes.c_void_p),
        ("link", ctypes.c_void_p),
        ("found", ctypes.c_int32),
    )


class _Search:
    """The struct and the arrays that it points to."""

    def __init__(self, walk: Walk, hurdle: Hurdle, aim: Aim, limit: int) -> None:
        n = walk.task.n
        counts = np.cumsum([0, *map(len, walk.later)])
        pairs = [pair for row in walk.later for pair in row]
        self.best = np.zeros(n, dtype=np.uint8)
        self.arrays: dict[str, NDArray[Any]] = {
            "first": counts.astype(np.int32),
            "later": np.array([j for j, _ in pairs], dtype=np.int32),
            "weight": np.array([w for _, w in pairs], dtype=np.int64),
            "gamma": np.array(walk.gamma, dtype=np.int64),
            "twin": np.array(walk.twin, dtype=np.uint8),
            "worst": np.ascontiguousarray(walk.task.worst),
            "side": np.zeros(n, dtype=np.uint8),
            "best": self.best,
            "link": np.zeros(2 * n, dtype=np.int64),
        }
        pointers = {name: array.ctypes.data for name, array in self.arrays.items()}
        self.struct = _Struct(
            n=n,
            total=walk.task.total,
            mode=int(aim),
            limit=limit,
            hurdle=(ctypes.c_int64 * 4)(hurdle.b, hurdle.c, hurdle.q, hurdle.d),
            **pointers,
        )
