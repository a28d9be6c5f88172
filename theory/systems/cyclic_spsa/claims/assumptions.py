"""Assumptions that claims about cyclic SPSA share."""

from __future__ import annotations

from ....claims import Assumption

PERTURBATION = Assumption(
    "A7", "the entries of Delta are independent of each other and of the noise, +1 or -1 with 1/2"
)
TWO_INSTANTS = Assumption("R2", "the two costs of a step use the measurements of two instants")
ONE_INSTANT = Assumption("R1", "the two costs of a step use the same measurement")
