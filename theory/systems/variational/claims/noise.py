"""Claims about measurement noise."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import DAMPING, GAINS

STABLE_STEP = Assumption("A15", "the sampling period is below the step limit")
READING_A = Assumption(
    "A16", "x is computed from the estimate and the measured positions at each sample"
)
READING_B = Assumption("A17", "x and u are propagated by (16) and (17) themselves")
WHITE = Assumption("A18", "noises of different samples are independent")

VELOCITY = Claim(
    id="variational.section_3_velocity_noise",
    system="variational",
    source="Sanyal & Eslamiat, after (17), section 3",
    title="Errors in velocity measurements are attenuated in the velocity estimate",
    statement="The velocity estimate is less noisy than the average of the measured velocities.",
    formula=r"\operatorname{Cov}(\hat v - v) \prec \Sigma_\nu",
    sense="upper",
    assumes=(GAINS, DAMPING, STABLE_STEP, READING_A, WHITE),
    printed="variance below 1",
)

ROBUST_A = Claim(
    id="variational.section_3_robust_reading_a",
    system="variational",
    source="Sanyal & Eslamiat, after (17), section 3",
    title="Bounded noise leaves bounded errors if the position error is measured at each sample",
    statement="Under noise of bounded size every error stays bounded.",
    formula="",
    sense="property",
    assumes=(GAINS, DAMPING, STABLE_STEP, READING_A),
)

ROBUST_B = Claim(
    id="variational.section_3_robust_reading_b",
    system="variational",
    source="Sanyal & Eslamiat, (16) and (17), section 3",
    title="Bounded noise leaves bounded errors if x and u are propagated by themselves",
    statement="Under noise of bounded size every error stays bounded.",
    formula="",
    sense="property",
    assumes=(GAINS, DAMPING, STABLE_STEP, READING_B),
    printed="bounded",
)

CLAIMS: tuple[Claim, ...] = (VELOCITY, ROBUST_A, ROBUST_B)
