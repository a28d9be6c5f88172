"""What a sensor that follows targets by cyclic SPSA holds, and what its last sample was for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.schedules import Turn

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class SpsaStatus:
    """What the last sample was for.

    Parameters
    ----------
    turn : Turn or None
        Cycle, block and which sample of it; None before the first step.
    updated : tuple of str
        Targets whose estimate the sample has moved.
    left_out : tuple of str
        Targets of the block that are left out of both costs, since a measurement is missing or the
        estimate has run away to no number.
    """

    turn: Turn | None = None
    updated: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()

    def __str__(self) -> str:
        if self.turn is None:
            return "start"
        where = f"cycle {self.turn.cycle}, block {self.turn.block}"
        if not self.turn.second:
            return f"{where}, first sample"
        return f"{where}, {len(self.updated)} updated"


@dataclass(frozen=True, eq=False)
class SpsaState:
    """What the sensor carries from sample to sample, a row a target in the order of the schedule.

    Parameters
    ----------
    time : int
        Last sample, 0 before the first.
    positions : array (m, 2)
        Estimates in m.
    costs : array (m,)
        Costs at the first sample of the block under way, in m^2; NaN where there is none.
    status : SpsaStatus
    notes : tuple of str
        What was remarkable in the last step.
    """

    time: int
    positions: Floats
    costs: Floats
    status: SpsaStatus = SpsaStatus()
    notes: tuple[str, ...] = ()

    @property
    def flat(self) -> Floats:
        """Every number of the state in one array."""
        return np.concatenate([self.positions.ravel(), self.costs])
