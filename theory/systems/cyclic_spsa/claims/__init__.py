"""What Erofeeva & Granichin claim, in the order of their paper."""

from __future__ import annotations

from ....claims import Claim
from . import experiment, measurement, schedule, theorem_1, theorem_2

CLAIMS: tuple[Claim, ...] = (
    *measurement.CLAIMS,
    *schedule.CLAIMS,
    *theorem_1.CLAIMS,
    *theorem_2.CLAIMS,
    *experiment.CLAIMS,
)
