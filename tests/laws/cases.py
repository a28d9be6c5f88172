"""What the laws need to know of each system: how its inputs move when the world is moved."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from sensortrack.estimators.variational import Variational
from sensortrack.sensors import View


@dataclass(frozen=True)
class EstimatorCase:
    """An estimator with measurements, and how they are moved and renamed.

    Parameters
    ----------
    draw : callable
        ``draw(rng)`` returns the estimator and a list of samples, each a list of views.
    moved : callable
        ``moved(views, rotation, shift, boost, time)``, the same seen from a moved frame.
    renamed : callable
        ``renamed(estimator, samples, names)``, with other names of the sensors.
    blinded : callable
        ``blinded(view, rng)``, what a sensor reports that does not see the target.
    """

    draw: Callable[[np.random.Generator], tuple[Any, list[list[Any]]]]
    moved: Callable[..., list[Any]]
    renamed: Callable[..., tuple[Any, list[list[Any]]]]
    blinded: Callable[..., Any]


def _draw(rng):
    weights = rng.dirichlet(np.ones(3))
    weights[2] = 1 - weights[0] - weights[1]
    estimator = Variational(2.0, 3.0, 1.5, 0.1, dict(zip("abc", weights, strict=True)))
    samples = [
        [View(name, *rng.normal(size=(4, 3))) for name in estimator.weights] for _ in range(6)
    ]
    return estimator, samples


def _moved(views, rotation, shift, boost, time):
    """Positions are turned and shifted, relative ones turned; velocities gain the boost."""
    return [
        View(
            view.sensor,
            rotation @ view.position + shift + boost * time,
            rotation @ view.velocity + boost,
            rotation @ view.relative_position,
            rotation @ view.relative_velocity,
        )
        for view in views
    ]


def _renamed(estimator, samples, names):
    weights = {names[name]: weight for name, weight in estimator.weights.items()}
    other = Variational(estimator.M, estimator.K, estimator.C, estimator.h, weights)
    turned = [
        [
            View(names[v.sensor], v.position, v.velocity, v.relative_position, v.relative_velocity)
            for v in views
        ]
        for views in samples
    ]
    return other, turned


def _blinded(view, rng):
    """A relative position without a finite number; what else it says must not matter."""
    return View(view.sensor, *rng.normal(size=(2, 3)), np.full(3, np.nan), rng.normal(size=3))


ESTIMATORS = {"variational": EstimatorCase(_draw, _moved, _renamed, _blinded)}


@dataclass(frozen=True)
class Frame:
    """How the numbers of a system's generated functions turn with the frame.

    Parameters
    ----------
    functions : frozenset of str
        Those whose results turn with their arguments.
    draw : callable
        ``draw(rng)``, a turn.
    turned : callable
        ``turned(names, numbers, turn)``, one group as seen from the turned frame.
    """

    functions: frozenset[str]
    draw: Callable[[np.random.Generator], Any]
    turned: Callable[..., Any]


def _turned_vectors(names, numbers, rotation):
    """Vectors v to Rv, matrices A to RAR'; what has no index stays."""
    whole = dict(zip(names, numbers, strict=True))
    found = dict(whole)
    for name in {re.sub(r"_\d+$", "", key) for key in whole if re.search(r"_\d+$", key)}:
        if f"{name}_0" in whole:
            column = rotation @ [whole[f"{name}_{i}"] for i in range(3)]
            found |= {f"{name}_{i}": column[i] for i in range(3)}
        else:
            upper = [[whole[f"{name}_{min(i, j)}{max(i, j)}"] for j in range(3)] for i in range(3)]
            square = rotation @ np.array(upper) @ rotation.T
            found |= {f"{name}_{i}{j}": square[i, j] for i in range(3) for j in range(i, 3)}
    return np.array([found[name] for name in whole])


LINEAR = ("w_P", "pull_P", "sign_P")
"""Differences of first rows of P; the others are such rows themselves, centred at (1/2, 0)."""


def _turned_bearings(names, numbers, angle):
    """Angles grow, vectors turn, and first rows of matrices of trace 1 turn twice as far."""
    whole = dict(zip(names, numbers, strict=True))
    found = {name: x + angle if name.startswith("theta") else x for name, x in whole.items()}
    for stem in {name[:-2] for name in whole if name.endswith("_0")}:
        about = np.array([0.5 if stem.endswith("_P") and stem not in LINEAR else 0.0, 0.0])
        turn = 2 * angle if stem.endswith("_P") else angle
        sine, cosine = np.sin(turn), np.cos(turn)
        pair = np.array([whole[f"{stem}_0"], whole[f"{stem}_1"]]) - about
        pair = np.array([[cosine, -sine], [sine, cosine]]) @ pair + about
        found |= {f"{stem}_{i}": pair[i] for i in range(2)}
    return np.array([found[name] for name in whole])


FRAMES = {
    "bearing_dac": Frame(
        frozenset({"init", "step", "link_isotropic", "measure", "position"}),
        lambda rng: rng.uniform(0, 2 * np.pi),
        _turned_bearings,
    ),
    "variational": Frame(
        frozenset({"init", "step", "leapfrog_step"}),
        lambda rng: np.linalg.qr(rng.normal(size=(3, 3)))[0],
        _turned_vectors,
    ),
}
"""The printed link of consensus is not among them: signs of entries depend on the axes."""
CONDITION = {"bearing_dac": 1000.0, "variational": 1.0}
"""How much a rounding may grow: up to 1/det_min for a position."""
