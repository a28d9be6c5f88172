"""A scenario: targets, the sensors, their noise and faults, one estimator and its baselines."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

from sensortrack.errors import InputError
from sensortrack.tables import read_table
from sensortrack.targets import KINDS, Several, Single, Target

from .parts import FaultPart, Header, Scenario, SensorPart, need, one_of
from .systems import SYSTEMS, Simulated, simulated

__all__ = ["Scenario", "read_scenario", "scenario_of", "shipped_scenarios"]

LARGEST, SAMPLES = 1 << 20, 1_000_000
COMMON = ("target", "sensor", "noise", "fault", "estimator")
"""Tables of every scenario."""


def shipped_scenarios() -> tuple[str, ...]:
    """Names of the scenarios that are shipped."""
    folder = files("sensortrack").joinpath("scenarios")
    names = (entry.name for entry in folder.iterdir())
    return tuple(sorted(name[:-5] for name in names if name.endswith(".toml")))


def read_scenario(text: str) -> Scenario:
    """Read a scenario from a file, or one that is shipped.

    Parameters
    ----------
    text : str
        Path of a TOML file, or one of `shipped_scenarios`.

    Raises
    ------
    InputError
        The file cannot be read, a key is unknown or missing, or keys contradict each other.
    """
    path = Path(text)
    if text in shipped_scenarios():
        content = files("sensortrack").joinpath("scenarios", f"{text}.toml").read_bytes()
    else:
        content = _content(path)
    try:
        data = tomllib.loads(content.decode("utf-8-sig"))
    except ValueError as error:
        raise InputError("scenario", f"{text}: {error}", "TOML is needed") from None
    return scenario_of(path.stem if path.suffix else text, data)


def _content(path: Path) -> bytes:
    needed = f"a TOML file, or one of {', '.join(shipped_scenarios())}, is needed"
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST + 1)
    except OSError as error:
        raise InputError("scenario", f"{path}: {error.strerror or error}", needed) from None
    if len(content) > LARGEST:
        raise InputError("scenario", f"{path} is larger than {LARGEST} bytes", needed)
    return content


def scenario_of(name: str, data: Mapping[str, Any]) -> Scenario:
    """Check data of a file and make a scenario of them.

    Raises
    ------
    InputError
        As `read_scenario`.
    """
    system = _system(data.get("estimator"))
    own = {*system.TABLES, *system.LISTS, *COMMON}
    header = read_table(Header, {k: v for k, v in data.items() if k not in own}, "scenario")
    if "baselines" not in data:
        header = replace(header, baselines=system.BASELINES)
    scenario = Scenario(
        name,
        header,
        _targets(data.get("target"), system.SEVERAL),
        tuple(read_table(SensorPart, entry, "sensor") for entry in _list(data, "sensor")),
        read_table(system.TABLES["noise"], data.get("noise", {}), "noise"),
        tuple(read_table(FaultPart, entry, "fault") for entry in _list(data, "fault")),
        read_table(system.TABLES["estimator"], data["estimator"], "estimator"),
        _parts(system, data),
    )
    scenario = system.complete(scenario)
    _check(scenario, system)
    system.check(scenario)
    return scenario


def _system(estimator: object) -> Simulated:
    """The system that the table of the estimator names."""
    if not isinstance(estimator, Mapping):
        raise InputError("estimator", f"{estimator!r:.60}", "a table is needed")
    name = estimator.get("system")
    if not isinstance(name, str):
        raise InputError("estimator.system", f"{name!r:.60}", "a text is needed")
    one_of("estimator.system", name, SYSTEMS)
    return simulated(name)


def _parts(system: Simulated, data: Mapping[str, Any]) -> dict[str, Any]:
    """The system's own tables that are there, and its lists."""
    tables: dict[str, Any] = {
        name: read_table(part, data[name], name)
        for name, part in system.TABLES.items()
        if name not in COMMON and name in data
    }
    lists: dict[str, Any] = {
        name: tuple(read_table(part, entry, name) for entry in _list(data, name))
        for name, part in system.LISTS.items()
    }
    return {**tables, **lists}


def _list(data: Mapping[str, Any], key: str) -> list[Any]:
    found = data.get(key, [])
    if not isinstance(found, list):
        raise InputError(key, f"{found!r:.60}", f"tables [[{key}]] are needed")
    return found


def _targets(data: object, several: bool) -> Target:
    """One table [target], or a list [[target]] where the system follows several."""
    if not several:
        needed = "one table [target] is needed: this system follows one"
        need(not isinstance(data, list), "target", "a list [[target]]", needed)
        return _target(data)
    entries = data if isinstance(data, list) else [data]
    need(bool(entries), "target", "no target", "one or more [[target]] are needed")
    names = tuple(_name(entry, str(k)) for k, entry in enumerate(entries, 1))
    for name in names:
        need(names.count(name) == 1, "target.name", f"{name} twice", "one each is needed")
    return Several(names, tuple(_target(_unnamed(entry)) for entry in entries))


def _name(entry: object, number: str) -> str:
    found = entry.get("name", number) if isinstance(entry, Mapping) else number
    need(
        isinstance(found, str) and found != "", "target.name", f"{found!r:.60}", "a text is needed"
    )
    return str(found)


def _unnamed(entry: object) -> object:
    if not isinstance(entry, Mapping):
        return entry
    return {key: value for key, value in entry.items() if key != "name"}


def _target(data: object) -> Single:
    if not isinstance(data, Mapping) or data.get("kind") not in KINDS:
        found = data.get("kind") if isinstance(data, Mapping) else data
        raise InputError("target.kind", f"{found!r:.60}", f"one of {', '.join(KINDS)} is needed")
    rest = {key: value for key, value in data.items() if key != "kind"}
    made: Single = read_table(KINDS[data["kind"]], rest, "target")  # type: ignore[arg-type]
    return made


def _check(scenario: Scenario, system: Simulated) -> None:
    """What no single key shows, whatever the system."""
    header, estimator = scenario.header, scenario.estimator
    names = [sensor.name for sensor in scenario.sensors]
    need(bool(names), "sensor", "no sensor", "one or more [[sensor]] are needed")
    for name in names:
        need(name != "", "sensor.name", "an empty text", "a name is needed")
        need(names.count(name) == 1, "sensor.name", f"{name} twice", "one each is needed")
    _ = scenario.weights
    need(header.duration_s > 0, "scenario.duration_s", f"{header.duration_s}", "above 0 is needed")
    since, needed = header.summary_from_s, f"0 to {header.duration_s:g} s, the end, is needed"
    need(0 <= since <= header.duration_s, "scenario.summary_from_s", f"{since} s", needed)
    noise = header.kalman_acceleration
    need(noise > 0, "scenario.kalman_acceleration", f"{noise}", "a number above 0 is needed")
    need(estimator.h_s > 0, "estimator.h_s", f"{estimator.h_s}", "a step above 0 s is needed")
    count = header.duration_s / estimator.h_s
    need(1 <= count <= SAMPLES, "estimator.h_s", f"{count:.0f} samples", f"1 to {SAMPLES}")
    for baseline in header.baselines:
        one_of("scenario.baselines", baseline, system.BASELINES)
    for fault in scenario.faults:
        one_of("fault.kind", fault.kind, (*system.FAULTS,))
        one_of("fault.sensor", fault.sensor, tuple(names))
        order = f"{fault.from_s} s to {fault.until_s} s"
        need(fault.from_s < fault.until_s, "fault.until_s", order, "a later time is needed")
