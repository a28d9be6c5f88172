"""Scales, ticks and lines of a figure, in the units of its view box."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from verification.figure import Axis

Floats = NDArray[np.float64]
TOLERANCE = 0.25
"""Largest distance, in view-box units, by which a simplified line may leave its points."""
MANY = 400
SHORT = 2.0
"""Decades below which a logarithmic axis has more ticks than the powers of ten."""


@dataclass(frozen=True)
class Scale:
    """From the values of an axis to places in the view box."""

    axis: Axis
    start: float
    end: float

    def __call__(self, values: float | tuple[float, ...] | Floats) -> Floats:
        """Places of values; what lies outside is held at a margin beyond the frame."""
        v = np.asarray(values, dtype=float)
        low, high = self.axis.low, self.axis.high
        if self.axis.log:
            v = np.log10(np.maximum(v, low * 1e-6))
            low, high = math.log10(low), math.log10(high)
        part = np.clip((v - low) / (high - low), -0.5, 1.5)
        return np.asarray(self.start + part * (self.end - self.start))


def ticks(axis: Axis, most: int = 5) -> list[float]:
    """Few round values, and those that must be marked."""
    found = _decades(axis) if axis.log else _steps(axis, most)
    apart = _distance(axis) / 9
    kept = [
        v for v in found if all(abs(_place(axis, v) - _place(axis, t)) > apart for t in axis.ticks)
    ]
    return sorted([*kept, *(t for t in axis.ticks if axis.low <= t <= axis.high)])


def _steps(axis: Axis, most: int) -> list[float]:
    span = axis.high - axis.low
    raw = span / most
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 5, 10) if m * power >= raw * 0.999)
    first = math.ceil(axis.low / step - 1e-9)
    last = math.floor(axis.high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


def _decades(axis: Axis) -> list[float]:
    """Powers of ten; on a short axis also twice and five times each."""
    low, high = math.ceil(math.log10(axis.low) - 1e-9), math.floor(math.log10(axis.high) + 1e-9)
    if _distance(axis) < SHORT - 1e-9:
        found = [m * 10.0**k for k in range(low - 1, high + 1) for m in (1, 2, 5)]
        return [v for v in found if axis.low * (1 - 1e-9) <= v <= axis.high * (1 + 1e-9)]
    every = max(1, -(-(high - low) // 5))
    return [10.0**k for k in range(low, high + 1, every)]


def _place(axis: Axis, value: float) -> float:
    return math.log10(value) if axis.log else value


def _distance(axis: Axis) -> float:
    return _place(axis, axis.high) - _place(axis, axis.low)


def number(value: float) -> str:
    """A tick's text: at most five digits, a real minus sign."""
    if value == 0:
        return "0"
    power = math.log10(abs(value))
    if power.is_integer() and not -3 <= power <= 4:
        sign = "−" if value < 0 else ""
        exponent = str(int(power)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        return f"{sign}10{exponent}"
    return f"{value:.5g}".replace("-", "−")


def path(x: Floats, y: Floats, close: bool = False) -> str:
    """Path data of a line through places, simplified where it has many."""
    keep = simplified(x, y) if len(x) > MANY else np.ones(len(x), dtype=bool)
    places = [f"{a:.1f} {b:.1f}".replace(".0 ", " ") for a, b in zip(x[keep], y[keep], strict=True)]
    return "M" + "L".join(places) + ("Z" if close else "")


def simplified(x: Floats, y: Floats) -> NDArray[np.bool_]:
    """Which points of a line to keep so that no other is farther away than the tolerance.

    References
    ----------
    D. Douglas, T. Peucker, Cartographica 10 (1973).
    """
    keep = np.zeros(len(x), dtype=bool)
    keep[[0, -1]] = True
    stack = [(0, len(x) - 1)]
    while stack:
        i, j = stack.pop()
        if j - i < 2:
            continue
        dx, dy = x[j] - x[i], y[j] - y[i]
        px, py = x[i + 1 : j] - x[i], y[i + 1 : j] - y[i]
        length = math.hypot(dx, dy)
        away = np.abs(px * dy - py * dx) / length if length else np.hypot(px, py)
        k = int(np.argmax(away))
        if away[k] > TOLERANCE:
            keep[i + 1 + k] = True
            stack += [(i, i + 1 + k), (i + 1 + k, j)]
    return keep
