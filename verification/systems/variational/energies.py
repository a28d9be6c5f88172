"""The printed energy and the strict one along the continuous estimator, as a figure."""

from __future__ import annotations

import math

from verification.figure import Axis, Curve, Dots, Plot

SHOWN = 12.0
"""Seconds that the figure shows."""
SAMPLES = 240
OMEGA = math.sqrt(3) / 2


def state(t: float) -> tuple[float, float]:
    """Position and velocity error of x'' + x' + x = 0 from x = 1, u = 0.

    Parameters
    ----------
    t : float
        Time, s.

    Returns
    -------
    tuple of float
    """
    shrink, turn = math.exp(-t / 2), OMEGA * t
    return (
        shrink * (math.cos(turn) + math.sin(turn) / (2 * OMEGA)),
        -shrink * math.sin(turn) / OMEGA,
    )


def energies(x: float, u: float, g: float = 0.5) -> tuple[float, float]:
    """E and V = E + g x'Mu for M = K = 1, C = 2g, so that V' = -2gV."""
    energy = (u * u + x * x) / 2
    return energy, energy + g * x * u


def energies_over_time() -> Plot:
    """Both functions on a logarithmic scale, M = K = C = 1."""
    times = tuple(SHOWN * k / SAMPLES for k in range(SAMPLES + 1))
    pairs = [energies(*state(t)) for t in times]
    stops = tuple(k * math.pi / OMEGA for k in range(int(SHOWN * OMEGA / math.pi) + 1))
    levels = tuple(energies(*state(t))[0] for t in stops)
    return Plot(
        title="The printed energy and a strict one along the continuous estimator",
        finding=f"The printed energy stands still {len(stops)} times within {SHOWN:g} s; the "
        "strict one falls at the same rate all the time.",
        caption="M = K = C = 1, from rest at x = 1. The energy (14) (dashed) stands still whenever "
        "the velocity error is zero (points), so that its fall alone says nothing about x; "
        "V = E + x'Mu/2 falls as exp(-t), exactly.",
        x=Axis("time", "s", 0.0, SHOWN),
        y=Axis("energy", "J", pairs[-1][1] / 2, 1.0, log=True),
        curves=(
            Curve("sharp", times, tuple(pair[1] for pair in pairs), "strict V"),
            Curve("printed", times, tuple(pair[0] for pair in pairs), "printed E"),
        ),
        dots=(Dots("held", stops, levels),),
    )
