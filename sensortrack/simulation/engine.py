"""Run a scenario: sensors look, the estimator and its baselines step, everything is kept."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.estimators.kalman import Kalman
from sensortrack.estimators.variational import Variational
from sensortrack.kernels.steppers import stepper
from sensortrack.sensors import View, average

from .observing import observed, paths
from .run import Run
from .scenario import Scenario

Floats = NDArray[np.float64]
SMALLEST_SIGMA = 1e-6
LABELS = {
    "variational": "variational estimator",
    "kalman": "Kalman filter",
    "raw": "raw average",
}


def simulate(scenario: Scenario, seed: int | None = None) -> Run:
    """Run a scenario once.

    Parameters
    ----------
    scenario : Scenario
    seed : int, optional
        Instead of the scenario's own.

    Returns
    -------
    Run
        The same for the same scenario and seed, bit by bit.

    Raises
    ------
    InputError
        The first sample has no measurement, or a track ends too early.
    """
    part, header = scenario.estimator, scenario.header
    chosen = header.seed if seed is None else seed
    count = round(header.duration_s / part.h_s) + 1
    time: Floats = part.h_s * np.arange(count, dtype=np.float64)
    target = scenario.target.at(time)
    views = observed(scenario, chosen, time, target)
    found, notes = _estimated(scenario, time, views)
    estimates = {"variational": found, **_baselines(scenario, views)}
    return Run(
        name=scenario.name,
        title=header.title,
        about=header.about,
        digest=stepper("variational").digest,
        seed=chosen,
        assumptions=header.assumptions,
        parameters=_parameters(scenario),
        time=time,
        target=target,
        sensors={name: path[0] for name, path in paths(scenario, time).items()},
        estimates=estimates,
        labels=LABELS,
        events=_events(scenario),
        notes=notes,
        summary_from=header.summary_from_s,
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
    return (np.array(places), np.array(rates)), _merged(notes)


def _merged(notes: Sequence[tuple[float, tuple[str, ...]]]) -> tuple[str, ...]:
    """Notes with the time at which each begins and how many samples it lasts."""
    first: dict[str, float] = {}
    times: dict[str, int] = {}
    for t, texts in notes:
        for text in texts:
            first.setdefault(text, float(t))
            times[text] = times.get(text, 0) + 1
    return tuple(f"{text} ({times[text]} samples, first at {first[text]:g} s)" for text in first)


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


def _events(scenario: Scenario) -> tuple[dict[str, Any], ...]:
    words = {"lost": "no longer sees the target", "nan": "sends no numbers"}
    found = []
    for fault in scenario.faults:
        text = f"sensor {fault.sensor} {words[fault.kind]}"
        found.append({"time": fault.from_s, "kind": f"sensor_{fault.kind}", "text": text})
        if fault.until_s <= scenario.header.duration_s:
            again = f"sensor {fault.sensor} sees the target again"
            found.append({"time": fault.until_s, "kind": "sensor_back", "text": again})
    return tuple(sorted(found, key=lambda event: float(event["time"])))
