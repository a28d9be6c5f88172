"""Claims about the experiment of section 5."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import ONE_INSTANT, PERTURBATION, TWO_INSTANTS
from .theorem_assumptions import WEIGHTS

SYSTEM = "cyclic_spsa"
STEP = Assumption("E1", "alpha = 0.05 and beta = 0.03, as printed, lengths in km")
SIX = Assumption("E2", "six sensors and six targets, so that d = 12")
CERTAIN = Assumption("E3", "p_sigma = 0, K the sum of the six variances or their mean")
NOISE = Assumption(
    "E4", "tr Xi = 7.5^2 km^2, that of 5 % and half a degree at 148 km, and K = n sigma^2"
)
SHARED = Assumption("E5", "the targets are divided evenly, k = 6/m_max blocks of m_max targets")
GENTLE = Assumption("E6", "0 < alpha h <= 1 for every weight h")
AT_REST = Assumption("E7", "the targets are at rest and have equal weights and noises")

STEP_INTERVAL = Claim(
    id="cyclic_spsa.section_5_step_interval",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 5 with Theorem 2",
    title="The step 0.05 of the experiment is in the interval of Theorem 2 for every sensor",
    statement="The parameters of the experiment meet the conditions of Theorem 2 at all six "
    "sensors.",
    formula=r"0.05<\frac{\mu^j}{\gamma^j}\quad\text{for every }j",
    sense="threshold",
    assumes=(WEIGHTS, STEP, SIX, CERTAIN),
    printed="0.05",
)

STABLE_TWO = Claim(
    id="cyclic_spsa.section_5_stable_two_instants",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 5, Figures 1 and 2",
    title="With the printed parameters the error of the two-instant algorithm stays bounded",
    statement="The error at alpha = 0.05 and beta = 0.03 settles, all six targets in one block.",
    formula=r"\limsup E\lVert\hat\theta_t-\theta_t\rVert^2<\infty",
    sense="property",
    assumes=(WEIGHTS, STEP, SIX, NOISE, PERTURBATION, TWO_INSTANTS),
    printed="0.05",
)

STABLE_ONE = Claim(
    id="cyclic_spsa.section_5_stable_one_instant",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 5, Figures 1 and 2",
    title="With the printed parameters the error of the one-instant algorithm stays bounded",
    statement="The error at alpha = 0.05 and beta = 0.03 settles, all six targets in one block.",
    formula=r"\limsup E\lVert\hat\theta_t-\theta_t\rVert^2<\infty",
    sense="property",
    assumes=(WEIGHTS, STEP, SIX, NOISE, PERTURBATION, ONE_INSTANT),
    printed="0.05",
)

FEW = Claim(
    id="cyclic_spsa.section_5_few_targets",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 5 and section 6",
    title="With few targets at a time the estimates converge more slowly",
    statement="The fewer targets a sensor follows at a time, the slower the mean error decays.",
    formula="",
    sense="property",
    assumes=(SHARED, GENTLE, PERTURBATION),
    printed="slower",
)

MOST = Claim(
    id="cyclic_spsa.section_5_most_targets",
    system=SYSTEM,
    source="Erofeeva & Granichin, section 5",
    title="Following as many targets at a time as possible leaves the smallest error",
    statement="With the largest m_max the error that stays is the smallest.",
    formula="",
    sense="property",
    assumes=(SHARED, AT_REST, PERTURBATION, ONE_INSTANT),
    printed="m_max = 6 is best",
)

CLAIMS: tuple[Claim, ...] = (STEP_INTERVAL, STABLE_TWO, STABLE_ONE, FEW, MOST)
