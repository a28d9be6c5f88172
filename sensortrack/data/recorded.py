"""Recorded tracks that are shipped, with their licence beside them."""

from __future__ import annotations

import csv
from functools import cache
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError

Floats = NDArray[np.float64]
TRACKS = {
    "solent_six_vessels": "six vessels around the Solent, automatic identification reports",
    "uav_gps": "one drone, GPS fixes each second",
}
"""Name to what it is."""


def load_track(name: str, target: str = "") -> tuple[Floats, Floats]:
    """Load a recorded track.

    Parameters
    ----------
    name : str
        One of `TRACKS`.
    target : str, optional
        Which target of a file with several.

    Returns
    -------
    time : array (fixes,)
        In s, increasing.
    position : array (fixes, 3)
        In m in a local plane, east, north, up; up is 0 where it was not recorded.

    Raises
    ------
    InputError
        With the name ``track`` if there is no such file or target.
    """
    if name not in TRACKS:
        needed = f"one of {', '.join(TRACKS)} is needed"
        raise InputError("track", f"{name!r} is no track that is shipped", needed)
    rows = [row for row in _table(name) if not target or row.get("target") == target]
    names = sorted({row["target"] for row in _table(name)} if "target" in _table(name)[0] else [])
    if not rows or (names and not target):
        raise InputError("track", f"no target {target!r} in {name}", f"one of {', '.join(names)}")
    table = np.array([[float(row[k]) for k in ("t_s", "x_m", "y_m")] for row in rows])
    up = np.array([float(row.get("alt_m", 0.0)) for row in rows])
    first = np.r_[True, np.diff(table[:, 0]) > 0]  # one fix a time
    return table[first, 0], np.column_stack([table[first, 1:], up[first] - up[0]])


@cache
def _table(name: str) -> tuple[dict[str, str], ...]:
    text = files(__package__).joinpath("tracks", f"{name}.csv").read_text(encoding="utf-8")
    return tuple(csv.DictReader(text.splitlines()))
