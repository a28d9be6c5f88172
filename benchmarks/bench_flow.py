"""Exact runs and exact implicit steps against the size of the network, and beside solvers.

The exact run needs no step: its time is that of all events up to agreement. The solvers integrate
the law with a sign smoothed over a width, because with the jump itself their step control stalls;
what is timed is what it takes to come within the same distance of the exact run half way.
"""

from fractions import Fraction

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from sensortrack.consensus import SignConsensus
from sensortrack.networks import read_network
from verification.exact.runs.filippov import filippov_run
from verification.exact.runs.prox import implicit_step

FAMILIES = ("path:{}", "random_geometric:{},0.2,1")
SIZES = (25, 50, 100, 200)
TOLERANCE = 1e-2
"""Distance from the exact run, of a start with entries up to 10."""


def case(family: str, n: int = 0):
    network = read_network(family.format(n))
    rng = np.random.default_rng(4)
    return network, [Fraction(int(v), 1000) for v in rng.integers(-10_000, 10_001, network.n)]


@pytest.mark.benchmark(group="exact run to agreement")
@pytest.mark.parametrize("n", SIZES)
@pytest.mark.parametrize("family", FAMILIES)
def test_exact_run(benchmark, family: str, n: int) -> None:
    network, x0 = case(family, n)
    run = benchmark.pedantic(filippov_run, (network, Fraction(1), x0), rounds=3)
    bits = max(v.denominator.bit_length() for point in run.points for v in point)
    benchmark.extra_info |= {"nodes": network.n, "links": network.m, "pieces": len(run.pieces)}
    benchmark.extra_info |= {"longest denominator, bits": bits, "error": 0}
    assert run.agreement == run.times[-1]


@pytest.mark.benchmark(group="exact implicit step")
@pytest.mark.parametrize("n", SIZES)
@pytest.mark.parametrize("family", FAMILIES)
def test_exact_implicit_step(benchmark, family: str, n: int) -> None:
    network, x0 = case(family, n)
    after = benchmark.pedantic(implicit_step, (network, x0, Fraction(1)), rounds=3)
    benchmark.extra_info |= {"nodes": network.n, "links": network.m, "error": 0}
    assert sum(after) == sum(x0)


NETWORK, X0 = case("karate")
START = np.array([float(v) for v in X0])
RUN = filippov_run(NETWORK, Fraction(1), X0)
HALF = RUN.agreement / 2
GOAL = np.array([float(v) for v in RUN.at(HALF)])
FIRST, SECOND = NETWORK.edges.T


def distance(x) -> float:
    return float(np.linalg.norm(x - x.mean() - GOAL))


def by_implicit_steps(steps: int) -> np.ndarray:
    """The package's implicit stepper: what is averaged stands still, so that x is the state."""
    law = SignConsensus(NETWORK, 1.0, float(HALF) / steps)
    signal = START[:, None]
    state = law.init(signal)
    for _ in range(steps):
        state = law.step(state, signal)
    return state.x[:, 0]


def by_exact_steps(steps: int) -> np.ndarray:
    x = tuple(X0)
    for _ in range(steps):
        x = implicit_step(NETWORK, x, HALF / steps)
    return np.array([float(v) for v in x])


def smoothed(width: float):
    """The law with a sign that is linear within the width; width 0 is the jump."""

    def rate(_, x):
        gap = x[FIRST] - x[SECOND]
        sign = np.clip(gap / width, -1, 1) if width else np.sign(gap)
        found = np.zeros_like(x)
        np.subtract.at(found, FIRST, sign)
        np.add.at(found, SECOND, sign)
        return found

    return rate


def by_solver(method: str, width: float, accuracy: float):
    found = solve_ivp(
        smoothed(width), (0, float(HALF)), START, method, rtol=accuracy, atol=accuracy
    )
    return found.y[:, -1], found.nfev


@pytest.mark.benchmark(group="half way to agreement, within 0.01")
def test_implicit_steps_of_the_package(benchmark) -> None:
    steps = next(k for k in (2**j for j in range(14)) if distance(by_implicit_steps(k)) < TOLERANCE)
    x = benchmark.pedantic(by_implicit_steps, (steps,), rounds=3)
    benchmark.extra_info |= {"steps": steps, "error": distance(x)}
    assert distance(x) < TOLERANCE


@pytest.mark.benchmark(group="half way to agreement, within 0.01")
def test_exact_implicit_steps(benchmark) -> None:
    steps = next(k for k in (2**j for j in range(10)) if distance(by_exact_steps(k)) < TOLERANCE)
    x = benchmark.pedantic(by_exact_steps, (steps,), rounds=3)
    benchmark.extra_info |= {"steps": steps, "error": distance(x)}
    assert distance(x) < TOLERANCE


@pytest.mark.benchmark(group="half way to agreement, within 0.01")
def test_the_exact_run_itself(benchmark) -> None:
    run = benchmark.pedantic(filippov_run, (NETWORK, Fraction(1), X0), rounds=3)
    benchmark.extra_info |= {"pieces": len(run.pieces), "error": 0}
    assert run.at(HALF) == RUN.at(HALF)


WIDTHS = [0.3 / 2**k for k in range(12)]


@pytest.mark.benchmark(group="half way to agreement, within 0.01")
@pytest.mark.parametrize("method", ["RK45", "BDF", "Radau"])
def test_solvers_of_the_smoothed_law(benchmark, method: str) -> None:
    """The widest smoothing, with an accuracy to match, that comes near enough."""
    width = next(w for w in WIDTHS if distance(by_solver(method, w, w / 100)[0]) < TOLERANCE)
    x, calls = benchmark.pedantic(by_solver, (method, width, width / 100), rounds=3)
    benchmark.extra_info |= {"width": width, "calls": calls, "error": distance(x)}
    assert distance(x) < TOLERANCE
