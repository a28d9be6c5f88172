"""Baselines with all bearings in one place."""

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.estimators.bearing_filters import BearingKalman, BearingKalmanState, intersect
from sensortrack.sensors import bearings_to

PLACES = np.array([[60.0, 10], [-20, 70], [-70, -30], [10, -80], [80, -40]])
H = 0.01


def target(t):
    return np.array([20 * np.cos(0.6 * t), 15 * np.sin(1.1 * t)])


def test_lines_of_sight_meet_at_the_target_or_not_at_all():
    angles = bearings_to(target(1.0), PLACES)
    assert intersect(angles, PLACES) == pytest.approx(target(1.0), abs=1e-12)
    assert intersect([0.3] * 5, PLACES) is None
    assert intersect([0.3, *[np.nan] * 4], PLACES) is None
    weights = [1.0, 2, 3, 4, 5]
    assert intersect(angles, PLACES, weights) == pytest.approx(target(1.0), abs=1e-12)


def test_weights_are_those_of_the_squares():
    rng = np.random.default_rng(1)
    angles, weights = rng.uniform(-1, 1, 5), rng.uniform(1, 2, 5)
    rows = np.stack([-np.sin(angles), np.cos(angles)], axis=1)
    root = np.sqrt(weights)[:, None]
    wanted = np.linalg.lstsq(rows * root, ((rows * PLACES).sum(axis=1) * root[:, 0]), rcond=None)[0]
    assert intersect(angles, PLACES, weights) == pytest.approx(wanted, rel=1e-9)


def test_the_filter_follows_and_waits_for_its_first_position():
    rng = np.random.default_rng(2)
    sigma = 0.01
    kalman = BearingKalman(PLACES, H, 5.0, sigma)
    state = kalman.step(BearingKalmanState(), np.full(5, 0.3))
    assert np.isnan(state.position).all()
    assert np.isnan(state.velocity).all()
    off, raw = [], []
    for k in range(1, 400):
        angles = bearings_to(target(k * H), PLACES) + sigma * rng.standard_normal(5)
        state = kalman.step(state, angles if k % 50 else np.full(5, np.nan))
        off.append(np.linalg.norm(state.position - target(k * H)))
        raw.append(np.linalg.norm(intersect(angles, PLACES) - target(k * H)))
    assert np.mean(off[100:]) < 0.7 * np.mean(raw[100:])


def test_a_filter_does_not_start_where_only_one_sensor_says_where():
    """Two lines of sight that meet on a sensor: nothing is known along the other's."""
    places = np.array([[0.0, 0.0], [0.0, 50.0]])
    kalman = BearingKalman(places, 0.1, 1.0, 0.001)
    state = kalman.step(BearingKalmanState(), [0.0, -np.pi / 2])
    assert np.isnan(state.position).all()
    state = kalman.step(state, bearings_to((-30.0, 20.0), places))
    assert state.position == pytest.approx([-30.0, 20.0])


def test_angles_that_pass_the_half_turn_are_one_small_step_apart():
    place = np.array([[0.0, 0.0], [0.0, 50.0]])
    kalman = BearingKalman(place, 0.1, 1.0, 0.001)
    state = kalman.step(BearingKalmanState(), bearings_to((-30.0, 0.2), place))
    for k in range(1, 20):
        state = kalman.step(state, bearings_to((-30.0, 0.2 - 0.1 * k), place))
        assert state.position == pytest.approx([-30.0, 0.2 - 0.1 * k], abs=0.05)


@pytest.mark.parametrize("name", ["h", "acceleration", "sigma"])
@pytest.mark.parametrize("value", [0.0, float("nan")])
def test_bad_parameters_of_the_filter_are_refused(name, value):
    given = {"positions": PLACES, "h": H, "acceleration": 1.0, "sigma": 0.1} | {name: value}
    with pytest.raises(InputError) as error:
        BearingKalman(**given)
    assert error.value.name == name
    for places in (np.zeros((3, 3)), np.full((2, 2), np.nan)):
        with pytest.raises(InputError) as error:
            BearingKalman(places, H, 1.0, 0.1)
        assert error.value.name == "positions"
