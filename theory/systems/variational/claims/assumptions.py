"""Hypotheses that the claims of Sanyal & Eslamiat share."""

from __future__ import annotations

from ....claims import Assumption

GAINS = Assumption("A1", "M and K are symmetric positive definite")
DAMPING = Assumption("A2", "C is positive definite, which includes that it is symmetric")
STEP = Assumption("A3", "the sampling period h is any positive number")
NOISELESS = Assumption(
    "A4", "measurements are exact and the target moves as (19) supposes, so that (20) rules alone"
)
