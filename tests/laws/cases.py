"""What the laws need to know of each system: how its inputs move when the world is moved."""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from sensortrack.estimators.bearing_dac import BearingDac
from sensortrack.estimators.cyclic_spsa import CyclicSpsa
from sensortrack.estimators.variational import Variational
from sensortrack.networks import Network
from sensortrack.polar import PolarView, polar_to
from sensortrack.schedules import Schedule
from sensortrack.sensors import Bearing, View, bearings_to


@dataclass(frozen=True)
class EstimatorCase:
    """An estimator with measurements, and how they are moved and renamed.

    Parameters
    ----------
    draw : callable
        ``draw(rng)`` returns the estimator and a list of samples, each a list of views.
    motion : callable
        ``motion(rng)`` draws a motion of the frame that the system says it follows.
    moved : callable
        ``moved(views, motion, time)``, the same seen from the moved frame.
    placed : callable
        ``placed(estimator, motion)``, the estimator whose fixed sensors are moved.
    results : callable
        ``results(state, moved_state, motion, time)``, pairs of arrays that must be equal.
    renamed : callable
        ``renamed(estimator, samples, names)``, with other names of the sensors.
    blinded : callable
        ``blinded(view, rng)``, what a sensor reports that does not see the target.
    rounding : float, optional
        Relative error that moved results may have.
    period : callable, optional
        ``period(estimator)``, from one sample to the next.
    """

    draw: Callable[[np.random.Generator], tuple[Any, list[list[Any]]]]
    motion: Callable[[np.random.Generator], Any]
    moved: Callable[..., list[Any]]
    placed: Callable[..., Any]
    results: Callable[..., list[tuple[Any, Any]]]
    renamed: Callable[..., tuple[Any, list[list[Any]]]]
    blinded: Callable[..., Any]
    rounding: float = 1e-9
    period: Callable[[Any], Any] = lambda estimator: estimator.h


def _draw(rng):
    weights = rng.dirichlet(np.ones(3))
    weights[2] = 1 - weights[0] - weights[1]
    estimator = Variational(2.0, 3.0, 1.5, 0.1, dict(zip("abc", weights, strict=True)))
    samples = [
        [View(name, *rng.normal(size=(4, 3))) for name in estimator.weights] for _ in range(6)
    ]
    return estimator, samples


def _motion(rng):
    """A turn, a shift, and a constant velocity."""
    return (np.linalg.qr(rng.normal(size=(3, 3)))[0], *rng.normal(size=(2, 3)))


def _moved(views, motion, time):
    """Positions are turned and shifted, relative ones turned; velocities gain the boost."""
    rotation, shift, boost = motion
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


def _results(one, other, motion, time):
    rotation, shift, boost = motion
    place = rotation @ one.position + shift + boost * time
    return [(place, other.position), (rotation @ one.velocity + boost, other.velocity)]


NETWORK = Network(list("abcde"), np.array([[0, 1], [1, 2], [1, 3], [3, 4], [0, 4]]))


def _draw_bearings(rng):
    """Isotropic signs, so that turned axes do not matter; noisy bearings of a target that moves."""
    places = dict(zip("abcde", rng.normal(scale=9.0, size=(5, 2)), strict=True))
    estimator = BearingDac(NETWORK, places, 2.0, 20.0, 0.1, sign="isotropic", det_min=0.01)
    start, rate = rng.normal(size=(2, 2))
    samples = [
        [
            Bearing(name, float(bearings_to(start + k * 0.1 * rate, place)) + 0.01 * rng.normal())
            for name, place in places.items()
        ]
        for k in range(4)
    ]
    return estimator, samples


def _turned_bearing(views, angle, time):
    return [Bearing(view.sensor, view.angle + angle) for view in views]


def _turn_of(angle):
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def _placed_bearings(estimator, angle):
    places = {name: _turn_of(angle) @ place for name, place in estimator.positions.items()}
    return replace(estimator, positions=places)


def _bearing_results(one, other, angle, time):
    return [(one.positions @ _turn_of(angle).T, other.positions), (one.known, other.known)]


def _renamed_bearings(estimator, samples, names):
    network = Network([names[name] for name in estimator.names], estimator.network.edges)
    places = {names[name]: place for name, place in estimator.positions.items()}
    turned = [[Bearing(names[view.sensor], view.angle) for view in views] for views in samples]
    return replace(estimator, network=network, positions=places), turned


SOURCES = {"p": "a", "q": "b", "r": "c"}


def _draw_polar(rng):
    """Three targets in two blocks, each measured by a sensor of its own; a cycle and a half."""
    schedule = Schedule([["q", "p"], ["r"]], SOURCES)
    weights = dict(zip("pqr", rng.uniform(0.2, 1.0, size=3), strict=True))
    places = dict(zip("abc", rng.normal(scale=9.0, size=(3, 2)), strict=True))
    reading = "one" if rng.random() < 0.5 else "two"
    estimator = CyclicSpsa(
        schedule, weights, 0.1, 2.0, reading, int(rng.integers(2**60)), sigma_bearing=0.01
    )
    targets = dict(zip("pqr", rng.normal(size=(3, 2)), strict=True))
    samples = []
    for _ in range(7):
        views = []
        for target, sensor in SOURCES.items():
            angle, distance = polar_to(targets[target], places[sensor])
            noisy = float(angle + 0.01 * rng.normal()), float(distance) * rng.uniform(0.9, 1.1)
            views.append(PolarView(sensor, target, *noisy, places[sensor]))
        samples.append(views)
    return estimator, samples


def _shifted_polar(views, shift, time):
    """Turns are not among the motions: perturbations lie along the axes."""
    return [replace(view, position=np.asarray(view.position) + shift) for view in views]


def _renamed_polar(estimator, samples, names):
    sources = {target: names[sensor] for target, sensor in SOURCES.items()}
    turned = [[replace(view, sensor=names[view.sensor]) for view in views] for views in samples]
    return replace(estimator, schedule=Schedule(estimator.schedule.blocks, sources)), turned


ESTIMATORS = {
    "bearing_dac": EstimatorCase(
        _draw_bearings,
        lambda rng: rng.uniform(0, 2 * np.pi),
        _turned_bearing,
        _placed_bearings,
        _bearing_results,
        _renamed_bearings,
        lambda view, _: Bearing(view.sensor, np.nan),
        1e-5,  # the tolerance of a step, over the least det P_x
    ),
    "cyclic_spsa": EstimatorCase(
        _draw_polar,
        lambda rng: rng.normal(size=2),
        _shifted_polar,
        lambda estimator, _: estimator,
        lambda one, other, shift, _: [(one.positions + shift, other.positions)],
        _renamed_polar,
        lambda view, rng: replace(view, angle=np.nan, position=rng.normal(size=2)),
        period=lambda _: 1,
    ),
    "variational": EstimatorCase(
        _draw,
        _motion,
        _moved,
        lambda estimator, _: estimator,
        _results,
        _renamed,
        _blinded,
    ),
}


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
    axes = range(len(rotation))
    whole = dict(zip(names, numbers, strict=True))
    found = dict(whole)
    for name in {re.sub(r"_\d+$", "", key) for key in whole if re.search(r"_\d+$", key)}:
        if f"{name}_0" in whole:
            column = rotation @ [whole[f"{name}_{i}"] for i in axes]
            found |= {f"{name}_{i}": column[i] for i in axes}
        else:
            upper = [[whole[f"{name}_{min(i, j)}{max(i, j)}"] for j in axes] for i in axes]
            square = rotation @ np.array(upper) @ rotation.T
            found |= {f"{name}_{i}{j}": square[i, j] for i in axes for j in axes if i <= j}
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


def _turned_polar(names, numbers, angle):
    """Angles from the second axis fall; perturbations are vectors here, whatever their entries."""
    found = dict(zip(names, numbers, strict=True))
    if "z_1" in found:
        return np.array([x - angle if name == "z_1" else x for name, x in found.items()])
    return _turned_vectors(names, numbers, _turn_of(angle))


FRAMES = {
    "bearing_dac": Frame(
        frozenset({"init", "step", "link_isotropic", "measure", "position"}),
        lambda rng: rng.uniform(0, 2 * np.pi),
        _turned_bearings,
    ),
    "cyclic_spsa": Frame(
        frozenset({"init", "step", "first_cost", "second_cost", "update", "position"}),
        lambda rng: rng.uniform(0, 2 * np.pi),
        _turned_polar,
    ),
    "variational": Frame(
        frozenset({"init", "step", "leapfrog_step"}),
        lambda rng: np.linalg.qr(rng.normal(size=(3, 3)))[0],
        _turned_vectors,
    ),
}
"""The printed link of consensus is not among them: signs of entries depend on the axes."""
CONDITION = {"bearing_dac": 1000.0, "cyclic_spsa": 100.0, "variational": 1.0}
"""How much a rounding may grow: up to 1/det_min for a position, up to 1/beta for a gradient."""
