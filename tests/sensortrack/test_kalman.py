"""The baseline filter beside a batch solution and its own covariance."""

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.estimators.kalman import Kalman
from sensortrack.sensors import Average


def seen(position, velocity):
    return Average(np.array(position), np.array(velocity), ("a",), ())


def test_it_is_the_weighted_least_squares_estimate():
    """Without acceleration the mean is that of all measurements, carried to the last time."""
    rng = np.random.default_rng(3)
    kalman = Kalman(0.5, 1e-9, 2.0, 0.5)
    data = [(rng.normal(size=3), rng.normal(size=3)) for _ in range(12)]
    state = kalman.init(seen(*data[0]))
    for row in data[1:]:
        state = kalman.step(state, seen(*row))
    times = 0.5 * (np.arange(12) - 11)
    rows = np.concatenate(
        [np.stack([np.ones(12), times]).T / 2, np.stack([np.zeros(12), np.ones(12)]).T / 0.5]
    )
    right = np.concatenate([[p for p, _ in data], [v for _, v in data]])
    right = right / np.repeat([2.0, 0.5], 12)[:, None]
    assert state.mean == pytest.approx(np.linalg.lstsq(rows, right, rcond=None)[0], abs=1e-9)
    assert state.covariance == pytest.approx(np.linalg.inv(rows.T @ rows), rel=1e-9)


def test_the_covariance_settles_and_stays_positive():
    kalman = Kalman(0.1, 1.0, 0.3, 0.2)
    state = kalman.init(seen([0, 0, 0], [0, 0, 0]))
    for _ in range(3000):
        state = kalman.step(state, seen([0, 0, 0], [0, 0, 0]))
    assert np.linalg.eigvalsh(state.covariance)[0] > 0
    assert state.covariance == pytest.approx(state.covariance.T)
    again = kalman.step(state, seen([0, 0, 0], [0, 0, 0]))
    assert again.covariance == pytest.approx(state.covariance, rel=1e-9)


def test_unseen_it_only_predicts():
    kalman = Kalman(1.0, 1.0, 1.0, 1.0)
    state = kalman.init(seen([0, 0, 0], [1, 2, 3]))
    after = kalman.step(state, Average(None, None, (), ()))
    assert after.mean[0] == pytest.approx([1, 2, 3])
    assert after.covariance[0, 0] > state.covariance[0, 0]


@pytest.mark.parametrize("name", ["h", "acceleration", "position_sigma", "velocity_sigma"])
def test_parameters_above_zero_are_needed(name):
    good = {"h": 1.0, "acceleration": 1.0, "position_sigma": 1.0, "velocity_sigma": 1.0}
    with pytest.raises(InputError) as error:
        Kalman(**(good | {name: 0.0}))
    assert error.value.name == name
    with pytest.raises(InputError):
        Kalman(**good).init(Average(None, None, (), ()))
