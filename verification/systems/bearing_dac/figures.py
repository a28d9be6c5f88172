"""Why the printed gain and the printed time of Theorem 1 fail, as figures."""

from __future__ import annotations

import math

from verification.figure import Area, Axis, Curve, Dots, Plot

from .counterexamples import Counterexample


def gain_plane(example: Counterexample) -> Plot:
    """The printed and the sharp gain over the disturbance bound, on the smallest network.

    Parameters
    ----------
    example : Counterexample
        Of Theorem 1's gain; both gains are affine in gamma, which its two numbers fix.
    """
    gamma, n = float(example.gamma), example.network.n
    printed, sharp = (example.printed - 1) / gamma, example.sharp / gamma
    meet = 1 / (sharp - printed)
    end = 1.6 * max(gamma, meet)
    top = sharp * end
    crossing, last = (meet, end), (sharp * meet, sharp * end)
    return Plot(
        title=f"Gain over disturbance bound for {n} sensors",
        finding=f"The printed line 1 + {printed:.4g} gamma falls below the sharp line "
        f"{sharp:.4g} gamma beyond gamma = {meet:.4g}; in that wedge agreement is promised and "
        "fails.",
        caption=f"In the hatched wedge the theorem promises agreement of {n} sensors and a "
        f"disturbance drives them apart; the diamond is the replayed run, gamma = {example.gamma}, "
        f"beta = {example.beta}.",
        x=Axis("disturbance bound γ", "", 0.0, end, ticks=(meet,)),
        y=Axis("gain β", "", 0.0, top),
        curves=(
            Curve("sharp", (0.0, end), (0.0, top), "sharp"),
            Curve("printed", (0.0, end), (1.0, 1 + printed * end), "printed"),
        ),
        areas=(
            Area("proved", (0.0, *crossing), (1.0, *last), (top, top, top)),
            Area("false", crossing, (last[0], 1 + printed * end), last),
        ),
        dots=(Dots("refuting", (gamma,), (float(example.beta),), "agreement fails"),),
    )


def error_over_time(example: Counterexample) -> Plot:
    """The error of the replayed run, the printed and the true time of agreement.

    Parameters
    ----------
    example : Counterexample
        Of Theorem 1's time: the error moves along one ray, at a constant rate until it is zero.
    """
    start = math.sqrt(sum(float(x) ** 2 for x in example.run["x0"]))
    end, t = example.sharp * 1.25, float(example.run["t"])
    left = math.sqrt(sum(float(x) ** 2 for x in example.run["x1"]))
    return Plot(
        title=f"Disagreement over time of {example.network.n} sensors",
        finding=f"The error is zero at {example.sharp:.5g}, after the printed time "
        f"{example.printed:.5g}.",
        caption=f"The replayed run still disagrees by {left:.3g} at t = {example.run['t']}, after "
        "the printed time (dashed).",
        x=Axis("time", "s", 0.0, end, ticks=(example.sharp,)),
        y=Axis("norm of the error", "", 0.0, start * 1.1),
        curves=(
            Curve("sharp", (0.0, example.sharp, end), (start, 0.0, 0.0)),
            Curve(
                "printed", (example.printed,) * 2, (0.0, start), f"printed t* {example.printed:.4g}"
            ),
        ),
        dots=(Dots("refuting", (t,), (left,), "not yet agreed"),),
    )
