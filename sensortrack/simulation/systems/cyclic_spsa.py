"""Cyclic SPSA of several targets, in several settings on the same data, beside other estimators."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.generated import cyclic_spsa as generated
from sensortrack.simulation.parts import Scenario, need, one_of
from sensortrack.simulation.placement import NetworkPart, PlacementPart, placed
from sensortrack.simulation.ranging import Measured, NoisePart, measured, moments
from sensortrack.simulation.run import rounded
from sensortrack.simulation.several import EXACT, distance_text, until
from sensortrack.simulation.several_baselines import averaged, filtered
from sensortrack.simulation.spsa_checks import check_scenario
from sensortrack.simulation.spsa_following import Followed, Starts, follow, starts
from sensortrack.simulation.spsa_settings import (
    EstimatorPart,
    StartPart,
    Variant,
    VariantPart,
    variants,
)
from sensortrack.simulation.spsa_teams import Team, team_of

from . import Found, merged

Floats = NDArray[np.float64]
SEVERAL = True
BASELINES = ("plain", "gradient", "kalman")
LABELS = {
    "cyclic_spsa": "cyclic SPSA",
    "plain": "SPSA, all targets at once",
    "gradient": "gradient steps with consensus",
    "kalman": "Kalman filters",
}
AGAIN = "measures again"
OWN = ("alpha", "beta_m", "reading", "n_max", "m_max")
"""Keys of the estimator that a variant may change."""
FAULTS = {"lost": ("measures nothing", AGAIN), "nan": ("sends no numbers", AGAIN)}

TABLES: Mapping[str, type] = {
    "noise": NoisePart,
    "estimator": EstimatorPart,
    "start": StartPart,
    "placement": PlacementPart,
}
LISTS: Mapping[str, type] = {"variant": VariantPart}


def complete(scenario: Scenario) -> Scenario:
    """Place sensors that are not listed.

    Raises
    ------
    InputError
        Sensors are listed and placed, or the placement is not possible.
    """
    if "placement" not in scenario.parts:
        return scenario
    listed = f"beside {len(scenario.sensors)} [[sensor]]"
    need(not scenario.sensors, "placement", listed, "sensors either listed or placed are needed")
    part = scenario.parts["placement"]
    one_of("placement.kind", part.kind, ("ring", "random"))
    return replace(scenario, sensors=placed(part, NetworkPart()))


def check(scenario: Scenario) -> None:
    """What no single key shows.

    Raises
    ------
    InputError
        With the name of the key.
    """
    check_scenario(scenario, BASELINES)


def run(scenario: Scenario, seed: int, time: Floats, target: tuple[Floats, Floats]) -> Found:
    """Let sensors measure, exchange measurements and follow the targets, in the plane x, y.

    Raises
    ------
    InputError
        There is no start and a sensor has no first measurement.
    """
    path = _flat(target[0]), _flat(target[1])
    truth = path[0][..., :2]
    seen = measured(scenario, seed, time, truth)
    teams = {v.name: team_of(scenario, v, truth, seed) for v in _all_settings(scenario)}
    first = {name: starts(scenario, team, seen, seed) for name, team in teams.items()}
    limit = scenario.estimator.diverged_m
    followed = {
        name: follow(team, seen, time, truth, first[name], limit) for name, team in teams.items()
    }
    others = {
        name: until(place, truth, limit)
        for name, place in _baselines(scenario, seen, next(iter(teams.values())), first).items()
    }
    ends = {name: found.diverged for name, found in followed.items()}
    ends |= {name: end for name, (_, end) in others.items()}
    return Found(
        digest=generated.DIGEST,
        target=path,
        sensors={
            sensor.name: np.tile(np.array(sensor.position_m), (len(time), 1))
            for sensor in scenario.sensors
        },
        estimates={
            name: _placed(place)
            for name, place in {
                **{name: found.positions for name, found in followed.items()},
                **{name: place for name, (place, _) in others.items()},
            }.items()
        },
        labels={name: LABELS.get(name, name) for name in [*teams, *BASELINES]},
        parameters=_parameters(scenario),
        notes=merged([note for found in followed.values() for note in found.notes]),
        events=_diverged(ends, time, limit),
        extra={"spsa": _record(scenario, teams, followed)},
    )


def _all_settings(scenario: Scenario) -> tuple[Variant, ...]:
    """Those of the estimator and its variants, and all targets at once if that is asked for."""
    own = variants(scenario)
    if "plain" not in scenario.header.baselines:
        return own
    together = len(scenario.targets)
    return (*own, replace(own[0], name="plain", m_max=together))


def _baselines(
    scenario: Scenario, seen: Measured, team: Team, first: Mapping[str, Starts]
) -> dict[str, Floats]:
    """Positions that other estimators find from what reaches the sensors."""
    asked, made = scenario.header.baselines, {}
    if "gradient" in asked:
        made["gradient"] = averaged(scenario, team, seen, first[team.variant.name])
    if "kalman" in asked:
        made["kalman"] = filtered(scenario, team, seen)
    return made


def _flat(rows: Floats) -> Floats:
    """Angle and distance are of the plane x, y."""
    found = rows.copy()
    found[..., 2] = 0.0
    return found


def _placed(places: Floats) -> tuple[Floats, Floats]:
    """Two coordinates as three, and no velocities."""
    height = np.where(np.isfinite(places).all(axis=-1, keepdims=True), 0.0, np.nan)
    found = np.concatenate([places, height], axis=-1)
    return found, np.full_like(found, np.nan)


def _diverged(
    ends: Mapping[str, int | None], time: Floats, limit: float
) -> tuple[dict[str, Any], ...]:
    passed = distance_text(limit)
    return tuple(
        {
            "time": float(time[end]),
            "kind": "diverged",
            "of": name,
            "text": f"{LABELS.get(name, name)} has diverged: its error passes {passed}",
        }
        for name, end in ends.items()
        if end is not None
    )


def _parameters(scenario: Scenario) -> Mapping[str, Any]:
    part, noise = scenario.estimator, scenario.noise
    listed = scenario.parts["variant"]
    own: dict[str, Any] = {name: getattr(part, name) for name in OWN}
    return {
        "h": part.h_s,
        **({} if listed else own),
        **{f"setting: {v.name}": _text(v) for v in variants(scenario) if listed},
        "scale": part.scale,
        "reach": part.reach_m or "without limit",
        "noise": f"{noise.kind}, {noise.bearing_deg} deg, {100 * noise.range_relative:g} % of the "
        "distance",
    }


def _text(setting: Variant) -> str:
    """A setting in one line."""
    return (
        f"alpha {setting.alpha:g}, beta {setting.beta_m:g} m, reading {setting.reading}, "
        f"n_max {setting.n_max}, m_max {setting.m_max}"
    )


def _record(
    scenario: Scenario, teams: Mapping[str, Team], followed: Mapping[str, Followed]
) -> dict[str, Any]:
    """Who followed what with which numbers, from which start: what closed forms need."""
    along, across = moments(scenario.noise)
    return {
        "noise": {"kind": scenario.noise.kind, "along": along, "across": across},
        "diverged_m": scenario.estimator.diverged_m,
        "variants": [
            {
                "name": name,
                "alpha": team.variant.alpha,
                "beta": team.variant.beta_m,
                "reading": team.variant.reading,
                "n_max": team.variant.n_max,
                "m_max": team.variant.m_max,
                "shares": team.record(),
                "start": rounded(followed[name].positions[0], EXACT),
            }
            for name, team in teams.items()
        ],
    }
