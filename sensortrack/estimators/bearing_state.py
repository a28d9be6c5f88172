"""What the sensors of bearing consensus hold, and what they are asked with."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.arguments import numbers
from sensortrack.consensus import ConsensusState, IsotropicState, LinearState, StepStatus
from sensortrack.errors import InputError

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
ON_TIME = 1e-6


@dataclass(frozen=True, eq=False)
class BearingState:
    """What the sensors hold, one row a sensor in the order of the network's nodes.

    Parameters
    ----------
    time : float
        In s.
    consensus : ConsensusState, IsotropicState or LinearState
        With ``w`` and ``x``, an array each of sensors by agreed entries.
    angles : array (n,)
        Last bearing in rad; NaN before the first.
    positions : array (n, 2)
        In m; NaN where `known` is false.
    known : array (n,) of bool
        Whether the sensor can compute a position: det P_x is above the limit.
    fresh : array (n,) of bool
        Whether the sensor has a bearing of this time.
    present : array (n,) of bool
        Whether the sensor takes part.
    notes : tuple of str
        What was remarkable in the last step.
    """

    time: float
    consensus: ConsensusState | IsotropicState | LinearState
    angles: Floats
    positions: Floats
    known: Flags
    fresh: Flags
    present: Flags
    notes: tuple[str, ...] = ()

    @property
    def w(self) -> Floats:
        """Internal states, sensors by entries."""
        return self.consensus.w

    @property
    def x(self) -> Floats:
        """Estimates of the averages, sensors by entries."""
        return self.consensus.x

    @property
    def status(self) -> StepStatus:
        """How the step of the consensus was found."""
        return self.consensus.status

    @cached_property
    def flat(self) -> Floats:
        """Every number of the state in one array."""
        parts = (self.w, self.x, self.angles, self.positions, self.known, self.fresh, self.present)
        return np.concatenate([np.asarray(part, dtype=float).ravel() for part in parts])


def pair(name: str, value: ArrayLike) -> Floats:
    """Two finite numbers as an array.

    Raises
    ------
    InputError
        With this name, if they are not.
    """
    needed = "two finite numbers are needed"
    found = numbers(name, value, needed)
    if found.shape != (2,) or not np.isfinite(found).all():
        raise InputError(name, f"{value!r:.60}", needed)
    return found


def on_time(t: float, before: float, h: float) -> None:
    """Demand that a sample comes one period after the last.

    Raises
    ------
    InputError
        With the name ``t``.
    """
    if not t > before:
        needed = "measurements in order of time are needed"
        raise InputError("t", f"{t} s after {before} s", needed)
    if abs(t - before - h) > ON_TIME * h:
        needed = f"{before + h} s is needed, one sampling period later"
        raise InputError("t", f"{t} s", needed)
