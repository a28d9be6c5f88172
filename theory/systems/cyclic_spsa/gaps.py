"""Printed statements of Erofeeva & Granichin that their text does not determine."""

from __future__ import annotations

from ...claims import Gap

GAPS: tuple[Gap, ...] = (
    Gap(
        "Erofeeva & Granichin, section 2, first paragraph",
        "the state of a sensor has m entries",
        "another letter: m is the number of objects, and in (10) to (13) a sensor has two entries, "
        "its place in the plane",
    ),
    Gap(
        "Erofeeva & Granichin, section 2, second paragraph after (2)",
        "where no inverse exists, the state can be estimated on the subspace z = U r",
        "how U follows from the observation function, and which step of Algorithm 1, all of whose "
        "costs contain the inverse, would use it",
    ),
    Gap(
        "Erofeeva & Granichin, section 2, before (3)",
        "with probability p_sigma the mean of tr Xi is below a threshold",
        "what is drawn: a mean is a number and has no probability; with tr Xi itself in its place "
        "p_sigma and the threshold would still need values, and no section gives any",
    ),
    Gap(
        "Erofeeva & Granichin, end of section 2.1",
        "one K serves all targets",
        "the target: the printed K contains variances with the index i and stands outside the sum "
        "over i; eq_3_mean_risk says what it has to be for each",
    ),
    Gap(
        "Erofeeva & Granichin, (9)",
        "H^j has d columns and l rows for every sensor j",
        "the length of theta^j: for parts of theta it is d^j, and a constraint that couples parts "
        "of two sensors could be met by neither alone",
    ),
    Gap(
        "Erofeeva & Granichin, Assumption 1",
        "x - h(theta_t) is taken for every x in R^d",
        "the space of x: h maps to d - l coordinates, so the difference exists for l = 0 only, "
        "where h is the identity; all that follows is decided for l = 0",
    ),
    Gap(
        "Erofeeva & Granichin, (17), (18) and the initialization of Algorithm 1",
        "form matrices A_t^j such that (17) to (19) hold",
        "which blocks, in which order, and who tracks which target: the limits leave many choices, "
        "and the steady error depends on them",
    ),
    Gap(
        "Erofeeva & Granichin, Algorithm 1",
        "n_max^j is an input, and sensors exchange data with their neighbours",
        "a step that sends or receives: none does; read with (20), neighbours send measurements "
        "with the place and the variance of the sensor that made them, and no estimates",
    ),
    Gap(
        "Erofeeva & Granichin, Algorithm 1, steps 3.3, 3.4 and 3.6",
        "the two costs of a pair come from the measurements of two instants, or of one",
        "which: steps 3.3 and 3.6 get two, step 3.4 uses the second one for both; the limit of the "
        "step differs, and claims that depend on it are decided for both",
    ),
    Gap(
        "Erofeeva & Granichin, Theorems 1 and 2, first lines",
        "the step is sufficiently small, besides being in the interval",
        "how small: claims about the theorems take every step in the interval, and the "
        "counterexamples to (21) with a steady drift hold for all small steps, by certificates",
    ),
    Gap(
        "Erofeeva & Granichin, Theorem 2, the drift",
        "a target moves by at most sigma_t^i in a sample",
        "another letter: sigma is the scale of the noise, and the appendix bounds the drift by "
        "delta^i, which the claims about Theorem 2 take",
    ),
    Gap(
        "Erofeeva & Granichin, section 5, Figures 1 and 2",
        "the error over time for m_max = 3 and for m_max = 1",
        "the sampling period, the headings, the places of the sensors, K, the blocks, the error "
        "that is plotted and the unit of beta: other choices give other curves",
    ),
)
