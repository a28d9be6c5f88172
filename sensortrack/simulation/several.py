"""One run in which several sensors follow several targets: errors by sensor and target."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .run import Run, csv_text, rms, rounded

Floats = NDArray[np.float64]
KEPT, LISTED = 600, 200
"""Samples that ``run.json`` and ``errors.csv`` have at most, evenly chosen."""
EXACT = 12
"""Digits of true positions, whose differences over a sample count."""
SETTLED = 0.1
"""Share of the first estimate's error at the start below which an estimate counts as settled."""


@dataclass(frozen=True, eq=False)
class RunOfSeveral(Run):
    """What a simulation of several targets found.

    Parameters
    ----------
    target : (array (samples, targets, 3), array (samples, targets, 3))
        True positions and velocities.
    estimates : mapping of str to (array, array)
        Samples by sensors by targets by coordinates; NaN where a sensor does not follow a target
        and from the time on at which the estimate has diverged. Velocities are not estimated.
    targets : tuple of str
        Names.
    """

    targets: tuple[str, ...] = ()

    def pairs(self, name: str) -> Floats:
        """Norm of the position error in m, samples by sensors by targets."""
        away = self.estimates[name][0] - self.target[0][:, None]
        return np.asarray(np.linalg.norm(away, axis=-1))

    def errors(self, name: str) -> tuple[Floats, Floats]:
        """Root-mean-square position error over sensors and targets in m; no velocities."""
        level = mean_square(self.pairs(name), (1, 2))
        return level, np.full(len(level), np.nan)

    @property
    def summary(self) -> list[dict[str, Any]]:
        """Errors of each estimate: at the start, in the long run, and when it has settled."""
        counted = self.time >= self.summary_from
        rows: list[dict[str, Any]] = []
        levels = {name: self.errors(name)[0] for name in self.estimates}
        first = float(next(iter(levels.values()))[0])
        for name, level in levels.items():
            whole = np.isfinite(level[-1])
            rows.append(
                {
                    "estimate": name,
                    "position_rms": rms(level[counted]) if whole else None,
                    "velocity_rms": None,
                    "from": self.summary_from,
                    "start": float(level[0]),
                    "settled": settled(self.time, level, SETTLED * first),
                    "diverged": None if whole else float(self.time[int(np.isnan(level).argmax())]),
                }
            )
        return rows

    def truth_data(self) -> dict[str, Any]:
        """The kept times, and where the targets truly were."""
        kept = self._kept(KEPT)
        place, rate = (part[kept] for part in self.target)
        return {
            "samples": len(self.time),
            "time": self.time[kept].tolist(),
            "targets": [
                {
                    "name": name,
                    "position": rounded(place[:, i], EXACT),
                    "velocity": rounded(rate[:, i], EXACT),
                }
                for i, name in enumerate(self.targets)
            ],
        }

    def estimate_data(self) -> list[dict[str, Any]]:
        """Errors of each estimate at the kept samples: together, by sensor, by target."""
        kept = self._kept(KEPT)
        made = []
        for name in self.estimates:
            pairs = self.pairs(name)[kept]
            made.append(
                {
                    "name": name,
                    "label": self.labels.get(name, name),
                    "error": rounded(mean_square(pairs, (1, 2))),
                    "by_sensor": rounded(mean_square(pairs, (2,)).T),
                    "by_target": rounded(mean_square(pairs, (1,)).T),
                }
            )
        return made

    def sensor_data(self) -> list[dict[str, Any]]:
        """Sensors rest: one place each."""
        return [
            {"name": name, "position": rounded(place[:1], EXACT)}
            for name, place in self.sensors.items()
        ]

    def tracks_csv(self) -> str:
        """True positions and velocities, one row a time and a target."""
        head = ("time_s", "target", "x_m", "y_m", "z_m", "vx_mps", "vy_mps", "vz_mps")
        place, rate = self.target
        rows = [
            (float(self.time[k]), name, *map(float, (*place[k, i], *rate[k, i])))
            for k in self._kept(KEPT)
            for i, name in enumerate(self.targets)
        ]
        return csv_text(head, rows)

    def errors_csv(self) -> str:
        """Norms of the errors, one row a time, an estimate, a sensor and a target."""
        kept, sensors = self._kept(LISTED), [*self.sensors]
        pairs = {name: self.pairs(name) for name in self.estimates}
        rows = [
            (float(self.time[k]), name, sensor, target, float(found[k, j, i]))
            for k in kept
            for name, found in pairs.items()
            for j, sensor in enumerate(sensors)
            for i, target in enumerate(self.targets)
            if np.isfinite(found[k, j, i])
        ]
        return csv_text(("time_s", "estimate", "sensor", "target", "position_error_m"), rows)

    def _kept(self, most: int) -> NDArray[np.int64]:
        every = -(-len(self.time) // most)
        return np.arange(0, len(self.time), every)


def mean_square(pairs: Floats, axes: tuple[int, ...]) -> Floats:
    """Root of the mean square over some axes; NaN where nothing is known."""
    known = np.isfinite(pairs)
    count = known.sum(axis=axes)
    total = np.where(known, pairs, 0.0) ** 2
    found = np.full(count.shape, np.nan)
    np.divide(total.sum(axis=axes), count, out=found, where=count > 0)
    return np.sqrt(found)


def until(places: Floats, truth: Floats, limit: float) -> tuple[Floats, int | None]:
    """Estimates before the first sample at which the error passes a limit, and that sample.

    Parameters
    ----------
    places : array (samples, sensors, targets, 2)
        In m.
    truth : array (samples, targets, 2)
        In m.
    limit : float
        Of the root-mean-square error over sensors and targets, in m.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        over = mean_square(np.linalg.norm(places - truth[:, None], axis=-1), (1, 2)) > limit
    if not over.any():
        return places, None
    first, kept = int(over.argmax()), places.copy()
    kept[first:] = np.nan
    return kept, first


def distance_text(value: float) -> str:
    """A round distance with its unit."""
    return f"{value / 1000:g} km" if 1e4 <= value < 1e9 else f"{value:g} m"


def settled(time: Floats, level: Floats, limit: float) -> float | None:
    """First time at which the error is below a limit."""
    below = level < limit
    return float(time[int(below.argmax())]) if below.any() else None
