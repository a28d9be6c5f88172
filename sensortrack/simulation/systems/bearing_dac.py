"""Bearing sensors with consensus beside explicit and linear steps, least squares and a filter."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.estimators.bearing_noise import covariance
from sensortrack.kernels.steppers import stepper
from sensortrack.simulation.bearings import (
    EstimatorPart,
    NoisePart,
    estimator_of,
    places,
    seen_by,
    sigma_of,
)
from sensortrack.simulation.consensus_run import Follower, Trace
from sensortrack.simulation.filters import filtered, met
from sensortrack.simulation.links import DropoutPart, OutagePart, carrying, outage_events
from sensortrack.simulation.parts import Scenario, need, one_of
from sensortrack.simulation.placement import NetworkPart, PlacementPart, network_of, placed

from . import Found, merged

Floats = NDArray[np.float64]
LABELS = {
    "bearing_dac": "sign consensus",
    "explicit": "sign consensus, explicit steps",
    "linear": "linear consensus",
    "least_squares": "least squares, all bearings in one place",
    "ekf": "extended Kalman filter, all bearings in one place",
}
SEVERAL = False
BASELINES = ("explicit", "linear", "least_squares", "ekf")
AGAIN = "sees the target again"
FAULTS = {
    "lost": ("no longer sees the target", AGAIN),
    "nan": ("sends no numbers", AGAIN),
    "leaves": ("leaves and hands over what it holds", "takes part again"),
    "fails": ("fails without a word", "takes part again"),
}
TABLES: Mapping[str, type] = {
    "noise": NoisePart,
    "estimator": EstimatorPart,
    "network": NetworkPart,
    "placement": PlacementPart,
    "dropout": DropoutPart,
}
LISTS: Mapping[str, type] = {"outage": OutagePart}


def complete(scenario: Scenario) -> Scenario:
    """Place sensors that are not listed.

    Raises
    ------
    InputError
        Sensors are listed and placed, or the placement is not possible.
    """
    need("network" in scenario.parts, "network", "not given", "a table [network] is needed")
    if "placement" not in scenario.parts:
        return scenario
    listed = f"beside {len(scenario.sensors)} [[sensor]]"
    need(not scenario.sensors, "placement", listed, "sensors either listed or placed are needed")
    made = placed(scenario.parts["placement"], scenario.parts["network"])
    return replace(scenario, sensors=made)


def check(scenario: Scenario) -> None:
    """What no single key shows.

    Raises
    ------
    InputError
        With the name of the key.
    """
    names = tuple(sensor.name for sensor in scenario.sensors)
    for sensor in scenario.sensors:
        moving = f"{sensor.name} moves"
        needed = "sensors at rest are needed: moving ones change what is averaged"
        need(not any(sensor.velocity_mps), "sensor.velocity_mps", moving, needed)
    noise, part = scenario.noise, scenario.estimator
    one_of("noise.kind", noise.kind, ("none", "gaussian", "uniform"))
    need(noise.bearing_deg >= 0, "noise.bearing_deg", f"{noise.bearing_deg}", "0 or more is needed")
    quiet = noise.kind == "none" and noise.bearing_deg > 0
    need(not quiet, "noise.kind", "none beside a size above 0", "gaussian or uniform is needed")
    one_of("estimator.origin", part.origin, ("zero", "centroid"))
    one_of("estimator.shown", part.shown or names[0], names)
    estimator = estimator_of(scenario, _network(scenario))
    rate = scenario.parts.get("dropout", DropoutPart()).rate
    needed = "a probability of 0 or more, below 1, is needed"
    need(0 <= rate < 1, "dropout.rate", f"{rate}", needed)
    linked = {frozenset(names[i] for i in edge) for edge in np.asarray(estimator.network.edges)}
    for outage in scenario.parts["outage"]:
        pair = " and ".join(outage.link)
        need(frozenset(outage.link) in linked, "outage.link", f"{pair} are not linked", "a link")
        order = f"{outage.from_s} s to {outage.until_s} s"
        need(outage.from_s < outage.until_s, "outage.until_s", order, "a later time is needed")


def _network(scenario: Scenario) -> Any:
    names = tuple(sensor.name for sensor in scenario.sensors)
    return network_of(scenario.parts["network"], names, places(scenario))


def run(scenario: Scenario, seed: int, time: Floats, target: tuple[Floats, Floats]) -> Found:
    """Let sensors look and the estimators follow, in the plane x, y.

    Raises
    ------
    InputError
        No sensor sees the target in the first sample.
    """
    path = _flat(target[0]), _flat(target[1])
    network = _network(scenario)
    angles = seen_by(scenario, seed, time, path[0][:, :2])
    carry = carrying(scenario, seed, time, network)
    traces = {
        name: Follower(estimator_of(scenario, network, name), scenario).follow(time, angles, carry)
        for name in ("bearing_dac", *_asked(scenario, ("explicit", "linear")))
    }
    own, names = traces["bearing_dac"], own_names(scenario)
    shown = names.index(scenario.estimator.shown or names[0])
    seen = np.where(own.present, angles, np.nan)
    return Found(
        digest=stepper("bearing_dac").digest,
        target=path,
        sensors={
            sensor.name: np.tile(np.array(sensor.position_m), (len(time), 1))
            for sensor in scenario.sensors
        },
        estimates=_distributed(traces, shown) | _central(scenario, seen),
        labels={name: _label(name, names[shown]) for name in LABELS},
        parameters=_parameters(scenario, network),
        notes=(
            *merged(own.notes),
            *_inexact(own),
            *_expected(scenario, time, path[0][:, :2], seen),
        ),
        events=(*outage_events(scenario), *_milestones(own, time)),
        extra=_extra(network, traces, path[0]),
    )


def own_names(scenario: Scenario) -> list[str]:
    """Names of the sensors in order."""
    return [sensor.name for sensor in scenario.sensors]


def _asked(scenario: Scenario, names: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(name for name in names if name in scenario.header.baselines)


def _label(name: str, shown: str) -> str:
    return LABELS[name] if "place" in LABELS[name] else f"{LABELS[name]}, at {shown}"


def _distributed(traces: Mapping[str, Trace], shown: int) -> dict[str, tuple[Floats, Floats]]:
    """Positions that one sensor computes; no velocities."""
    return {
        name: (_placed(trace.positions[:, shown]), _unknown(trace.positions))
        for name, trace in traces.items()
    }


def _central(scenario: Scenario, angles: Floats) -> dict[str, tuple[Floats, Floats]]:
    """Baselines that have all bearings in one place."""
    made: dict[str, tuple[Floats, Floats]] = {}
    if "least_squares" in scenario.header.baselines:
        place = met(scenario, angles)
        made["least_squares"] = (_placed(place), _unknown(place))
    if "ekf" in scenario.header.baselines:
        place, rate = filtered(scenario, angles)
        made["ekf"] = (_placed(place), _placed(rate))
    return made


def _inexact(own: Trace) -> tuple[str, ...]:
    """Steps of the consensus that were found within a tolerance only, as a note."""
    count, error = own.inexact
    return (f"{count} steps within {error:.2g} of the exact ones",) if count else ()


def _expected(scenario: Scenario, time: Floats, target: Floats, seen: Floats) -> tuple[str, ...]:
    """Error that noise alone gives least squares, as a note, if there is noise."""
    sigma = sigma_of(scenario.noise)
    counted = time >= scenario.header.summary_from_s
    if sigma == 0 or not counted.any():
        return ()
    flat, traces = places(scenario), []
    for place, good in zip(target[counted], np.isfinite(seen[counted]), strict=True):
        try:
            traces.append(np.trace(covariance(flat[good], place, sigma)))
        except InputError:  # on one line with all who see it: no position to be off
            continue
    size = f"{np.sqrt(np.mean(traces)):.4g} m rms" if traces else "no position"
    return (f"noise alone gives least squares {size} to first order",)


def _flat(rows: Floats) -> Floats:
    """Bearings see the plane x, y."""
    found = rows.copy()
    found[:, 2] = 0.0
    return found


def _placed(rows: Floats) -> Floats:
    """Two coordinates as three; what is not known stays so."""
    height = np.where(np.isfinite(rows).all(axis=1), 0.0, np.nan)
    return np.column_stack([rows, height])


def _unknown(rows: Floats) -> Floats:
    return np.full((len(rows), 3), np.nan)


def _milestones(own: Trace, time: Floats) -> list[dict[str, Any]]:
    """First sample at which every sensor has a position."""
    everyone = (own.known | ~own.present).all(axis=1)
    if not everyone.any():
        text = "no sample at which every sensor has a position"
        return [{"time": float(time[-1]), "kind": "no_position", "text": text}]
    first = float(time[int(np.argmax(everyone))])
    return [{"time": first, "kind": "position", "text": "every sensor has a position"}]


def _parameters(scenario: Scenario, network: Any) -> Mapping[str, Any]:
    part, noise = scenario.estimator, scenario.noise
    return {
        "beta_P": part.beta_P,
        "beta_q": part.beta_q,
        "h": part.h_s,
        "method": part.method,
        "sign": part.sign,
        "entries": part.entries,
        "missing": part.missing,
        "det_min": part.det_min,
        "origin": part.origin,
        "network": f"{network.n} sensors, {network.m} links",
        "dropout": scenario.parts.get("dropout", DropoutPart()).rate,
        "noise": f"{noise.kind}, {noise.bearing_deg} deg",
    }


def _extra(network: Any, traces: Mapping[str, Trace], truth: Floats) -> dict[str, Any]:
    """Links, and how far sensors are from each other and the target: for figures and bounds."""
    own = traces["bearing_dac"]
    off = np.linalg.norm(own.positions - truth[:, None, :2], axis=2)
    worst = np.where(own.known, off, -1.0).max(axis=1).tolist()
    return {
        "coordinates": 2,
        "links": np.asarray(network.edges).tolist(),
        "agents": {
            "known": own.known.sum(axis=1).tolist(),
            "worst": [x if x >= 0 else None for x in worst],
        },
        "levels": [
            {
                "of": name,
                "label": LABELS[name],
                "quantity": f"disagreement on {block}",
                "unit": unit,
                "value": trace.level(block).tolist(),
            }
            for name, trace in traces.items()
            for block, unit in (("P", "1"), ("q", "m"))
        ],
        "consensus": own.record(),
    }
