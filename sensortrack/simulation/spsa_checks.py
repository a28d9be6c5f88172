"""What a scenario of cyclic SPSA has to satisfy beyond the types of its keys."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sensortrack.estimators.cyclic_spsa import READINGS, RESOLVED

from .parts import Scenario, SensorPart, need, one_of
from .ranging import check_noise
from .spsa_settings import SCALES, StartPart, Variant, variants
from .spsa_teams import team_of

Floats = NDArray[np.float64]
LARGEST = 1e12
"""Of a length in m and of every other number, so that no square or product overflows."""
FARTHEST = 1e30
"""Of an error that counts as followed; a step from there is finite, and its square too."""


def check_scenario(scenario: Scenario, reserved: Sequence[str]) -> None:
    """Demand that sensors, targets, noise, start and every setting fit each other.

    Parameters
    ----------
    scenario : Scenario
    reserved : sequence of str
        Names that no setting may have.

    Raises
    ------
    InputError
        With the name of the key.
    """
    for sensor in scenario.sensors:
        _check_sensor(sensor)
    check_noise(scenario.noise)
    part = scenario.estimator
    one_of("estimator.scale", part.scale, SCALES)
    needed = f"0, for without limit, or a distance up to {LARGEST:g} m is needed"
    need(0 <= part.reach_m <= LARGEST, "estimator.reach_m", f"{part.reach_m}", needed)
    _check_size("estimator.diverged_m", part.diverged_m, FARTHEST)
    _check_size("scenario.kalman_acceleration", scenario.header.kalman_acceleration)
    _check_start(scenario.parts.get("start"))
    _check_names([variant.name for variant in scenario.parts["variant"]], reserved)
    paths = scenario.target.at(scenario.time)[0][..., :2]
    places = np.array([sensor.position_m[:2] for sensor in scenario.sensors])
    far = _check_paths(scenario, paths, places)
    for variant in variants(scenario):
        _check_setting(variant, far)
        team_of(scenario, variant, paths, scenario.header.seed)


def _check_sensor(sensor: SensorPart) -> None:
    moving = f"{sensor.name} moves"
    need(not any(sensor.velocity_mps), "sensor.velocity_mps", moving, "sensors at rest")
    for key in ("weight", "bias_position_m"):
        found = f"given of {sensor.name}"
        unused = not np.any(getattr(sensor, key))
        need(unused, f"sensor.{key}", found, "none is needed: this system has no such key")


def _check_size(name: str, value: float, most: float = LARGEST) -> None:
    needed = f"a number above 0, up to {most:g}, is needed"
    need(0 < value <= most, name, f"{value}", needed)


def _check_start(part: StartPart | None) -> None:
    if part is None:
        return
    for key, corner in (("low_m", part.low_m), ("high_m", part.high_m)):
        needed = f"lengths up to {LARGEST:g} m are needed"
        need(max(map(abs, corner)) <= LARGEST, f"start.{key}", f"{list(corner)}", needed)
    good = all(low <= high for low, high in zip(part.low_m, part.high_m, strict=True))
    found = f"{list(part.high_m)} beside {list(part.low_m)}"
    need(good, "start.high_m", found, "numbers not below those of low_m are needed")


def _check_names(names: Sequence[str], reserved: Sequence[str]) -> None:
    for name in names:
        need(name != "", "variant.name", "an empty text", "a name is needed")
        needed = f"another name is needed: {', '.join(reserved)} are baselines"
        need(name not in reserved, "variant.name", repr(name), needed)
        need(names.count(name) == 1, "variant.name", f"{name} twice", "one each is needed")


def _check_paths(scenario: Scenario, paths: Floats, places: Floats) -> float:
    """Refuse what overflows, and targets that rest at a sensor; the largest coordinate in m."""
    needed = f"positions within {LARGEST:g} m are needed"
    far = float(np.abs(places).max())
    need(far <= LARGEST, "sensor.position_m", f"{far:g} m", needed)
    for i, name in enumerate(scenario.targets):
        away = float(np.abs(paths[:, i]).max())
        need(away <= LARGEST, "target", f"target {name} comes to {away:g} m", needed)
        far = max(far, away)
        for sensor, place in zip(scenario.sensors, places, strict=True):
            found = f"target {name} is at sensor {sensor.name} all the time"
            apart = bool((paths[:, i] != place).any())
            need(apart, "target", found, "a distance, which has an error, is needed")
    return far


def _check_setting(variant: Variant, far: float) -> None:
    table = variant.table
    one_of(f"{table}.reading", variant.reading, READINGS)
    _check_size(f"{table}.alpha", variant.alpha)
    _check_size(f"{table}.beta_m", variant.beta_m)
    found = f"{variant.beta_m} m beside positions of {far:g} m"
    needed = "a perturbation that is not lost in their rounding is needed"
    need(max(far, 1 / LARGEST) <= RESOLVED * variant.beta_m, f"{table}.beta_m", found, needed)
