"""Schedules and weights from where sensors and targets are: each target from the nearest it hears.

References
----------
V. Erofeeva, O. Granichin, *Distributed State Estimation of Moving Targets Using Cyclic Simultaneous
Perturbation Stochastic Approximation*, (15) to (20).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from sensortrack.arguments import numbers, real
from sensortrack.errors import InputError
from sensortrack.random_numbers import whole
from sensortrack.schedules import Schedule


def nearest_schedules(
    sensors: Mapping[str, ArrayLike],
    targets: Mapping[str, ArrayLike],
    n_max: int,
    m_max: int,
    reach: float = math.inf,
) -> dict[str, Schedule]:
    """For each sensor: its nearest neighbours, and for each target the nearest of these as source.

    Parameters
    ----------
    sensors : mapping of str to array (2,)
        Positions in m.
    targets : mapping of str to array (2,) or (samples, 2)
        Positions in m, or whole paths, of which the largest distance counts: a source that were
        chosen from noisy measurements would depend on their errors.
    n_max : int
        Neighbours that a sensor hears, 0 or more.
    m_max : int
        Targets that it works on at once, 1 or more. Blocks are as few as that allows.
    reach : float, optional
        Distance in m up to which a sensor sees a target.

    Returns
    -------
    dict of str to Schedule
        Targets by turns, each sensor starting further on than the one before it.

    Raises
    ------
    InputError
        A number is out of its range; a position has not two finite numbers; there is no target, or
        no sensor sees one; a sensor and its neighbours see none.
    """
    n_max, m_max = whole("n_max", n_max), whole("m_max", m_max, 1)
    if not real("reach", reach) > 0:
        raise InputError("reach", f"{reach}", "a number above 0 is needed")
    if not targets:
        raise InputError("targets", "no target", "one or more are needed")
    places = {name: _place(name, place) for name, place in sensors.items()}
    paths = {name: _path("targets", name, path) for name, path in targets.items()}
    away = {
        target: {name: _farthest(path, place) for name, place in places.items()}
        for target, path in paths.items()
    }
    for target, distances in away.items():
        if not any(distance <= reach for distance in distances.values()):
            found = f"no sensor sees target {target}"
            raise InputError("targets", found, "targets within reach of a sensor are needed")
    return {
        name: _schedule(name, k, _heard(name, places, n_max), away, m_max, reach)
        for k, name in enumerate(places)
    }


def shares(
    variances: Mapping[str, Mapping[str, float]], sources: Mapping[str, str]
) -> dict[str, float]:
    """Weights of targets: of each, its source's part of the information of all sensors.

    Parameters
    ----------
    variances : mapping of str to mapping of str to float
        Target to sensor to the variance of the position that it measures, trace in m^2: by true
        distances, or the largest along a path, but not by the measurement at hand.
    sources : mapping of str to str
        Target to sensor.

    Returns
    -------
    dict of str to float
        K_i/(n sigma_is^2) with K_i = n over the sum of 1/sigma_iq^2, the one for which (3) is the
        mean risk of (20).

    Raises
    ------
    InputError
        With the name ``variances``: one is missing or is not a finite number above 0.

    References
    ----------
    Erofeeva & Granichin, (20) and the line below it, where K does not depend on the target.
    """
    found = {}
    for target, source in sources.items():
        known = variances.get(target, {})
        if source not in known:
            missing = f"none of {target} from {source}"
            raise InputError("variances", missing, "one of every source is needed")
        for sensor, value in known.items():
            if not (math.isfinite(real("variances", value)) and value > 0):
                wrong = f"{value} of {target} from {sensor}"
                raise InputError("variances", wrong, "finite numbers above 0 are needed")
        # ratios, as the inverse of a tiny variance is infinite
        found[target] = 1 / sum(known[source] / value for value in known.values())
    return found


def _place(name: str, value: ArrayLike) -> np.ndarray:
    path = _path("sensors", name, value)
    if len(path) > 1:
        raise InputError("sensors", f"{len(path)} places of {name}", "sensors at rest are needed")
    found: np.ndarray = path[0]
    return found


def _path(kind: str, name: str, value: ArrayLike) -> np.ndarray:
    path = np.atleast_2d(numbers(kind, value, "two finite numbers are needed"))
    if path.shape[1:] != (2,) or not len(path) or not np.isfinite(path).all():
        raise InputError(kind, f"{value!r:.60} of {name}", "two finite numbers are needed")
    return path


def _farthest(path: np.ndarray, place: np.ndarray) -> float:
    return float(np.hypot(*(path - place).T).max())


def _heard(name: str, places: Mapping[str, np.ndarray], n_max: int) -> list[str]:
    """The sensor and its nearest others; of two as near, the one named first."""
    apart = {other: math.dist(place, places[name]) for other, place in places.items()}
    others = sorted((other for other in apart if other != name), key=apart.__getitem__)
    return [name, *others[:n_max]]


def _schedule(
    name: str,
    number: int,
    heard: Sequence[str],
    away: Mapping[str, Mapping[str, float]],
    m_max: int,
    reach: float,
) -> Schedule:
    sources = {}
    for target, distances in away.items():
        source = min(heard, key=distances.__getitem__)
        if distances[source] <= reach:
            sources[target] = source
    if not sources:
        found = f"sensor {name} and those it hears see no target"
        raise InputError("sensors", found, "one target within reach is needed")
    seen = list(sources)
    start = number % len(seen)
    seen = seen[start:] + seen[:start]
    blocks = [seen[i : i + m_max] for i in range(0, len(seen), m_max)]
    return Schedule(blocks, sources)
