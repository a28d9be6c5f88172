"""Figures of the claims about bearings, starts, positions, forms of the gain and discrete time."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from verification.adversary.universal_graphs import Compared
from verification.figure import Axis, Curve, Dots, Plot

from .genuine_bearings import Late, Singular

ANGLE = 0.5
SAMPLES = 150


def turns_of_a_bearing() -> Plot:
    """A bearing, the printed vector, and what the clockwise turn gives."""
    c, s = math.cos(ANGLE), math.sin(ANGLE)
    circle = np.linspace(0.0, 2 * math.pi, 97)
    return Plot(
        title="A bearing and its two turns by a right angle",
        finding="The printed vector lies counter-clockwise of the bearing, opposite to the "
        "clockwise turn.",
        caption="The vector (-sin, cos) is a quarter turn counter-clockwise from the bearing; the "
        "clockwise turn (dashed) is its opposite.",
        x=Axis("east", "", -1.6, 1.6, ticks=(0.0,)),
        y=Axis("north", "", -1.1, 1.1, ticks=(0.0,)),
        curves=(
            Curve("guide", tuple(np.cos(circle).tolist()), tuple(np.sin(circle).tolist())),
            Curve("bound", (0.0, c), (0.0, s), "bearing"),
            Curve("sharp", (0.0, -s), (0.0, c), "(-sin, cos)"),
            Curve("printed", (0.0, s), (0.0, -c), "clockwise"),
        ),
        equal=True,
    )


def agreement_off_the_average() -> Plot:
    """Two sensors whose internal states start at sum two: they agree one above the average."""
    start, meeting, end = 2.0, 1.0, 2.0
    return Plot(
        title="Two sensors whose internal states do not start at sum zero",
        finding="They agree at the mean of the internal states instead of the average, for ever.",
        caption="The internal states start at 2 and 0, the average is 0, the gain 1: both sensors "
        "agree at 1 and stay there.",
        x=Axis("time", "s", 0.0, end),
        y=Axis("state", "c", -0.2, 2.2, ticks=(0.0, meeting)),
        curves=(
            Curve("run", (0.0, meeting, end), (start, meeting, meeting), "sensors"),
            Curve("run", (0.0, meeting, end), (0.0, meeting, meeting)),
            Curve("target", (0.0, end), (0.0, 0.0), "average"),
        ),
    )


def position_over_time(found: Late) -> Plot:
    """Error of one sensor's position after its P_x is exact, and the printed time."""
    t, end = float(found.t), 1.1 * found.sharp
    wrong = math.hypot(found.position[0] - float(found.distance), found.position[1])
    first = found.printed - 2 * (found.sharp - found.printed)
    slope = wrong / (found.sharp - t)
    top = slope * (found.sharp - first)
    return Plot(
        title="Position error of one of three sensors, all linked",
        finding=f"At the printed time {found.printed:.5g} s the position is wrong; it is right "
        f"from {found.sharp:.5g} s on.",
        caption=f"Bearings are genuine and the target rests, {found.distance} m away: {wrong:.3g} "
        f"m are left at t = {found.t} s, after the printed time (dashed).",
        x=Axis("time", "s", first, end, ticks=(found.sharp,)),
        y=Axis("position error", "m", 0.0, top),
        curves=(
            Curve("sharp", (first, found.sharp, end), (top, 0.0, 0.0)),
            Curve("printed", (found.printed,) * 2, (0.0, top), f"printed t* {found.printed:.4g}"),
        ),
        dots=(Dots("refuting", (t,), (wrong,), "wrong position"),),
    )


def determinant_over_time(found: Singular) -> Plot:
    """Determinant of one sensor's P_x, from the start until the entries agree."""
    end = found.agreement * Fraction(11, 10)
    times = [end * k / SAMPLES for k in range(SAMPLES + 1)]
    values = [float(found.determinant(t)) for t in times]
    low, high = min(values), max(values)
    return Plot(
        title="Determinant of P_x at one of three sensors, all linked",
        finding=f"It is zero at the start and again at t = {found.t}, and negative after that.",
        caption=f"A target that rests, gain {found.beta}: P_x has no inverse at the start and none "
        f"at t = {found.t}; from the agreement of its entries on it has.",
        x=Axis("time", "s", 0.0, float(end), ticks=(float(found.agreement),)),
        y=Axis("determinant of P_x", "", 1.3 * low, 1.1 * high, ticks=(0.0,)),
        curves=(
            Curve("sharp", tuple(map(float, times)), tuple(values)),
            Curve("guide", (0.0, float(end)), (0.0, 0.0)),
        ),
        dots=(Dots("refuting", (0.0, float(found.t)), (0.0, 0.0), "no inverse"),),
    )


def steps_of_two_sensors(start: Fraction, push: Fraction, steps: int = 8) -> Plot:
    """Difference of two sensors under explicit and implicit steps.

    Parameters
    ----------
    start : Fraction
        Difference at the start.
    push : Fraction
        Step times gain; each sensor moves by it.
    steps : int, optional
    """
    explicit, implicit = [float(start)], [float(start)]
    for _ in range(steps):
        explicit.append(explicit[-1] - math.copysign(2 * float(push), explicit[-1]))
        implicit.append(max(implicit[-1] - 2 * float(push), 0.0))
    low, high = 1.3 * min(explicit), 1.3 * max(explicit)
    number = tuple(float(k) for k in range(steps + 1))
    return Plot(
        title="Difference of two sensors, step by step",
        finding="The explicit step changes its sign for ever; the implicit one reaches zero and "
        "stays.",
        caption=f"From {start} with step times gain {push}: explicit steps alternate for ever "
        f"(dashed), implicit ones agree exactly.",
        x=Axis("step", "", 0.0, float(steps)),
        y=Axis("difference", "c", low, high, ticks=(0.0,)),
        curves=(
            Curve("printed", number, tuple(explicit), "explicit"),
            Curve("sharp", number, tuple(implicit), "implicit"),
        ),
    )


def form_over_graphs(graphs: tuple[Compared, ...], form: str, label: str) -> Plot:
    """One form of the gain against the threshold, on every small graph.

    Parameters
    ----------
    graphs : tuple of Compared
    form : str
        One of `verification.adversary.universal_graphs.FORMS`.
    label : str
        The form as text.
    """
    points = [(float(g.threshold), g.ratio(form) * float(g.threshold)) for g in graphs]
    order = sorted(range(len(points)), key=lambda k: points[k])
    failed = [k for k in order if graphs[k].signs[form] < 0]
    equal = [k for k in order if graphs[k].signs[form] == 0]
    held = [k for k in order if graphs[k].signs[form] > 0]
    low = min(min(point) for point in points) / 1.2
    wide, tall = (1.2 * max(point[i] for point in points) for i in (0, 1))
    largest, below = max(g.network.n for g in graphs), len(failed)
    return Plot(
        title=f"{label} against the threshold, all connected graphs on 2 to {largest} nodes",
        finding=f"Of {len(graphs)} graphs {below} lie below the line of equality and {len(equal)} "
        f"on it.",
        caption=f"All {len(graphs)} connected graphs on 2 to {largest} nodes, gamma = 1, compared "
        f"exactly: {below} need more than the form says (on the wrong side of the line), "
        f"{len(equal)} just as much.",
        x=Axis("threshold", "", low, wide, log=True),
        y=Axis(label, "", low, tall, log=True),
        curves=(Curve("sharp", (low, wide), (low, wide), "threshold"),),
        dots=tuple(
            Dots(role, tuple(points[k][0] for k in some), tuple(points[k][1] for k in some), text)
            for role, some, text in (
                ("held", held + equal, ""),
                ("refuting", failed, "too small"),
            )
            if some
        ),
    )
