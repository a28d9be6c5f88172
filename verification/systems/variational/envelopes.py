"""Bounds on the errors of a run of the variational estimator, for noise of bounded size.

Under the recursion of the errors, with position noise chi, velocity noise nu and the target's
displacement d_k = b_{k+1} - b_k - h v_k that sampled velocities miss,

    e+ = e + p,  p = h(w - nu) - d,      (M + hC) w+ = M w - hK(e+ + chi+),

every error is the free motion plus a convolution with the impulse responses. The triangle
inequality bounds it by the sizes of chi, nu and d alone, whatever their course. The coefficients of
the recursion are those derived from the action in `theory`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from theory.algebra.lagrange import discrete_equation
from theory.algebra.noncommuting import Form
from theory.systems.variational.statements.common import (
    EQUATION,
    centred_dissipation,
    lagrangian,
)
from verification.exact.evaluate import Rows, at

Floats = NDArray[np.float64]
ROUNDING = 1e-9
"""Relative room for rounding in the run and in the bound itself."""
SCHEMES: Mapping[str, Form] = {
    "printed": EQUATION,
    "leapfrog": discrete_equation(lagrangian, centred_dissipation),
}


@dataclass(frozen=True)
class Sizes:
    """Largest norms in a run: position noise in m, velocity noise in m/s, displacement in m."""

    chi: float
    nu: float
    d: float


def envelopes(run: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Proved bounds on the errors of a run, beside what the run reached.

    Parameters
    ----------
    run : mapping
        Content of ``run.json``: the errors start where the run's first sample left them; the raw
        average of the measurements tells the noise.

    Returns
    -------
    list of dict
        Entries of ``bounds``: one on the position error in m, one on the velocity error in m/s.
        Empty where the recursion above is not what was run: late data, or no raw average.
    """
    own, raw = _estimate(run, "variational"), _estimate(run, "raw")
    if own is None or raw is None or run["parameters"].get("delay"):
        return []
    count = _seen(raw)
    if count < 2:
        return []
    truth = _states(run["target"], count)
    error = _states(own, count) - truth
    noise = truth - _states(raw, count)
    sizes = _sizes(truth, noise, float(run["parameters"]["h"]))
    start = np.concatenate([error[0, 0], error[0, 1] + noise[0, 1]])
    position, velocity = _bounds(run["parameters"], sizes, start, count)
    words = (
        f"for every position noise up to {sizes.chi:.4g} m, velocity noise up to {sizes.nu:.4g} "
        f"m/s and displacement up to {sizes.d:.4g} m between samples, by the triangle inequality"
    )
    time = list(run["time"][:count])
    counted = np.array(time) >= _settled(run, time)
    return [
        _entry("worst case", "position", "m", time, position, error[:, 0], words, counted),
        _entry("worst case", "velocity", "m/s", time, velocity, error[:, 1], words, counted),
    ]


def _settled(run: Mapping[str, Any], time: list[float]) -> float:
    """Time from which errors are summarised, within the run; bound and error start as one."""
    since = max((row["from"] for row in run.get("summary", ())), default=0.0)
    return min(float(since), time[-1])


def _estimate(run: Mapping[str, Any], name: str) -> Mapping[str, Any] | None:
    return next((entry for entry in run["estimates"] if entry["name"] == name), None)


def _states(entry: Mapping[str, Any], count: int) -> Floats:
    """Positions and velocities, count by 2 by coordinates."""
    kinds = (entry["position"][:count], entry["velocity"][:count])
    return np.stack([np.array(kind, dtype=float) for kind in kinds], axis=1)


def _seen(raw: Mapping[str, Any]) -> int:
    """Samples before the first at which no sensor saw the target."""
    places = np.array(raw["position"], dtype=float)
    rates = np.array(raw["velocity"], dtype=float)
    blind = ~np.isfinite(np.concatenate([places, rates], axis=1)).all(axis=1)
    return int(np.argmax(blind)) if blind.any() else len(places)


def _sizes(truth: Floats, noise: Floats, h: float) -> Sizes:
    moved = truth[1:, 0] - truth[:-1, 0] - h * truth[:-1, 1]
    chi, nu, d = (_largest(part) for part in (noise[:, 0], noise[:, 1], moved))
    return Sizes(chi, nu, d)


def _largest(vectors: Floats) -> float:
    return float(np.linalg.norm(vectors, axis=1).max())


def _bounds(
    parameters: Mapping[str, Any], sizes: Sizes, start: Floats, count: int
) -> tuple[Floats, Floats]:
    """Bounds on position and velocity error at each sample."""
    n, h = len(start) // 2, float(parameters["h"])
    step, kick, chi = _recursion(parameters, n)
    rows = (slice(0, n), slice(n, 2 * n))
    free, pushed = start, np.eye(2 * n)
    totals = np.zeros(2)
    found = np.zeros((count, 2))
    for k in range(count):
        found[k] = [float(np.linalg.norm(free[part])) + totals[i] for i, part in enumerate(rows)]
        for i, part in enumerate(rows):
            by_motion = float(np.linalg.norm(pushed[part] @ kick, 2))
            by_noise = float(np.linalg.norm(pushed[part] @ chi, 2))
            totals[i] += by_motion * (h * sizes.nu + sizes.d) + by_noise * sizes.chi
        free, pushed = step @ free, step @ pushed
    found[:, 1] += sizes.nu
    return found[:, 0] * (1 + ROUNDING), found[:, 1] * (1 + ROUNDING)


def _recursion(parameters: Mapping[str, Any], n: int) -> tuple[Floats, Floats, Floats]:
    """One step of (e, w), and what a displacement of e and a position noise do to it."""
    gains = {name: _exact(parameters[name], n) for name in "MKC"}
    h = Fraction(str(parameters["h"]))
    equation = SCHEMES[parameters.get("scheme", "printed")]
    newer, position, older = (
        np.array(at(equation.before(letter), gains, h), dtype=float) for letter in "uxv"
    )
    pull, keep = -np.linalg.solve(newer, position), -np.linalg.solve(newer, older)
    one, zero = np.eye(n), np.zeros((n, n))
    step = np.block([[one, float(h) * one], [pull, float(h) * pull + keep]])
    return step, np.vstack([one, pull]), np.vstack([zero, pull])


def _exact(gain: Any, n: int) -> Rows:
    """A gain of a run, given as a number or a matrix, at its decimal value."""
    if not isinstance(gain, Sequence) or isinstance(gain, str):
        value = Fraction(str(gain))
        return tuple(tuple(value * (i == j) for j in range(n)) for i in range(n))
    return tuple(tuple(Fraction(str(entry)) for entry in row) for row in gain)


def _entry(
    name: str,
    what: str,
    unit: str,
    time: list[float],
    bound: Floats,
    error: Floats,
    words: str,
    counted: NDArray[np.bool_],
) -> dict[str, Any]:
    size = np.linalg.norm(error, axis=1)
    slack = bound - size
    tiny = np.finfo(float).tiny
    return {
        "name": f"{name}, {what}",
        "of": "variational",
        "quantity": f"{what} error",
        "unit": unit,
        "time": time,
        "value": bound.tolist(),
        "statement": words,
        "source": "variational.prop_4_1",
        "holds": bool((slack >= 0).all()),
        "smallest_slack": float(slack.min()),
        "reached": float((size / np.maximum(bound, tiny))[counted].max()),
    }
