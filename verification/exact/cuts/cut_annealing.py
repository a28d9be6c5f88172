"""Cuts improved by single nodes that change sides at random, at a falling temperature.

What is lowered is A k - c N - r sqrt(p), which is negative for cuts that are worse than the worst
one so far; that one sets c (or r) anew after each sweep. The road in C and the road in Python draw
the same numbers and add in the same order.

References
----------
D. S. Johnson, C. R. Aragon, L. A. McGeoch and C. Schevon, "Optimization by simulated annealing: an
experimental evaluation; part I, graph partitioning", Operations Research 37 (1989).
"""

from __future__ import annotations

import ctypes
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from sensortrack.kernels import kernel

from ..cut_problem import Aim
from .cut_graph import CutGraph, Flags, Scales

WORD = 2**64 - 1
COLD = 20.0
"""Nothing dearer than this many temperatures is accepted."""


@dataclass(frozen=True)
class Schedule:
    """Temperatures in units of the average weight of an edge.

    Parameters
    ----------
    hot, cold : float
        At the start and at the end.
    sweeps : int
        How often each node is looked at, on average.
    """

    hot: float
    cold: float
    sweeps: int


class _Struct(ctypes.Structure):
    """``struct anneal`` of mincut.c."""

    _fields_ = (
        ("n", ctypes.c_int32),
        ("by_rate", ctypes.c_int32),
        *((name, ctypes.c_void_p) for name in ("first", "head", "weight", "size", "gamma")),
        *((name, ctypes.c_void_p) for name in ("side", "best", "pull")),
        *((name, ctypes.c_double) for name in ("whole", "total", "k", "s", "inside")),
        *((name, ctypes.c_double) for name in ("a", "c", "r", "hot", "cool")),
        ("sweeps", ctypes.c_int64),
        ("seed", ctypes.c_uint64),
        ("mark", ctypes.c_double),
        ("found", ctypes.c_int32),
    )


def annealed(graph: CutGraph, scales: Scales, side: Flags, schedule: Schedule, seed: int) -> Flags:
    """The worst cut at the end of a sweep if it is worse than the first cut, else the last cut.

    Parameters
    ----------
    graph : CutGraph
    scales : Scales
    side : ndarray of bool, shape (n,)
        A proper cut that leaves a rate above 0.
    schedule : Schedule
    seed : int
    """
    value = scales.of(graph, side)
    if not 0 < value < math.inf:
        return side
    a, c, r = scales.prices(value)
    k, s, inside = graph.weights_of(side)
    unit = a * float(graph.weight.mean())
    cool = (schedule.cold / schedule.hot) ** (1 / max(1, schedule.sweeps - 1))
    same = side[graph.first] == side[graph.second]
    signed = np.where(same, graph.weight, -graph.weight)
    pull = np.bincount(graph.first, signed, graph.n) + np.bincount(graph.second, signed, graph.n)
    best = np.zeros(graph.n, dtype=np.uint8)
    arrays: dict[str, Any] = {
        "first": graph.rows.start,
        "head": graph.rows.head,
        "weight": graph.arc_weight,
        "size": graph.size,
        "gamma": graph.gamma,
        "side": side.astype(np.uint8),
        "best": best,
        "pull": pull,
    }
    numbers = {
        "n": graph.n,
        "by_rate": int(scales.aim is Aim.RATE),
        "whole": graph.whole,
        "total": graph.total,
        **{"k": k, "s": s, "inside": inside, "a": a, "c": c, "r": r},
        "hot": schedule.hot * unit,
        "cool": cool,
        "sweeps": schedule.sweeps,
        "seed": seed,
        "mark": value,
    }
    library = kernel("mincut").library
    if library is None:
        return _Walker(arrays, numbers).run()
    pointers = {name: array.ctypes.data for name, array in arrays.items()}
    struct = _Struct(**numbers, **pointers)
    library.sensortrack_anneal(ctypes.byref(struct))
    return best.astype(bool)


class _Walker:
    """The road in Python: step by step that of mincut.c."""

    def __init__(self, arrays: dict[str, Any], numbers: dict[str, Any]) -> None:
        self.start = arrays["first"].tolist()
        self.head = arrays["head"].tolist()
        self.weight = arrays["weight"].tolist()
        self.size, self.gamma = arrays["size"].tolist(), arrays["gamma"].tolist()
        self.side = arrays["side"].tolist()
        self.pull: list[float] = arrays["pull"].tolist()
        self.t = dict(numbers)
        self.best: list[int] | None = None
        self.state = numbers["seed"]

    def _draw(self) -> int:
        self.state = (self.state + 0x9E3779B97F4A7C15) & WORD
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & WORD
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & WORD
        return int(z ^ (z >> 31))

    def _price(self, k: float, s: float, inside: float) -> float:
        t = self.t
        load = inside + s / t["whole"] * (t["total"] - 2.0 * inside)
        root = t["r"] * math.sqrt(s * (t["whole"] - s) / t["whole"]) if t["r"] else 0.0
        price: float = t["a"] * k - t["c"] * load - root
        return price

    def _remember(self) -> None:
        t = self.t
        load = t["inside"] + t["s"] / t["whole"] * (t["total"] - 2.0 * t["inside"])
        if t["by_rate"]:
            gap = t["a"] * t["k"] - t["c"] * load
            root = math.sqrt(t["s"] * (t["whole"] - t["s"]) / t["whole"])
            value = root / gap if gap > 0 else math.inf
        else:
            value = load / t["k"]
        if not value > t["mark"]:
            return
        t["mark"] = value
        if t["by_rate"]:
            t["r"] = 1.0 / value
        else:
            t["c"] = 1.0 / value
        self.best = self.side.copy()

    def run(self) -> Flags:
        """All sweeps."""
        heat, n = self.t["hot"], self.t["n"]
        for _ in range(self.t["sweeps"]):
            now = self._price(self.t["k"], self.t["s"], self.t["inside"])
            for _ in range(n):
                now = self._try(((self._draw() >> 32) * n) >> 32, now, heat)
            self._remember()
            heat *= self.t["cool"]
        return np.array(self.best or self.side, dtype=bool)

    def _try(self, v: int, now: float, heat: float) -> float:
        """Flip a node, or not; what the cut at hand costs then."""
        t, way = self.t, -1.0 if self.side[v] else 1.0
        s, k = t["s"] + way * self.size[v], t["k"] + self.pull[v]
        inside = t["inside"] + way * self.gamma[v]
        if s <= 0.0 or s >= t["whole"]:
            return now
        then = self._price(k, s, inside)
        if then - now > 0.0:
            x = (then - now) / heat
            y = 1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0)))
            if x > COLD or (self._draw() >> 11) * 2.0**-53 * y >= 1.0:
                return now
        self.side[v] ^= 1
        t["k"], t["s"], t["inside"] = k, s, inside
        self.pull[v] = -self.pull[v]
        for arc in range(self.start[v], self.start[v + 1]):
            u, twice = self.head[arc], 2.0 * self.weight[arc]
            self.pull[u] += twice if self.side[u] == self.side[v] else -twice
        return then
