"""Positions of several targets at one sensor, by cyclic simultaneous perturbation.

The sensor works on a block of its targets at a time and compares the cost of two points about its
estimate, each with a measurement of its own instant (`reading` two) or with one and the same (one).
The formulas are those of the generated source, a target at a time; the cost (20) is the sum.

References
----------
V. Erofeeva, O. Granichin, *Distributed State Estimation of Moving Targets Using Cyclic Simultaneous
Perturbation Stochastic Approximation*, (13), (20) and Algorithm 1, with each sample paired with the
block that it belongs to; see `sensortrack.schedules`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike

from sensortrack.arguments import positive, real
from sensortrack.errors import InputError
from sensortrack.generated import cyclic_spsa as generated
from sensortrack.polar import PolarView, from_sources
from sensortrack.random_numbers import STREAMS, signs, whole
from sensortrack.schedules import Schedule, Turn

from .bearing_state import pair
from .spsa_state import Floats, SpsaState, SpsaStatus

__all__ = ["CyclicSpsa", "SpsaState", "SpsaStatus"]

Formula = Callable[[Sequence[float], Sequence[float], Sequence[float]], tuple[float, ...]]
READINGS = ("two", "one")
RESOLVED = 2.0**52
"""Where an estimate is farther than this many times beta, adding beta to it changes nothing."""
DIVERGED = "an estimate has run away, and the perturbation is lost in its rounding"


@dataclass(frozen=True, eq=False)
class CyclicSpsa:
    """Algorithm 1 at one sensor.

    Parameters
    ----------
    schedule : Schedule
        Blocks of the sensor's targets, and whose measurements it uses.
    weights : mapping of str to float
        h of each target, above 0: the Hessian of its cost. `sensortrack.nearest.shares` makes
        them from variances.
    alpha : float
        Step size, above 0.
    beta : float
        Size of the perturbation in m, above 0.
    reading : str, optional
        ``two`` instants of measurement in a step, or ``one``.
    seed : int, optional
        Of the perturbations.
    number : int, optional
        Of this sensor: sensors with one seed and other numbers draw independently.
    sigma_bearing : float, optional
        Standard deviation of the measured angle in rad. (13) as printed, which 0 stands for, puts
        the target nearer by the factor exp(-sigma^2/2) in the mean; this undoes it.

    Raises
    ------
    InputError
        A number is out of its range, a name unknown, or a target has no weight.
    """

    schedule: Schedule
    weights: Mapping[str, float]
    alpha: float
    beta: float
    reading: str = "two"
    seed: int = 0
    number: int = 0
    sigma_bearing: float = 0.0
    contexts: tuple[tuple[float, ...], ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if not isinstance(self.schedule, Schedule):
            raise InputError("schedule", f"{self.schedule!r:.60}", "a Schedule is needed")
        rest = tuple(positive(name, getattr(self, name)) for name in ("alpha", "beta"))
        if self.reading not in READINGS:
            needed = f"one of {', '.join(READINGS)} is needed"
            raise InputError("reading", repr(self.reading), needed)
        needed = "a number of 0 or more, below pi, is needed"
        if not 0 <= real("sigma_bearing", self.sigma_bearing, needed) < math.pi:
            raise InputError("sigma_bearing", f"{self.sigma_bearing}", needed)
        for name in ("seed", "number"):
            object.__setattr__(self, name, whole(name, getattr(self, name)))
        weights = _weights(self.weights, self.targets)
        contexts = tuple((h, 0.0, h, *rest) for h in weights.values())
        object.__setattr__(self, "weights", weights)
        object.__setattr__(self, "contexts", contexts)

    @property
    def targets(self) -> tuple[str, ...]:
        """The targets, in the order of the state's rows."""
        return self.schedule.targets

    @property
    def growth(self) -> float:
        """Factor of the polar part of (13)."""
        return math.exp(self.sigma_bearing**2 / 2)

    def perturbation(self, cycle: int) -> Floats:
        """Delta of a cycle, a row a target: a function of seed, number, cycle and place alone.

        Parameters
        ----------
        cycle : int
            From 1.

        Returns
        -------
        array (m, 2)
            Entries +1 or -1.

        Raises
        ------
        InputError
            With the name ``cycle``: it is no whole number from 1 on.
        """
        cycle = whole("cycle", cycle, 1)
        key = self.seed, STREAMS["perturbation"]
        drawn = signs((0, cycle, self.number, 0), key, 2 * len(self.targets))
        return np.array(drawn, dtype=float).reshape(-1, 2)

    def init(
        self, views: Sequence[PolarView] = (), positions: Mapping[str, ArrayLike] | None = None
    ) -> SpsaState:
        """State before the first step, at sample 0.

        Parameters
        ----------
        views : sequence of PolarView, optional
            Measurements; a target starts where its source measured it, unless it is given.
        positions : mapping of str to array (2,), optional
            First estimates in m.

        Raises
        ------
        InputError
            With the name ``positions``: of a target there is neither, or one is unknown; or a
            measurement is unusable, as in `step`.
        """
        given = dict(positions or {})
        for target in given:
            if target not in self.schedule.sources:
                needed = f"one of {', '.join(self.targets)} is needed"
                raise InputError("positions", f"an unknown target {target}", needed)
        seen = from_sources(views, self.schedule.sources, 0)
        rows = []
        for target in self.targets:
            if target in given:
                rows.append(pair("positions", given[target]).tolist())
            elif target in seen:
                rows.append(self.measured(seen[target]))
            else:
                needed = "a first estimate or a measurement of each target is needed"
                raise InputError("positions", f"none of target {target}", needed)
        return SpsaState(0, np.array(rows), np.full(len(rows), np.nan))

    def measured(self, view: PolarView) -> tuple[float, ...]:
        """Position in m that follows from one measurement, (13)."""
        first, second = map(float, np.asarray(view.position, dtype=float))
        return generated.position((first, second, self.growth), (view.angle, view.distance))

    def step(self, t: int, state: SpsaState, views: Sequence[PolarView]) -> SpsaState:
        """State one sample later.

        Parameters
        ----------
        t : int
            The new sample: the state's and 1.
        state : SpsaState
            Is not changed.
        views : sequence of PolarView
            What arrived at this sample. Of it counts what the sources measured of the block whose
            turn it is; with one instant a step, nothing at the first sample of a block. A target of
            which one of the two measurements of a step is missing is left out of both costs, and
            its estimate stays where it is.

        Raises
        ------
        InputError
            With the name ``t``: samples are out of order; ``measurement``: one is of another
            sample, of an unknown target, or comes twice; ``angle``: it is beyond a full turn, so
            in degrees; ``distance``: it is negative; ``position``: it has not two numbers;
            ``state``: it is of another number of targets.
        """
        t = whole("t", t, 1)
        if t != state.time + 1:
            needed = f"sample {state.time + 1} is needed, each one once and in order"
            raise InputError("t", f"{t}", needed)
        if state.positions.shape != (len(self.targets), 2):
            needed = f"one of {len(self.targets)} targets is needed"
            raise InputError("state", f"one of {len(state.positions)} targets", needed)
        turn = self.schedule.turn(t)
        seen = from_sources(views, self.schedule.sources, t)
        if turn.second:
            return self._second(turn, state, seen)
        if self.reading == "one":
            return replace(state, time=t, status=SpsaStatus(turn), notes=())
        return self._first(turn, state, seen)

    def _first(self, turn: Turn, state: SpsaState, seen: Mapping[str, PolarView]) -> SpsaState:
        """Costs of the block at its first sample."""
        probes = self.perturbation(turn.cycle).tolist()
        costs = self._costs(generated.first_cost, turn, probes, state, seen)
        missing = self._missing(turn, seen)
        status = SpsaStatus(turn, left_out=missing)
        return SpsaState(state.time + 1, state.positions, costs, status, self._notes(missing))

    def _second(self, turn: Turn, state: SpsaState, seen: Mapping[str, PolarView]) -> SpsaState:
        """Costs at the second sample, and the update by their difference."""
        blank, early = np.full(len(self.targets), np.nan), state.costs
        probes = self.perturbation(turn.cycle).tolist()
        if self.reading == "one":
            early = self._costs(generated.first_cost, turn, probes, state, seen)
        late = self._costs(generated.second_cost, turn, probes, state, seen)
        block, used = self._block(turn), ~np.isnan(early + late)
        rows = [i for i, _ in block if used[i]]
        costs = [sum(found[i] for i in rows) for found in (early.tolist(), late.tolist())]
        positions = state.positions.copy()
        for i in rows:
            now = state.positions[i].tolist()
            positions[i] = generated.update(self.contexts[i], now, (*probes[i], *costs))
        status = SpsaStatus(
            turn,
            tuple(target for i, target in block if used[i]),
            tuple(target for i, target in block if not used[i]),
        )
        notes = self._notes(self._missing(turn, seen))
        if not (np.abs(positions) <= RESOLVED * self.beta).all():
            notes = (*notes, DIVERGED)
        return SpsaState(state.time + 1, positions, blank, status, notes)

    def _costs(
        self,
        formula: Formula,
        turn: Turn,
        probes: Sequence[Sequence[float]],
        state: SpsaState,
        seen: Mapping[str, PolarView],
    ) -> Floats:
        """Cost of each target of the block, NaN where it is not measured."""
        found = np.full(len(self.targets), np.nan)
        for i, target in self._block(turn):
            if target in seen:
                group = (*probes[i], *self.measured(seen[target]))
                (found[i],) = formula(self.contexts[i], state.positions[i].tolist(), group)
        return found

    def _block(self, turn: Turn) -> list[tuple[int, str]]:
        """Rows and names of the targets of a turn."""
        blocks = self.schedule.blocks
        start = sum(len(block) for block in blocks[: turn.block - 1])
        return list(enumerate(blocks[turn.block - 1], start=start))

    def _missing(self, turn: Turn, seen: Mapping[str, PolarView]) -> tuple[str, ...]:
        return tuple(target for _, target in self._block(turn) if target not in seen)

    def _notes(self, missing: Sequence[str]) -> tuple[str, ...]:
        source = self.schedule.sources
        return tuple(
            f"no measurement of {target} from {source[target]}: left out of this step"
            for target in missing
        )


def _weights(given: Mapping[str, float], targets: Sequence[str]) -> dict[str, float]:
    """Weights in the order of the targets."""
    if not isinstance(given, Mapping):
        raise InputError("weights", f"{given!r:.60}", "a mapping of targets to numbers is needed")
    for target in given:
        if target not in targets:
            found = f"target {target} is in no block"
            raise InputError("weights", found, "those of the schedule's targets are needed")
    for target in targets:
        if target not in given:
            raise InputError("weights", f"none of target {target}", "one a target is needed")
        weight = real("weights", given[target])
        if not (math.isfinite(weight) and weight > 0):
            found = f"{given[target]} of target {target}"
            raise InputError("weights", found, "numbers above 0 are needed")
    return {target: float(given[target]) for target in targets}
