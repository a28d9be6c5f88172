"""The inputs that questions about a user's own sensors and targets share, read and checked once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Input
from verification.exact.evaluate import Rows
from verification.input_words import positive

from ..block_inputs import BETA, READING, READINGS
from .measurement_moments import MEASUREMENT

Point = tuple[Fraction, ...]

WEIGHTINGS = ("harmonic", "printed")
ASSIGNMENTS = ("nearest", "best")
STEEP = Fraction(7, 20)
"""Standard deviation of an angle, in rad, from where on first-order covariances mean nothing."""

SENSORS = Input("sensors", "points", "positions of the sensors", "m")
TARGETS = Input("targets", "points", "positions of the targets", "m")
N_MAX = Input("n_max", "number", "neighbours that a sensor listens to at most")
M_MAX = Input("m_max", "number", "targets that a sensor updates at once at most, 1 or more")
SPEEDS = Input("eta_m", "list", "drift of a sample, one number or one a target", "m", optional=True)
VELOCITIES = Input(
    "velocities", "points", "drift of a sample as vectors, one or one a target", "m", optional=True
)
REACH = Input("reach", "number", "how far a sensor sees; left out: all targets", "m", optional=True)
TALK = Input("talk", "number", "how far sensors hear each other", "m", optional=True)
WEIGHTING = Input(
    "K", "word", "weight in (20): harmonic, n over the sum of 1/s^2, or printed, the sum of s^2",
    "", "harmonic",
)  # fmt: skip
ASSIGNMENT = Input(
    "assignment",
    "word",
    "neighbours and blocks: nearest, in the order given, or best",
    "",
    "nearest",
)
NETWORK = (
    SENSORS, TARGETS, *MEASUREMENT, N_MAX, M_MAX, BETA, READING, VELOCITIES, REACH, TALK,
    WEIGHTING, ASSIGNMENT,
)  # fmt: skip


@dataclass(frozen=True)
class Network:
    """Sensors and targets, checked.

    Parameters
    ----------
    sensors, targets : tuple of points
        In m.
    bearing, distance : Fraction
        Standard deviations of the angle, in rad, and of the range over the range.
    n_max, m_max : int
    beta : Fraction
        In m.
    instants : int
        Measurement instants of a step, 1 or 2.
    drifts : tuple of points
        Of each target, in m a sample. Where only lengths are given they lie along the first axis:
        the limit of the step does not depend on directions.
    reach, talk : Fraction or None
        In m.
    weighting, assignment : str
    """

    sensors: tuple[Point, ...]
    targets: tuple[Point, ...]
    bearing: Fraction
    distance: Fraction
    n_max: int
    m_max: int
    beta: Fraction
    instants: int
    drifts: tuple[Point, ...]
    reach: Fraction | None
    talk: Fraction | None
    weighting: str
    assignment: str

    @cached_property
    def ranges_squared(self) -> Rows:
        """A row a sensor, a column a target, in m^2."""
        return tuple(tuple(apart(s, r) for r in self.targets) for s in self.sensors)

    @cached_property
    def variances(self) -> tuple[tuple[Fraction | None, ...], ...]:
        """tr Xi of the first order, in m^2; None where the sensor does not see the target."""
        part = self.bearing**2 + self.distance**2
        limit = None if self.reach is None else self.reach**2
        return tuple(
            tuple(part * x if limit is None or x <= limit else None for x in row)
            for row in self.ranges_squared
        )

    def heard(self, own: int) -> tuple[int, ...]:
        """Sensors that a sensor may listen to."""
        limit = None if self.talk is None else self.talk**2
        here = self.sensors[own]
        return tuple(
            q
            for q, place in enumerate(self.sensors)
            if q != own and (limit is None or apart(here, place) <= limit)
        )

    def hessian(self, source: int, target: int) -> Fraction:
        """h_i = K_i/(n s_i^2) in the cost (20), s_i^2 being that of the source."""
        seen = [row[target] for row in self.variances if row[target] is not None]
        known = [x for x in seen if x is not None]
        used = self.variances[source][target]
        assert used is not None  # a source sees its target
        if self.weighting == "harmonic":
            return 1 / (used * sum((1 / x for x in known), Fraction(0)))
        return sum(known, Fraction(0)) / (len(self.sensors) * used)

    def covariance(self, source: int, target: int) -> Rows:
        """Xi of the first order, in m^2: along the line of sight and across it."""
        x, y = (a - b for a, b in zip(self.targets[target], self.sensors[source], strict=True))
        along, across = self.distance**2, self.bearing**2
        cross = (along - across) * x * y
        return (
            (along * x * x + across * y * y, cross),
            (cross, along * y * y + across * x * x),
        )


def apart(a: Point, b: Point) -> Fraction:
    """Squared distance."""
    return sum(((x - y) ** 2 for x, y in zip(a, b, strict=True)), Fraction(0))


def network_of(values: Mapping[str, Any]) -> Network:
    """Read and check the inputs of a network.

    Raises
    ------
    InputError
        Two sensors or two targets are at one place, or a target is on a sensor; a target that no
        sensor sees; a negative or vanishing noise, or an angle too large for radians; m_max < 1,
        n_max < 0; a size that is not positive; a word that is not known; drifts given twice, or
        not one a target.
    """
    sensors, targets = values["sensors"], values["targets"]
    _apart(sensors, targets)
    bearing, distance = _noise(values)
    counts = (_whole(values, "n_max", 0), _whole(values, "m_max", 1))
    for name in ("reach", "talk"):
        if values[name] is not None:
            positive(values, name)
    known = {"K": WEIGHTINGS, "assignment": ASSIGNMENTS, "reading": tuple(READINGS)}
    for name, words in known.items():
        if values[name] not in words:
            raise InputError(name, repr(values[name]), f"one of {', '.join(words)} is needed")
    drifts = _drifts(values, len(targets))
    network = Network(
        *(sensors, targets, bearing, distance, *counts, positive(values, "beta")),
        *(READINGS[values["reading"]], drifts, values["reach"], values["talk"]),
        *(values["K"], values["assignment"]),
    )
    for i in range(len(targets)):
        if all(row[i] is None for row in network.variances):
            needed = "one within reach of some sensor is needed"
            raise InputError("targets", f"target {i}, which no sensor sees", needed)
    return network


def _apart(sensors: Sequence[Point], targets: Sequence[Point]) -> None:
    for name, points in (("sensors", sensors), ("targets", targets)):
        place: dict[Point, int] = {}
        for i, point in enumerate(points):
            if point in place:
                found = f"number {place[point]} and number {i} at one place"
                raise InputError(name, found, "places that differ are needed")
            place[point] = i
    for i, point in enumerate(targets):
        if point in sensors:
            found = f"target {i} on sensor {sensors.index(point)}"
            raise InputError("targets", found, "a target away from sensors, which has an angle")


def _noise(values: Mapping[str, Any]) -> tuple[Fraction, Fraction]:
    found = tuple(values[entry.name] for entry in MEASUREMENT)
    for entry, value in zip(MEASUREMENT, found, strict=True):
        if value < 0:
            raise InputError(entry.name, f"{value}", "a number of at least 0 is needed")
    if found[0] >= STEEP:
        needed = f"radians below {float(STEEP)} are needed; is it an angle in degrees?"
        raise InputError(MEASUREMENT[0].name, f"{found[0]}", needed)
    if not any(found):
        needed = "noise of the angle or of the range is needed: the weights are 1/tr Xi"
        raise InputError(MEASUREMENT[0].name, "no noise at all", needed)
    return found[0], found[1]


def _whole(values: Mapping[str, Any], name: str, least: int) -> int:
    value: Fraction = values[name]
    if value.denominator != 1 or value < least:
        raise InputError(name, f"{value}", f"a whole number of at least {least} is needed")
    return int(value)


def _drifts(values: Mapping[str, Any], count: int) -> tuple[Point, ...]:
    vectors, lengths = values["velocities"], values.get("eta_m")
    zero = Fraction(0)
    if lengths is None:
        return _one_each("velocities", ((zero, zero),) if vectors is None else vectors, count)
    if vectors is not None:
        raise InputError("eta_m", "given beside velocities", "one of the two is needed")
    if min(lengths) < 0:
        raise InputError("eta_m", f"{min(lengths)}", "a length of at least 0 is needed")
    return tuple((x, zero) for x in _one_each("eta_m", lengths, count))


def _one_each(name: str, given: tuple[Any, ...], count: int) -> tuple[Any, ...]:
    if len(given) == 1:
        return given * count
    if len(given) != count:
        raise InputError(name, f"{len(given)}", f"{count} are needed, one a target, or one for all")
    return given
