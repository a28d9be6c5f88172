"""The figures of a run in which several sensors follow several targets."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .style import COLOURS, axes_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Record = Mapping[str, Any]
LOOKS = (("sharp", "-"), ("printed", "--"), ("run", "-"), ("run", "--"))


def several_figures(run: Record) -> Mapping[str, Callable[[Record], Figure]]:
    """File name to what draws it."""
    limits = dict.fromkeys(entry["m_max"] for entry in run["spsa"]["variants"])
    return {
        "tracks": tracks,
        **{f"error_m_max_{m}": partial(error, m_max=m) for m in limits},
        "error_by_sensor": partial(parts, what="sensor"),
        "error_by_target": partial(parts, what="target"),
    }


def tracks(run: Record) -> Figure:
    """Targets, sensors and first estimates in the plane."""
    figure, axes = axes_of()
    for target in run["targets"]:
        path = _array(target["position"])
        axes.plot(path[:, 0], path[:, 1], ":", color=COLOURS["target"])
        end = (float(path[-1, 0]), float(path[-1, 1]))
        axes.annotate(target["name"], end, textcoords="offset points", xytext=(4, 3), fontsize=6)
    for sensor in run["sensors"]:
        place = sensor["position"][0][:2]
        axes.plot(*place, "s", color=COLOURS["run"], ms=4)
        axes.annotate(sensor["name"], place, textcoords="offset points", xytext=(5, 3))
    start = np.array(run["spsa"]["variants"][0]["start"], dtype=float).reshape(-1, 2)
    axes.plot(start[:, 0], start[:, 1], ".", color=COLOURS["sharp"], ms=3)
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    axes.set_adjustable("datalim")
    return figure


def error(run: Record, m_max: int) -> Figure:
    """Error over time of all that follow so many targets at a time, and of the baselines."""
    figure, axes = axes_of()
    settings = {entry["name"]: entry["m_max"] for entry in run["spsa"]["variants"]}
    estimates = {entry["name"]: entry for entry in run["estimates"]}
    chosen = [name for name, limit in settings.items() if limit == m_max]
    expected = {entry["of"]: entry for entry in run.get("expected", ())}
    for k, name in enumerate(chosen):
        role, dash = LOOKS[min(k, len(LOOKS) - 1)]
        entry = estimates[name]
        _curve(run, axes, entry["error"], COLOURS[role], dash, entry["label"])
        if name in expected:
            label = "expected" if k == 0 else ""
            _curve(run, axes, expected[name]["value"], COLOURS["bound"], "-", label)
    others = [entry for name, entry in estimates.items() if name not in settings]
    for dash, entry in zip((":", "-."), others, strict=False):
        _curve(run, axes, entry["error"], COLOURS["run"], dash, entry["label"])
    _finish(axes)
    return figure


def parts(run: Record, what: str) -> Figure:
    """Errors of the first estimate that has not diverged, by sensor or by target."""
    figure, axes = axes_of()
    colours = [COLOURS[role] for role in ("sharp", "printed", "bound", "target", "run", "rule")]
    names = [entry["name"] for entry in run[f"{what}s"]]
    whole = [entry for entry in run["estimates"] if entry["error"][-1] is not None]
    for k, level in enumerate((whole or run["estimates"])[0][f"by_{what}"]):
        dash = ("-", "--", ":")[k // len(colours) % 3]
        _curve(run, axes, level, colours[k % len(colours)], dash, names[k])
    _finish(axes, what)
    return figure


def _curve(run: Record, axes: Axes, level: Any, colour: str, dash: str, label: str) -> None:
    width = 0.8 if colour == COLOURS["bound"] else 1.3
    axes.semilogy(run["time"], _array(level), dash, color=colour, lw=width, label=label or None)


def _finish(axes: Axes, title: str = "") -> None:
    axes.set(xlabel="time, s", ylabel="error, rms, m")
    axes.legend(frameon=False, fontsize=7, title=title)


def _array(rows: Any) -> NDArray[np.float64]:
    return np.array(rows, dtype=float)
