"""What can be asked about a user's own costs, sensors and targets."""

from __future__ import annotations

from verification.answers import Condition, Quantity

from .assumptions.sharp import COST, GIVEN, WANTED_C3, assumption_constants, decide_assumptions
from .network.errors import ERROR, network_error
from .network.limits import LIMITED, network_step_limit
from .network.times import AHEAD, network_schedule

QUANTITIES: tuple[Quantity, ...] = (
    Quantity(
        "assumptions",
        "[mu, M, c2, c3, c4, delta]: the sharp constants of Assumptions 1 to 5",
        (*COST, WANTED_C3),
        assumption_constants,
        True,
    ),
    Quantity(
        "network_step_limit",
        "supremum of alpha with every block of every sensor stable",
        LIMITED,
        network_step_limit,
        True,
    ),
    Quantity(
        "network_error",
        "root-mean-square error of all sensors and targets in the long run",
        ERROR,
        network_error,
        False,
    ),
    Quantity(
        "network_schedule",
        "the same while targets move, and who uses whose measurements when",
        AHEAD,
        network_schedule,
        False,
    ),
)

CONDITIONS: tuple[Condition, ...] = (
    Condition(
        "assumptions",
        "mu, M, c2, c3, c4 and delta are constants of Assumptions 1 to 5",
        (*COST, *GIVEN),
        decide_assumptions,
    ),
)
