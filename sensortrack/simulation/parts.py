"""What every scenario is made of, whatever system it runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.sensors import checked_weights
from sensortrack.tables import Vector
from sensortrack.targets import Several, Target


@dataclass(frozen=True)
class SensorPart:
    """One sensor, moving with constant velocity."""

    name: str
    position_m: Vector
    velocity_mps: Vector = (0.0, 0.0, 0.0)
    weight: float = 0.0
    bias_position_m: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class FaultPart:
    """From one time to another something is wrong with a sensor: ``lost``, ``nan``, ..."""

    kind: str
    sensor: str
    from_s: float
    until_s: float = float("inf")


@dataclass(frozen=True)
class Header:
    """What the file says about itself."""

    title: str
    about: str
    duration_s: float
    seed: int = 0
    assumptions: tuple[str, ...] = ()
    baselines: tuple[str, ...] = ()
    kalman_acceleration: float = 1.0
    summary_from_s: float = 0.0


@dataclass(frozen=True)
class Scenario:
    """Everything that a run depends on.

    `noise` and `estimator` are tables of the system, as are its own ones in `parts`.
    """

    name: str
    header: Header
    target: Target
    sensors: tuple[SensorPart, ...]
    noise: Any
    faults: tuple[FaultPart, ...]
    estimator: Any
    parts: Mapping[str, Any] = field(default_factory=dict)

    @property
    def weights(self) -> dict[str, float]:
        """Weights of all sensors, of sum one; equal ones if none is given."""
        given = {sensor.name: sensor.weight for sensor in self.sensors}
        if not any(given.values()):
            return dict.fromkeys(given, 1.0 / len(given))
        return checked_weights(given)

    @property
    def time(self) -> NDArray[np.float64]:
        """Times of the samples in s, the start included."""
        count = round(self.header.duration_s / self.estimator.h_s) + 1
        return np.asarray(self.estimator.h_s * np.arange(count, dtype=np.float64))

    @property
    def targets(self) -> tuple[str, ...]:
        """Names of the targets, none where the system follows a single one."""
        return self.target.names if isinstance(self.target, Several) else ()

    def to_data(self) -> dict[str, Any]:
        """Return the scenario as JSON data."""
        return asdict(self)


def one_of(name: str, value: str, known: tuple[str, ...]) -> None:
    """Demand one of a few words.

    Raises
    ------
    InputError
        With this name.
    """
    need(value in known, name, f"{value!r}", f"one of {', '.join(known)} is needed")


def need(good: bool, name: str, found: str, needed: str) -> None:
    """Raise an `InputError` unless the condition holds."""
    if not good:
        raise InputError(name, found, needed)
