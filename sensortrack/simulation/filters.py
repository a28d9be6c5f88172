"""Baselines of bearing sensors that have all bearings in one place."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sensortrack.estimators.bearing_filters import BearingKalman, BearingKalmanState, intersect

from .bearings import places, sigma_of
from .parts import Scenario

Floats = NDArray[np.float64]
SMALLEST_SIGMA = 1e-6
"""In rad: a filter that trusts bearings without end has no gain left to speak of."""


def met(scenario: Scenario, angles: Floats) -> Floats:
    """Where the lines of sight of each sample meet, samples by 2; NaN where they do not."""
    flat, det_min = places(scenario), scenario.estimator.det_min
    found = [intersect(row, flat, det_min=det_min) for row in angles]
    return np.array([np.full(2, np.nan) if place is None else place for place in found])


def filtered(scenario: Scenario, angles: Floats) -> tuple[Floats, Floats]:
    """Positions and velocities of the filter, which knows the size of the noise."""
    sigma = max(sigma_of(scenario.noise), SMALLEST_SIGMA)
    header = scenario.header
    kalman = BearingKalman(
        places(scenario), scenario.estimator.h_s, header.kalman_acceleration, sigma
    )
    state, rows = BearingKalmanState(), []
    for row in angles:
        state = kalman.step(state, row)
        rows.append(np.concatenate([state.position, state.velocity]))
    stacked = np.array(rows)
    return stacked[:, :2], stacked[:, 2:]
