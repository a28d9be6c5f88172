"""What the laws need to know of each system: how its inputs move when the world is moved."""

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
ROTATED = {"variational": frozenset({"init", "step", "leapfrog_step"})}
"""Generated functions whose vectors turn with the frame."""
