"""A scenario: one target, its sensors, their noise and faults, one estimator and its baselines."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

from sensortrack.errors import InputError
from sensortrack.sensors import checked_weights
from sensortrack.tables import Vector, read_table
from sensortrack.targets import KINDS, Target

BASELINES = ("raw", "kalman")
LARGEST, SAMPLES = 1 << 20, 1_000_000


@dataclass(frozen=True)
class SensorPart:
    """One sensor, moving with constant velocity."""

    name: str
    position_m: Vector
    velocity_mps: Vector = (0.0, 0.0, 0.0)
    weight: float = 0.0
    bias_position_m: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class NoisePart:
    """Measurement noise of each sensor: per coordinate a standard deviation or a largest value."""

    kind: str = "none"
    position_m: float = 0.0
    velocity_mps: float = 0.0


@dataclass(frozen=True)
class FaultPart:
    """From one time to another a sensor is ``lost`` or sends ``nan``."""

    kind: str
    sensor: str
    from_s: float
    until_s: float = float("inf")


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


@dataclass(frozen=True)
class Header:
    """What the file says about itself."""

    title: str
    about: str
    duration_s: float
    seed: int = 0
    assumptions: tuple[str, ...] = ()
    baselines: tuple[str, ...] = BASELINES
    kalman_acceleration: float = 1.0
    summary_from_s: float = 0.0


@dataclass(frozen=True)
class Scenario:
    """Everything that a run depends on."""

    name: str
    header: Header
    target: Target
    sensors: tuple[SensorPart, ...]
    noise: NoisePart
    faults: tuple[FaultPart, ...]
    estimator: EstimatorPart

    @property
    def weights(self) -> dict[str, float]:
        """Weights of all sensors, of sum one; equal ones if none is given."""
        given = {sensor.name: sensor.weight for sensor in self.sensors}
        if not any(given.values()):
            return dict.fromkeys(given, 1.0 / len(given))
        return checked_weights(given)

    def to_data(self) -> dict[str, Any]:
        """Return the scenario as JSON data."""
        return asdict(self)


TABLES = ("target", "sensor", "noise", "fault", "estimator")


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
    header = read_table(Header, {k: v for k, v in data.items() if k not in TABLES}, "scenario")
    scenario = Scenario(
        name,
        header,
        _target(data.get("target")),
        tuple(read_table(SensorPart, entry, "sensor") for entry in _list(data, "sensor")),
        read_table(NoisePart, data.get("noise", {}), "noise"),
        tuple(read_table(FaultPart, entry, "fault") for entry in _list(data, "fault")),
        read_table(EstimatorPart, data.get("estimator"), "estimator"),
    )
    _check(scenario)
    return scenario


def _list(data: Mapping[str, Any], key: str) -> list[Any]:
    found = data.get(key, [])
    if not isinstance(found, list):
        raise InputError(key, f"{found!r:.60}", f"tables [[{key}]] are needed")
    return found


def _target(data: object) -> Target:
    if not isinstance(data, Mapping) or data.get("kind") not in KINDS:
        found = data.get("kind") if isinstance(data, Mapping) else data
        raise InputError("target.kind", f"{found!r:.60}", f"one of {', '.join(KINDS)} is needed")
    rest = {key: value for key, value in data.items() if key != "kind"}
    made: Target = read_table(KINDS[data["kind"]], rest, "target")  # type: ignore[arg-type]
    return made


def _check(scenario: Scenario) -> None:
    """What no single key shows."""
    header, estimator = scenario.header, scenario.estimator
    names = [sensor.name for sensor in scenario.sensors]
    _need(bool(names), "sensor", "no sensor", "one or more [[sensor]] are needed")
    for name in names:
        _need(names.count(name) == 1, "sensor.name", f"{name} twice", "one each is needed")
    _ = scenario.weights
    _need(header.duration_s > 0, "scenario.duration_s", f"{header.duration_s}", "above 0 is needed")
    _need(estimator.h_s > 0, "estimator.h_s", f"{estimator.h_s}", "a step above 0 s is needed")
    count = header.duration_s / estimator.h_s
    _need(1 <= count <= SAMPLES, "estimator.h_s", f"{count:.0f} samples", f"1 to {SAMPLES}")
    _one_of("estimator.system", estimator.system, ("variational",))
    _one_of("estimator.velocity", estimator.velocity, ("measured", "differenced"))
    _one_of("noise.kind", scenario.noise.kind, ("none", "gaussian", "uniform"))
    sizes = (scenario.noise.position_m, scenario.noise.velocity_mps)
    _need(min(sizes) >= 0, "noise", f"{min(sizes)}", "sizes of 0 or more are needed")
    quiet = scenario.noise.kind == "none" and any(sizes)
    _need(not quiet, "noise.kind", "none beside sizes above 0", "gaussian or uniform is needed")
    for baseline in header.baselines:
        _one_of("scenario.baselines", baseline, BASELINES)
    for fault in scenario.faults:
        _one_of("fault.kind", fault.kind, ("lost", "nan"))
        _one_of("fault.sensor", fault.sensor, tuple(names))
        order = f"{fault.from_s} s to {fault.until_s} s"
        _need(fault.from_s < fault.until_s, "fault.until_s", order, "a later time is needed")


def _one_of(name: str, value: str, known: tuple[str, ...]) -> None:
    _need(value in known, name, f"{value!r}", f"one of {', '.join(known)} is needed")


def _need(good: bool, name: str, found: str, needed: str) -> None:
    if not good:
        raise InputError(name, found, needed)
