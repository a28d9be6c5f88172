"""Assumptions that claims about cyclic SPSA share."""

from __future__ import annotations

from ....claims import Assumption

PERTURBATION = Assumption(
    "A7", "the entries of Delta are independent of each other and of the noise, +1 or -1 with 1/2"
)
TWO_INSTANTS = Assumption("R2", "the two costs of a step use the measurements of two instants")
ONE_INSTANT = Assumption("R1", "the two costs of a step use the same measurement")
CENTRED = Assumption("M1", "the errors of angle and distance have mean zero and are independent")
QUADRANTS = Assumption(
    "M2", "the angle is that of the offset in all four quadrants, not a quotient"
)
NOT_AT_SENSOR = Assumption("M3", "the target is not at the sensor")
FIRST_ORDER = Assumption("M4", "errors are so small that terms of second order do not count")
