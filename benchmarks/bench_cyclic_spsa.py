"""Monte-Carlo updates of cyclic SPSA on three roads, and exact step limits with certificates.

The three roads draw from one law and must agree with the exact mean square of the error within five
standard errors; the first two give the same bits.
"""

import ctypes
import random

import numpy as np
import pytest

from sensortrack.kernels.build import kernel
from sensortrack.normal_numbers import TABLE
from sensortrack.simulation.spsa_batch import SpsaBatch
from verification.exact.rationals import parse_exact
from verification.systems.cyclic_spsa.stability.steps import step_limit

UPDATES, SKIP = 200, 100
SIZES = {"one target": 2, "six targets": 12}
RUNS = {"C": 4000, "NumPy": 1000, "Python loop": 20}
ALPHA, BETA, NOISE = 0.05, 1.0, 0.25
"""Step size; perturbation in m; variance of a coordinate in m^2; the Hessian is the identity."""


def exact(size: int) -> float:
    """D x s/(2(2 - x)) with x = alpha D (1 + s/(2 beta^2)): two instants, targets at rest."""
    x = ALPHA * size * (1 + NOISE / (2 * BETA**2))
    return size * x * NOISE / (2 * (2 - x))


def own(size: int) -> SpsaBatch:
    return SpsaBatch(np.ones(size), ALPHA, BETA, NOISE)


def through_the_package(size: int, runs: int) -> tuple[float, float]:
    found = own(size).run(runs, UPDATES, SKIP, seed=1)
    return found.mean_square, found.mean_square_error


def python_loop(size: int, runs: int) -> tuple[float, float]:
    """Algorithm 1 as a person writes it, on floats with the generator of the standard library."""
    rng, spread, squares = random.Random(1), NOISE**0.5, []
    coordinates = range(size)
    for _ in range(runs):
        e, total = [0.0] * size, 0.0
        for update in range(UPDATES):
            delta = [rng.choice((-1.0, 1.0)) for _ in coordinates]
            before = sum((e[i] - BETA * delta[i] - spread * rng.gauss()) ** 2 for i in coordinates)
            after = sum((e[i] + BETA * delta[i] - spread * rng.gauss()) ** 2 for i in coordinates)
            slope = (after - before) / 2 / (2 * BETA)
            e = [e[i] - ALPHA * delta[i] * slope for i in coordinates]
            if update >= SKIP:
                total += sum(x * x for x in e)
        squares.append(total / (UPDATES - SKIP))
    return float(np.mean(squares)), float(np.std(squares, ddof=1) / np.sqrt(runs))


@pytest.mark.benchmark(group="updates", max_time=2.0, min_rounds=3)
@pytest.mark.parametrize("size", SIZES.values(), ids=SIZES)
@pytest.mark.parametrize("road", RUNS)
def test_updates(benchmark, monkeypatch, road: str, size: int) -> None:
    """Divide the updates by the time: roads differ in how many they make."""
    if road == "NumPy":
        monkeypatch.setenv("SENSORTRACK_NO_COMPILER", "1")
    run, runs = python_loop if road == "Python loop" else through_the_package, RUNS[road]
    found, error = benchmark(run, size, runs)
    least = benchmark.stats.stats.min
    benchmark.extra_info |= {"updates": runs * UPDATES, "ns": 1e9 * least / (runs * UPDATES)}
    assert abs(found - exact(size)) < 5 * error


@pytest.mark.benchmark(group="normal numbers", max_time=1.0)
@pytest.mark.parametrize("road", ["C", "generator of NumPy"])
def test_normal_numbers(benchmark, road: str) -> None:
    """What the draws of an update cannot be quicker than: four numbers for one target."""
    count, numbers = 100_000, np.empty(100_000)
    words = np.random.Philox(key=1).random_raw(count)
    library, rng = kernel("spsa", native=True).library, np.random.Generator(np.random.Philox(key=1))
    assert library is not None
    addresses = [ctypes.c_void_p(array.ctypes.data) for array in (TABLE, words, numbers)]

    def in_c() -> None:
        library.sensortrack_spsa_normals(*addresses[:2], ctypes.c_int64(count), addresses[2])

    benchmark(in_c if road == "C" else lambda: rng.standard_normal(out=numbers))
    benchmark.extra_info |= {"ns": 1e9 * benchmark.stats.stats.min / count}
    assert abs(numbers.mean()) < 5 / np.sqrt(count)


def block(size: int, full: bool) -> dict[str, object]:
    """Data with two decimals; a full Hessian is well conditioned."""
    rng = np.random.default_rng(size)
    half = rng.normal(size=(size, size)) / np.sqrt(size)
    square = np.round(half @ half.T / 4 + np.eye(size), 2)
    rows = square if full else np.diag(np.diag(square))
    exact_rows = tuple(tuple(parse_exact(f"{x:.2f}", "H") for x in row) for row in rows)
    diagonal = tuple(exact_rows[i][i] for i in range(size))
    tenth = parse_exact("0.1", "Xi")
    return {
        "h": None if full else diagonal,
        "H": exact_rows if full else None,
        "Xi": tuple(tuple(tenth * (i == j) for j in range(size)) for i in range(size)),
        "eta": (parse_exact("0", "eta"),) * size,
        "beta": parse_exact("1", "beta"),
        "reading": "two",
        "k": parse_exact("1", "k"),
    }


@pytest.mark.benchmark(group="step limit", max_time=1.0, min_rounds=1)
@pytest.mark.parametrize("size", [2, 4, 6, 12, 20, 40, 60])
@pytest.mark.parametrize("full", [False, True], ids=["diagonal", "full"])
def test_step_limit(benchmark, full: bool, size: int) -> None:
    values = block(size, full)
    answer = benchmark.pedantic(step_limit, (values,), rounds=3 if size < 20 else 1)
    width = answer.upper - answer.lower
    benchmark.extra_info |= {"coordinates": size, "width": width, "exact": answer.exact is not None}
    assert answer.verdict == "PROVED"
