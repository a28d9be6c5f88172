"""Closed forms beside simulations that know nothing of them: the algorithm, run after run.

A run makes the updates of Algorithm 1 with its draws, from theta_hat = theta on, forgets its start
and averages what follows; runs are independent, so that Student's interval of their mean stands.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.simulation.spsa_batch import SpsaBatch
from verification.exact.evaluate import Rows
from verification.statistics import LEVEL, Interval, mean_interval, monte_carlo

from ..block_inputs import Block, block_of
from ..errors.stationary import stationary_mean, stationary_mse
from ..stability.limits import limit_of
from ..stability.moments import double_operators

Floats = NDArray[np.float64]
FORGOTTEN = 1e-6
"""What is left of the start when counting begins, as a share."""
COUNTED = 64
"""Updates of a run that count, at least; as many as it takes to forget a start, else."""
LONGEST = 100_000
"""Updates of a run, at most."""
TAIL = 0.75
"""Share of the limit of the step up to which squares are averaged. Nearer to it their own spread
grows without bound, long before their mean does, and an interval would be too narrow."""
PILOT = 512
"""Runs of the first stage. Squares have a heavy tail, so the deviation of few is too small as a
rule: at `TAIL` and a level of 0.999, one interval in sixty misses with 64, one in 250 with these.
"""
RUNS = 256
ROUNDS = 400


@dataclass(frozen=True)
class Confirmation:
    """An exact value and the interval that a simulation gives for it.

    Parameters
    ----------
    exact : float
        Of the closed form, in m^2 or m.
    interval : Interval
    updates, skip : int
        Of each run; that do not count.
    """

    exact: float
    interval: Interval
    updates: int
    skip: int

    @property
    def holds(self) -> bool:
        """Whether the simulated interval brackets the exact value."""
        return self.interval.holds(self.exact)


def confirm_mean_square(
    values: Mapping[str, Any], width: float = 0.05, seed: int = 0, level: float = LEVEL
) -> Confirmation:
    """Simulate until the mean-square error has an interval of a wanted relative width.

    Parameters
    ----------
    values : mapping
        The inputs of `errors.stationary.stationary_mse`.
    width : float, optional
        Of the interval over the mean.
    seed : int, optional
    level : float, optional

    Raises
    ------
    InputError
        An input is out of range, second moments grow or nearly do, or the width asks for too many
        runs.
    """
    answer = stationary_mse(values)
    block, alpha = block_of(values), values["alpha"]
    batch, skip, updates = _batch(block, alpha, str(values["law"]))
    if not isinstance(answer.value, float):
        raise InputError("alpha", f"{alpha}", "a step with a settled mean square is needed")

    def draw(first: int, count: int) -> Floats:
        return batch.run(count, updates, skip, seed, first).squares

    return Confirmation(answer.value, monte_carlo(draw, width, seed, level, PILOT), updates, skip)


def confirm_mean(
    values: Mapping[str, Any], runs: int = RUNS, seed: int = 0, level: float = LEVEL
) -> tuple[Confirmation, ...]:
    """Simulate the mean error, a confirmation a coordinate; all hold at the level together.

    Parameters, errors are those of `confirm_mean_square`, with the number of runs.
    """
    answer = stationary_mean(values)
    block, alpha = block_of(values), values["alpha"]
    batch, skip, updates = _batch(block, alpha, str(values.get("law", "gaussian")))
    if not 0 < level < 1:
        raise InputError("level", f"{level}", "a number above 0 and below 1 is needed")
    each = 1 - (1 - level) / block.size
    means = batch.run(runs, updates, skip, seed).means
    return tuple(
        Confirmation(float(exact), mean_interval(column, each, seed), updates, skip)
        for exact, column in zip(answer.value, means.T, strict=True)
    )


def _batch(block: Block, alpha: Fraction, law: str) -> tuple[SpsaBatch, int, int]:
    """The simulation, how many updates forget its start, and how many there are."""
    limit = limit_of(block)
    if limit is None or not alpha < TAIL * Fraction(limit.lower):
        known = "unknown" if limit is None else f"{float(limit.lower):.4g}"
        found = f"{float(alpha):.4g} for a limit of {known}"
        raise InputError("alpha", found, f"less than {TAIL:g} of the limit is needed")
    rate = decay(block, float(alpha))
    skip = math.ceil(math.log(FORGOTTEN) / math.log(rate)) if rate > 0 else 1
    updates = skip + max(COUNTED, skip)
    if updates > LONGEST:
        found, needed = f"{float(alpha):.4g}", f"a start forgotten within {LONGEST} updates"
        raise InputError("alpha", f"{found} takes {updates} updates a run", needed)
    hessian = _doubles(block.hessian)
    batch = SpsaBatch(
        hessian=np.diag(hessian) if block.diagonal else hessian,
        alpha=float(alpha),
        beta=float(block.beta),
        noise=_doubles(block.noise),
        drift=[float(x) for x in block.drift],
        reading="two" if block.instants == 2 else "one",
        blocks=block.blocks,
        law=law,
    )
    return batch, skip, updates


def decay(block: Block, alpha: float) -> float:
    """Share of mean and second moment that an update leaves, the larger of the two.

    Of the second moment by power iteration, from the identity.
    """
    operators = double_operators(block)
    p, factor = np.eye(block.size) / block.size, 0.0
    for _ in range(ROUNDS):
        p = p - alpha * operators.pull(p) + alpha**2 * operators.kick(p)
        factor = float(np.trace(p))
        p = p / factor
    slow = 1 - alpha * np.linalg.eigvalsh(operators.hessian)
    return max(factor, float(np.abs(slow).max()))


def _doubles(rows: Rows) -> Floats:
    return np.array([[float(x) for x in row] for row in rows])
