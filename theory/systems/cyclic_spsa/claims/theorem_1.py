"""Claims about Assumptions 1 to 7 and Theorem 1."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import ONE_INSTANT, PERTURBATION, TWO_INSTANTS
from .theorem_assumptions import (
    ADDITIVE_NOISE,
    BOUNDED_DRIFT,
    CHANGE,
    CONSTANT_COST,
    CONVEX,
    GRADIENTS,
    IN_INTERVAL,
    RANDOM_DRIFT,
    SMOOTH,
)

SYSTEM = "cyclic_spsa"
ALL = (CONVEX, SMOOTH, GRADIENTS, BOUNDED_DRIFT, CHANGE, ADDITIVE_NOISE, PERTURBATION)

BRANCH = Claim(
    id="cyclic_spsa.theorem_1_second_branch",
    system=SYSTEM,
    source="Erofeeva & Granichin, Theorem 1",
    title="For some costs the steps are taken from one of two intervals with a gap between them",
    statement="Where mu^2 >= 2 gamma, steps between the two roots of 1 - alpha m = 0 are excluded.",
    formula=r"\alpha\in\bigl(0;\tfrac{\mu-\sqrt{\mu^2-2\gamma}}{2\gamma}\bigr)\cup"
    r"\bigl(\tfrac{\mu+\sqrt{\mu^2-2\gamma}}{2\gamma};\tfrac\mu\gamma\bigr)\ \text{if}\ "
    r"\mu^2\ge2\gamma",
    sense="property",
    assumes=(CONVEX, SMOOTH),
    printed="two cases",
)

CONSTANT_C1 = Claim(
    id="cyclic_spsa.theorem_1_c1",
    system=SYSTEM,
    source="Erofeeva & Granichin, Assumption 3 and Theorem 1",
    title="The mean gradient at the minimum may differ from zero by some c1",
    statement="The norm of the mean gradient at the minimum is bounded by a constant c1 of its "
    "own, which enters the bound of Theorem 1.",
    formula=r"\lVert E\nabla f_{w_t}(\theta_t)\rVert\le c_1",
    sense="upper",
    assumes=(CONVEX, SMOOTH),
    printed="c1",
)

EVERY_POINT = Claim(
    id="cyclic_spsa.assumption_5_every_point",
    system=SYSTEM,
    source="Erofeeva & Granichin, Assumption 5",
    title="Assumption 5 bounds the change of the cost from sample to sample at every point",
    statement="With c3 and c4 of Assumption 5 the mean square of f_t(x) - f_(t-1)(x) is bounded "
    "in terms of the distance of x from the minimum.",
    formula=r"E\bigl(f_{w_t}(\theta_t)-f_{w_{t-1}}(\theta_{t-1})\bigr)^2\le "
    r"c_3\lVert x-\theta_{t-2}\rVert+c_4",
    sense="upper",
    assumes=(CHANGE,),
    printed="left side without x",
)

NOT_CONVEX = Claim(
    id="cyclic_spsa.section_4_convex",
    system=SYSTEM,
    source="Erofeeva & Granichin, remarks after Theorem 2, section 4",
    title="A cost that meets Assumptions 1 and 2 is convex",
    statement="Assumptions 1 and 2 make the mean cost convex.",
    formula="",
    sense="property",
    assumes=(CONVEX, SMOOTH),
    printed="convex",
)

UNITS_GAMMA = Claim(
    id="cyclic_spsa.theorem_1_units_gamma",
    system=SYSTEM,
    source="Erofeeva & Granichin, Theorem 1, gamma",
    title="The interval of the step is the same in kilometres and in metres",
    statement="All terms of gamma have one unit, so that mu/gamma does not depend on the unit of "
    "length.",
    formula=r"\gamma=3d\Bigl(M^2d+\frac{c_3}{\beta}\Bigr)",
    sense="property",
    assumes=(CONVEX, SMOOTH, CHANGE),
    printed="c3/beta",
)

UNITS_L = Claim(
    id="cyclic_spsa.theorem_1_units_l",
    system=SYSTEM,
    source="Erofeeva & Granichin, Theorem 1, l",
    title="The bound on the error is the same in kilometres and in metres",
    statement="All terms of l have one unit, so that (21) does not depend on the unit of length.",
    formula=r"\begin{array}{l}"
    r"\bar l=2\alpha d\bigl(c_v^2+3\bigl(\tfrac{c_4}\beta+\dots\bigr)\bigr) \\"
    r"\quad+2\delta_\theta(\dots+3\mu\delta_\theta^2)\end{array}",
    sense="property",
    assumes=ALL,
    printed="c_v^2, c4/beta, 3 mu delta^2 beside terms of other units",
)

INTERVAL = Claim(
    id="cyclic_spsa.theorem_1_interval",
    system=SYSTEM,
    source="Erofeeva & Granichin, Theorem 1",
    title="With a step in the printed interval the mean-square error stays bounded",
    statement="For every step between 0 and mu/gamma the error of the estimates stays bounded in "
    "the mean square, if the costs of a step are measured at two instants.",
    formula=r"0<\alpha<\frac{\mu}{\gamma}\ \Rightarrow\ "
    r"\limsup E\lVert\hat\theta_t-\theta_t\rVert^2<\infty",
    sense="threshold",
    assumes=(*ALL, TWO_INSTANTS),
    printed="mu/gamma, gamma = 3d(M^2 d + c3/beta)",
)

INTERVAL_ONE = Claim(
    id="cyclic_spsa.theorem_1_interval_one_instant",
    system=SYSTEM,
    source="Erofeeva & Granichin, Theorem 1, Algorithm 1, step 3.4 as printed",
    title="Measured at one instant, every step in the printed interval keeps the error bounded",
    statement="For every step between 0 and mu/gamma the error of the estimates stays bounded in "
    "the mean square, if both costs of a step are measured at one instant.",
    formula=r"0<\alpha<\frac{\mu}{\gamma}\ \Rightarrow\ "
    r"\limsup E\lVert\hat\theta_t-\theta_t\rVert^2<\infty",
    sense="threshold",
    assumes=(*ALL, ONE_INSTANT),
    printed="mu/gamma",
)

FORMULA_21 = r"\limsup\sqrt{E\lVert\hat\theta_t-\theta_t\rVert^2}\le"
FORMULA_21 += r"\frac{\sqrt k\,(b+\sqrt{b^2+ml})}{m}"


def _bound(part: str, title: str, statement: str, assumes: tuple[Assumption, ...]) -> Claim:
    return Claim(
        id=f"cyclic_spsa.theorem_1_bound{part}",
        system=SYSTEM,
        source="Erofeeva & Granichin, Theorem 1, (21)",
        title=title,
        statement=statement,
        formula=FORMULA_21,
        sense="upper",
        assumes=assumes,
        printed="(21)",
    )


BOUND = _bound(
    "",
    "The error of a target that moves steadily is at most the printed bound",
    "In the long run the root of the mean square of the error is at most (21), with two instants "
    "and a target that moves by the same delta in every sample.",
    (*ALL, IN_INTERVAL, TWO_INSTANTS),
)
BOUND_ONE = _bound(
    "_one_instant",
    "Measured at one instant, too, the error of a moving target is at most the printed bound",
    "In the long run the root of the mean square of the error is at most (21), with one instant.",
    (*ALL, IN_INTERVAL, ONE_INSTANT),
)
BOUND_NOISE = _bound(
    "_noise",
    "The error from noise in the measured costs is at most the printed bound",
    "In the long run the root of the mean square of the error is at most (21), for a target at "
    "rest and costs that are measured with noise.",
    (*ALL, IN_INTERVAL),
)
BOUND_WALK = _bound(
    "_walk",
    "The error of a target that drifts without direction is at most the printed bound",
    "In the long run the root of the mean square of the error is at most (21), for a target on a "
    "random walk.",
    (*ALL, IN_INTERVAL, RANDOM_DRIFT, TWO_INSTANTS),
)
STATIC = _bound(
    "_static",
    "Without drift and noise the error is at most the printed bound",
    "In the long run the root of the mean square of the error is at most (21), for every step in "
    "the printed interval, if the cost does not change and is measured without noise.",
    (CONVEX, SMOOTH, CONSTANT_COST, IN_INTERVAL, PERTURBATION),
)

CLAIMS: tuple[Claim, ...] = (
    BRANCH,
    CONSTANT_C1,
    EVERY_POINT,
    NOT_CONVEX,
    UNITS_GAMMA,
    UNITS_L,
    INTERVAL,
    INTERVAL_ONE,
    BOUND,
    BOUND_ONE,
    BOUND_NOISE,
    BOUND_WALK,
    STATIC,
)
