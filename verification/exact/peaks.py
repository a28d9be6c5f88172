"""H-infinity norms of discrete-time systems, in floating point.

References
----------
N. A. Bruinsma, M. Steinbuch, "A fast algorithm to compute the H-infinity norm of a transfer
function matrix", Systems & Control Letters 14 (1990) 287-293; in discrete time the level is crossed
where a symplectic pencil has eigenvalues on the unit circle.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
STEP, ROUNDS, ON_CIRCLE = 1e-10, 60, 1e-7
GRID = 257


@dataclass(frozen=True)
class Channel:
    """y = C (zI - A)^-1 B u + D u with a Schur stable A."""

    a: Floats
    b: Floats
    c: Floats
    d: Floats


def gain_at(channel: Channel, angle: float) -> float:
    """Largest singular value at z = exp(i angle)."""
    shifted = np.exp(1j * angle) * np.eye(len(channel.a)) - channel.a
    response = channel.c @ np.linalg.solve(shifted, channel.b) + channel.d
    return float(np.linalg.norm(response, 2))


def peak(channel: Channel) -> float:
    """Largest singular value over all frequencies, to about ten digits.

    Parameters
    ----------
    channel : Channel

    Returns
    -------
    float
        A gain that is attained; the level 2e-10 above it is crossed nowhere that can be seen.
    """
    poles = np.abs(np.angle(np.linalg.eigvals(channel.a)))
    grid = np.unique(np.concatenate([np.linspace(0, np.pi, GRID), poles]))
    best = max(gain_at(channel, angle) for angle in grid)
    for _ in range(ROUNDS):
        angles = _crossings(channel, best * (1 + 2 * STEP))
        if not angles.size:
            break
        ends = np.concatenate([[0.0], angles, [np.pi]])
        higher = max(gain_at(channel, angle) for angle in (ends[1:] + ends[:-1]) / 2)
        if higher <= best * (1 + STEP):
            break
        best = higher
    return best


def _crossings(channel: Channel, level: float) -> Floats:
    """Angles in [0, pi] at which some singular value is at the level."""
    from scipy.linalg import eig

    a, b, c, d = channel.a, channel.b, channel.c, channel.d
    m = len(a)
    inside = level**2 * np.eye(d.shape[1]) - d.T @ d
    through = np.linalg.solve(inside, d.T @ c)
    spread = np.linalg.solve(inside, b.T)
    closed = a + b @ through
    cost = c.T @ c + c.T @ d @ through
    one, zero = np.eye(m), np.zeros((m, m))
    left = np.block([[one, zero], [cost, closed.T]])
    right = np.block([[closed, b @ spread], [zero, one]])
    values = eig(right, left, right=False)
    values = values[np.isfinite(values)]
    near = values[np.abs(np.abs(values) - 1) < ON_CIRCLE]
    return np.unique(np.abs(np.angle(near)))
