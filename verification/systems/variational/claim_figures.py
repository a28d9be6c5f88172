"""Figures of the claims about sensors, noise and late data."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction

import numpy as np

from verification.exact.evaluate import Rows
from verification.figure import Area, Axis, Curve, Dots, Plot

from .delays import late_pencil, late_radius
from .noise_gains import exact_traces

ONE: Rows = ((Fraction(1),),)
UNIT_GAINS: Mapping[str, Rows] = dict.fromkeys("MKC", ONE)
MARGIN = 0.15


def network(
    places: Sequence[Sequence[Fraction]], links: Collection[tuple[int, int]], marked: Sequence[int]
) -> Plot:
    """Sensors and the links within range, some sensors marked.

    Parameters
    ----------
    places : sequence of pairs of Fraction
        In units of the range.
    links : collection of pairs of int
    marked : sequence of int
        Sensors that refute the claim.
    """
    points = [(float(x), float(y)) for x, y in places]
    low = [min(point[i] for point in points) - MARGIN for i in (0, 1)]
    high = [max(point[i] for point in points) + MARGIN for i in (0, 1)]
    plain = [k for k in range(len(points)) if k not in marked]
    names = ", ".join(f"p{k}" for k in marked)
    return Plot(
        title="Sensors that communicate within the range 1",
        finding=f"The marked sensors {names} are what the claim excludes.",
        caption=f"Places found by search and replayed in rationals: links are all pairs within the "
        f"range; {names} marked.",
        x=Axis("east", "range", low[0], high[0]),
        y=Axis("north", "range", low[1], high[1]),
        curves=tuple(
            Curve(
                "printed" if {i, j} <= {*marked} else "sharp",
                (points[i][0], points[j][0]),
                (points[i][1], points[j][1]),
            )
            for i, j in sorted(links)
        ),
        dots=(_dots("held", plain, points), _dots("refuting", list(marked), points)),
        equal=True,
    )


def _dots(role: str, chosen: Sequence[int], points: Sequence[tuple[float, float]]) -> Dots:
    return Dots(role, tuple(points[k][0] for k in chosen), tuple(points[k][1] for k in chosen))


def velocity_variance() -> Plot:
    """Variance of the velocity estimate beside that of the raw average, M = K = C = 1."""
    steps = np.linspace(0.05, 2.5, 50)
    gains = [
        float(exact_traces(UNIT_GAINS, Fraction(float(h)).limit_denominator(10**6))[2])
        for h in steps
    ]
    end, top = float(steps[-1]), max(gains) * 1.05
    return Plot(
        title="Variance of the velocity estimate over the sampling period",
        finding="It lies above that of the raw average at every sampling period.",
        caption="M = K = C = 1, white velocity noise of variance one: the estimate is never better "
        "than the raw average (dashed), although attenuation is promised (hatched).",
        x=Axis("sampling period h", "s", 0.0, end),
        y=Axis("variance", "", 0.0, top, ticks=(1.0,)),
        curves=(
            Curve("sharp", tuple(steps.tolist()), tuple(gains), "estimate"),
            Curve("printed", (0.0, end), (1.0, 1.0), "raw average"),
        ),
        areas=(Area("false", (0.0, end), (0.0, 0.0), (1.0, 1.0)),),
    )


def readings_over_time() -> Plot:
    """Position error under a constant velocity noise, in both readings of (17), M = K = C = 1."""
    h, noise, samples = 0.1, 0.1, 200
    measured, e, u = [], 0.0, 0.0
    for _ in range(samples):
        measured.append(e)
        e = e + h * (u - noise)
        u = (u - h * e) / (1 + h)
    time = tuple(h * k for k in range(samples))
    drift = tuple(-noise * t for t in time)
    return Plot(
        title="Position error under a constant velocity noise",
        finding="With the error propagated the estimate drifts away; with the error measured it "
        "settles.",
        caption="M = K = C = 1, h = 0.1 s, velocity noise 0.1 m/s: read as propagating (17), the "
        "error grows without bound; read as measuring it anew, it settles at -C nu/K.",
        x=Axis("time", "s", 0.0, time[-1]),
        y=Axis("position error", "m", drift[-1] * 1.05, 0.2, ticks=(0.0, -noise)),
        curves=(
            Curve("printed", time, drift, "propagated"),
            Curve("sharp", time, tuple(measured), "measured"),
            Curve("guide", (0.0, time[-1]), (-noise, -noise)),
        ),
    )


def radii_of_late_data(gains: Mapping[str, Rows], now: float, late: float) -> Plot:
    """Spectral radius over the step with the position error at once and one sample late."""
    steps = np.unique(np.concatenate([np.linspace(0.01, 1.1 * now, 60), [now, late]]))
    radii = [[late_radius(gains, delay, float(h)) for h in steps] for delay in (0, 1)]
    end, top = float(steps[-1]), 1.6
    shown = tuple(steps.tolist())
    kept = [sum(r <= top for r in found) for found in radii]
    return Plot(
        title="Spectral radius over the sampling period, one sample late and at once",
        finding=f"One sample late, stability ends at h = {late:.4g} instead of {now:.4g}.",
        caption="The gains of the counterexample: where sums arrive one sample late, stability "
        "ends early; between the two limits the claim is false (hatched).",
        x=Axis("sampling period h", "s", 0.0, end, ticks=(late, now)),
        y=Axis("spectral radius", "", 0.6, top, ticks=(1.0,)),
        curves=(
            Curve("printed", shown[: kept[0]], tuple(radii[0][: kept[0]]), "at once"),
            Curve("sharp", shown[: kept[1]], tuple(radii[1][: kept[1]]), "one late"),
            Curve("guide", (0.0, end), (1.0, 1.0)),
        ),
        areas=(Area("false", (late, now), (0.6, 0.6), (top, top)),),
    )


def growing_errors(gains: Mapping[str, Rows], h: Fraction) -> Plot:
    """Size of the position error of (20), from (1, 0) at rest, on a logarithmic axis."""
    samples = 4000
    left, right = late_pencil(gains, 0, h)
    step = np.linalg.solve(np.array(left, dtype=float), np.array(right, dtype=float))
    state, sizes = np.array([1.0, 0.0, 1.0, 0.0]), []
    for _ in range(samples):
        sizes.append(float(math.hypot(state[0], state[1])))
        state = step @ state
    kept = range(0, samples, 39)
    shown = tuple(sizes[k] for k in kept)
    return Plot(
        title="Position error with a damping that turns",
        finding=f"The error has grown {max(shown) / shown[0]:.3g} times after {samples} samples.",
        caption="The gains of the counterexample: the form of C is positive, and the error grows.",
        x=Axis("sample k", "", 0.0, float(samples - 1)),
        y=Axis("position error", "m", min(shown) * 0.8, max(shown) * 1.2, log=True, ticks=(1.0,)),
        curves=(Curve("sharp", tuple(float(k) for k in kept), shown, "error"),),
    )
