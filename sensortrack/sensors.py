"""What sensors see: local views of one target and their weighted average, or bearings."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError

Floats = NDArray[np.float64]
ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class View:
    """What one sensor knows at one time; vectors in the inertial frame.

    Parameters
    ----------
    sensor : str
        Its name.
    position, velocity : array (3,)
        Its own, in m and m/s.
    relative_position, relative_velocity : array (3,)
        Measured: sensor minus target, in m and m/s. `from_sensor` takes the opposite sign.

    References
    ----------
    Sanyal & Eslamiat, (1), (2): b_0i = b_i - b.
    """

    sensor: str
    position: Floats
    velocity: Floats
    relative_position: Floats
    relative_velocity: Floats

    @classmethod
    def from_sensor(
        cls,
        sensor: str,
        position: ArrayLike,
        velocity: ArrayLike,
        target_position: ArrayLike,
        target_velocity: ArrayLike,
    ) -> View:
        """Make a view from what is seen from the sensor: target minus sensor.

        Raises
        ------
        InputError
            A vector has not three numbers.
        """
        own = vector("position", position), vector("velocity", velocity)
        seen = (
            vector("target_position", target_position),
            vector("target_velocity", target_velocity),
        )
        return cls(sensor, *own, -seen[0], -seen[1])

    @property
    def target(self) -> Floats:
        """Where this sensor alone puts the target: b_i - b_0i and v_i - v_0i, six numbers."""
        return np.concatenate(
            [self.position - self.relative_position, self.velocity - self.relative_velocity]
        )


@dataclass(frozen=True)
class Bearing:
    """The direction in which one sensor sees the target, in the plane of the inertial frame.

    Parameters
    ----------
    sensor : str
        Its name.
    angle : float
        In rad from the first axis towards the second; NaN if the sensor does not see the target.
    """

    sensor: str
    angle: float

    @property
    def seen(self) -> bool:
        """Whether there is an angle."""
        return bool(np.isfinite(self.angle))


def bearings_to(target: ArrayLike, positions: ArrayLike) -> Floats:
    """Angles in rad of a target from positions in a plane; NaN for one that the target sits on.

    Parameters
    ----------
    target : array (..., 2)
        In m.
    positions : array (..., 2)
        In m; the two are broadcast.

    Returns
    -------
    array (...)
    """
    apart = np.asarray(target, dtype=float) - np.asarray(positions, dtype=float)
    angle = np.arctan2(apart[..., 1], apart[..., 0])
    found: Floats = np.where((apart == 0).all(axis=-1), np.nan, angle)
    return found


@dataclass(frozen=True, eq=False)
class Average:
    """Weighted mean of what the sensors see.

    Parameters
    ----------
    position, velocity : array (3,) or None
        b_bar and v_bar of (6), (7); None if no sensor sees the target.
    used, skipped : tuple of str
        Sensors that count; sensors whose measurement is not finite.
    """

    position: Floats | None
    velocity: Floats | None
    used: tuple[str, ...]
    skipped: tuple[str, ...]


def vector(name: str, value: ArrayLike) -> Floats:
    """Three numbers as an array.

    Raises
    ------
    InputError
        With this name, if there are not three.
    """
    found = np.array(value, dtype=float)
    if found.shape != (3,):
        raise InputError(name, f"an array of shape {found.shape}", "three numbers are needed")
    return found


def checked_weights(weights: Mapping[str, float]) -> dict[str, float]:
    """Weights of all sensors, positive and of sum one.

    Raises
    ------
    InputError
        With the name ``weights``.

    References
    ----------
    Sanyal & Eslamiat, (5).
    """
    if not weights:
        raise InputError("weights", "no sensor", "a weight for each sensor is needed")
    for sensor, weight in weights.items():
        if not (np.isfinite(weight) and weight > 0):
            raise InputError("weights", f"{weight} for {sensor}", "numbers above 0 are needed")
    total = sum(weights.values())
    if abs(total - 1) > ROUNDING:
        cure = "Divide each by their sum."
        raise InputError("weights", f"a sum of {total:.9g}", "a sum of 1 is needed", cure)
    return dict(weights)


def average(views: Sequence[View], weights: Mapping[str, float]) -> Average:
    """Average over the sensors that see the target, their weights rescaled to sum one.

    Parameters
    ----------
    views : sequence of View
        Of the sensors that report; a sensor that does not see the target is left out.
    weights : mapping of str to float
        Of all sensors, as `checked_weights` returns them.

    Raises
    ------
    InputError
        With the name ``measurement``: a sensor reports twice or is unknown.

    References
    ----------
    Sanyal & Eslamiat, (5) to (7); rescaling is what (5) asks for when the set changes.
    """
    once_each([view.sensor for view in views], weights)
    # summed in the order of the weights: the order of the reports does not change a bit
    place = {name: k for k, name in enumerate(weights)}
    views = sorted(views, key=lambda view: place[view.sensor])
    names = [view.sensor for view in views]
    finite = [bool(np.isfinite(view.target).all()) for view in views]
    seeing = [view for view, good in zip(views, finite, strict=True) if good]
    skipped = tuple(name for name, good in zip(names, finite, strict=True) if not good)
    if not seeing:
        return Average(None, None, (), skipped)
    total = sum(weights[view.sensor] for view in seeing)
    mean = sum((weights[view.sensor] / total * view.target for view in seeing), np.zeros(6))
    return Average(mean[:3], mean[3:], tuple(view.sensor for view in seeing), skipped)


def once_each(names: Iterable[str], known: Collection[str]) -> None:
    """Demand that every sensor reports at most once and is known.

    Raises
    ------
    InputError
        With the name ``measurement``.
    """
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise InputError("measurement", f"sensor {name} twice", "one view a sensor is needed")
        if name not in known:
            needed = f"one of {', '.join(known)} is needed"
            raise InputError("measurement", f"an unknown sensor {name}", needed)
        seen.add(name)
