"""Run a scenario: sensors look, the estimator and its baselines step, everything is kept."""

from __future__ import annotations

from functools import partial
from typing import Any

from .parts import Scenario
from .run import Run
from .several import RunOfSeveral
from .systems import Simulated, simulated


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
    time = scenario.time
    system = simulated(part.system)
    found = system.run(scenario, chosen, time, scenario.target.at(time))
    kind = partial(RunOfSeveral, targets=scenario.targets) if scenario.targets else Run
    return kind(
        name=scenario.name,
        title=header.title,
        about=header.about,
        system=part.system,
        digest=found.digest,
        seed=chosen,
        assumptions=header.assumptions,
        parameters=found.parameters,
        time=time,
        target=found.target,
        sensors=found.sensors,
        estimates=found.estimates,
        labels=found.labels,
        events=_in_order([*_faults(scenario, system), *found.events]),
        notes=found.notes,
        summary_from=header.summary_from_s,
        extra=found.extra,
    )


def _faults(scenario: Scenario, system: Simulated) -> list[dict[str, Any]]:
    """When each fault begins, and ends if it does."""
    found = []
    for fault in scenario.faults:
        begins, ends = system.FAULTS[fault.kind]
        text = f"sensor {fault.sensor} {begins}"
        found.append({"time": fault.from_s, "kind": f"sensor_{fault.kind}", "text": text})
        if fault.until_s <= scenario.header.duration_s:
            again = f"sensor {fault.sensor} {ends}"
            found.append({"time": fault.until_s, "kind": "sensor_back", "text": again})
    return found


def _in_order(events: list[dict[str, Any]]) -> tuple[dict[str, Any], ...]:
    return tuple(sorted(events, key=lambda event: float(event["time"])))
