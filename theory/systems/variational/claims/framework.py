"""Claims about sensors, weights and communication."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import NOISELESS

SIGNS = Assumption("A5", "positions and velocities are relative as (1) and (2) define them")
RANGE = Assumption("A6", "sensors within a known range of each other communicate both ways")
PATHS = Assumption("A7", "there is a communications path between any two sensors")
WEIGHTS = Assumption("A8", "the weights of the sensors that see the target are positive, of sum 1")

OBSERVED = Claim(
    id="variational.eq_1_observed_by",
    system="variational",
    source="Sanyal & Eslamiat, after (2)",
    title="The relative position of two objects is the first one as the second observes it",
    statement="b^{0i} = b^i - b^0 is the position of the target relative to sensor i.",
    formula=r"b^{\mu\nu} = b^\nu - b^\mu",
    sense="equality",
    assumes=(SIGNS,),
    printed="target seen from sensor",
)

ERRORS = Claim(
    id="variational.eq_6_errors",
    system="variational",
    source="Sanyal & Eslamiat, (6) and (7) beside (4)",
    title="The weighted errors are the true ones, whatever the weights",
    statement="Without noise, x of (6) and u of (7) equal the errors of (4), for any weights of "
    "sum 1, and so they do not jump when sensors are lost and the weights are rescaled.",
    formula=r"\hat b - \sum_i \lambda_i (b_i - b_{0i}) = \hat b - b",
    sense="equality",
    assumes=(SIGNS, WEIGHTS, NOISELESS),
)

KINEMATICS = Claim(
    id="variational.eq_8_kinematics",
    system="variational",
    source="Sanyal & Eslamiat, (8)",
    title="The position error changes at the rate of the velocity error",
    statement="If the estimated position moves with the estimated velocity, the derivative of x "
    "is u, whether the weights are constant or not.",
    formula=r"\dot x = u",
    sense="equality",
    assumes=(SIGNS, WEIGHTS, NOISELESS),
)

KINEMATICS_MEASURED = Claim(
    id="variational.eq_8_kinematics_measured",
    system="variational",
    source="Sanyal & Eslamiat, (8) with (6), (7) from the measurements (3)",
    title="With noise, too, the measured position error changes at the measured rate",
    statement="With the measured x of (6) and the measured u of (7), the derivative of x is u.",
    formula=r"\dot x_m = u_m",
    sense="equality",
    assumes=(SIGNS, WEIGHTS),
)

NEIGHBOURS = Claim(
    id="variational.section_2_neighbours",
    system="variational",
    source="Sanyal & Eslamiat, section 2",
    title="Every sensor of a connected network within range has two neighbours",
    statement="If sensors within range of each other communicate and any two are joined by a "
    "path, every sensor is within range of two others at least.",
    formula=r"\deg(i) \ge 2",
    sense="lower",
    assumes=(RANGE, PATHS),
    printed="2",
)

BRIDGES = Claim(
    id="variational.section_2_two_edge_connected",
    system="variational",
    source="Sanyal & Eslamiat, section 2",
    title="Two neighbours for every sensor leave no single link to be lost",
    statement="If every sensor is within range of two others at least, the network stays "
    "connected when any one link is lost.",
    formula="",
    sense="property",
    assumes=(RANGE, PATHS),
    printed="no bridge",
)

CLAIMS: tuple[Claim, ...] = (OBSERVED, ERRORS, KINEMATICS, KINEMATICS_MEASURED, NEIGHBOURS, BRIDGES)
