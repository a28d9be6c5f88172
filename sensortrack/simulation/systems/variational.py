"""The variational estimator beside a Kalman filter and the raw average."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.estimators.kalman import Kalman
from sensortrack.estimators.variational import Variational
from sensortrack.kernels.steppers import stepper
from sensortrack.sensors import View, average
from sensortrack.simulation.observing import observed, paths
from sensortrack.simulation.parts import Scenario, need, one_of
from sensortrack.tables import Vector

from . import Found, merged

Floats = NDArray[np.float64]
SMALLEST_SIGMA = 1e-6
LABELS = {
    "variational": "variational estimator",
    "kalman": "Kalman filter",
    "raw": "raw average",
}
SEVERAL = False
BASELINES = ("raw", "kalman")
AGAIN = "sees the target again"
FAULTS = {"lost": ("no longer sees the target", AGAIN), "nan": ("sends no numbers", AGAIN)}


@dataclass(frozen=True)
class NoisePart:
    """Measurement noise of each sensor: per coordinate a standard deviation or a largest value."""

    kind: str = "none"
    position_m: float = 0.0
    velocity_mps: float = 0.0


@dataclass(frozen=True)
class EstimatorPart:
    """Gains and step of the variational estimator; a gain is a number or a 3 by 3 list."""

    system: str
    M: Any
    K: Any
    C: Any
    h_s: float
    scheme: str = "printed"
    delay_samples: int = 0
    velocity: str = "measured"
    start_offset_m: Vector = (0.0, 0.0, 0.0)
    start_rate_mps: Vector = (0.0, 0.0, 0.0)


TABLES: Mapping[str, type] = {"noise": NoisePart, "estimator": EstimatorPart}
LISTS: Mapping[str, type] = {}


def complete(scenario: Scenario) -> Scenario:
    """Nothing is said in short."""
    return scenario


def check(scenario: Scenario) -> None:
    """What no single key shows.

    Raises
    ------
    InputError
        With the name of the key.
    """
    one_of("estimator.velocity", scenario.estimator.velocity, ("measured", "differenced"))
    one_of("noise.kind", scenario.noise.kind, ("none", "gaussian", "uniform"))
    sizes = (scenario.noise.position_m, scenario.noise.velocity_mps)
    need(min(sizes) >= 0, "noise", f"{min(sizes)}", "sizes of 0 or more are needed")
    quiet = scenario.noise.kind == "none" and any(sizes)
    need(not quiet, "noise.kind", "none beside sizes above 0", "gaussian or uniform is needed")


def run(scenario: Scenario, seed: int, time: Floats, target: tuple[Floats, Floats]) -> Found:
    """Let sensors look, the estimator and its baselines step.

    Raises
    ------
    InputError
        The first sample has no measurement, or a gain is not definite.
    """
    views = observed(scenario, seed, time, target)
    found, notes = _estimated(scenario, time, views)
    return Found(
        digest=stepper("variational").digest,
        target=target,
        sensors={name: path[0] for name, path in paths(scenario, time).items()},
        estimates={"variational": found, **_baselines(scenario, views)},
        labels=LABELS,
        parameters=_parameters(scenario),
        notes=notes,
    )


def _estimated(
    scenario: Scenario, time: Floats, views: Sequence[Sequence[View]]
) -> tuple[tuple[Floats, Floats], tuple[str, ...]]:
    part, weights = scenario.estimator, scenario.weights
    estimator = Variational(
        M=part.M,
        K=part.K,
        C=part.C,
        h=part.h_s,
        weights=weights,
        scheme=part.scheme,
        delay=part.delay_samples,
    )
    first = average(views[0], weights).position
    start = None if first is None else first + np.array(part.start_offset_m)
    state = estimator.init(views[0], float(time[0]), start, part.start_rate_mps)
    places, rates, notes = [state.position], [state.velocity], [(time[0], state.notes)]
    for t, seen in zip(time[1:], views[1:], strict=True):
        state = estimator.step(float(t), state, seen)
        places.append(state.position)
        rates.append(state.velocity)
        notes.append((t, state.notes))
    return (np.array(places), np.array(rates)), merged(notes)


def _baselines(
    scenario: Scenario, views: Sequence[Sequence[View]]
) -> dict[str, tuple[Floats, Floats]]:
    seen = [average(row, scenario.weights) for row in views]
    blank = np.full(3, np.nan)
    made: dict[str, tuple[Floats, Floats]] = {}
    if "kalman" in scenario.header.baselines:
        made["kalman"] = _kalman(scenario, seen)
    if "raw" in scenario.header.baselines:
        made["raw"] = (
            np.array([blank if entry.position is None else entry.position for entry in seen]),
            np.array([blank if entry.velocity is None else entry.velocity for entry in seen]),
        )
    return made


def _kalman(scenario: Scenario, seen: Sequence[Any]) -> tuple[Floats, Floats]:
    """The filter knows the size of the noise and the weights, as a user who tuned it would."""
    noise, share = scenario.noise, np.sqrt(sum(w**2 for w in scenario.weights.values()))
    spread = 1 / np.sqrt(3) if noise.kind == "uniform" else 1.0
    sigmas = (
        max(spread * share * size, SMALLEST_SIGMA)
        for size in (noise.position_m, noise.velocity_mps)
    )
    kalman = Kalman(scenario.estimator.h_s, scenario.header.kalman_acceleration, *sigmas)
    state = kalman.init(seen[0])
    means = [state.mean]
    for entry in seen[1:]:
        state = kalman.step(state, entry)
        means.append(state.mean)
    stacked = np.array(means)
    return stacked[:, 0], stacked[:, 1]


def _parameters(scenario: Scenario) -> Mapping[str, Any]:
    part = scenario.estimator
    return {
        "M": part.M,
        "K": part.K,
        "C": part.C,
        "h": part.h_s,
        "scheme": part.scheme,
        "delay": part.delay_samples,
        "velocity": part.velocity,
        "weights": scenario.weights,
        "noise": f"{scenario.noise.kind}, {scenario.noise.position_m} m, "
        f"{scenario.noise.velocity_mps} m/s",
    }
