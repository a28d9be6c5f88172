"""The estimator beside its printed equations, and what it does when data fail."""

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.estimators import Variational
from sensortrack.sensors import View

WEIGHTS = {"a": 0.5, "b": 0.3, "c": 0.2}
M = np.array([[2, 0.5, 0], [0.5, 1, 0.2], [0, 0.2, 1.5]])
K = np.array([[4, 1, 0], [1, 3, -0.5], [0, -0.5, 2]])
C = np.array([[1, 0, 0.3], [0, 0.5, 0], [0.3, 0, 0.8]])
H = 0.1


def views(t, names="abc", rng=None):
    """Sensors at rest beside a target that moves straight."""
    target, rate = np.array([t, 1 - t, 2.0]), np.array([1.0, -1.0, 0.0])
    made = []
    for k, name in enumerate(names):
        own = np.array([5.0 * k, 3.0, -1.0])
        noise = rng.normal(size=(2, 3)) if rng else np.zeros((2, 3))
        made.append(View(name, own, np.zeros(3), own - target + noise[0], -rate + noise[1]))
    return made


def estimator(**changes):
    return Variational(**({"M": M, "K": K, "C": C, "h": H, "weights": WEIGHTS} | changes))


def mean(seen):
    return sum(WEIGHTS[v.sensor] * v.target for v in seen) / sum(WEIGHTS[v.sensor] for v in seen)


@pytest.mark.parametrize("scheme", ["printed", "leapfrog"])
def test_it_follows_the_printed_equations(scheme):
    rng = np.random.default_rng(4)
    first = views(0, rng=rng)
    e = estimator(scheme=scheme)
    state = e.init(first, position=[3, 3, 3], error_rate=[1, 0, -1])
    b, u = np.array([3.0, 3, 3]), np.array([1.0, 0, -1])
    v = mean(first)[3:] + u
    damped, kept = (M + H * C, M) if scheme == "printed" else (M + H / 2 * C, M - H / 2 * C)
    for k in range(1, 60):
        seen = views(k * H, rng=rng)
        state = e.step(k * H, state, seen)
        b = b + H * v
        u = np.linalg.solve(damped, kept @ u - H * K @ (b - mean(seen)[:3]))
        v = mean(seen)[3:] + u
        assert np.concatenate([b, v, u]) == pytest.approx(state.flat, rel=1e-12, abs=1e-12)


def test_it_finds_a_target_of_constant_velocity_without_error():
    e = estimator()
    state = e.init(views(0), position=[9, 9, 9])
    for k in range(1, 1501):
        state = e.step(k * H, state, views(k * H))
    assert state.position == pytest.approx([150, -149, 2], abs=1e-6)
    assert state.velocity == pytest.approx([1, -1, 0], abs=1e-6)


def test_a_lost_sensor_makes_no_jump_without_noise():
    e = estimator()
    state = e.init(views(0), position=[9, 9, 9])
    for k in range(1, 40):
        state = e.step(k * H, state, views(k * H, "abc"))
    whole, fewer = e.step(4.0, state, views(4.0)), e.step(4.0, state, views(4.0, "ab"))
    assert whole.flat == pytest.approx(fewer.flat, abs=1e-12)


def test_no_sensor_left_moves_on_and_says_so():
    e = estimator()
    state = e.step(H, e.init(views(0)), views(H))
    after = e.step(2 * H, state, [])
    assert after.position == pytest.approx(state.position + H * state.velocity)
    assert after.velocity == pytest.approx(state.velocity)
    assert "no sensor sees the target" in after.notes[0]
    back = e.step(3 * H, after, views(3 * H))
    assert back.notes == ()


def test_a_nan_is_skipped_and_reported():
    e = estimator()
    state = e.init(views(0))
    broken = views(H)
    broken[1] = View("b", broken[1].position, np.zeros(3), np.full(3, np.nan), np.zeros(3))
    after = e.step(H, state, broken)
    assert after.notes == ("measurement of b is not finite: skipped",)
    assert after.flat == pytest.approx(e.step(H, state, views(H, "ac")).flat)


@pytest.mark.parametrize("delay", [1, 2, 5])
def test_late_positions_pull_by_the_error_of_then(delay):
    e = estimator(delay=delay)
    state = e.init(views(0), position=[3, 3, 3])
    b = [np.array([3.0, 3, 3])] * (delay + 1)
    errors = [b[0] - mean(views(0))[:3]] * (delay + 1)
    u, v = np.zeros(3), mean(views(0))[3:]
    for k in range(1, 30):
        seen = views(k * H)
        state = e.step(k * H, state, seen)
        b.append(b[-1] + H * v)
        errors.append(b[-1] - mean(seen)[:3])
        u = np.linalg.solve(M + H * C, M @ u - H * K @ errors[-1 - delay])
        v = mean(seen)[3:] + u
        assert np.concatenate([b[-1], v, u]) == pytest.approx(state.flat, abs=1e-9)


def test_many_samples_at_once_are_the_same_steps():
    e = estimator()
    state = start = e.init(views(0), position=[3, 3, 3])
    inputs = np.array([mean(views(k * H)) for k in range(1, 30)])
    rows = e.replay(start, inputs)
    for k in range(1, 30):
        state = e.step(k * H, state, views(k * H))
        assert rows[k - 1] == pytest.approx(state.flat, abs=1e-12)


@pytest.mark.parametrize(
    "changes,name",
    [
        ({"M": -1.0}, "M"),
        ({"K": [[1, 2, 0], [0, 1, 0], [0, 0, 1]]}, "K"),
        ({"C": [[1, 2], [2, 1]]}, "C"),
        ({"C": float("nan")}, "C"),
        ({"h": 0.0}, "h"),
        ({"h": float("nan")}, "h"),
        ({"weights": {"a": 0.4, "b": 0.4}}, "weights"),
        ({"weights": {}}, "weights"),
        ({"scheme": "euler"}, "scheme"),
        ({"delay": -1}, "delay"),
        ({"delay": 1.5}, "delay"),
    ],
)
def test_bad_parameters_are_refused_by_name(changes, name):
    with pytest.raises(InputError) as error:
        estimator(**changes)
    assert error.value.name == name


def test_measurements_out_of_order_or_off_the_grid_are_refused():
    e = estimator()
    state = e.step(H, e.init(views(0)), views(H))
    for t, word in (
        (H, "order"),
        (0.0, "order"),
        (3 * H, "one sampling period"),
        (1.5 * H, "period"),
    ):
        with pytest.raises(InputError, match=word) as error:
            e.step(t, state, views(t))
        assert error.value.name == "t"


def test_nobody_sees_the_target_at_the_start():
    with pytest.raises(InputError) as error:
        estimator().init([])
    assert error.value.name == "measurement"


def test_replay_needs_finite_rows_and_the_printed_form():
    e = estimator()
    state = e.init(views(0))
    for inputs in (np.zeros((3, 5)), np.full((2, 6), np.nan), np.zeros(6)):
        with pytest.raises(InputError) as error:
            e.replay(state, inputs)
        assert error.value.name == "inputs"
    with pytest.raises(InputError):
        estimator(delay=1).replay(state, np.zeros((2, 6)))
