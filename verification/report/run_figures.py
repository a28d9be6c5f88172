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
MANY_PIECES = 20
"""An estimate that comes and goes more often is drawn as dots."""
DECADES, ALL_DECADES = 6, 18
"""Below the largest value; all that doubles tell apart where agreement is exact."""


def figures(run: Record) -> tuple[tuple[str, Plot], ...]:
    """All figures of a run with the names that links use.

    Parameters
    ----------
    run : dict
        Content of ``run.json``.
    """
    levels = dict.fromkeys(entry["quantity"] for entry in run.get("levels", ()))
    moving = [("velocity-error", _errors(run, "velocity"))] if _has_velocity(run) else []
    return (
        ("tracks", _tracks(run)),
        ("position-error", _errors(run, "position")),
        *moving,
        *([("positions-known", _known(run))] if _someone_blind(run) else []),
        *((quantity.replace(" ", "-"), level_plot(run, quantity)) for quantity in levels),
        ("components", _components(run)),
    )


def _someone_blind(run: Record) -> bool:
    """Whether sensors lack a position after the first sample."""
    known = run.get("agents", {}).get("known", [])
    return bool(known) and min(known[1:], default=0) < len(run["sensors"])


def _known(run: Record) -> Plot:
    """How many sensors can compute a position; what others have is no number."""
    time, known = np.array(run["time"], dtype=float), np.array(run["agents"]["known"], dtype=float)
    most = len(run["sensors"])
    finding = "Sensors whose P_x allows a position; the others have a status, and no number."
    return Plot(
        title=f"{run['title']}: sensors with a position",
        finding=finding,
        caption=finding,
        x=Axis("time", "s", float(time[0]), float(time[-1])),
        y=Axis("sensors with a position", "", 0.0, most * 1.05, ticks=(float(most),)),
        curves=(*pieces("sharp", time, known, ""), *events_in(run, 0.0, float(most))),
    )


def _has_velocity(run: Record) -> bool:
    """Whether the system estimates velocities at all."""
    own = next(entry for entry in run["estimates"] if entry["name"] == run["system"])
    return bool(np.isfinite(np.array(own["velocity"], dtype=float)).any())


def errors(run: Record, estimate: Record, what: str) -> Floats:
    """Norm of an estimate's error at each time, in m or m/s."""
    truth = np.array(run["target"][what], dtype=float)
    return np.asarray(np.linalg.norm(np.array(estimate[what], dtype=float) - truth, axis=1))


def _tracks(run: Record) -> Plot:
    """The plane in which most happens, with equal axes."""
    target = np.array(run["target"]["position"], dtype=float)
    curves = [_curve("target", target, "target")]
    for estimate in run["estimates"]:
        if estimate["name"] == run["system"]:
            places = np.array(estimate["position"], dtype=float)
            known = np.isfinite(places).all(axis=1)
            if known.any():
                curves.append(_curve("sharp", places[known], estimate["label"]))
    sensors = [np.array(sensor["position"], dtype=float) for sensor in run["sensors"]]
    curves += [
        _curve("guide", np.stack([sensors[i][0], sensors[j][0]]), "")
        for i, j in run.get("links", ())
    ]
    shown = [target[:, :2], *(places[:, :2] for places in sensors)]
    (low_x, high_x), (low_y, high_y) = (extent([s[:, k] for s in shown]) for k in (0, 1))
    dots = [
        Dots("start", (float(places[0, 0]),), (float(places[0, 1]),), sensor["name"])
        for sensor, places in zip(run["sensors"], sensors, strict=True)
    ]
    return Plot(
        title=f"{run['title']}: tracks seen from above",
        finding="The dotted line is the target, the solid one the estimate; dots are sensors.",
        caption="Seen from above: target dotted, estimate solid, sensors where they start."
        + (" Links between sensors are thin." if run.get("links") else ""),
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
    curves: list[Curve] = []
    dots: list[Dots] = []
    for estimate in run["estimates"]:
        role = "sharp" if estimate["name"] == run["system"] else "run"
        level = errors(run, estimate, what)
        parts = pieces(role, time, level, estimate["label"])
        if len(parts) > MANY_PIECES:
            known = np.isfinite(level)
            label = estimate["label"]
            dots.append(Dots("failed", _listed(time[known]), _listed(level[known]), label))
        else:
            curves += parts
    bounds = [entry for entry in run.get("bounds", ()) if entry["quantity"] == f"{what} error"]
    for entry in bounds:
        values = np.array(entry["value"], dtype=float)
        curves += pieces("bound", np.array(entry["time"]), values, entry["name"])
    decades = DECADES if "levels" not in run else ALL_DECADES
    low, high = _positive([*curves, *dots], decades)
    curves += events_in(run, low, high)
    unit = "m" if what == "position" else "m/s"
    return Plot(
        title=f"{run['title']}: {what} error over time",
        finding=_verdict(bounds, what),
        caption=_verdict(bounds, what) + " Dotted lines mark events.",
        x=Axis("time", "s", float(time[0]), float(time[-1])),
        y=Axis(f"{what} error", unit, low, high, log=True),
        curves=tuple(curves),
        dots=tuple(dots),
    )


def pieces(role: str, x: Floats, y: Floats, label: str) -> list[Curve]:
    """A curve where it is known: one piece a stretch, the label on the last."""
    known = np.isfinite(y)
    starts = np.flatnonzero(known & ~np.r_[False, known[:-1]])
    ends = np.flatnonzero(known & ~np.r_[known[1:], False]) + 1
    return [
        Curve(role, _listed(x[i:j]), _listed(y[i:j]), label if j == ends[-1] else "")
        for i, j in zip(starts, ends, strict=True)
    ]


def events_in(run: Record, low: float, high: float) -> list[Curve]:
    """Events within the run as lines for the eye."""
    time = run["time"]
    return [
        Curve("guide", (event["time"],) * 2, (low, high))
        for event in run.get("events", ())
        if time[0] < event["time"] < time[-1]
    ]


def level_plot(run: Record, quantity: str) -> Plot:
    """How far the sensors are apart: the system, its distributed baselines, the bounds."""
    time = np.array(run["time"], dtype=float)
    levels = [entry for entry in run["levels"] if entry["quantity"] == quantity]
    bounds = [entry for entry in run.get("bounds", ()) if entry["quantity"] == quantity]
    sizes = np.concatenate([np.array(entry["value"], dtype=float) for entry in levels])
    high = float(sizes.max()) * 3 or 1.0
    low = high * 10.0**-ALL_DECADES
    curves = []
    for entry in levels:
        role = "sharp" if entry["of"] == run["system"] else "run"
        shown = np.maximum(np.array(entry["value"], dtype=float), low)
        curves += pieces(role, time, shown, entry["label"])
    for entry in bounds:
        shown = np.maximum(np.array(entry["value"], dtype=float), low)
        curves += pieces("bound", np.array(entry["time"]), shown, entry["name"])
    held = all(entry["holds"] for entry in bounds)
    said = "below its proved bound" if held else "above a bound, whose assumption is broken"
    finding = f"The {quantity} of the sensors stays {said}." if bounds else f"The {quantity}."
    return Plot(
        title=f"{run['title']}: {quantity} over time",
        finding=finding,
        caption=f"{finding} Norm over the sensors, largest entry; what is 0 lies at the bottom.",
        x=Axis("time", "s", float(time[0]), float(time[-1])),
        y=Axis(quantity, levels[0]["unit"].replace("1", ""), low, high, log=True),
        curves=(*curves, *events_in(run, low, high)),
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
    truth = np.array(run["target"]["position"], dtype=float)
    error = np.array(own["position"], dtype=float) - truth
    error = error[:, : run.get("coordinates", error.shape[1])]
    shown = error[np.array(time) >= run["summary"][0]["from"]] if "levels" in run else error
    low, high = extent([shown])
    curves = [
        curve
        for k, role in zip(range(error.shape[1]), ("sharp", "bound", "printed"), strict=False)
        for curve in pieces(role, np.array(time), error[:, k], f"{PARTS[k]} error")
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


def _positive(curves: Sequence[Curve | Dots], decades: int) -> tuple[float, float]:
    """Ends of a logarithmic axis: at most some decades below the largest value."""
    values = np.concatenate([np.zeros(0), *(np.array(curve.y) for curve in curves)])
    values = values[np.isfinite(values) & (values > 0)]
    if not values.size:
        return 0.1, 1.0
    high = float(values.max()) * 1.5
    return max(float(values.min()) * 0.7, high * 10.0**-decades), high
