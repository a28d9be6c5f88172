"""Claims about the weights, the cost and its constraints, (3) to (9), (14) and (20)."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import (
    CENTRED,
    CENTRED_POSITION,
    COPIES,
    INDEPENDENT_ROWS,
    NOISY,
    PARTS,
    SAME_MEASUREMENT,
    STEADY_WEIGHT,
)

SYSTEM = "cyclic_spsa"

MEAN_RISK = Claim(
    id="cyclic_spsa.eq_3_mean_risk",
    system=SYSTEM,
    source="Erofeeva & Granichin, (3), (5) and the end of section 2.1",
    title="With the printed K the mean of the weighted cost is half the squared error",
    statement="With K = p sigma_min^2 + (1 - p) times the sum of the sensors' variances the mean "
    "of the cost of section 2.1 is (3), up to a number that no estimate changes.",
    formula=r"E\,\frac K{2n}\sum_j\frac{\lVert r+\xi^j-\hat r\rVert^2}{(\sigma^j)^2}="
    r"\tfrac12\lVert r-\hat r\rVert^2+\mathrm{const}",
    sense="equality",
    assumes=(CENTRED_POSITION, STEADY_WEIGHT),
    printed="K = p sigma_min^2 + (1 - p) sum of variances",
)

MINIMUM = Claim(
    id="cyclic_spsa.eq_3_minimum",
    system=SYSTEM,
    source="Erofeeva & Granichin, (3), (5) and the end of section 2.1",
    title="The weighted cost has its least mean at the true positions",
    statement="Whatever positive weights and K are, the mean of the cost of section 2.1 is least "
    "at the true positions and nowhere else.",
    formula=r"\operatorname{argmin}_{\hat\theta}E\tilde f_{w_t}(\hat\theta)=\theta_t",
    sense="equality",
    assumes=(CENTRED_POSITION, STEADY_WEIGHT),
)

MEASURABLE = Claim(
    id="cyclic_spsa.eq_5_measurable",
    system=SYSTEM,
    source="Erofeeva & Granichin, (5) and the paragraph before",
    title="What happened before t determines the cost at t",
    statement="The random cost with w_t is measurable with respect to what happened before t, the "
    "events over which (5) takes no mean.",
    formula=r"\tilde f_{w_t}(\theta)\ \text{is}\ \mathcal F_{t-1}\text{-measurable}",
    sense="property",
    assumes=(NOISY,),
    printed="measurable before t",
)

REDUCED = Claim(
    id="cyclic_spsa.eq_6_reduced",
    system=SYSTEM,
    source="Erofeeva & Granichin, (6), (9) and the display after (6)",
    title="Constraints of full rank can be solved for fewer coordinates, there and back",
    statement="If the l rows of H are independent, there are a linear h to d - l coordinates and a "
    "function g back, with x = g(h(x)) wherever Hx = q.",
    formula=r"x=g(h(x))\quad\forall x:\ Hx=q",
    sense="property",
    assumes=(INDEPENDENT_ROWS,),
)

LIKE_COPIES = Claim(
    id="cyclic_spsa.eq_7_copies",
    system=SYSTEM,
    source="Erofeeva & Granichin, (7), (8), first case",
    title="Copies whose costs add up to the least value agree",
    statement="If every sensor has a copy of theta, the copies whose costs add up to the least "
    "value of the sum at a common point are one and the same solution.",
    formula=r"\sum_jf^j(\theta^j)=\min_\theta\sum_jf^j(\theta)\ \Rightarrow\ "
    r"\theta^1=\dots=\theta^n",
    sense="property",
    assumes=(COPIES,),
    printed="the copies agree",
)

SUBVECTORS = Claim(
    id="cyclic_spsa.eq_7_subvectors",
    system=SYSTEM,
    source="Erofeeva & Granichin, (7), (8), second case",
    title="Parts without common terms can be minimised each by itself",
    statement="If every sensor has its own part of theta, the quadratic cost is the sum of the "
    "costs of the parts, so that each sensor's least value is a part of the common one.",
    formula=r"\bar f_w(\theta)=\sum_jf_w^j(\theta^j)",
    sense="equality",
    assumes=(PARTS,),
)

MEASURED_VARIANCE = Claim(
    id="cyclic_spsa.eq_14_sigma",
    system=SYSTEM,
    source="Erofeeva & Granichin, paragraph before (14)",
    title="The measured distance times sigma_rho squares to the variance of the distance",
    statement="The variance of the distance's error is (z2 sigma_rho)^2 in the mean, z2 being the "
    "measured distance itself.",
    formula=r"E(z_2\sigma_\rho)^2=(\rho\,\sigma_\rho)^2",
    sense="equality",
    assumes=(CENTRED,),
    printed="(z2 sigma_rho)^2",
)

EXACT_TRACE = Claim(
    id="cyclic_spsa.eq_14_trace_exact",
    system=SYSTEM,
    source="Erofeeva & Granichin, remark after (14)",
    title="The mean square of the position's error is the printed trace, for errors of any size",
    statement="E|xi|^2 = (rho sigma_psi)^2 + (rho sigma_rho)^2 without any approximation.",
    formula=r"E\lVert\xi\rVert^2=(\rho\sigma_\psi)^2+(\rho\sigma_\rho)^2",
    sense="equality",
    assumes=(CENTRED,),
    printed="sigma_psi^2 + sigma_rho^2",
)

EXACT_COVARIANCE = Claim(
    id="cyclic_spsa.eq_14_exact",
    system=SYSTEM,
    source="Erofeeva & Granichin, (14)",
    title="With its axes put right, (14) is the covariance for errors of any size",
    statement="The variance of the position is exactly (rho sigma_rho)^2 along the line of sight "
    "and exactly (rho sigma_psi)^2 across it.",
    formula=r"\Xi=R(\psi)\begin{bmatrix}(\rho\sigma_\rho)^2&0\\0&(\rho\sigma_\psi)^2\end{bmatrix}"
    r"R(\psi)^\top",
    sense="equality",
    assumes=(CENTRED,),
    printed="sigma_rho^2 and sigma_psi^2",
)

MEASURED_WEIGHTS = Claim(
    id="cyclic_spsa.eq_20_weights_measured",
    system=SYSTEM,
    source="Erofeeva & Granichin, (20) with (14)",
    title="Weights that come from the measured distance itself leave the fit right in the mean",
    statement="With sigma_t^2 from the measured distance z2 the mean of (20) is least at the "
    "target's true distance.",
    formula=r"\operatorname{argmin}_xE\frac{(z-x)^2}{z^2}=\rho",
    sense="equality",
    assumes=(CENTRED, SAME_MEASUREMENT),
    printed="the true distance",
)

STEADY_WEIGHTS = Claim(
    id="cyclic_spsa.eq_20_weights_steady",
    system=SYSTEM,
    source="Erofeeva & Granichin, (20) with the definition of sigma_t in section 2.1",
    title="Weights that do not depend on the noise of the moment leave the fit right in the mean",
    statement="With sigma_t^2 the largest trace over time, the same for all outcomes, the mean of "
    "(20) is least at the true position, in each coordinate.",
    formula=r"\operatorname{argmin}_xE\frac{(z-x)^2}{\sigma^2}=E z",
    sense="equality",
    assumes=(CENTRED_POSITION, STEADY_WEIGHT),
)

MEAN_COSTS = (MEAN_RISK, MINIMUM, MEASURABLE, REDUCED, LIKE_COPIES, SUBVECTORS)
WEIGHTS = (MEASURED_WEIGHTS, STEADY_WEIGHTS)
