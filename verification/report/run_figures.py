"""Figures of a run: where everything was, how large the errors were, what bounds them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from verification.figure import Axis, Curve, Dots, Plot

from .plots import extent
from .records import Record, digits

Floats = NDArray[np.float64]
PARTS = ("x", "y", "z")


def figures(run: Record) -> tuple[tuple[str, Plot], ...]:
    """All figures of a run with the names that links use.

    Parameters
    ----------
    run : dict
        Content of ``run.json``.
    """
    return (
        ("tracks", _tracks(run)),
        ("position-error", _errors(run, "position")),
        ("velocity-error", _errors(run, "velocity")),
        ("components", _components(run)),
    )


def errors(run: Record, estimate: Record, what: str) -> Floats:
    """Norm of an estimate's error at each time, in m or m/s."""
    truth = np.array(run["target"][what], dtype=float)
    return np.asarray(np.linalg.norm(np.array(estimate[what], dtype=float) - truth, axis=1))


def _tracks(run: Record) -> Plot:
    """The plane in which most happens, with equal axes."""
    target = np.array(run["target"]["position"], dtype=float)
    curves = [_curve("target", target, "target")]
    roles = {"variational": "sharp"}
    for estimate in run["estimates"]:
        role = roles.get(estimate["name"])
        if role:
            places = np.array(estimate["position"], dtype=float)
            curves.append(_curve(role, places, estimate["label"]))
    sensors = [np.array(sensor["position"], dtype=float) for sensor in run["sensors"]]
    shown = [target[:, :2], *(places[:, :2] for places in sensors)]
    (low_x, high_x), (low_y, high_y) = (extent([s[:, k] for s in shown]) for k in (0, 1))
    dots = [
        Dots("start", (float(places[0, 0]),), (float(places[0, 1]),), sensor["name"])
        for sensor, places in zip(run["sensors"], sensors, strict=True)
    ]
    return Plot(
        title=f"{run['title']}: tracks seen from above",
        finding="The dotted line is the target, the solid one the estimate; dots are sensors.",
        caption="Seen from above: target dotted, estimate solid, sensors where they start.",
        x=Axis("x", "m", low_x, high_x),
        y=Axis("y", "m", low_y, high_y),
        curves=tuple(curves),
        dots=tuple(dots),
        equal=True,
    )


def _curve(role: str, places: Floats, label: str) -> Curve:
    return Curve(role, tuple(places[:, 0].tolist()), tuple(places[:, 1].tolist()), label)


def _errors(run: Record, what: str) -> Plot:
    """Errors of all estimates, the proved bounds above them, events as guides."""
    time = np.array(run["time"], dtype=float)
    curves = []
    for estimate in run["estimates"]:
        role = "sharp" if estimate["name"] == run["system"] else "run"
        level = errors(run, estimate, what)
        curves.append(Curve(role, tuple(time.tolist()), _listed(level), estimate["label"]))
    bounds = [entry for entry in run.get("bounds", ()) if entry["quantity"] == f"{what} error"]
    for entry in bounds:
        values = np.array(entry["value"], dtype=float)
        curves.append(Curve("bound", tuple(entry["time"]), _listed(values), entry["name"]))
    low, high = _positive(curves)
    curves += [
        Curve("guide", (event["time"],) * 2, (low, high))
        for event in run.get("events", ())
        if time[0] < event["time"] < time[-1]
    ]
    unit = "m" if what == "position" else "m/s"
    return Plot(
        title=f"{run['title']}: {what} error over time",
        finding=_verdict(bounds, what),
        caption=_verdict(bounds, what) + " Dotted lines mark events.",
        x=Axis("time", "s", float(time[0]), float(time[-1])),
        y=Axis(f"{what} error", unit, low, high, log=True),
        curves=tuple(curves),
    )


def _verdict(bounds: Sequence[Record], what: str) -> str:
    if not bounds:
        return f"The norm of each estimate's {what} error; no bound was proved for this run."
    held = all(entry["holds"] for entry in bounds)
    reached = max(float(entry["reached"]) for entry in bounds)
    if held:
        return f"The {what} error stays below its proved bound and reaches {digits(reached)} of it."
    return f"The {what} error crosses a bound: an assumption of the bound is broken in this run."


def _components(run: Record) -> Plot:
    """Position errors of the system's estimate, by coordinate."""
    time = tuple(run["time"])
    own = next(entry for entry in run["estimates"] if entry["name"] == run["system"])
    error = np.array(own["position"]) - np.array(run["target"]["position"])
    low, high = extent([error])
    curves = [
        Curve(role, time, _listed(error[:, k]), f"{PARTS[k]} error")
        for k, role in zip(range(error.shape[1]), ("sharp", "bound", "printed"), strict=False)
    ]
    return Plot(
        title=f"{run['title']}: components of the position error",
        finding="Each component of the position error over time.",
        caption="Components of the position error, inertial frame.",
        x=Axis("time", "s", time[0], time[-1]),
        y=Axis("position error", "m", low, high, ticks=(0.0,) if low < 0 < high else ()),
        curves=tuple(curves),
    )


def _listed(values: Floats) -> tuple[float, ...]:
    return tuple(float(v) for v in values)


def _positive(curves: Sequence[Curve]) -> tuple[float, float]:
    """Ends of a logarithmic axis: at most six decades below the largest value."""
    values = np.concatenate([np.array(curve.y) for curve in curves])
    values = values[np.isfinite(values) & (values > 0)]
    if not values.size:
        return 0.1, 1.0
    high = float(values.max()) * 1.5
    return max(float(values.min()) * 0.7, high * 1e-6), high
