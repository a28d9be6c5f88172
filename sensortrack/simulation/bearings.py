"""Bearings that the sensors of a scenario measure, and the estimator that it asks for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.estimators.bearing_dac import BearingDac
from sensortrack.networks import Network
from sensortrack.sensors import bearings_to

from .observing import during, generator
from .parts import Scenario

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class NoisePart:
    """Noise of every bearing: a standard deviation or a largest value, in degrees."""

    kind: str = "none"
    bearing_deg: float = 0.0


@dataclass(frozen=True)
class EstimatorPart:
    """Gains, step and law of the consensus; ``shown`` is the sensor whose position is drawn."""

    system: str
    beta_P: float
    beta_q: float
    h_s: float
    method: str = "implicit"
    sign: str = "componentwise"
    entries: str = "reduced"
    missing: str = "hold"
    det_min: float = 1e-9
    origin: str = "zero"
    shown: str = ""


def places(scenario: Scenario) -> Floats:
    """Positions of the sensors in the plane, in m."""
    return np.array([sensor.position_m[:2] for sensor in scenario.sensors])


def seen_by(scenario: Scenario, seed: int, time: Floats, target: Floats) -> Floats:
    """Bearings in rad, samples by sensors; NaN where a sensor has none.

    Parameters
    ----------
    scenario : Scenario
    seed : int
    time : array (samples,)
    target : array (samples, 2)
    """
    columns = []
    for sensor, place in zip(scenario.sensors, places(scenario), strict=True):
        angle = bearings_to(target, place) + _noise(scenario.noise, seed, sensor.name, len(time))
        faults = [fault for fault in scenario.faults if fault.sensor == sensor.name]
        blind = during(faults, "lost", time) | during(faults, "nan", time)
        columns.append(np.where(blind, np.nan, angle))
    return np.stack(columns, axis=1)


def _noise(noise: NoisePart, seed: int, sensor: str, count: int) -> Floats:
    rng, size = generator(seed, sensor, "bearing"), np.deg2rad(noise.bearing_deg)
    if noise.kind == "gaussian":
        return np.asarray(size * rng.standard_normal(count))
    if noise.kind == "uniform":
        return np.asarray(size * rng.uniform(-1, 1, count))
    return np.zeros(count)


def sigma_of(noise: NoisePart) -> float:
    """Standard deviation of each bearing in rad."""
    spread = {"none": 0.0, "gaussian": 1.0, "uniform": 1 / np.sqrt(3)}[noise.kind]
    return float(spread * np.deg2rad(noise.bearing_deg))


def estimator_of(scenario: Scenario, network: Network, law: str = "bearing_dac") -> BearingDac:
    """The estimator of a scenario, or one of its distributed baselines.

    Parameters
    ----------
    scenario : Scenario
    network : Network
    law : str, optional
        ``bearing_dac``, ``explicit`` (the same by explicit steps) or ``linear``.

    Raises
    ------
    InputError
        With the name of the key that is out of range.
    """
    part, flat = scenario.estimator, places(scenario)
    try:
        return BearingDac(
            network=network,
            positions={s.name: p for s, p in zip(scenario.sensors, flat, strict=True)},
            beta_P=part.beta_P,
            beta_q=part.beta_q,
            h=part.h_s,
            method="explicit" if law == "explicit" else part.method,
            sign="linear" if law == "linear" else part.sign,
            entries=part.entries,
            missing=part.missing,
            det_min=part.det_min,
            origin=flat.mean(axis=0) if part.origin == "centroid" else (0.0, 0.0),
        )
    except InputError as error:
        raise InputError(f"estimator.{error.name}", error.found, error.needed) from None
