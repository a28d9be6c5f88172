"""What certificates about cyclic SPSA prove, in the order of the paper."""

from __future__ import annotations

from collections.abc import Mapping

from ....algebra.identities import Identity
from ....statements import Statement
from . import (
    assumptions,
    experiment,
    measurement,
    network,
    schedule,
    stability,
    stationary,
    theorem_1,
    theorem_2,
)

STATEMENTS: tuple[Statement, ...] = (
    *stability.STATEMENTS,
    *stationary.STATEMENTS,
    *assumptions.STATEMENTS,
    *network.STATEMENTS,
    *measurement.STATEMENTS,
    *schedule.STATEMENTS,
    *theorem_1.STATEMENTS,
    *theorem_2.STATEMENTS,
    *experiment.STATEMENTS,
)

PROOFS: Mapping[str, tuple[Identity, ...]] = {
    entry.name: entry.proof
    for part in (measurement, schedule, theorem_1, theorem_2, experiment)
    for entry in part.UNIVERSAL
}
"""The identities that prove a universal statement, by its name."""
