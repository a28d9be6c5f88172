"""Steps of sign consensus beside scipy.sparse, memory bandwidth and general-purpose solvers.

Ratios are of one run: what is compared is timed in turns, and the least time of each counts, for
other processes can only make a run slower.
"""

import ctypes
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from time import perf_counter

import numpy as np
import pytest
from scipy import sparse
from scipy.integrate import solve_ivp
from scipy.spatial import cKDTree

from sensortrack.consensus import SignConsensus
from sensortrack.consensus.proximal import proximal
from sensortrack.kernels import kernel
from sensortrack.kernels.consensus import sign_step
from sensortrack.kernels.dual import Ascent
from sensortrack.kernels.links import Forest, Links, links_of, rooted
from sensortrack.kernels.tree import tree_flow
from sensortrack.networks import DecimalNames, Network, read_network

SIZES = (10**3, 10**4, 10**5, 10**6)
STREAM = 2 * 10**7
DEGREE = 8


@cache
def geometric(n: int) -> Network:
    """Drawn points of the unit square, linked up to a distance that makes the mean degree 8."""
    points = np.random.default_rng(0).random((n, 2))
    pairs = cKDTree(points).query_pairs(np.sqrt(DEGREE / (np.pi * n)), output_type="ndarray")
    return Network(DecimalNames(n), np.sort(pairs.astype(np.int64), axis=1), label=f"geometric {n}")


@cache
def recursive_tree(n: int) -> Network:
    rng = np.random.default_rng(0)
    parents = (rng.random(n - 1) * np.arange(1, n)).astype(np.int64)
    return Network(DecimalNames(n), np.stack([parents, np.arange(1, n)], axis=1))


@cache
def search_tree(n: int) -> Network:
    """Breadth-first forest of the geometric network."""
    links = links_of(geometric(n))
    forest = rooted(links.n, links.ends, np.arange(links.m, dtype=np.int32))
    return Network(DecimalNames(n), links.ends[np.sort(forest.link[forest.below])].astype(np.int64))


NETWORKS = {
    "path": lambda n: read_network(f"path:{n}"),
    "search tree": search_tree,
    "recursive tree": recursive_tree,
}


def in_turns(*roads: Callable[[], object], rounds: int = 9) -> list[float]:
    """Least time of each in s."""
    times = []
    for _ in range(rounds):
        row = []
        for road in roads:
            start = perf_counter()
            road()
            row.append(perf_counter() - start)
        times.append(row)
    return np.min(times, axis=0).tolist()


@cache
def stream() -> dict[str, Callable[[], object]]:
    """Copy and triad over 160 MB a stream."""
    library = kernel("stream", Path(__file__).parent, native=True).library
    assert library is not None
    a, b, out = np.ones(STREAM), np.ones(STREAM), np.zeros(STREAM)
    addresses = [ctypes.c_void_p(array.ctypes.data) for array in (a, b, out)]
    count = ctypes.c_size_t(STREAM)
    keep = (a, b, out)
    return {
        "copy": lambda: library.stream_copy(count, addresses[0], addresses[2]) and keep,
        "triad": lambda: library.stream_triad(count, *addresses) and keep,
    }


class Explicit:
    """The same step on three roads, over rows by place."""

    def __init__(self, n: int, width: int) -> None:
        self.links = links_of(geometric(n))
        self.x, self.w, self.r = np.random.default_rng(1).normal(size=(3, n, width))
        self.gain = np.full(width, 0.125)
        self.out = np.empty_like(self.w), np.empty_like(self.x)
        # the signal lies by place too: what is measured is the step, not the renumbering
        self.by_place = Links(**{**vars_of(self.links), "order": None})
        self.transposed = self.links.incidence.T.tocsr()

    def in_c(self) -> None:
        sign_step(self.by_place, self.x, self.w, self.r, self.gain, out=self.out)

    def by_scipy(self) -> tuple[np.ndarray, np.ndarray]:
        w = self.w - self.gain * (self.links.incidence @ np.sign(self.transposed @ self.x))
        return w, w + self.r

    @property
    def bytes(self) -> int:
        """Each row once: x, w and r read, w and x written; the neighbour lists read."""
        return 5 * self.x.nbytes + 4 * (len(self.links.index) + self.links.n)


def vars_of(links: Links) -> dict[str, object]:
    return {name: getattr(links, name) for name in Links.__dataclass_fields__}


@pytest.mark.benchmark(group="explicit step", max_time=1.0, min_rounds=3)
@pytest.mark.parametrize("n", SIZES)
@pytest.mark.parametrize("width", [6, 1])
@pytest.mark.parametrize("road", ["in_c", "by_scipy"])
def test_explicit_step(benchmark, n: int, width: int, road: str) -> None:
    task = Explicit(n, width)
    found = benchmark(getattr(task, road)) or task.out
    benchmark.extra_info |= {"nodes": n, "links": task.links.m, "components": width}
    assert np.array_equal(found[0], task.by_scipy()[0])
    assert np.array_equal(found[1], task.by_scipy()[1])


@pytest.mark.benchmark(group="explicit step of 10^6 nodes beside memory and scipy.sparse")
@pytest.mark.parametrize("width, loop, goal", [(6, "triad", 0.6), (1, "copy", 0.4)])
def test_share_of_bandwidth(benchmark, width: int, loop: str, goal: float) -> None:
    task = Explicit(10**6, width)
    moved = {"copy": 16, "triad": 24}[loop] * STREAM
    step, memory = in_turns(task.in_c, stream()[loop], rounds=15)
    step_too, other = in_turns(task.in_c, task.by_scipy, rounds=5)
    benchmark.pedantic(task.in_c, rounds=5)
    benchmark.extra_info |= {
        "GB/s": task.bytes / step / 1e9,
        f"{loop} GB/s": moved / memory / 1e9,
        f"share of {loop}": task.bytes / step / (moved / memory),
        "goal of the share": goal,
        "times scipy": other / step_too,
        "goal of times scipy": 5,
    }


@pytest.mark.benchmark(group="order of the nodes, 10^6", max_time=1.0, min_rounds=3)
@pytest.mark.parametrize("width", [6, 1])
def test_gain_of_renumbering(benchmark, width: int) -> None:
    """The same network with its nodes where they were drawn."""
    task = Explicit(10**6, width)
    network = geometric(10**6)
    lists = sparse.csr_array(abs(network.laplacian()))
    lists.setdiag(0)
    lists.eliminate_zeros()
    drawn = Links(
        network.n,
        task.links.ends,
        task.links.rank,
        None,
        None,
        lists.indptr.astype(np.int32),
        lists.indices.astype(np.int32),
        task.links.link,
    )
    arrays = task.x, task.w, task.r, task.gain
    ordered, random = in_turns(task.in_c, lambda: sign_step(drawn, *arrays, out=task.out))
    benchmark.pedantic(task.in_c, rounds=3)
    benchmark.extra_info |= {"random order / renumbered": random / ordered}


@pytest.mark.benchmark(group="proximal map of a tree", max_time=1.0, min_rounds=3)
@pytest.mark.parametrize("size", [0.05, 0.5])
@pytest.mark.parametrize("family", NETWORKS)
@pytest.mark.parametrize("n", [10**4, 10**6])
def test_tree(benchmark, family: str, n: int, size: float) -> None:
    """The dynamic program beside one dual step, which it makes needless."""
    links = links_of(NETWORKS[family](n))
    forest = links.forest
    assert isinstance(forest, Forest)
    y = np.random.default_rng(1).normal(size=n)
    by_moment, most = y[forest.order], np.full(n, size)
    ascent = Ascent(links, y, np.full(links.m, size), np.zeros(links.m))

    def program() -> np.ndarray:
        return tree_flow(forest, by_moment, most)

    alone, steps = in_turns(program, lambda: ascent.advance(5), rounds=5)
    benchmark.pedantic(program, rounds=3)
    found = proximal(links, y[None], np.full((1, links.m), size))
    benchmark.extra_info |= {
        "nodes": n,
        "ns a node": alone / n * 1e9,
        "dual steps in that time": 5 * alone / steps,
    }
    assert found.error[0] == 0


@pytest.mark.benchmark(group="proximal map of a grid")
@pytest.mark.parametrize("side", [100, 1000])
def test_warm_start(benchmark, side: int) -> None:
    """Dual steps to a gap of 1e-4 of the variance, cold and after a change of the data by 1 %."""
    links = links_of(read_network(f"grid:{side},{side}"))
    rng = np.random.default_rng(1)
    capacity, y = np.full(links.m, 0.5), rng.normal(size=links.n)
    goal = 1e-4 * links.n / 2

    def steps(data: np.ndarray, flow: np.ndarray) -> tuple[int, np.ndarray]:
        ascent, count = Ascent(links, data, capacity, flow), 0
        while ascent.point()[1] > goal:
            ascent.advance(10)
            count += 10
        return count, ascent.flow.copy()

    cold, flow = steps(y, np.zeros(links.m))
    changed = y + 0.01 * rng.normal(size=links.n)
    warm, _ = benchmark.pedantic(steps, (changed, flow), rounds=1)
    benchmark.extra_info |= {"nodes": links.n, "cold steps": cold, "warm steps": warm, "goal": 40}
    assert warm < cold


PHASES = 1.3 * np.arange(6)
BETA, UNTIL = 4.0, 3.0
MOST = 20_000
SOLVERS = [("RK45", 1e-2), ("RK45", 1e-3), ("LSODA", 1e-2), ("BDF", 1e-3), ("Radau", 1e-3)]


def signal(t: float) -> np.ndarray:
    return np.sin(1.1 * t + PHASES)


class Enough(Exception):
    """A solver has asked for the right-hand side often enough."""


def solved(method: str, tolerance: float) -> tuple[float, int, str]:
    """Error at the end, evaluations, and how a solver of scipy ended, on a ring of six."""
    network, count = read_network("cycle:6"), 0
    links = links_of(network)

    def rate(t: float, w: np.ndarray) -> np.ndarray:
        nonlocal count
        count += 1
        if count > MOST:
            raise Enough
        return -BETA * (links.incidence @ np.sign(links.incidence.T @ (w + signal(t))))

    start, options = np.zeros(6), {"method": method, "rtol": tolerance, "atol": tolerance}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            found = solve_ivp(rate, (0, UNTIL), start, **options)
    except Enough:
        return np.inf, count, "too many evaluations"
    if found.status != 0:
        return np.inf, count, found.message
    x = found.y[:, -1] + signal(UNTIL)
    return float(np.abs(x - signal(UNTIL).mean()).max()), count, "done"


def stepped(method: str, h: float) -> tuple[float, int, str]:
    law = SignConsensus(read_network("cycle:6"), BETA, h, method)
    state, steps = law.init(signal(0)[:, None]), round(UNTIL / h)
    for k in range(steps):
        state = law.step(state, signal((k + 1) * h)[:, None])
    error = np.abs(state.x[:, 0] - signal(UNTIL).mean()).max()
    return float(error), steps, str(state.status)


@pytest.mark.benchmark(group="three seconds of a ring of six")
@pytest.mark.parametrize("method, number", [("implicit", 0.1), ("explicit", 0.001), *SOLVERS])
def test_three_seconds(benchmark, method: str, number: float) -> None:
    """Our steps by h and scipy's solvers by tolerance: time beside the error at the end."""
    road = stepped if method in {"implicit", "explicit"} else solved
    error, count, end = benchmark.pedantic(road, (method, number), rounds=1)
    benchmark.extra_info |= {"error": error, "steps or evaluations": count, "end": end}
    if method == "implicit":
        assert error < 1e-14
