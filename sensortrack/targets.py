"""Paths of a target: formulas, and recorded tracks between their fixes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.tables import Vector

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """Constant velocity."""

    start_m: Vector = (0.0, 0.0, 0.0)
    velocity_mps: Vector = (1.0, 0.0, 0.0)

    def at(self, time: Floats) -> tuple[Floats, Floats]:
        """Positions in m and velocities in m/s at times in s, one row a time."""
        start, rate = np.array(self.start_m), np.array(self.velocity_mps)
        return start + time[:, None] * rate, np.tile(rate, (len(time), 1))


@dataclass(frozen=True)
class Helix:
    """A circle in the plane x, y that climbs."""

    radius_m: float
    rate_radps: float
    climb_mps: float = 0.0
    centre_m: Vector = (0.0, 0.0, 0.0)

    def at(self, time: Floats) -> tuple[Floats, Floats]:
        """Positions in m and velocities in m/s at times in s, one row a time."""
        angle, r, w = self.rate_radps * time, self.radius_m, self.rate_radps
        flat = np.stack([r * np.cos(angle), r * np.sin(angle), self.climb_mps * time], axis=1)
        rate = np.stack(
            [-r * w * np.sin(angle), r * w * np.cos(angle), np.full_like(time, self.climb_mps)],
            axis=1,
        )
        return flat + np.array(self.centre_m), rate


@dataclass(frozen=True)
class Weaving:
    """Nearly constant velocity: v(t) = velocity + swing sin(2 pi t/period)."""

    start_m: Vector
    velocity_mps: Vector
    swing_mps: Vector
    period_s: float

    def at(self, time: Floats) -> tuple[Floats, Floats]:
        """Positions in m and velocities in m/s at times in s, one row a time.

        Raises
        ------
        InputError
            The period is not above 0.
        """
        if not self.period_s > 0:
            raise InputError("target.period_s", f"{self.period_s}", "a time above 0 is needed")
        start, mean, swing = map(np.array, (self.start_m, self.velocity_mps, self.swing_mps))
        turn = 2 * np.pi / self.period_s
        angle = turn * time[:, None]
        away = swing * (1 - np.cos(angle)) / turn
        return start + mean * time[:, None] + away, mean + swing * np.sin(angle)


@dataclass(frozen=True)
class Track:
    """A recorded track: cubic between fixes without overshoot (PCHIP), velocity its derivative."""

    data: str
    target: str = ""
    from_s: float = 0.0

    def at(self, time: Floats) -> tuple[Floats, Floats]:
        """Positions in m and velocities in m/s at times in s, one row a time.

        Raises
        ------
        InputError
            There is no such track, or it ends before the last time.
        """
        from scipy.interpolate import PchipInterpolator

        from sensortrack.data import load_track

        fixes, places = load_track(self.data, self.target)
        wanted = self.from_s + time
        if wanted[0] < fixes[0] or wanted[-1] > fixes[-1]:
            found = f"{wanted[0]:g} s to {wanted[-1]:g} s"
            needed = f"times within {fixes[0]:g} s to {fixes[-1]:g} s are needed"
            raise InputError("target.from_s", found, needed)
        path = PchipInterpolator(fixes, places)
        return np.asarray(path(wanted)), np.asarray(path.derivative()(wanted))


Single = Line | Helix | Weaving | Track


@dataclass(frozen=True)
class Several:
    """Targets that move at the same time, each with its name."""

    names: tuple[str, ...]
    members: tuple[Single, ...]

    def at(self, time: Floats) -> tuple[Floats, Floats]:
        """Positions in m and velocities in m/s, times by targets by coordinates.

        Raises
        ------
        InputError
            As the members do.
        """
        places, rates = zip(*(member.at(time) for member in self.members), strict=True)
        return np.stack(places, axis=1), np.stack(rates, axis=1)


Target = Single | Several
KINDS: Mapping[str, Callable[..., Single]] = {
    "line": Line,
    "helix": Helix,
    "weaving": Weaving,
    "track": Track,
}
