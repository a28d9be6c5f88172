"""What the agents of cyclic SPSA estimate, sample by sample."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.estimators.cyclic_spsa import CyclicSpsa, SpsaState
from sensortrack.polar import PolarView

from .observing import generator
from .parts import Scenario
from .ranging import Measured
from .several import mean_square
from .spsa_teams import Team

Floats = NDArray[np.float64]
Starts = dict[str, dict[str, Floats]]
"""First estimates in m by sensor and target."""


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
