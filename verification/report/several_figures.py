"""Figures of a run in which several sensors follow several targets."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from sensortrack.simulation.several import distance_text
from verification.figure import Axis, Curve, Dots, Plot

from .plots import extent
from .records import Record, digits
from .several_tables import metres

Floats = NDArray[np.float64]
ROOM = 1.5
"""Above the largest and below the smallest value of a logarithmic axis."""
ROLES = ("sharp", "printed", "run")
"""Of the settings in one figure, in order; further ones look like the last."""
POINTS = 60
"""Of a curve of one sensor or target, each over a part of the run: noise would hide the others."""


def several_figures(run: Record) -> tuple[tuple[str, Plot], ...]:
    """All figures of a run with the names that links use.

    Parameters
    ----------
    run : dict
        Content of ``run.json``.
    """
    limits = dict.fromkeys(entry["m_max"] for entry in _settings(run))
    first = _first(run)
    return (
        ("tracks", _tracks(run)),
        *((f"error-m-max-{m}", _settings_plot(run, m)) for m in limits),
        ("error-beside", _beside(run)),
        ("error-by-sensor", _parts(run, first, "sensor", _names(run["sensors"]))),
        ("error-by-target", _parts(run, first, "target", _names(run["targets"]))),
    )


def _settings(run: Record) -> list[Record]:
    found: list[Record] = run["spsa"]["variants"]
    return found


def _first(run: Record) -> Record:
    """The first setting that has not diverged, or the first."""
    names = [entry["name"] for entry in _settings(run)]
    kept = [row["estimate"] for row in run["summary"] if row["position_rms"] is not None]
    name = next((name for name in names if name in kept), names[0])
    return _by(run["estimates"], "name")[name]


def _by(entries: Iterable[Record], key: str) -> dict[str, Record]:
    return {entry[key]: entry for entry in entries}


def _names(entries: Iterable[Record]) -> list[str]:
    return [entry["name"] for entry in entries]


def _tracks(run: Record) -> Plot:
    """The plane, in km where it is wide."""
    paths = [_array(target["position"])[:, :2] for target in run["targets"]]
    places = np.array([sensor["position"][0][:2] for sensor in run["sensors"]], dtype=float)
    start = np.array(_settings(run)[0]["start"], dtype=float).reshape(-1, 2)
    start = start[np.isfinite(start).all(axis=1)]
    wide = float(np.ptp(np.concatenate([*paths, places, start]), axis=0).max()) > 2e4
    scale, unit = (1e-3, "km") if wide else (1.0, "m")
    curves = [_line("target", path * scale) for path in paths]
    ends = np.array([path[0] for path in paths]) * scale
    places, start = places * scale, start * scale
    shown = [*(path * scale for path in paths), places, start]
    (low_x, high_x), (low_y, high_y) = (extent([s[:, k] for s in shown]) for k in (0, 1))
    names = _names(run["sensors"])
    finding = "Paths of the targets are dotted and begin at the rings; dots are sensors."
    return Plot(
        title=f"{run['title']}: seen from above",
        finding=finding,
        caption=f"{finding} Those in colour are the first estimates.",
        x=Axis("x", unit, low_x, high_x),
        y=Axis("y", unit, low_y, high_y),
        curves=tuple(curves),
        dots=(
            *(
                Dots("start", (float(x),), (float(y),), name)
                for (x, y), name in zip(places, names, strict=True)
            ),
            _dots("failed", ends),
            _dots("held", start),
        ),
        equal=True,
    )


def _line(role: str, points: Floats) -> Curve:
    return Curve(role, tuple(points[:, 0].tolist()), tuple(points[:, 1].tolist()))


def _dots(role: str, points: Floats) -> Dots:
    return Dots(role, tuple(points[:, 0].tolist()), tuple(points[:, 1].tolist()))


def _settings_plot(run: Record, m_max: int) -> Plot:
    """The settings that follow so many targets at a time, beside what was expected of them."""
    entries = [entry for entry in _settings(run) if entry["m_max"] == m_max]
    estimates, expected = _by(run["estimates"], "name"), _by(run.get("expected", ()), "of")
    curves: list[Curve] = []
    dots: list[Dots] = []
    for k, entry in enumerate(entries):
        found = estimates[entry["name"]]
        role = ROLES[min(k, len(ROLES) - 1)]
        lost = _lost(run, entry["name"])
        curves.append(_level(run, found["error"], role, "" if lost else found["label"]))
        if lost:
            dots.append(Dots("refuting", (lost,), (run["spsa"]["diverged_m"],), found["label"]))
        if entry["name"] in expected:
            curves.append(_level(run, expected[entry["name"]]["value"], "bound", ""))
    said = f"error with {m_max} target{'s' if m_max > 1 else ''} at a time"
    caption = "Root-mean-square error over sensors and targets; thin lines are what was expected, "
    caption += "from exact moments along these paths. "
    caption += f"A diamond is where an error has passed {distance_text(run['spsa']['diverged_m'])}."
    return _plot(run, said, caption, curves, dots)


def _lost(run: Record, name: str) -> float | None:
    """When an estimate diverged."""
    found: float | None = _by(run["summary"], "estimate")[name]["diverged"]
    return found


def _beside(run: Record) -> Plot:
    """The first setting and the other estimators."""
    first = _first(run)
    settings = {*_names(_settings(run))}
    others = [entry for entry in run["estimates"] if entry["name"] not in settings]
    curves = [_level(run, first["error"], "sharp", first["label"])]
    for k, entry in enumerate(others):
        role = ("printed", "run")[min(k, 1)]
        curves.append(_level(run, entry["error"], role, entry["label"]))
    caption = "Root-mean-square error over sensors and targets, on the same measurements. "
    caption += "The other estimators work on all targets at every sample."
    return _plot(run, "error beside other estimators", caption, curves)


def _parts(run: Record, entry: Record, what: str, names: Sequence[str]) -> Plot:
    """Errors of one estimate by sensor or by target."""
    levels = entry[f"by_{what}"]
    ends = [_last(level) for level in levels]
    worst, best = int(np.argmax(ends)), int(np.argmin(ends))
    curves = []
    for k, level in enumerate(levels):
        role = "printed" if k == worst else "sharp" if k == best else "run"
        name = f"{what} {names[k]}" if names[k].isdigit() else names[k]
        label = name if k in (worst, best) else ""
        curves.append(_curve(*_windows(run["time"], level), role, label))
    caption = (
        f"Root-mean-square error of {entry['label']} by {what}; the best and the worst at the "
    )
    caption += "end are named."
    if (width := _width(run["time"])) > 1:
        length = width * (run["time"][1] - run["time"][0])
        caption += f" Each point is of {digits(length)} s."
    return _plot(run, f"error by {what}", caption, curves)


def _last(level: Sequence[float | None]) -> float:
    """Root-mean-square over the last tenth."""
    part = _array(level)[-max(1, len(level) // 10) :]
    part = part[np.isfinite(part)]
    return float(np.sqrt(np.mean(part**2))) if part.size else np.inf


def _level(run: Record, level: Sequence[float | None], role: str, label: str) -> Curve:
    return _curve(_array(run["time"]), _array(level), role, label)


def _curve(time: Floats, values: Floats, role: str, label: str) -> Curve:
    """A curve up to where it is known."""
    known = np.logical_and.accumulate(np.isfinite(values))
    return Curve(role, tuple(time[known].tolist()), tuple(values[known].tolist()), label)


def _width(time: Sequence[float]) -> int:
    return max(1, len(time) // POINTS)


def _windows(time: Sequence[float], level: Sequence[float | None]) -> tuple[Floats, Floats]:
    """The start, then middles of windows and the root-mean-square over each."""
    width = _width(time)
    whole = (len(time) - 1) // width * width
    middles = _array(time)[1 : whole + 1].reshape(-1, width).mean(axis=1)
    values = _array(level)
    squares = (values[1 : whole + 1] ** 2).reshape(-1, width).mean(axis=1)
    return np.append(time[0], middles), np.append(values[0], np.sqrt(squares))


def _plot(
    run: Record, said: str, caption: str, curves: list[Curve], dots: Sequence[Dots] = ()
) -> Plot:
    time = run["time"]
    marks: tuple[Curve | Dots, ...] = (*curves, *dots)
    values = np.concatenate([np.array(mark.y) for mark in marks])
    values = values[values > 0]
    low, high = (values.min() / ROOM, values.max() * ROOM) if values.size else (0.1, 1.0)
    finding = "; ".join(
        f"{curve.label} ends at {metres(curve.y[-1])} m"
        for curve in curves
        if curve.label and curve.y
    )
    return Plot(
        title=f"{run['title']}: {said}",
        finding=f"{finding}.",
        caption=caption,
        x=Axis("time", "s", float(time[0]), float(time[-1])),
        y=Axis("error, rms", "m", float(low), float(high), log=True),
        curves=tuple(curve for curve in curves if curve.y),
        dots=tuple(dots),
    )


def _array(rows: object) -> Floats:
    return np.array(rows, dtype=float)
