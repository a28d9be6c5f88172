"""Second moments of the errors of cyclic SPSA along given paths, update by update.

For deterministic paths, sensors, blocks and start, mean m and second moment P of the error of a
block obey a recursion without approximation. With two instants t - 1 and t the error a counts from
the middle of the two positions, with one instant from the position at t; from one update to the
next it moves by c, and

    m+ = (I - alpha H) m
    P+ = P - alpha (H P + P H) + alpha^2 {[tr U + tr(U N)] I + 2 (U - diag U)},  U = H (P + Z) H

(U in tr(U N) with Z counted apart where noise and its difference are not independent: they are for
Gaussian errors of equal covariance, which is what is assumed). N is the second moment of nu and Z
the covariance of chi: Xi/(2 beta^2) + eta eta'/(4 beta^2) and Xi/2 with two instants, 0 and Xi with
one. Numbers are floating point: expectations to stand beside a run, not proofs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Setting:
    """One setting of the algorithm along the paths of a run.

    Parameters
    ----------
    alpha, beta : float
    instants : int
    paths : array (samples, targets, 2)
        In m.
    sensors : array (sensors, 2)
        In m.
    along, across : float
        Variances of a measured position for a distance of 1.
    shares : sequence of mapping
        By sensor: sources, blocks, weights.
    start : array (sensors, targets, 2)
        First estimates in m.
    """

    alpha: float
    beta: float
    instants: int
    paths: Floats
    sensors: Floats
    along: float
    across: float
    shares: list[Mapping[str, Any]]
    start: Floats


def expected_squares(setting: Setting) -> tuple[Floats, float]:
    """Second moments of all errors, and the least limit of the step.

    Returns
    -------
    squares : array (samples, sensors, targets)
        E|theta_hat - theta|^2 in m^2; infinite once it cannot be told from that, NaN for a target
        that a sensor does not follow.
    limit : float
        Least over sensors, blocks and updates of 2/sum of h_i (1 + N_ii).
    """
    squares = np.full((len(setting.paths), *setting.start.shape[:2]), np.nan)
    groups: dict[tuple[int, int, int], list[tuple[int, list[int]]]] = {}
    for j, share in enumerate(setting.shares):
        for u, block in enumerate(share["blocks"], 1):
            key = (len(share["blocks"]), u, len(block))
            groups.setdefault(key, []).append((j, block))
    limits = [
        _follow(_together(setting, members, blocks, u), squares)
        for (blocks, u, _), members in groups.items()
    ]
    return squares, min(limits, default=np.inf)


@dataclass(frozen=True, eq=False)
class _Together:
    """Blocks of one size and turn at several sensors, which are followed at one go.

    Arrays have updates, then sensors first; D is the number of coordinates of a block.
    """

    alpha: float
    sensors: Indices
    targets: Indices
    updates: Indices
    h: Floats
    start: Floats
    theta: Floats
    middle: Floats
    n: Floats
    z: Floats


def _together(
    setting: Setting, members: list[tuple[int, list[int]]], blocks: int, u: int
) -> _Together:
    sensors, targets = (np.array(part) for part in zip(*members, strict=True))
    updates = np.arange(2 * u, len(setting.paths), 2 * blocks)
    weights = np.array([[setting.shares[j]["weights"][i] for i in row] for j, row in members])
    flat = (len(members), 2 * targets.shape[1])
    theta = setting.paths[:, targets].reshape(-1, *flat)
    now, before = theta[updates], theta[updates - 1]
    noise = covariances(setting, members, updates)
    middle, n, z = now, np.zeros_like(noise), noise
    if setting.instants == 2:
        noise = (noise + covariances(setting, members, updates - 1)) / 2
        drift = now - before
        n = noise / 2 + drift[..., :, None] * drift[..., None, :] / 4
        middle, n, z = (now + before) / 2, n / setting.beta**2, noise / 2
    return _Together(
        alpha=setting.alpha,
        sensors=sensors,
        targets=targets,
        updates=updates,
        h=np.repeat(weights, 2, axis=1),
        start=setting.start[sensors[:, None], targets].reshape(flat),
        theta=theta,
        middle=middle,
        n=n,
        z=z,
    )


def covariances(setting: Setting, members: list[tuple[int, list[int]]], samples: Indices) -> Floats:
    """Covariances of the measured positions of a block, updates by sensors by D by D."""
    size = len(members[0][1])
    found = np.zeros((len(samples), len(members), 2 * size, 2 * size))
    for s, (j, block) in enumerate(members):
        for b, i in enumerate(block):
            source = setting.sensors[setting.shares[j]["sources"][i]]
            apart = setting.paths[samples, i] - source
            square = (apart**2).sum(axis=1)[:, None, None]
            outer = apart[:, :, None] * apart[:, None, :]
            part = (setting.along - setting.across) * outer + setting.across * square * np.eye(2)
            found[:, s, 2 * b : 2 * b + 2, 2 * b : 2 * b + 2] = part
    return found


@np.errstate(over="ignore", invalid="ignore")
def _follow(group: _Together, squares: Floats) -> float:
    """Follow mean and second moment, write the errors of these blocks; the limit of the step."""
    h, alpha, middle = group.h, group.alpha, group.middle
    mean = group.start - (middle[0] if len(middle) else group.start)
    second = mean[:, :, None] * mean[:, None, :]
    one, means, traces = np.eye(h.shape[1]), np.zeros_like(middle), np.zeros_like(middle)
    for k in range(len(group.updates)):
        if k:
            moved = middle[k] - middle[k - 1]
            cross = moved[:, :, None] * mean[:, None, :]
            second = second - cross - np.swapaxes(cross, 1, 2)
            second += moved[:, :, None] * moved[:, None, :]
            mean = mean - moved
        pulled = h[:, :, None] * (second + group.z[k]) * h[:, None, :]
        size = np.trace(pulled, axis1=1, axis2=2) + (pulled * group.n[k]).sum(axis=(1, 2))
        second = second * (1 - alpha * (h[:, :, None] + h[:, None, :]))
        second += alpha**2 * (size[:, None, None] * one + 2 * pulled * (1 - one))
        mean = mean * (1 - alpha * h)
        means[k], traces[k] = mean, np.diagonal(second, axis1=1, axis2=2)
    _write(group, means, traces, squares)
    whole = (h * (1 + np.diagonal(group.n, axis1=2, axis2=3))).sum(axis=2)
    return float(2 / whole.max()) if whole.size else float("inf")


def _write(group: _Together, means: Floats, traces: Floats, squares: Floats) -> None:
    """Errors at every sample: between two updates the targets move on."""
    last = np.searchsorted(group.updates, np.arange(len(squares)), side="right") - 1
    found = (group.start - group.theta) ** 2
    moved = last >= 0
    away = group.middle[last[moved]] - group.theta[moved]
    found[moved] = traces[last[moved]] + 2 * means[last[moved]] * away + away**2
    found = np.where(np.isfinite(found), found, np.inf)
    pairs = found.reshape(*found.shape[:2], -1, 2).sum(axis=-1)
    squares[:, group.sensors[:, None], group.targets] = pairs
