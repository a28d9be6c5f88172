"""Which targets a sensor works on when, and whose measurements it uses: blocks and sources as data.

A cycle has two samples for each block. Sample 2k(T - 1) + 2u - 1 and the one after it belong to
block u of cycle T, where k is the number of blocks; all three count from 1.

References
----------
V. Erofeeva, O. Granichin, *Distributed State Estimation of Moving Targets Using Cyclic Simultaneous
Perturbation Stochastic Approximation*, (15) to (19). The printed indices of block and time pair
measurements of different blocks; these do not.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from sensortrack.arguments import numbers, real
from sensortrack.errors import InputError
from sensortrack.random_numbers import whole


@dataclass(frozen=True)
class Turn:
    """What happens at one sample.

    Parameters
    ----------
    cycle, block : int
        From 1.
    second : bool
        Whether it is the second sample of the block, the one with the update.
    """

    cycle: int
    block: int
    second: bool


@dataclass(frozen=True)
class Schedule:
    """Blocks of whole targets in the order of their turns, and the source of each target.

    Parameters
    ----------
    blocks : sequence of sequence of str
        Targets by name; each in one block.
    sources : mapping of str to str
        Target to the sensor whose measurement is used.

    Raises
    ------
    InputError
        With the name ``blocks``: there is none, one is empty or a text, or a target is in two
        places, so that its coordinates would be split; ``sources``: a target has none, or it is in
        no block.
    """

    blocks: Sequence[Sequence[str]]
    sources: Mapping[str, str]

    def __post_init__(self) -> None:
        blocks = tuple(_names(block) for block in _names(self.blocks))
        if not isinstance(self.sources, Mapping):
            raise InputError("sources", f"{self.sources!r:.60}", "target to sensor is needed")
        if not blocks or not all(blocks):
            found = "an empty block" if blocks else "no block"
            needed = "blocks of one target or more are needed: the sensor has to see some"
            raise InputError("blocks", found, needed)
        place: dict[str, int] = {}
        for u, block in enumerate(blocks, start=1):
            for target in block:
                if target in place:
                    found = f"target {target} in block {place[target]} and in block {u}"
                    needed = "one place a target is needed, which holds both coordinates"
                    raise InputError("blocks", found, needed)
                place[target] = u
        for target in self.sources:
            if target not in place:
                found = f"target {target} is in no block"
                raise InputError("blocks", found, "each target that has a source is needed")
        for target in place:
            if target not in self.sources:
                found = f"none of target {target}"
                raise InputError("sources", found, "a sensor is needed whose measurement is used")
        object.__setattr__(self, "blocks", blocks)
        object.__setattr__(self, "sources", {target: self.sources[target] for target in place})

    @property
    def targets(self) -> tuple[str, ...]:
        """All targets, in the order of their turns."""
        return tuple(self.sources)

    @property
    def period(self) -> int:
        """Samples of a cycle: 2k."""
        return 2 * len(self.blocks)

    def turn(self, t: int) -> Turn:
        """What happens at sample t = 1, 2, ...

        Raises
        ------
        InputError
            With the name ``t``: it is no whole number from 1 on.
        """
        cycle, inside = divmod(whole("t", t, 1) - 1, self.period)
        return Turn(cycle + 1, inside // 2 + 1, bool(inside % 2))


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


def _names(value: object) -> tuple[Any, ...]:
    """A list as a tuple; a text would fall apart into its letters."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        needed = "lists of names are needed: [['a', 'b'], ['c']]"
        raise InputError("blocks", f"{value!r:.60}", needed)
    return tuple(value)


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
