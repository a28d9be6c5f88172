"""Claims about the simulations: moving targets, lost sensors, late data."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import DAMPING, GAINS, NOISELESS, STEP
from .framework import WEIGHTS
from .noise import STABLE_STEP

EXACT = Assumption("A20", "measurements are exact; the target moves in any way")
WHITE = Assumption(
    "A21", "all sensors' noises are white, independent, of one covariance, and weights are equal"
)
LATE = Assumption(
    "A22", "relaying takes time: a node knows the sums of (6) and (7) some samples late"
)
STEADY = Assumption("A23", "sensors and target move with constant velocities, without noise")

CONVERGE = Claim(
    id="variational.section_4_converge",
    system="variational",
    source="Sanyal & Eslamiat, section 4.B, Figures 5 and 6",
    title="Without noise the errors of the simulated estimator converge to zero for any target",
    statement="With exact measurements, the position and the velocity error of (24) tend to zero "
    "while the target moves along its trajectory.",
    formula=r"\hat b_k - b_k \to 0,\quad \hat v_k - v_k \to 0",
    sense="property",
    assumes=(GAINS, DAMPING, STABLE_STEP, EXACT),
    printed="0",
)

MEASURED = Claim(
    id="variational.eq_24_measured",
    system="variational",
    source="Sanyal & Eslamiat, after (24)",
    title="In (24) each sensor puts in its measured value of the target's velocity",
    statement="The velocity that (24) takes off the velocity of sensor i is the measured velocity "
    "of the target, and the errors then behave as those of (20).",
    formula=r"v^{0i}_{k,m} = v^0_k",
    sense="equality",
    assumes=(GAINS, DAMPING, STEP, WEIGHTS, STEADY),
    printed="measured value of v_k^0",
)

SENSOR_LOSS = Claim(
    id="variational.section_4_sensor_loss",
    system="variational",
    source="Sanyal & Eslamiat, section 4.B, Figures 5 and 6",
    title="Errors go on converging to zero when a sensor is lost",
    statement="Without noise, the errors tend to zero although one of the sensors stops to see the "
    "target at some sample.",
    formula=r"(x_k, u_k) \to 0",
    sense="property",
    assumes=(GAINS, DAMPING, STABLE_STEP, NOISELESS, WEIGHTS),
)

INSTANTANEOUS = Claim(
    id="variational.section_4_instantaneous",
    system="variational",
    source="Sanyal & Eslamiat, after (24) and section 5",
    title="A network that relays the sums of (24) a sample late is stable for the same steps",
    statement="(24) takes the position error at the new sample for known at once; run by each "
    "node on what its neighbours relay, it is as stable as where all is known at once.",
    formula=r"(M + hC)\,u_{k+1} = M u_k - hK x_{k+1-d},\quad d \ge 1",
    sense="lower",
    assumes=(GAINS, DAMPING, STABLE_STEP, LATE),
    printed="no limit of its own",
)

ROBUST = Claim(
    id="variational.section_4_noise_robust",
    system="variational",
    source="Sanyal & Eslamiat, section 4.B, Figures 7 and 8",
    title="With noise, losing one of three sensors makes errors larger by no more than its share",
    statement="After one of three like sensors is lost, the errors stay as small as the average of "
    "the two others allows: their root mean squares grow as those of the averaged noise do.",
    formula=r"\mathrm{rms}_{2}/\mathrm{rms}_{3} = \sqrt{3/2}",
    sense="equality",
    assumes=(GAINS, DAMPING, STABLE_STEP, WEIGHTS, WHITE),
)

CLAIMS: tuple[Claim, ...] = (CONVERGE, MEASURED, SENSOR_LOSS, INSTANTANEOUS, ROBUST)
