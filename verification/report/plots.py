"""A plot as inline SVG: labels on the data, few ticks, no frame, colours by role."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from verification.figure import Axis, Curve, Dots, Plot

from .axes import Floats, Scale, number, path, ticks
from .dom import Element, el

WIDTH, HEIGHT = 480, 320
LEFT, RIGHT, TOP, BOTTOM = 52, 468, 28, 272
APART = 15.0
MOST_DOTS = 150
DIGIT = 8.0
"""Width of a character of a tick, at most."""


def plot(figure: Plot, name: str) -> Element:
    """Draw one figure.

    Parameters
    ----------
    figure : Plot
    name : str
        Unique on the page; ids of title and description are made of it.
    """
    x, y = _scales(figure)
    overhang = _overhang(y)
    clip = f"{name}-clip"
    frame = el("rect", x=LEFT, y=TOP, width=RIGHT - LEFT, height=BOTTOM - TOP)
    return el(
        "svg",
        el("title", figure.title, id=f"{name}-t"),
        el("desc", figure.finding, id=f"{name}-d"),
        el("clipPath", frame, id=clip),
        el("g", _areas(figure, x, y), _lines(figure, x, y), clip_path=f"url(#{clip})"),
        _axes(figure, x, y),
        [_dots(dots, x, y) for dots in figure.dots],
        _labels(figure, x, y),
        viewBox=f"{-overhang} 0 {WIDTH + overhang} {HEIGHT}",
        role="img",
        aria_labelledby=f"{name}-t {name}-d",
        class_="fig",
    )


def _scales(figure: Plot) -> tuple[Scale, Scale]:
    """Scales of both axes; on a map the smaller unit gives way."""
    x, y = figure.x, figure.y
    if figure.equal:
        unit = max((x.high - x.low) / (RIGHT - LEFT), (y.high - y.low) / (BOTTOM - TOP))
        x, y = _widened(x, unit * (RIGHT - LEFT)), _widened(y, unit * (BOTTOM - TOP))
    return Scale(x, LEFT, RIGHT), Scale(y, BOTTOM, TOP)


def _widened(axis: Axis, span: float) -> Axis:
    middle = (axis.low + axis.high) / 2
    return Axis(axis.label, axis.unit, middle - span / 2, middle + span / 2, False, axis.ticks)


def _axes(figure: Plot, x: Scale, y: Scale) -> list[Element]:
    made = [el("path", d=f"M{LEFT} {TOP}V{BOTTOM}H{RIGHT}", class_="ax")]
    marks = []
    for value in ticks(x.axis):
        across, words = float(x(value)), number(value)
        marks.append(f"M{across:.1f} {BOTTOM}v4")
        middle = min(across, WIDTH - len(words) * DIGIT / 2)
        made.append(_text(words, f"{middle:.1f}", BOTTOM + 19, "k", "middle"))
    for value in ticks(y.axis):
        along = float(y(value))
        marks.append(f"M{LEFT} {along:.1f}h-4")
        made.append(_text(number(value), LEFT - 8, f"{along + 4.5:.1f}", "k", "end"))
    made.append(el("path", d="".join(marks), class_="ax"))
    made.append(_text(_named(figure.x), RIGHT, BOTTOM + 40, "al", "end"))
    made.append(_text(_named(figure.y), 4, 14, "al", "start"))
    return made


def _overhang(y: Scale) -> int:
    """How far the longest label of the vertical axis would stick out on the left."""
    longest = max((len(number(value)) for value in ticks(y.axis)), default=0)
    return max(0, math.ceil(longest * DIGIT) - (LEFT - 8))


def _named(axis: Axis) -> str:
    return f"{axis.label}, {axis.unit}" if axis.unit else axis.label


def _text(words: str, x: float | str, y: float | str, role: str, anchor: str) -> Element:
    return el("text", words, x=x, y=y, class_=role, text_anchor=anchor)


def _areas(figure: Plot, x: Scale, y: Scale) -> list[Element]:
    made = []
    for area in figure.areas:
        across = np.concatenate([x(area.x), x(area.x)[::-1]])
        along = np.concatenate([y(area.high), y(area.low)[::-1]])
        made.append(el("path", d=path(across, along, close=True), class_=f"area {area.role}"))
    return made


def _lines(figure: Plot, x: Scale, y: Scale) -> list[Element]:
    """Runs below, then guides, bounds, the printed and the sharp line."""
    order = ("run", "guide", "bound", "target", "printed", "sharp")
    curves = sorted(figure.curves, key=lambda curve: order.index(curve.role))
    return [
        el("path", d=path(x(curve.x), y(curve.y)), class_=f"line {curve.role}") for curve in curves
    ]


def _dots(dots: Dots, x: Scale, y: Scale) -> Element:
    """All dots of a kind in one path; many are thinned evenly."""
    every = -(-len(dots.x) // MOST_DOTS)
    places = zip(x(dots.x[::every]), y(dots.y[::every]), strict=True)
    shape = _diamond if dots.role == "refuting" else _disc
    drawn = "".join(shape(a, b) for a, b in places)
    return el("path", d=drawn, class_=f"dot {dots.role}")


def _disc(x: float, y: float) -> str:
    return f"M{x - 3:.1f} {y:.1f}a3 3 0 1 0 6 0a3 3 0 1 0-6 0Z"


def _diamond(x: float, y: float) -> str:
    return f"M{x:.1f} {y - 6:.1f}l6 6l-6 6l-6-6Z"


def _labels(figure: Plot, x: Scale, y: Scale) -> list[Element]:
    """Labels at the ends of lines and beside dots, moved apart where they would touch."""
    wanted = [
        (*_end(curve, x, y), curve.label, curve.role) for curve in figure.curves if curve.label
    ]
    placed: list[Element] = []
    taken: list[tuple[float, float]] = []
    for across, along, label, role in sorted(wanted, key=lambda w: -w[1]):
        height = _free(along, across, taken)
        taken.append((across, height))
        placed += _haloed(label, across, height, role, "end")
    for dots in figure.dots:
        if dots.label:
            a, b = float(x(dots.x[-1])), float(y(dots.y[-1]))
            left = a > (LEFT + RIGHT) / 2
            placed += _haloed(
                dots.label,
                a - 10 if left else a + 10,
                b + 4.5,
                dots.role,
                "end" if left else "start",
            )
    return placed


def _end(curve: Curve, x: Scale, y: Scale) -> tuple[float, float]:
    """Where a curve's label goes: above its last point inside the frame."""
    a, b = x(curve.x), y(curve.y)
    inside = np.flatnonzero((a <= RIGHT + 0.1) & (b >= TOP - 0.1) & (b <= BOTTOM + 0.1))
    k = int(inside[-1]) if len(inside) else len(a) - 1
    return min(max(float(a[k]), LEFT + 90.0), float(RIGHT)), max(float(b[k]) - 7, TOP + 9.0)


def _free(along: float, across: float, taken: Iterable[tuple[float, float]]) -> float:
    """The wanted height, or the next above it that is free."""
    for other, height in sorted(taken, key=lambda place: -place[1]):
        if abs(other - across) < 140 and abs(height - along) < APART:
            along = height - APART
    return along


def _haloed(words: str, x: float, y: float, role: str, anchor: str) -> list[Element]:
    place = (f"{x:.1f}", f"{y:.1f}")
    return [_text(words, *place, "hl", anchor), _text(words, *place, f"lb {role}", anchor)]


def extent(values: Iterable[Floats], pad: float = 0.05) -> tuple[float, float]:
    """Smallest and largest finite value, with some room; (0, 1) if there is none."""
    flat = np.concatenate([np.ravel(np.asarray(v, dtype=float)) for v in values] or [np.zeros(0)])
    flat = flat[np.isfinite(flat)]
    if not flat.size:
        return 0.0, 1.0
    low, high = float(flat.min()), float(flat.max())
    room = (high - low or abs(high) or 1.0) * pad
    return low - room, high + room
