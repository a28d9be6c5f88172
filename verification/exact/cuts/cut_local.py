"""Good cuts of small networks by sweeps and local moves: candidates, in the end measured."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..cut_problem import Aim, Hurdle, Problem
from .cut_orders import laplacian_modes

MODES = 4
PASSES = 12
CONGESTION = 8
"""Power of the relative load that makes the length of an edge."""

IMPROVED = 5
"""How many of the worst sweeps are improved."""

Flags = NDArray[np.bool_]
Floats = NDArray[np.float64]
Cut = tuple[int, ...]


class Scale:
    """A problem in doubles, and how bad a cut is: the larger, the nearer to the answer."""

    def __init__(self, task: Problem, hurdle: Hurdle, aim: Aim) -> None:
        from scipy.sparse import coo_matrix

        unit, top = max(task.weights), max(task.gamma) or 1
        self.n, self.aim = task.n, aim
        self.weights = np.array([w / unit for w in task.weights])
        self.gamma = np.array([g / top for g in task.gamma])
        self.first, self.second = task.edges[:, 0], task.edges[:, 1]
        ends = (np.r_[self.first, self.second], np.r_[self.second, self.first])
        both = np.r_[self.weights, self.weights]
        self.links = coo_matrix((both, ends), shape=(self.n, self.n)).tocsr()
        self.degrees = np.bincount(ends[0], both, self.n)
        size = max(abs(hurdle.b * unit), abs(hurdle.c * top), 1)
        self.b, self.c = hurdle.b * unit / size, hurdle.c * top / size

    def badness(self, k: Floats, inside: Floats, s: Floats) -> Floats:
        """load/k, or s (n - s) over the square of b k - c load."""
        load = (self.n - 2 * s) * inside + s * self.gamma.sum()
        proper = (s > 0) & (s < self.n)
        with np.errstate(divide="ignore", invalid="ignore"):
            if self.aim is Aim.RATE:
                value = s * (self.n - s) / np.maximum(self.b * k - self.c * load, 0) ** 2
            else:
                value = load / k
        return np.where(proper, value, -np.inf)

    def sweep(self, line: Floats) -> Flags:
        """The worst cut between two neighbours along a line."""
        order = np.argsort(line, kind="stable")
        place = np.empty(self.n, dtype=np.int64)
        place[order] = np.arange(self.n)
        ends = np.sort(np.stack([place[self.first], place[self.second]]), axis=0)
        steps = np.bincount(ends[0], self.weights, self.n) - np.bincount(
            ends[1], self.weights, self.n
        )
        k, inside = np.cumsum(steps)[:-1], np.cumsum(self.gamma[order])[:-1]
        best = int(np.argmax(self.badness(k, inside, np.arange(1.0, self.n))))
        flags: Flags = place <= best
        return flags

    def improve(self, flags: Flags) -> Flags:
        """Move one node after the other, each once a pass, and keep the worst cut on the way."""
        for _ in range(PASSES):
            better = self._pass(flags)
            if better is None:
                break
            flags = better
        return flags

    def _pass(self, flags: Flags) -> Flags | None:
        side = flags.copy()
        across = self.links @ np.where(side, -1.0, 1.0)  # links out of S minus links into S
        k = float(self.weights[side[self.first] != side[self.second]].sum())
        inside, s = float(self.gamma[side].sum()), int(side.sum())
        top = best = float(self.badness(np.array(k), np.array(inside), np.array(s)))
        keep: Flags | None = None
        free = np.ones(self.n, dtype=bool)
        for _ in range(self.n):
            sign = np.where(side, -1, 1)
            values = self.badness(k + sign * across, inside + sign * self.gamma, s + sign)
            values[~free] = -np.inf
            move = int(np.argmax(values))
            if values[move] == -np.inf:
                break
            k += sign[move] * across[move]
            inside, s = inside + sign[move] * self.gamma[move], s + int(sign[move])
            side[move] = not side[move]
            free[move] = False
            row = slice(self.links.indptr[move], self.links.indptr[move + 1])
            across[self.links.indices[row]] -= 2 * sign[move] * self.links.data[row]
            if values[move] > best * (1 + 1e-12):
                best, keep = float(values[move]), side.copy()
        return keep if best > top * (1 + 1e-12) else None


def good_cut(task: Problem, hurdle: Hurdle, aim: Aim) -> Cut:
    """A cut that is hard to beat.

    Parameters
    ----------
    task : Problem
        Two nodes or more.
    hurdle : Hurdle
        Its b and c, for ``Aim.RATE``.
    aim : Aim
        ``RATIO`` or ``RATE``.

    Returns
    -------
    tuple of int
        Nodes of one side, increasing.
    """
    scale = Scale(task, hurdle, aim)
    return _best(task, hurdle, scale, list(_starts(task, scale)))


def congested_cut(task: Problem, hurdle: Hurdle, shares: Floats) -> Cut:
    """A cut of large load/k where a good routing has little room left.

    Sets of nodes that are near to a node, congested edges counting as long, are what the rounding
    of Leighton and Rao looks at.

    Parameters
    ----------
    task : Problem
    hurdle : Hurdle
    shares : ndarray, shape (m,)
        Load of each edge over its weight, in any unit.

    Returns
    -------
    tuple of int
        Nodes of one side, increasing.
    """
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import dijkstra

    scale = Scale(task, hurdle, Aim.RATIO)
    lengths = (shares / shares.max()) ** CONGESTION + 1e-4
    graph = csr_matrix((lengths, (scale.first, scale.second)), shape=(task.n, task.n))
    return _best(task, hurdle, scale, [scale.sweep(row) for row in dijkstra(graph, directed=False)])


def _best(task: Problem, hurdle: Hurdle, scale: Scale, cuts: list[Flags]) -> Cut:
    """The worst of some cuts after improving the worst of them."""

    def rank(cut: Cut) -> tuple[float, int]:
        return _rank(task, hurdle, scale.aim, cut)

    distinct = {flags.tobytes(): flags for flags in cuts}.values()
    chosen = sorted(distinct, key=lambda flags: rank(_nodes(flags)))[-IMPROVED:]
    chosen += [scale.improve(flags) for flags in chosen]
    return max({_nodes(flags) for flags in chosen}, key=rank)


def _nodes(flags: Flags) -> Cut:
    return tuple(int(i) for i in np.flatnonzero(flags))


def _rank(task: Problem, hurdle: Hurdle, aim: Aim, cut: Cut) -> tuple[float, int]:
    """How bad, exactly but for one rounding at the end; smaller sides win ties."""
    k, load, s = task.measure(cut)
    if aim is Aim.RATE:
        gap = hurdle.b * k - hurdle.c * load
        value = s * (task.n - s) / gap**2 if gap > 0 else float("inf")
    else:
        value = load / k
    return value, -s


def _starts(task: Problem, scale: Scale) -> Iterator[Flags]:
    singles = scale.badness(scale.degrees.astype(float), scale.gamma, np.ones(task.n))
    single = np.zeros(task.n, dtype=bool)
    single[int(np.argmax(singles))] = True
    yield single
    modes = laplacian_modes(task, MODES).slow
    for mode in modes.T:
        yield scale.sweep(mode)
    if modes.shape[1] > 1:
        for angle in np.arange(1, 8) * np.pi / 8:
            yield scale.sweep(np.cos(angle) * modes[:, 0] + np.sin(angle) * modes[:, 1])
