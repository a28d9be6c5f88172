"""The figures of one run: the target, the tracks, the errors beside their bounds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .several import several_figures
from .style import COLOURS, axes_of, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Record = Mapping[str, Any]
PARTS = (("x", "sharp"), ("y", "printed"), ("z", "bound"))
SCATTERED = 40
NEVER = {"Date": None}
"""No date in a file, so that the same run gives the same bytes."""


def save_run(run: Record, folder: Path) -> list[Path]:
    """Write the figures of a run as SVG files.

    Parameters
    ----------
    run : mapping
        Content of ``run.json``.
    folder : Path
        Exists.

    Returns
    -------
    list of Path
    """
    made = []
    with style():
        for name, draw in _chosen(run).items():
            figure = draw(run)
            path = folder / f"{name}.svg"
            figure.savefig(path, metadata=NEVER)
            made.append(path)
    return made


def _chosen(run: Record) -> Mapping[str, Callable[[Record], Figure]]:
    """The figures that say something about a run."""
    if "targets" in run:
        return several_figures(run)
    own = next(entry for entry in run["estimates"] if entry["name"] == run["system"])
    blind = () if np.isfinite(_array(own["velocity"])).any() else VELOCITIES
    levels = dict.fromkeys(entry["quantity"] for entry in run.get("levels", ()))
    return {name: draw for name, draw in FIGURES.items() if name not in blind} | {
        quantity.replace(" ", "_"): partial(_level, quantity=quantity) for quantity in levels
    }


def _array(rows: Any) -> NDArray[np.float64]:
    return np.array(rows, dtype=float)


def track(run: Record) -> Figure:
    """The target's path in space."""
    figure, axes = axes_of(projection="3d")
    path = _array(run["target"]["position"])
    axes.plot(*path.T, color=COLOURS["target"])
    axes.plot(*path[:1].T, "o", color=COLOURS["sharp"], ms=4)
    axes.set(xlabel="x, m", ylabel="y, m", zlabel="z, m")
    return figure


def seen_from_above(run: Record) -> Figure:
    """Target, estimate and sensors in the plane."""
    figure, axes = axes_of()
    path = _array(run["target"]["position"])
    axes.plot(path[:, 0], path[:, 1], ":", color=COLOURS["target"], label="target")
    for estimate in run["estimates"]:
        if estimate["name"] == run["system"]:
            places = _array(estimate["position"])
            axes.plot(places[:, 0], places[:, 1], color=COLOURS["sharp"], lw=1.1, label="estimate")
    for link in run.get("links", ()):
        ends = _array([run["sensors"][i]["position"][0] for i in link])
        axes.plot(ends[:, 0], ends[:, 1], color=COLOURS["rule"], lw=0.6)
    for sensor in run["sensors"]:
        place = _array(sensor["position"])
        axes.plot(place[:, 0], place[:, 1], color=COLOURS["run"], lw=0.7)
        axes.plot(*place[0, :2], "s", color=COLOURS["run"], ms=4)
        corner = (float(place[0, 0]), float(place[0, 1]))
        axes.annotate(sensor["name"], corner, textcoords="offset points", xytext=(5, 3))
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    axes.set_adjustable("datalim")
    axes.legend(frameon=False)
    return figure


def _parts(run: Record, values: NDArray[np.float64], label: str) -> Figure:
    """Three components over time."""
    figure, axes = axes_of()
    for k, (part, role) in enumerate(PARTS):
        axes.plot(run["time"], values[:, k], color=COLOURS[role], lw=1.2, label=part)
    _events(run, axes)
    axes.set(xlabel="time, s", ylabel=label)
    axes.legend(frameon=False, ncols=3)
    return figure


def _error(run: Record, what: str) -> NDArray[np.float64]:
    own = next(entry for entry in run["estimates"] if entry["name"] == run["system"])
    return _array(own[what]) - _array(run["target"][what])


def _beside_bounds(run: Record, what: str, unit: str) -> Figure:
    """Norms of the errors of all estimates, and what bounds them."""
    figure, axes = axes_of()
    truth = _array(run["target"][what])
    for estimate in run["estimates"]:
        own = estimate["name"] == run["system"]
        size = np.linalg.norm(_array(estimate[what]) - truth, axis=1)
        known = np.where(size > 0, size, np.nan)
        colour, width = (COLOURS["sharp"], 1.6) if own else (COLOURS["run"], 0.7)
        dash = "-" if own or estimate["name"] == "raw" else "--"
        if _scattered(size):
            dash = "."
        axes.semilogy(
            run["time"], known, dash, color=colour, lw=width, ms=2, label=estimate["label"]
        )
    for bound in run.get("bounds", ()):
        if bound["quantity"] == f"{what} error":
            value = _array(bound["value"])
            look = {"zorder": 1.5, "lw": 1.0} if "levels" in run else {}
            axes.semilogy(bound["time"], value, color=COLOURS["bound"], label="bound", **look)
    _events(run, axes)
    axes.set(xlabel="time, s", ylabel=f"{what} error, {unit}")
    axes.legend(frameon=False, fontsize=7)
    return figure


def _scattered(size: NDArray[np.float64]) -> bool:
    """Whether an estimate comes and goes so often that a line would show nothing of it."""
    known = np.isfinite(size)
    return int((known[1:] != known[:-1]).sum()) > SCATTERED


def _level(run: Record, quantity: str) -> Figure:
    """How far the sensors are apart, beside the bounds."""
    figure, axes = axes_of()
    for entry in run["levels"]:
        if entry["quantity"] != quantity:
            continue
        own = entry["of"] == run["system"]
        size = _array(entry["value"])
        colour, width = (COLOURS["sharp"], 1.6) if own else (COLOURS["run"], 0.7)
        known = np.where(size > 0, size, np.nan)
        axes.semilogy(run["time"], known, color=colour, lw=width, label=entry["label"])
    for bound in run.get("bounds", ()):
        if bound["quantity"] == quantity:
            value = _array(bound["value"])
            known = np.where(value > 0, value, np.nan)
            axes.semilogy(bound["time"], known, color=COLOURS["bound"], label=bound["name"])
    _events(run, axes)
    unit = next(e["unit"] for e in run["levels"] if e["quantity"] == quantity)
    axes.set(xlabel="time, s", ylabel=quantity if unit == "1" else f"{quantity}, {unit}")
    axes.legend(frameon=False, fontsize=7)
    return figure


def _events(run: Record, axes: Axes) -> None:
    for event in run.get("events", ()):
        axes.axvline(event["time"], color=COLOURS["rule"], ls=":", lw=0.9)


VELOCITIES = ("velocity_error", "velocity_bound")
FIGURES: Mapping[str, Callable[[Record], Figure]] = {
    "target_track": track,
    "target_position": lambda run: _parts(run, _array(run["target"]["position"]), "position, m"),
    "target_velocity": lambda run: _parts(run, _array(run["target"]["velocity"]), "velocity, m/s"),
    "tracks": seen_from_above,
    "position_error": lambda run: _parts(run, _error(run, "position"), "position error, m"),
    "velocity_error": lambda run: _parts(run, _error(run, "velocity"), "velocity error, m/s"),
    "position_bound": lambda run: _beside_bounds(run, "position", "m"),
    "velocity_bound": lambda run: _beside_bounds(run, "velocity", "m/s"),
}
"""File name to what draws it; the first three and the errors are Figures 2 to 8 of the paper."""
