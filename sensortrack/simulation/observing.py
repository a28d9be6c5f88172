"""What the sensors of a scenario measure, drawn so that one sensor's noise is its own."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from sensortrack.sensors import View

from .parts import FaultPart, Scenario, SensorPart

if TYPE_CHECKING:
    from .systems.variational import NoisePart

Floats = NDArray[np.float64]


def generator(seed: int, *names: str) -> np.random.Generator:
    """Random numbers of one component: adding another leaves them as they are."""
    keys = [zlib.crc32(name.encode()) for name in names]
    return np.random.default_rng(np.random.SeedSequence([seed, *keys]))


def paths(scenario: Scenario, time: Floats) -> dict[str, tuple[Floats, Floats]]:
    """Position and velocity of each sensor, rows by time."""
    return {
        sensor.name: (
            np.array(sensor.position_m) + time[:, None] * np.array(sensor.velocity_mps),
            np.tile(np.array(sensor.velocity_mps), (len(time), 1)),
        )
        for sensor in scenario.sensors
    }


def observed(
    scenario: Scenario, seed: int, time: Floats, target: tuple[Floats, Floats]
) -> list[list[View]]:
    """Views of the sensors that see the target, by sample."""
    columns = [_column(scenario, sensor, seed, time, target) for sensor in scenario.sensors]
    return [[view for view in row if view is not None] for row in zip(*columns, strict=True)]


def _column(
    scenario: Scenario, sensor: SensorPart, seed: int, time: Floats, target: tuple[Floats, Floats]
) -> Sequence[View | None]:
    place, rate = paths(scenario, time)[sensor.name]
    chi = _noise(scenario.noise, scenario.noise.position_m, seed, sensor.name, "position", time)
    nu = _noise(scenario.noise, scenario.noise.velocity_mps, seed, sensor.name, "velocity", time)
    seen = place - target[0] + chi + np.array(sensor.bias_position_m)
    moving = rate - target[1] + nu
    if scenario.estimator.velocity == "differenced":
        moving = np.vstack([moving[:1], np.diff(seen, axis=0) / scenario.estimator.h_s])
    faults = [fault for fault in scenario.faults if fault.sensor == sensor.name]
    blind, broken = (during(faults, kind, time) for kind in ("lost", "nan"))
    seen, moving = seen.copy(), moving.copy()
    seen[broken], moving[broken] = np.nan, np.nan
    return [
        None if blind[k] else View(sensor.name, place[k], rate[k], seen[k], moving[k])
        for k in range(len(time))
    ]


def _noise(
    noise: NoisePart, size: float, seed: int, sensor: str, what: str, time: Floats
) -> Floats:
    rng, shape = generator(seed, sensor, what), (len(time), 3)
    if noise.kind == "gaussian":
        return size * rng.standard_normal(shape)
    if noise.kind == "uniform":
        return size * rng.uniform(-1, 1, shape)
    return np.zeros(shape)


def during(faults: Sequence[FaultPart], kind: str, time: Floats) -> NDArray[np.bool_]:
    """Samples at which a fault of one kind lasts."""
    hit = np.zeros(len(time), dtype=bool)
    for fault in faults:
        if fault.kind == kind:
            hit |= (time >= fault.from_s - 1e-9) & (time < fault.until_s - 1e-9)
    return hit
