"""Angle and distance at which sensors see targets in a plane, by name of sensor and target.

Angles are counted from the second axis towards the first, as a compass counts from north if the
second axis points there. `sensortrack.sensors.Bearing` counts from the first axis.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.arguments import numbers, real
from sensortrack.errors import InputError

Floats = NDArray[np.float64]
WIDEST = 2 * math.pi
"""Largest angle in rad that any way of counting a full turn, with its noise, comes to."""


@dataclass(frozen=True, eq=False)
class PolarView:
    """One target as one sensor measures it: what sensors send each other, (10) to (13).

    Parameters
    ----------
    sensor, target : str
        Names.
    angle : float
        z_1 in rad from the second axis; NaN if the sensor does not see the target.
    distance : float
        z_2 in m, not negative; NaN if the sensor does not see the target.
    position : array (2,)
        Of the sensor that measured, in m.
    time : int, optional
        Sample at which it was measured; by default that in which it is used.

    References
    ----------
    Erofeeva & Granichin, (10) to (13), with atan2 in (11): one angle has to tell all quadrants.
    """

    sensor: str
    target: str
    angle: float
    distance: float
    position: ArrayLike
    time: int | None = None

    @property
    def seen(self) -> bool:
        """Whether every number of it is finite."""
        numbers = (self.angle, self.distance, *map(float, np.asarray(self.position).ravel()))
        return all(map(math.isfinite, numbers))


def polar_to(target: ArrayLike, position: ArrayLike) -> tuple[Floats, Floats]:
    """True angle and distance of targets from positions; the angle is NaN where the two are one.

    Parameters
    ----------
    target, position : array (..., 2)
        In m; the two are broadcast.

    Returns
    -------
    angle, distance : array (...)
        In rad from the second axis towards the first, and in m.

    References
    ----------
    Erofeeva & Granichin, (10) to (12).
    """
    apart = np.asarray(target, dtype=float) - np.asarray(position, dtype=float)
    angle = np.arctan2(apart[..., 0], apart[..., 1])
    angle = np.where((apart == 0).all(axis=-1), np.nan, angle)
    return angle, np.hypot(apart[..., 0], apart[..., 1])


def from_sources(
    views: Iterable[PolarView], sources: Mapping[str, str], time: int
) -> dict[str, PolarView]:
    """The measurement of each target that its source sent and that is finite.

    Parameters
    ----------
    views : iterable of PolarView
        What arrived. What a sensor measured that is not the target's source is left aside.
    sources : mapping of str to str
        Target to the sensor whose measurement counts.
    time : int
        Sample for which they are read.

    Raises
    ------
    InputError
        With the name ``measurement``: one is of another sample, of an unknown target, or comes
        twice; ``angle``: it is beyond a full turn; ``distance``: it is negative; ``position``: it
        has not two numbers.
    """
    found: dict[tuple[str, str], PolarView] = {}
    for view in views:
        what = f"{view.target} from {view.sensor}"
        if view.target not in sources:
            needed = f"one of {', '.join(sources)} is needed"
            raise InputError("measurement", f"an unknown target {view.target}", needed)
        if (view.sensor, view.target) in found:
            raise InputError("measurement", f"{what} twice", "one a sample is needed")
        if view.time is not None and view.time != time:
            late = f"{what} of sample {view.time}"
            raise InputError("measurement", late, f"one of sample {time} is needed")
        _in_range(view, what)
        found[view.sensor, view.target] = view
    chosen = {target: found.get((sensor, target)) for target, sensor in sources.items()}
    return {target: view for target, view in chosen.items() if view is not None and view.seen}


def _in_range(view: PolarView, what: str) -> None:
    position = numbers("position", view.position, "two numbers are needed")
    if abs(real("angle", view.angle)) > WIDEST:
        cure = "An angle in degrees is divided by 180 and multiplied by pi."
        needed = "rad within a full turn are needed"
        raise InputError("angle", f"{view.angle} rad of {what}", needed, cure)
    if real("distance", view.distance) < 0:
        found = f"{view.distance} m of {what}"
        raise InputError("distance", found, "a number of 0 or more is needed")
    if position.shape != (2,):
        found = f"an array of shape {position.shape} of {what}"
        raise InputError("position", found, "two numbers are needed")
