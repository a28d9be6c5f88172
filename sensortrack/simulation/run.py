"""One run: everything that was true and everything that was estimated."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
FORMAT = "sensortrack-run/1"


@dataclass(frozen=True, eq=False)
class Run:
    """What a simulation found; positions in m, velocities in m/s, times in s, inertial frame.

    Parameters
    ----------
    name, title, about : str
        Of the scenario.
    system : str
        Whose estimator ran.
    digest : str
        Of the generated source that was stepped.
    seed : int
    assumptions, notes : tuple of str
        What was chosen because no paper prints it; what was remarkable.
    parameters : mapping
        Gains, step, weights, noise.
    time : array (samples,)
    target : (array (samples, 3), array (samples, 3))
        True position and velocity.
    sensors : mapping of str to array (samples, 3)
    estimates : mapping of str to (array, array)
        Position and velocity; NaN where there is no estimate.
    labels : mapping of str to str
        Names of the estimates for readers.
    events : tuple of dict
    summary_from : float
        Time from which errors are summarised.
    extra : mapping, optional
        Further entries of ``run.json``.
    """

    name: str
    title: str
    about: str
    system: str
    digest: str
    seed: int
    assumptions: tuple[str, ...]
    parameters: Mapping[str, Any]
    time: Floats
    target: tuple[Floats, Floats]
    sensors: Mapping[str, Floats]
    estimates: Mapping[str, tuple[Floats, Floats]]
    labels: Mapping[str, str]
    events: tuple[dict[str, Any], ...]
    notes: tuple[str, ...]
    summary_from: float
    extra: Mapping[str, Any] = field(default_factory=dict)

    def errors(self, name: str) -> tuple[Floats, Floats]:
        """Norms of the position error in m and the velocity error in m/s of an estimate."""
        found = self.estimates[name]
        place, rate = (
            np.linalg.norm(estimate - truth, axis=1)
            for estimate, truth in zip(found, self.target, strict=True)
        )
        return place, rate

    @property
    def summary(self) -> list[dict[str, Any]]:
        """Root-mean-square errors of each estimate; None where it is never known."""
        counted = self.time >= self.summary_from
        rows = []
        for name in self.estimates:
            place, rate = (rms(error[counted]) for error in self.errors(name))
            rows.append(
                {
                    "estimate": name,
                    "position_rms": place,
                    "velocity_rms": rate,
                    "from": self.summary_from,
                }
            )
        return rows

    def to_data(self) -> dict[str, Any]:
        """Return the content of ``run.json``."""
        return {
            "format": FORMAT,
            "name": self.name,
            "title": self.title,
            "about": self.about,
            "system": self.system,
            "digest": self.digest,
            "seed": self.seed,
            "assumptions": list(self.assumptions),
            "parameters": dict(self.parameters),
            **self.truth_data(),
            "sensors": self.sensor_data(),
            "estimates": self.estimate_data(),
            "events": list(self.events),
            "summary": self.summary,
            "notes": list(self.notes),
            **self.extra,
        }

    def truth_data(self) -> dict[str, Any]:
        """Times, and where the target truly was."""
        place, rate = self.target
        return {
            "time": self.time.tolist(),
            "target": {"position": _rows(place), "velocity": _rows(rate)},
        }

    def sensor_data(self) -> list[dict[str, Any]]:
        """Where the sensors were."""
        return [{"name": name, "position": _rows(place)} for name, place in self.sensors.items()]

    def estimate_data(self) -> list[dict[str, Any]]:
        """What was estimated, and how it is called."""
        return [
            {
                "name": name,
                "label": self.labels.get(name, name),
                "position": _rows(place),
                "velocity": _rows(rate),
            }
            for name, (place, rate) in self.estimates.items()
        ]

    def tracks_csv(self) -> str:
        """Positions and velocities, one row a time and a track."""
        tracks = {"target": self.target, **self.estimates}
        head = ("time_s", "track", "x_m", "y_m", "z_m", "vx_mps", "vy_mps", "vz_mps")
        rows = [
            (t, name, *place[k], *rate[k])
            for k, t in enumerate(self.time)
            for name, (place, rate) in tracks.items()
        ]
        return csv_text(head, rows)

    def errors_csv(self) -> str:
        """Norms of the errors, one row a time and an estimate."""
        errors = {name: self.errors(name) for name in self.estimates}
        rows = [
            (t, name, place[k], rate[k])
            for k, t in enumerate(self.time)
            for name, (place, rate) in errors.items()
        ]
        return csv_text(("time_s", "estimate", "position_error_m", "velocity_error_mps"), rows)


def rms(values: Floats) -> float | None:
    """Root-mean-square of what is known, None if nothing is."""
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known**2))) if known.size else None


def _rows(values: Floats) -> list[list[float | None]]:
    return [[x if np.isfinite(x) else None for x in row] for row in values.tolist()]


def rounded(values: Floats, digits: int = 6) -> list[Any]:
    """Numbers with some digits, nested as they are; None for what is not known."""
    if values.ndim > 1:
        return [rounded(row, digits) for row in values]
    return [float(f"{x:.{digits}g}") if np.isfinite(x) else None for x in values.tolist()]


def csv_text(head: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """Rows as comma-separated values, numbers with nine digits."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows([[f"{x:.9g}" if isinstance(x, float) else x for x in row] for row in rows])
    return text.getvalue()
