"""Figures of the claims about angles, distances and the covariance of positions."""

from __future__ import annotations

import math

from verification.figure import Axis, Curve, Dots, Plot

POINTS = 97
TURN = tuple(2 * math.pi * k / (POINTS - 1) for k in range(POINTS))
Place = tuple[float, float]


def mirrored(sensor: Place, target: Place, computed: Place) -> Plot:
    """A target and where the arctangent of one quotient puts it.

    Parameters
    ----------
    sensor, target, computed : (float, float)
        Positions, in km.
    """
    reach = math.dist(sensor, target)
    circle = [(sensor[0] + reach * math.cos(t), sensor[1] + reach * math.sin(t)) for t in TURN]
    low = [min(p[k] for p in circle) - 0.2 * reach for k in (0, 1)]
    high = [max(p[k] for p in circle) + 0.2 * reach for k in (0, 1)]
    line = (target, sensor, computed)
    return Plot(
        title="One angle and one distance, two places",
        finding="The computed place lies opposite to the target, as far from the sensor.",
        caption="The arctangent of the quotient is the same for an offset and its opposite, so the "
        "target and its mirror image at the sensor cannot be told apart.",
        x=Axis("x1", "km", low[0], high[0], ticks=(sensor[0],)),
        y=Axis("x2", "km", low[1], high[1], ticks=(sensor[1],)),
        curves=(
            Curve("guide", tuple(p[0] for p in circle), tuple(p[1] for p in circle)),
            Curve("guide", tuple(p[0] for p in line), tuple(p[1] for p in line)),
        ),
        dots=(
            Dots("start", (sensor[0],), (sensor[1],), "sensor"),
            Dots("held", (target[0],), (target[1],), "target"),
            Dots("refuting", (computed[0],), (computed[1],), "computed"),
        ),
        equal=True,
    )


def ellipses(distance: float, along: float, across: float) -> Plot:
    """Ellipses of one deviation around a target straight ahead, printed and correct.

    Parameters
    ----------
    distance : float
        From the sensor, in km.
    along, across : float
        Deviations of the position along the line of sight and across it, in km.
    """

    def ellipse(
        wide: float, high: float, start: float
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        x = tuple(wide * math.cos(start + t) for t in TURN)
        return x, tuple(distance + high * math.sin(start + t) for t in TURN)

    reach = 1.4 * max(along, across)
    return Plot(
        title="One standard deviation around a target straight ahead",
        finding="The printed ellipse lies across the line of sight, the correct one along it.",
        caption=f"The sensor is {distance:g} km below, its distance errs by {along:g} km and its "
        f"angle by {across:.3g} km. (14) swaps the two.",
        x=Axis("across the line of sight", "km", -reach, reach, ticks=(0.0,)),
        y=Axis("along it", "km", distance - reach, distance + reach, ticks=(distance,)),
        curves=(
            Curve("guide", (0.0, 0.0), (distance - reach, distance + reach)),
            Curve("sharp", *ellipse(across, along, math.pi / 2), "correct"),
            Curve("printed", *ellipse(along, across, 0.0), "printed"),
        ),
        dots=(Dots("held", (0.0,), (distance,)),),
        equal=True,
    )
