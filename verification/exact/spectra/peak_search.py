"""Where the gain of D(s)^-1 N(s) on the imaginary axis is largest, in floating point.

Points of the axis, infinity among them, are angles: s = i tan(angle). Nothing here is trusted;
`peaks` proves what follows from the frequency found.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
STEP, ROUNDS, ON_AXIS = 1e-11, 40, 1e-7
GRID, MOST_POINTS, SECTIONS = 33, 129, 50
GOLDEN = (5**0.5 - 1) / 2
RIGHT = np.pi / 2


@dataclass(frozen=True)
class FloatChannel:
    """Coefficients of 1, s, s^2 in D and N, three n by n matrices each."""

    d: Floats
    n: Floats


@dataclass(frozen=True)
class Peak:
    """The largest gain found, and the angle where it is attained."""

    gain: float
    angle: float


def pencils_at(channel: FloatChannel, angle: float) -> tuple[Complexes, Complexes]:
    """D and N at s = i tan(angle), times cos(angle)^2: finite at infinity too."""
    b, a = np.cos(angle), np.sin(angle)
    weights = np.array([b * b, 1j * a * b, -a * a])
    return np.tensordot(weights, channel.d, 1), np.tensordot(weights, channel.n, 1)


def gain_at(channel: FloatChannel, angle: float) -> float:
    """Largest singular value at s = i tan(angle)."""
    d, n = pencils_at(channel, angle)
    return float(np.linalg.norm(np.linalg.solve(d, n), 2))


def left_vector(channel: FloatChannel, angle: float) -> Complexes:
    """The q with |q*N| / |q*D| largest at s = i tan(angle), its largest entry of size 1."""
    d, n = pencils_at(channel, angle)
    left, _, _ = np.linalg.svd(np.linalg.solve(d, n))
    q = np.linalg.solve(d.conj().T, left[:, 0])
    return np.asarray(q / np.abs(q).max())


def highest(channel: FloatChannel) -> Peak:
    """The largest gain on the axis.

    Parameters
    ----------
    channel : FloatChannel
        D is nowhere singular on the axis, nor is its last coefficient.

    Returns
    -------
    Peak
        A gain that is attained; the level 2e-11 above it is crossed nowhere that can be seen.
    """
    points = _points(channel)
    gains = [gain_at(channel, angle) for angle in points]
    k = int(np.argmax(gains))
    best = _climbed(channel, points[max(k - 1, 0)], points[min(k + 1, len(points) - 1)])
    best = max(best, Peak(gains[k], float(points[k])), key=lambda peak: peak.gain)
    for _ in range(ROUNDS):
        angles = _crossings(channel, best.gain * (1 + 2 * STEP))
        ends = np.concatenate([[0.0], angles, [RIGHT]])
        middles = [(gain_at(channel, (x + y) / 2), x, y) for x, y in pairwise(ends)]
        gain, low, high = max(middles)
        if not angles.size or gain <= best.gain * (1 + STEP):
            break
        best = max(
            _climbed(channel, low, high), Peak(gain, (low + high) / 2), key=lambda peak: peak.gain
        )
    return best


def _points(channel: FloatChannel) -> Floats:
    """Angles to look at first: a grid, and where D is nearly singular."""
    n = channel.d.shape[1]
    roots = _roots(channel.d)
    near = np.concatenate([np.abs(roots.imag), np.abs(roots)])
    angles = np.unique(np.concatenate([np.linspace(0, RIGHT, GRID), np.arctan(near)]))
    most = min(MOST_POINTS if n <= GRID else GRID, len(angles))
    return np.asarray(angles[np.linspace(0, len(angles) - 1, most).round().astype(int)])


def _climbed(channel: FloatChannel, low: float, high: float) -> Peak:
    """A local maximum between two angles, by golden sections."""
    x, y = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_x, at_y = gain_at(channel, x), gain_at(channel, y)
    for _ in range(SECTIONS):
        if at_x < at_y:
            low, x, at_x = x, y, at_y
            y = low + GOLDEN * (high - low)
            at_y = gain_at(channel, y)
        else:
            high, y, at_y = y, x, at_x
            x = high - GOLDEN * (high - low)
            at_x = gain_at(channel, x)
    return Peak(at_x, float(x)) if at_x > at_y else Peak(at_y, float(y))


def _crossings(channel: FloatChannel, level: float) -> Floats:
    """Angles at which some singular value is at the level, ascending."""
    d, n = channel.d, channel.n
    size = d.shape[1]
    coefficients = np.zeros((5, size, size))
    for i in range(3):
        for j in range(3):
            coefficients[i + j] += (-1) ** j * (level**2 * d[i] @ d[j].T - n[i] @ n[j].T)
    roots = _roots(coefficients)
    near = roots[np.abs(roots.real) <= ON_AXIS * (1 + np.abs(roots))]
    return np.asarray(np.unique(np.arctan(np.abs(near.imag))))


def _roots(coefficients: Floats) -> Complexes:
    """Where a matrix polynomial is singular; its last coefficient is not."""
    degree, size = len(coefficients) - 1, coefficients.shape[1]
    rows = np.linalg.solve(coefficients[-1], np.hstack(list(coefficients[:-1])))
    companion = np.eye(degree * size, k=size)
    companion[-size:] = -rows
    values: Complexes = np.linalg.eigvals(companion).astype(complex)
    return values
