"""The sensors of a scenario as agents of cyclic SPSA: who follows what, with which weights."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.estimators.cyclic_spsa import CyclicSpsa
from sensortrack.nearest import nearest_schedules, shares

from .parts import Scenario
from .ranging import moments
from .spsa_settings import Variant

Floats = NDArray[np.float64]
KEYS = {"n_max": "n_max", "m_max": "m_max", "alpha": "alpha", "beta": "beta_m"}


@dataclass(frozen=True, eq=False)
class Team:
    """All sensors with one setting.

    Parameters
    ----------
    variant : Variant
    agents : mapping of str to CyclicSpsa
        By sensor, in the order of the scenario.
    targets : tuple of str
    weights : array (sensors, targets)
        K/(n sigma^2) of every measurement; NaN where a sensor does not see a target.
    """

    variant: Variant
    agents: Mapping[str, CyclicSpsa]
    targets: tuple[str, ...]
    weights: Floats

    @property
    def sources(self) -> NDArray[np.int64]:
        """Whose measurement each sensor uses of each target; -1 where it does not follow it."""
        names = [*self.agents]
        found = np.full((len(names), len(self.targets)), -1)
        for j, agent in enumerate(self.agents.values()):
            for target, source in agent.schedule.sources.items():
                found[j, self.targets.index(target)] = names.index(source)
        return found

    def record(self) -> list[dict[str, object]]:
        """What each sensor follows, by numbers of sensors and targets: for closed forms."""
        return [
            {
                "sources": row.tolist(),
                "blocks": [[self.targets.index(name) for name in b] for b in agent.schedule.blocks],
                "weights": [agent.weights.get(name) for name in self.targets],
            }
            for row, agent in zip(self.sources, self.agents.values(), strict=True)
        ]


def team_of(scenario: Scenario, variant: Variant, paths: Floats, seed: int) -> Team:
    """Share targets among sensors by the largest true distances of the run.

    Parameters
    ----------
    scenario : Scenario
    variant : Variant
    paths : array (samples, targets, 2)
        True positions in m.
    seed : int

    Raises
    ------
    InputError
        With the name of the key: a target that no sensor sees, a sensor that sees none, or a number
        out of range.
    """
    part, names = scenario.estimator, scenario.targets
    places = {s.name: np.array(s.position_m[:2]) for s in scenario.sensors}
    targets = {name: paths[:, i] for i, name in enumerate(names)}
    reach = part.reach_m or math.inf
    try:
        schedules = nearest_schedules(places, targets, variant.n_max, variant.m_max, reach)
        weights = _weights(_variances(scenario, places, targets, reach), [*places], part.scale)
        agents = {
            name: CyclicSpsa(
                schedule=schedule,
                weights={t: weights[q][t] for t, q in schedule.sources.items()},
                alpha=variant.alpha,
                beta=variant.beta_m,
                reading=variant.reading,
                seed=seed,
                number=j,
                sigma_bearing=scenario.noise.bearing,
            )
            for j, (name, schedule) in enumerate(schedules.items())
        }
    except InputError as error:
        name = _key(error.name, variant.table)
        raise InputError(name, error.found, error.needed, error.cure) from None
    rows = [[weights[name].get(target, np.nan) for target in names] for name in places]
    return Team(variant, agents, names, np.array(rows))


def _key(name: str, table: str) -> str:
    """The key of a scenario that an argument of an agent or a schedule comes from."""
    if name in ("seed", "variances"):
        return {"seed": "scenario.seed", "variances": "target"}[name]
    return f"{table}.{KEYS[name]}" if name in KEYS else "estimator.reach_m"


def _variances(
    scenario: Scenario, places: Mapping[str, Floats], targets: Mapping[str, Floats], reach: float
) -> dict[str, dict[str, float]]:
    """Target to sensor that sees it to the largest variance along its path, in m^2."""
    size = sum(moments(scenario.noise)) or 1.0
    away = {
        target: {name: float(np.hypot(*(path - place).T).max()) for name, place in places.items()}
        for target, path in targets.items()
    }
    return {
        target: {name: size * far**2 for name, far in row.items() if far <= reach}
        for target, row in away.items()
    }


def _weights(
    variances: Mapping[str, Mapping[str, float]], sensors: Sequence[str], scale: str
) -> dict[str, dict[str, float]]:
    """Sensor to target that it sees to K/(n sigma^2), K by the scale."""
    found = {}
    for sensor in sensors:
        own = shares(variances, {t: sensor for t, row in variances.items() if sensor in row})
        found[sensor] = {t: h * _ratio([*variances[t].values()], scale) for t, h in own.items()}
    return found


def _ratio(variances: Sequence[float], scale: str) -> float:
    """K over the K of the harmonic mean."""
    if scale == "harmonic":
        return 1.0
    n = len(variances)
    ratio = sum(variances) * sum(1 / value for value in variances) / n
    return ratio if scale == "sum" else ratio / n
