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


Target = Line | Helix | Track
KINDS: Mapping[str, Callable[..., Target]] = {"line": Line, "helix": Helix, "track": Track}
