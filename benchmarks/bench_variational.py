"""One step of the variational estimator on five roads, and certificates beside their check.

The steps are timed as loops of many, so that a time is one of a step in use. All roads start from
the same state, see the same measurements and must end at the same place.
"""

import importlib
import json
import subprocess
import sys

import control
import numpy as np
import pytest

from sensortrack.estimators.variational import Variational, VariationalState
from sensortrack.kernels.steppers import stepper
from sensortrack.sensors import View
from verification.answers import Answer
from verification.certificates import check
from verification.certificates.make import statements
from verification.exact.rationals import parse_exact
from verification.systems.variational.steps import step_limit

STEPS, H = 500, 0.1
GAINS = {"M": 2.0 * np.eye(3), "K": 3.0 * np.eye(3), "C": 1.5 * np.eye(3)}
RNG = np.random.default_rng(7)
INPUTS = RNG.normal(size=(STEPS, 6))
START = np.concatenate([RNG.normal(size=6), np.zeros(3)])
UPPER = np.triu_indices(3)
CONTEXT = np.concatenate([*(GAINS[name][UPPER] for name in "MKC"), [H]])


def in_c() -> np.ndarray:
    """The loop is in C: what firmware does."""
    return stepper("variational").run(CONTEXT, START, INPUTS)[-1]


def through_the_package() -> np.ndarray:
    """A recorded track at once, through the public estimator: it is made, checked and started."""
    own = Variational(GAINS["M"], GAINS["K"], GAINS["C"], H, {"a": 1.0})
    return own.replay(VariationalState(0.0, START[:3], START[3:6], START[6:]), INPUTS)[-1]


def call_by_call() -> np.ndarray:
    """A call of the package for every step."""
    call, state = stepper("variational").call, START
    for row in INPUTS:
        state = call("step", CONTEXT, state, row)
    return state


def estimator() -> np.ndarray:
    """The estimator with one sensor's views: averaging, order of time and notes included."""
    own = Variational(GAINS["M"], GAINS["K"], GAINS["C"], H, {"a": 1.0})
    zero = np.zeros(3)
    views = [View("a", zero, zero, -row[:3], -row[3:]) for row in INPUTS]
    state = VariationalState(0.0, START[:3], START[3:6], START[6:])
    for k, view in enumerate(views, start=1):
        state = own.step(k * H, state, [view])
    return state.flat


def python_floats() -> tuple[float, ...]:
    """The fallback without a compiler."""
    step = importlib.import_module("sensortrack.generated.variational").step
    context, state = CONTEXT.tolist(), tuple(START.tolist())
    for row in INPUTS.tolist():
        state = step(context, state, row)
    return state


def numpy_by_hand() -> np.ndarray:
    """(24) as a person writes it, the inverse taken once."""
    m, k = GAINS["M"], GAINS["K"]
    inverse = np.linalg.inv(m + H * GAINS["C"])
    place, speed, u = START[:3], START[3:6], START[6:]
    for row in INPUTS:
        place = place + H * speed
        u = inverse @ (m @ u - H * (k @ (place - row[:3])))
        speed = row[3:] + u
    return np.concatenate([place, speed, u])


def python_control() -> np.ndarray:
    """python-control's nonlinear system in discrete time."""
    m, k = GAINS["M"], GAINS["K"]
    inverse = np.linalg.inv(m + H * GAINS["C"])

    def update(_, x, y, __):
        place = x[:3] + H * x[3:6]
        u = inverse @ (m @ x[6:] - H * (k @ (place - y[:3])))
        return np.concatenate([place, y[3:] + u, u])

    system = control.nlsys(update, None, inputs=6, states=9, outputs=9, dt=H)
    samples = np.vstack([INPUTS, INPUTS[-1:]])
    times = H * np.arange(STEPS + 1)
    found = control.input_output_response(system, times, samples.T, START)
    return found.states[:, -1]


ROADS = {
    "C, loop in C": in_c,
    "C, through the package": through_the_package,
    "package, step by step": call_by_call,
    "estimator with views": estimator,
    "Python floats": python_floats,
    "NumPy by hand": numpy_by_hand,
    "python-control nlsys": python_control,
}


@pytest.mark.benchmark(group=f"{STEPS} steps")
@pytest.mark.parametrize("road", ROADS)
def test_steps(benchmark, road: str) -> None:
    found = benchmark(ROADS[road])
    benchmark.extra_info |= {"steps": STEPS, "state": 9}
    assert np.allclose(found, numpy_by_hand(), rtol=1e-9, atol=1e-9)


def gains_of_size(n: int) -> dict[str, tuple[tuple[object, ...], ...]]:
    """Well conditioned gains with two decimals."""
    rng = np.random.default_rng(n)
    made = {}
    for name in "MKC":
        half = rng.normal(size=(n, n)) / np.sqrt(n)
        square = np.round(half @ half.T + np.eye(n), 2)
        made[name] = tuple(tuple(parse_exact(f"{x:.2f}", name) for x in row) for row in square)
    return made


def limit_of_size(n: int) -> Answer:
    answer = step_limit(gains_of_size(n))
    assert answer.certificate is not None
    return answer


@pytest.mark.benchmark(group="step limit, certificate", max_time=2.0, min_rounds=1)
@pytest.mark.parametrize("n", [6, 20, 60, 200])
def test_certificate(benchmark, n: int) -> None:
    gains = gains_of_size(n)
    answer = benchmark.pedantic(step_limit, (gains,), rounds=3 if n < 60 else 1)
    benchmark.extra_info |= {"n": n, "width": float(answer.upper - answer.lower)}
    assert answer.verdict == "PROVED"


@pytest.mark.benchmark(group="step limit, check", max_time=2.0, min_rounds=1)
@pytest.mark.parametrize("n", [6, 20, 60, 200])
def test_check(benchmark, n: int) -> None:
    document = limit_of_size(n).certificate
    entry = benchmark.pedantic(
        check.check_document, (document, statements()), rounds=3 if n < 60 else 1
    )
    benchmark.extra_info |= {"n": n, "bytes": len(json.dumps(document))}
    assert entry["verdict"] == "PROVED"


@pytest.mark.benchmark(group="step limit, check in a process")
@pytest.mark.parametrize("what", ["python start", "6", "20"])
def test_check_in_a_process(benchmark, what: str, tmp_path) -> None:
    command = [sys.executable, "-I", "-S", "-c", "pass"]
    if what != "python start":
        path = tmp_path / "certificate.json"
        path.write_text(json.dumps(limit_of_size(int(what)).certificate))
        command = [sys.executable, "-I", "-S", check.__file__, str(path)]
    done = benchmark(lambda: subprocess.run(command, capture_output=True, check=False))
    assert done.returncode == 0
