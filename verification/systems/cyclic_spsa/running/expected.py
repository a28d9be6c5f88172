"""What a run of cyclic SPSA was to be expected to do: exact moments along its own geometry.

Numbers are floating point: expectations to stand beside a run, not proofs.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from sensortrack.simulation.several import SETTLED, settled

from .expected_squares import Floats, Setting, expected_squares

WORDS = (
    "exact moments along the paths of this run, from its start, for Gaussian errors of positions"
)


def expected(run: Mapping[str, Any], entry: Mapping[str, Any], setting: Setting) -> dict[str, Any]:
    """Expected root-mean-square error of one setting of a run, over sensors and targets.

    Parameters
    ----------
    run : mapping
        Content of ``run.json``.
    entry : mapping
        Of its settings.
    setting : Setting
        The same, as `setting_of` returns it.

    Returns
    -------
    dict
        ``of`` the setting, ``value`` by time in m (None from divergence on), ``rms`` from the time
        on from which errors are summarised, when it is ``settled``, and the ``limit`` of alpha:
        the least over sensors, blocks and samples at which the mean square stays bounded, None
        if the run ends before an update.
    """
    since = float(run["summary"][0]["from"])
    squares, limit = expected_squares(setting)
    level = np.sqrt(np.nanmean(squares, axis=(1, 2)))
    over = ~(level <= float(run["spsa"]["diverged_m"]))
    if over.any():
        level[int(over.argmax()) :] = np.inf
    time = np.array(run["time"], dtype=float)
    shown = level[:: -(-len(level) // len(time))]
    counted = shown[time >= since]
    return {
        "of": entry["name"],
        "quantity": "position error",
        "unit": "m",
        "time": run["time"],
        "value": [float(f"{x:.6g}") if np.isfinite(x) else None for x in shown.tolist()],
        "rms": None if over.any() or not counted.size else float(np.sqrt(np.mean(counted**2))),
        "settled": settled(time, shown, SETTLED * float(shown[0])),
        "alpha": float(entry["alpha"]),
        "limit": limit if np.isfinite(limit) else None,
        "statement": WORDS,
    }


def setting_of(run: Mapping[str, Any], entry: Mapping[str, Any]) -> Setting:
    """A setting along the paths of a run, which are smooth between the kept samples."""
    kept = np.array(run["time"], dtype=float)
    place, rate = (
        np.array([target[key] for target in run["targets"]], dtype=float)[..., :2]
        for key in ("position", "velocity")
    )
    time = kept[0] + float(run["parameters"]["h"]) * np.arange(run["samples"])
    noise = run["spsa"]["noise"]
    return Setting(
        alpha=float(entry["alpha"]),
        beta=float(entry["beta"]),
        instants=2 if entry["reading"] == "two" else 1,
        paths=_between(kept, np.swapaxes(place, 0, 1), np.swapaxes(rate, 0, 1), time),
        sensors=np.array([sensor["position"][0][:2] for sensor in run["sensors"]], dtype=float),
        along=float(noise["along"]),
        across=float(noise["across"]),
        shares=entry["shares"],
        start=np.array(entry["start"], dtype=float),
    )


def _between(kept: Floats, place: Floats, rate: Floats, time: Floats) -> Floats:
    """Positions at all samples: Hermite's cubics between the kept ones, the last one continued."""
    first = np.minimum(np.searchsorted(kept, time, side="right") - 1, max(len(kept) - 2, 0))
    if len(kept) == 1:
        return place[first]
    h = (kept[first + 1] - kept[first])[:, None, None]
    s = (time - kept[first])[:, None, None] / h
    step = place[first + 1] - place[first]
    start, end = h * rate[first] - step, step - h * rate[first + 1]
    bend = s * (1 - s) * ((1 - s) * start + s * end)
    return np.asarray(place[first] + s * step + bend)
