"""The margin of a claim on one axis: left is always a broken promise."""

from __future__ import annotations

import math

from .dom import Element, el
from .records import Record, digits

AXIS = (-1.0, 2.0)
"""Ends of the axis in doublings of the ratio: from 1/2 to 4."""
LEFT, RIGHT = 6, 166


def ratio(claim: Record) -> float | None:
    """How much more is printed than is needed; below one it is not enough.

    An upper bound that lies below what it bounds, a lower bound above it and a threshold below the
    sharp one all give a ratio below one.
    """
    printed, sharp = claim["printed_value"], claim["sharp_value"]
    if not printed or not sharp or printed <= 0 or sharp <= 0:
        return None
    return float(sharp / printed if claim["sense"] == "lower" else printed / sharp)


def margin(claim: Record) -> Element | None:
    """The printed value as a dot beside the truth as a tick."""
    found = ratio(claim)
    if found is None:
        return None
    octave = math.log2(found)
    place = _place(min(max(octave, AXIS[0]), AXIS[1]))
    outside = not AXIS[0] <= octave <= AXIS[1]
    return el(
        "svg",
        el("use", href="#scale"),
        el("path", d=f"M{_place(0)} 8H{place}", class_="ml"),
        _arrow(place, octave) if outside else el("circle", cx=place, cy=8, r=4, class_="md"),
        viewBox="0 0 172 16",
        role="img",
        aria_label=f"{digits(found)} of what is needed",
    )


def scale() -> Element:
    """The axis and the truth, which all margins share."""
    lines = [
        el("path", d=f"M{LEFT} 8H{RIGHT}", class_="m0"),
        el("path", d=f"M{_place(0)} 2V14", class_="mx"),
    ]
    return el("symbol", lines, id="scale", viewBox="0 0 172 16")


def _place(octave: float) -> int:
    return round(LEFT + (RIGHT - LEFT) * (octave - AXIS[0]) / (AXIS[1] - AXIS[0]))


def _arrow(place: int, octave: float) -> Element:
    step = -8 if octave > 0 else 8
    return el("path", d=f"M{place} 8l{step}-5v10Z", class_="md")
