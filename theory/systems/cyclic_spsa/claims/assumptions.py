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
WHOLE_NUMBERS = Assumption("S1", "cycles T = 1, 2, ... of k pairs of instants, t = 1, 2, ...")
ACTIVE_SUM = Assumption("S2", "the sum of (20) runs over the active targets only")
OBSERVED_SUM = Assumption("S3", "the sum of (20) runs over all targets that the sensor observes")
WHOLE_SUM = Assumption("S4", "(20) has both coordinates of every target of which one is active")
DRIFTING = Assumption("S5", "the targets move at a constant velocity that is not zero")
EXACT_SIGHT = Assumption("S6", "angle and distance are measured without error")
SEEN = Assumption(
    "S7", "the sensor or a neighbour sees each of its targets, and m_max is at least 1"
)
COUNTED = Assumption(
    "S8", "a pair of steps takes a operations for each active coordinate, b besides"
)
SAME_MEASUREMENT = Assumption("C1", "the weight comes from the measurement that it weighs")
STEADY_WEIGHT = Assumption(
    "C2", "the weight is the same for all outcomes, like max tr Xi over time"
)
CENTRED_POSITION = Assumption("C3", "the computed positions are right in the mean")
COPIES = Assumption("C4", "every sensor has its own copy of all of theta")
PARTS = Assumption("C5", "every sensor has its own part of theta, and no cost spans two parts")
INDEPENDENT_ROWS = Assumption("C6", "H has l rows, l < d, and its rank is l")
NOISY = Assumption("C7", "w_t is random and independent of what happened before t")
