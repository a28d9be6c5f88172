"""How the printed claims about cyclic SPSA are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from verification.verdict import Decision

from . import experiment, measurement, schedule, theorem_1, theorem_2

DECISIONS: Mapping[str, Callable[[], Decision]] = {
    **measurement.DECISIONS,
    **schedule.DECISIONS,
    **theorem_1.DECISIONS,
    **theorem_2.DECISIONS,
    **experiment.DECISIONS,
}
