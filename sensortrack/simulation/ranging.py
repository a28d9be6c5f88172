"""Angles and distances of several targets, measured by sensors with relative errors."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.polar import polar_to

from .observing import during, generator
from .parts import Scenario, need, one_of

Floats = NDArray[np.float64]
KINDS = ("none", "gaussian")
LARGEST_BEARING_DEG = 60.0
"""Above it an angle tells less than nothing; a value in other units is likelier."""
LARGEST_SHARE = 0.125
"""Below it a measured distance is positive, but for one draw in 10^15."""


@dataclass(frozen=True)
class NoisePart:
    """Errors of every measurement: of the angle in degrees, of the distance relative to it."""

    kind: str = "none"
    bearing_deg: float = 0.0
    range_relative: float = 0.0

    @property
    def bearing(self) -> float:
        """Standard deviation of the angle in rad."""
        return float(np.deg2rad(self.bearing_deg))


@dataclass(frozen=True, eq=False)
class Measured:
    """What every sensor measures of every target; NaN where it does not.

    Parameters
    ----------
    sensors : array (sensors, 2)
        Where they are, in m.
    angle : array (samples, sensors, targets)
        In rad from the second axis towards the first.
    distance : array (samples, sensors, targets)
        In m.
    position : array (samples, sensors, targets, 2)
        Computed from the two, without bias, in m.
    covariance : array (samples, sensors, targets, 2, 2)
        Of that position's error at the true distance, in m^2; finite everywhere.
    """

    sensors: Floats
    angle: Floats
    distance: Floats
    position: Floats
    covariance: Floats


def check_noise(noise: NoisePart) -> None:
    """Refuse sizes that cannot be meant.

    Raises
    ------
    InputError
        With the name of the key.
    """
    one_of("noise.kind", noise.kind, KINDS)
    needed = f"0 to {LARGEST_BEARING_DEG:g} degrees are needed"
    good = 0 <= noise.bearing_deg <= LARGEST_BEARING_DEG
    need(good, "noise.bearing_deg", f"{noise.bearing_deg}", needed)
    relative = f"{noise.range_relative}"
    needed = f"a share of the distance, 0 to {LARGEST_SHARE:g}, is needed: 0.05 for 5 percent"
    good = 0 <= noise.range_relative <= LARGEST_SHARE
    need(good, "noise.range_relative", relative, needed)
    quiet = noise.kind == "none" and (noise.bearing_deg > 0 or noise.range_relative > 0)
    need(not quiet, "noise.kind", "none beside sizes above 0", "gaussian is needed")


def moments(noise: NoisePart) -> tuple[float, float]:
    """Variances along the line of sight and across it, for a distance of 1.

    Of the position e^(s^2/2) z_2 (sin z_1, cos z_1), which has no bias.

    References
    ----------
    Erofeeva & Granichin, (13), (14), with the factor that removes the bias and exact moments.
    """
    bearing = noise.bearing**2
    size = np.exp(bearing) * (1 + noise.range_relative**2)
    along = size * (1 + np.exp(-2 * bearing)) / 2 - 1
    across = -size * np.expm1(-2 * bearing) / 2
    return float(along), float(across)


def positions_of(sensors: Floats, angle: Floats, distance: Floats, bearing: float) -> Floats:
    """Positions without bias from angles and distances.

    Parameters
    ----------
    sensors : array (sensors, 2)
    angle, distance : array (..., sensors, targets)
    bearing : float
        Standard deviation of the angle in rad.
    """
    away = np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    found: Floats = sensors[:, None] + np.exp(bearing**2 / 2) * distance[..., None] * away
    return found


def measured(scenario: Scenario, seed: int, time: Floats, targets: Floats) -> Measured:
    """Measure; each sensor draws for each target by itself, so that another one changes none.

    Parameters
    ----------
    scenario : Scenario
    seed : int
    time : array (samples,)
    targets : array (samples, targets, 2)
        In m.
    """
    noise: NoisePart = scenario.noise
    places = np.array([sensor.position_m[:2] for sensor in scenario.sensors])
    apart = targets[:, None] - places[:, None]
    angle, distance = polar_to(targets[:, None], places[:, None])
    covariance = _turned(apart, *moments(noise))
    if noise.kind == "gaussian":
        angle = angle + noise.bearing * _drawn(scenario, seed, "angle", distance.shape)
        relative = noise.range_relative * _drawn(scenario, seed, "distance", distance.shape)
        distance = distance * (1 + relative)
    for q, sensor in enumerate(scenario.sensors):
        faults = [fault for fault in scenario.faults if fault.sensor == sensor.name]
        blind = during(faults, "lost", time) | during(faults, "nan", time)
        angle[blind, q] = distance[blind, q] = np.nan
    position = positions_of(places, angle, distance, noise.bearing)
    return Measured(places, angle, distance, position, covariance)


def _turned(apart: Floats, along: float, across: float) -> Floats:
    """rho^2 (along e e' + across (I - e e')), e towards the target: no division by rho."""
    square = (apart**2).sum(axis=-1)[..., None, None]
    outer = apart[..., :, None] * apart[..., None, :]
    found: Floats = (along - across) * outer + across * square * np.eye(2)
    return found


def _drawn(scenario: Scenario, seed: int, what: str, shape: tuple[int, ...]) -> Floats:
    found = np.empty(shape)
    for q, sensor in enumerate(scenario.sensors):
        for i, target in enumerate(scenario.targets):
            rng = generator(seed, sensor.name, target, what)
            found[:, q, i] = rng.standard_normal(shape[0])
    return found
