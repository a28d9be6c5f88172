"""Claims about the measurement model, the weights and the cost, (1) to (14) and (20)."""

from __future__ import annotations

from ....claims import Claim
from . import cost
from .assumptions import CENTRED, FIRST_ORDER, NOT_AT_SENSOR, QUADRANTS

SYSTEM = "cyclic_spsa"

ZERO_MEAN = Claim(
    id="cyclic_spsa.eq_2_zero_mean",
    system=SYSTEM,
    source="Erofeeva & Granichin, (2), (13)",
    title="Errors of mean zero in angle and distance make an error of mean zero in the position",
    statement="If the errors of the angle and of the distance have mean zero and are independent, "
    "the position computed by (13) is right in the mean.",
    formula=r"E\,\varphi^{-1}(s,\varphi(s,r)+\varepsilon)=r",
    sense="equality",
    assumes=(CENTRED, QUADRANTS),
    printed="mean 0",
)

INDEPENDENT = Claim(
    id="cyclic_spsa.eq_2_independent",
    system=SYSTEM,
    source="Erofeeva & Granichin, (2)",
    title="The error of the computed position has the same law wherever the target is",
    statement="The error xi of the position is a random vector of its own, independent of all "
    "else, the places of sensor and target included.",
    formula=r"\varphi^{-1}(s,z)=r+\xi,\qquad \xi\ \text{independent of}\ s,\,r",
    sense="property",
    assumes=(CENTRED, QUADRANTS),
    printed="independent",
)

FOURTH_MOMENT = Claim(
    id="cyclic_spsa.eq_2_fourth_moment",
    system=SYSTEM,
    source="Erofeeva & Granichin, (2), fourth moment",
    title="One number bounds the fourth moment of the position's error for all targets",
    statement="There is a number M_4 that the mean of |xi|^4 never exceeds, wherever sensors and "
    "targets are.",
    formula=r"E\lVert\xi\rVert^4\le M_4",
    sense="upper",
    assumes=(CENTRED, QUADRANTS),
    printed="some M_4",
)

ANGLE = Claim(
    id="cyclic_spsa.eq_11_angle",
    system=SYSTEM,
    source="Erofeeva & Granichin, (11)",
    title="The arctangent of one quotient and the distance tell where the target is",
    statement="With the angle as the arctangent of (r1 - s1)/(r2 - s2), (13) gives the target's "
    "position from an exact angle and an exact distance.",
    formula=r"\psi=\operatorname{arctg}\frac{r^1-s^1}{r^2-s^2}\ \Rightarrow\ "
    r"\varphi^{-1}(s,\varphi(s,r))=r",
    sense="equality",
    assumes=(NOT_AT_SENSOR,),
    printed="arctg",
)

INVERSE = Claim(
    id="cyclic_spsa.eq_13_inverse",
    system=SYSTEM,
    source="Erofeeva & Granichin, (10), (12), (13)",
    title="An exact angle, right in every quadrant, and an exact distance give the position",
    statement="If rho (sin psi, cos psi) is the offset of the target from the sensor, (13) returns "
    "the position, and rho is the distance (12).",
    formula=r"s+\begin{bmatrix}\rho\sin\psi\\\rho\cos\psi\end{bmatrix}=r,\qquad "
    r"\rho=\lVert r-s\rVert",
    sense="equality",
    assumes=(QUADRANTS, NOT_AT_SENSOR),
)

AXES = Claim(
    id="cyclic_spsa.eq_14_axes",
    system=SYSTEM,
    source="Erofeeva & Granichin, (14)",
    title="The position errs along the line of sight as the angle does, and across as the distance",
    statement="To first order the covariance of the position's error has the angle's part, (rho "
    "sigma_psi)^2, along the first column of R(psi), which is the line of sight, and the "
    "distance's part, (rho sigma_rho)^2, across it.",
    formula=r"\Xi=R(\psi)\begin{bmatrix}(\rho\sigma_\psi)^2&0\\0&(\rho\sigma_\rho)^2\end{bmatrix}"
    r"R(\psi)^\top",
    sense="equality",
    assumes=(CENTRED, FIRST_ORDER),
    printed="diag((rho sigma_psi)^2, (rho sigma_rho)^2)",
)

ROTATION = Claim(
    id="cyclic_spsa.eq_14_rotation",
    system=SYSTEM,
    source="Erofeeva & Granichin, (14), matrix R",
    title="The matrix [sin psi, -cos psi; cos psi, sin psi] turns by the angle psi",
    statement="R(psi) is a rotation, and psi is the angle by which it turns.",
    formula=r"R(\psi)=\begin{bmatrix}\sin\psi&-\cos\psi\\\cos\psi&\sin\psi\end{bmatrix}="
    r"\mathrm{Rot}(\psi)",
    sense="equality",
    assumes=(QUADRANTS,),
    printed="psi",
)

TRACE = Claim(
    id="cyclic_spsa.eq_14_trace",
    system=SYSTEM,
    source="Erofeeva & Granichin, remark after (14)",
    title="The variances of the two coordinates add up to those of the angle and of the distance",
    statement="To first order the trace of the covariance is (rho sigma_psi)^2 + (rho "
    "sigma_rho)^2, whichever way round the two are put on the axes.",
    formula=r"\operatorname{tr}\Xi=(\rho\sigma_\psi)^2+(\rho\sigma_\rho)^2",
    sense="equality",
    assumes=(CENTRED, FIRST_ORDER),
)

CLAIMS: tuple[Claim, ...] = (
    ZERO_MEAN,
    INDEPENDENT,
    FOURTH_MOMENT,
    *cost.MEAN_COSTS,
    ANGLE,
    INVERSE,
    cost.MEASURED_VARIANCE,
    AXES,
    ROTATION,
    TRACE,
    cost.EXACT_TRACE,
    cost.EXACT_COVARIANCE,
    *cost.WEIGHTS,
)
