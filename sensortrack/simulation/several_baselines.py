"""What several targets are followed with beside cyclic SPSA, on the same measurements."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sensortrack.estimators.position_kalman import PositionKalman

from .parts import Scenario
from .ranging import Measured
from .spsa_following import Starts
from .spsa_teams import Team

Floats = NDArray[np.float64]
SPEED = 1000.0
"""Standard deviation in m/s of a velocity of which nothing is known: a fast aircraft's."""
SMALLEST = 1e-6
"""Variance in m^2: a filter that trusts positions without end has no gain left to speak of."""


def filtered(scenario: Scenario, team: Team, seen: Measured) -> Floats:
    """One Kalman filter a sensor and target, on every measurement of the target's source.

    Returns
    -------
    array (samples, sensors, targets, 2)
        In m; NaN before the first measurement and where a sensor does not follow a target.
    """
    place, covariance = received(team, seen)
    part, acceleration = scenario.estimator, scenario.header.kalman_acceleration
    kalman = PositionKalman(part.h_s, acceleration, SPEED)
    noise = covariance + SMALLEST * np.eye(2)
    state = kalman.init(place[0], noise[0])
    found = [state.mean[..., :2]]
    for row, spread in zip(place[1:], noise[1:], strict=True):
        state = kalman.step(state, row, spread)
        found.append(state.mean[..., :2])
    return np.stack(found)


def received(team: Team, seen: Measured) -> tuple[Floats, Floats]:
    """Positions and covariances that reach each sensor: of each target its source's."""
    sources = team.sources
    columns = np.arange(sources.shape[1])
    place = seen.position[:, sources, columns].copy()
    place[:, sources < 0] = np.nan
    return place, seen.covariance[:, sources, columns]


@np.errstate(over="ignore", invalid="ignore")
def averaged(scenario: Scenario, team: Team, seen: Measured, start: Starts) -> Floats:
    """Gradient steps with consensus: at every sample each sensor descends, then averages.

    A sensor steps along the exact gradient of the sum of its own and its neighbours' costs at their
    newest measurements, with step size alpha, then takes the mean of its own and its neighbours'
    estimates of each target.

    Returns
    -------
    array (samples, sensors, targets, 2)
        In m.
    """
    linked = _linked(scenario, team)
    weights = np.nan_to_num(team.weights)
    now = np.array(
        [[start[name].get(t, (np.nan, np.nan)) for t in team.targets] for name in team.agents]
    )
    found = [now]
    for row in seen.position[1:]:
        known = np.isfinite(row).all(axis=-1)
        h = np.where(known, weights, 0.0)
        pull = h[..., None] * np.where(known[..., None], row, 0.0)
        total = np.einsum("jq,qi->ji", linked, h)
        gradient = total[..., None] * now - np.einsum("jq,qic->jic", linked, pull)
        stepped = now - scenario.estimator.alpha * gradient
        follows = np.isfinite(stepped).all(axis=-1)
        share = np.einsum("jq,qi->ji", linked, follows.astype(float))
        mean = np.einsum("jq,qic->jic", linked, np.where(follows[..., None], stepped, 0.0))
        now = np.where(follows[..., None], mean / np.maximum(share, 1.0)[..., None], np.nan)
        found.append(now)
    return np.stack(found)


def _linked(scenario: Scenario, team: Team) -> Floats:
    """Who hears whom, itself included: the nearest, as for SPSA."""
    places = np.array([sensor.position_m[:2] for sensor in scenario.sensors])
    apart = np.linalg.norm(places[:, None] - places, axis=2)
    np.fill_diagonal(apart, -1.0)
    order = np.argsort(apart, axis=1, kind="stable")[:, : team.variant.n_max + 1]
    found = np.zeros((len(places), len(places)))
    np.put_along_axis(found, order, 1.0, axis=1)
    return found
