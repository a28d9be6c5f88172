"""The sensors of a scenario as agents of cyclic SPSA: their shares, and what they estimate."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.estimators.cyclic_spsa import CyclicSpsa, SpsaState
from sensortrack.polar import PolarView
from sensortrack.schedules import nearest_schedules, shares

from .observing import generator
from .parts import Scenario
from .ranging import Measured, moments
from .several import mean_square

Floats = NDArray[np.float64]
Starts = dict[str, dict[str, Floats]]
"""First estimates in m by sensor and target."""
SCALES = ("harmonic", "sum", "mean")
KEYS = {"n_max": "n_max", "m_max": "m_max", "alpha": "alpha", "beta": "beta_m"}


@dataclass(frozen=True)
class Variant:
    """One setting of the algorithm; see the tables of `systems.cyclic_spsa`."""

    name: str
    alpha: float
    beta: float
    reading: str
    n_max: int
    m_max: int
    table: str = "estimator"


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


@dataclass(frozen=True, eq=False)
class Followed:
    """What a team estimated.

    Parameters
    ----------
    positions : array (samples, sensors, targets, 2)
        In m; NaN where a sensor does not follow a target, and after divergence.
    diverged : int or None
        First sample at which the error passes the limit.
    notes : list of (float, tuple of str)
        Time and what was remarkable.
    """

    positions: Floats
    diverged: int | None
    notes: list[tuple[float, tuple[str, ...]]]


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
                beta=variant.beta,
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


def starts(scenario: Scenario, team: Team, seen: Measured, seed: int) -> Starts:
    """First estimates by sensor and target: drawn from a box, or the source's first measurement.

    Raises
    ------
    InputError
        There is no box and a source measures nothing at the start.
    """
    part = scenario.parts.get("start")
    names, found = [*team.agents], dict[str, dict[str, Floats]]()
    for name, agent in team.agents.items():
        row = {}
        for target, source in agent.schedule.sources.items():
            if part is None:
                place = seen.position[0, names.index(source), team.targets.index(target)]
                silent = f"sensor {source} measures nothing of target {target} at first"
                if not np.isfinite(place).all():
                    raise InputError("start", silent, "a table [start] is needed")
            else:
                low, high = np.array(part.low_m[:2]), np.array(part.high_m[:2])
                drawn = generator(seed, name, target, "start").random(2)
                place = low + drawn * (high - low)
            row[target] = place
        found[name] = row
    return found


def follow(
    team: Team, seen: Measured, time: Floats, truth: Floats, start: Starts, limit: float
) -> Followed:
    """Let every agent step, sample by sample, until the end or until the estimates diverge.

    Parameters
    ----------
    team : Team
    seen : Measured
    time : array (samples,)
        In s.
    truth : array (samples, targets, 2)
        In m.
    start : mapping of str to mapping of str to array (2,)
        As `starts` returns it.
    limit : float
        Root-mean-square error in m, over sensors and targets, above which they have diverged.
    """
    agents = [*team.agents.values()]
    views = _Views(team, seen)
    states = [agent.init(positions=start[name]) for name, agent in team.agents.items()]
    places = [[team.targets.index(name) for name in agent.targets] for agent in agents]
    found = np.full((len(time), len(agents), len(team.targets), 2), np.nan)
    notes: list[tuple[float, tuple[str, ...]]] = []
    _write(found[0], states, places)
    for k in range(1, len(time)):
        states = [
            agent.step(k, state, views.at(k, agent))
            for agent, state in zip(agents, states, strict=True)
        ]
        _write(found[k], states, places)
        notes += [
            (float(time[k]), tuple(f"sensor {name}: {text}" for text in state.notes))
            for name, state in zip(team.agents, states, strict=True)
            if state.notes
        ]
        level = mean_square(np.linalg.norm(found[k] - truth[k], axis=-1), (0, 1))
        if not level <= limit:
            found[k:] = np.nan
            return Followed(found, k, notes)
    return Followed(found, None, notes)


def _write(row: Floats, states: Sequence[SpsaState], places: Sequence[Sequence[int]]) -> None:
    for j, (state, columns) in enumerate(zip(states, places, strict=True)):
        row[j, columns] = state.positions


class _Views:
    """What each agent receives: of the block whose turn it is, from the sources."""

    def __init__(self, team: Team, seen: Measured) -> None:
        names = [*team.agents]
        self._names, self._targets = names, team.targets
        self._angles, self._distances = seen.angle.tolist(), seen.distance.tolist()
        self._places = seen.sensors.tolist()
        self._known: dict[str, int] = {name: q for q, name in enumerate(names)}

    def at(self, k: int, agent: CyclicSpsa) -> list[PolarView]:
        made = []
        for target in agent.schedule.blocks[agent.schedule.turn(k).block - 1]:
            source = agent.schedule.sources[target]
            q, i = self._known[source], self._targets.index(target)
            angle, distance = self._angles[k][q][i], self._distances[k][q][i]
            made.append(PolarView(source, target, angle, distance, self._places[q], k))
        return made
