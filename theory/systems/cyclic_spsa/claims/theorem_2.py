"""Claims about Theorem 2 and its proof."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import PERTURBATION, TWO_INSTANTS
from .theorem_assumptions import (
    EVERY_POINT,
    IN_INTERVAL,
    INDEPENDENT_NOISE,
    SPEEDS,
    WEIGHTS,
)

SYSTEM = "cyclic_spsa"
APPENDIX = "Erofeeva & Granichin, appendix A, proof of Theorem 2"


def _claim(
    part: str,
    source: str,
    title: str,
    statement: str,
    formula: str,
    sense: str,
    printed: str,
    assumes: tuple[Assumption, ...] = (WEIGHTS, INDEPENDENT_NOISE),
) -> Claim:
    return Claim(
        id=f"cyclic_spsa.theorem_2_{part}",
        system=SYSTEM,
        source=source,
        title=title,
        statement=statement,
        formula=formula,
        sense=sense,
        assumes=assumes,
        printed=printed,
    )


GRADIENT = _claim(
    "gradient",
    f"{APPENDIX}, first display",
    "The derivative of the mean cost is K x/(2 n sigma^2) - r, summed over the targets",
    "The derivative of the mean cost with respect to a coordinate of target i is a sum over all "
    "targets of K x/(2 n sigma^2) - r.",
    r"\frac{\partial F}{\partial x^{i,l}}=\sum_i\frac{Kx^{i,l}}{2n\sigma_i^2}-r^{i,l}",
    "equality",
    "K x/(2 n sigma^2) - r",
)
MU = _claim(
    "mu",
    f"{APPENDIX}, Assumption 1",
    "Assumption 1 holds with mu = K/(2 n max sigma^2)",
    "For the targets of the block the mean cost meets Assumption 1 with this mu.",
    r"\mu^j=\frac{K}{2n\max_{i,t}(\sigma_t^{i,j})^2}",
    "lower",
    "K/(2 n max sigma^2)",
)
LIPSCHITZ = _claim(
    "lipschitz",
    f"{APPENDIX}, Assumption 2",
    "Assumption 2 holds with M = K/(2 n min sigma^2)",
    "The gradient of the cost has this Lipschitz constant.",
    r"M^j=\frac{K}{2n\min_{i,t}(\sigma_t^{i,j})^2}",
    "upper",
    "K/(2 n min sigma^2)",
)
GAMMA = _claim(
    "gamma",
    "Erofeeva & Granichin, Theorem 2, gamma, m and b",
    "gamma, m and b of Theorem 2 are those of Theorem 1 for c3 = 0",
    "Put into Theorem 1, the constants of Theorem 2 give the gamma, m and b that it prints.",
    r"\gamma^j=3d^2(M^j)^2",
    "equality",
    "3 d^2 M^2",
)
C1 = _claim(
    "c1",
    f"{APPENDIX}, Assumptions 3, 6 and 7",
    "The mean gradient vanishes at the true positions, and nothing is added to the costs",
    "Assumption 3 holds with c1 = 0 and Assumption 6 with c_v = 0; Assumption 7 holds.",
    r"c_1^j=0,\qquad c_v=0",
    "equality",
    "0",
)
C2 = _claim(
    "c2",
    f"{APPENDIX}, Assumption 3",
    "The mean square of the gradient at the true positions is at most (K/2n) max tr Xi/sigma^2",
    "Assumption 3 holds with this c2.",
    r"c_2^j=\frac{K}{2n}\max_{i,t}\frac{\operatorname{tr}\Xi_t^{i,j}}{(\sigma_t^{i,j})^2}",
    "upper",
    "(K/2n) max tr Xi/sigma^2",
)
C3 = _claim(
    "c3",
    f"{APPENDIX}, Assumption 5",
    "Assumption 5, word for word, holds with c3 = 0",
    "As printed, Assumption 5 bounds a number that does not depend on x, and c3 = 0 serves.",
    r"c_3^j=0",
    "equality",
    "0",
)
C3_EVERY = _claim(
    "c3_every_point",
    f"{APPENDIX}, Assumption 5",
    "With c3 = 0 the change of the cost is bounded at every point x",
    "The mean square of f_t(x) - f_(t-1)(x) is at most the printed c4 at every x.",
    r"E\bigl(f_{w_t}(x)-f_{w_{t-1}}(x)\bigr)^2\le c_4^j\quad\text{for every }x",
    "upper",
    "c3 = 0",
    (WEIGHTS, INDEPENDENT_NOISE, EVERY_POINT),
)
C4 = _claim(
    "c4",
    f"{APPENDIX}, last display",
    "The mean square of the change of the cost at the true positions is at most the printed c4",
    "Assumption 5 holds with c4 as printed, from the fourth moment M_4 of the noise.",
    r"c_4^j=\max_t\frac K{2n}\sum_i\Bigl(\frac{M_4}{(\sigma_t^{i,j})^4}+"
    r"\frac{M_4}{(\sigma_{t-1}^{i,j})^4}-2\Bigr)",
    "upper",
    "(K/2n) sum (M_4/sigma^4 + M_4/sigma^4 - 2)",
)
DRIFT = _claim(
    "drift",
    f"{APPENDIX}, Assumption 4",
    "All targets together move in a sample by at most k times the largest sum of their speeds",
    "Assumption 4 holds with delta_theta = k max sum delta_i.",
    r"\delta_\theta^j=k^j\max_t\sum_{i\in M_t^j}\delta_t^i",
    "upper",
    "k sum delta_i",
    (SPEEDS,),
)
L_BAR = _claim(
    "l",
    "Erofeeva & Granichin, Theorem 2, l-bar",
    "l-bar of Theorem 2 is that of Theorem 1 with the constants of Theorem 2",
    "Put into Theorem 1, the constants of Theorem 2 give the l-bar that it prints.",
    r"\begin{array}{l}\bar l^j=6d\tfrac\alpha\beta c_4 \\"
    r"\quad+6d^2\bigl(c_2+M^2(\delta_\theta+2\beta\sqrt d)^2+2\delta_\theta(\dots)\bigr)"
    r"\end{array}",
    "equality",
    "6 d^2(c2 + ... + 2 delta(...))",
)
INTERVAL = _claim(
    "interval",
    "Erofeeva & Granichin, Theorem 2",
    "With a step in the interval of Theorem 2 the error of a target at rest stays bounded",
    "For every step between 0 and mu/gamma the error stays bounded in the mean square, if the "
    "costs of a step are measured at two instants.",
    r"0<\alpha^j<\frac{\mu^j}{\gamma^j}\ \Rightarrow\ "
    r"\limsup E\lVert\hat\theta_t-\theta_t\rVert^2<\infty",
    "threshold",
    "mu/gamma",
    (WEIGHTS, INDEPENDENT_NOISE, PERTURBATION, TWO_INSTANTS),
)
BOUND = _claim(
    "bound",
    "Erofeeva & Granichin, Theorem 2",
    "The error of a moving target is at most the bound of Theorem 2",
    "In the long run the root of the mean square of the error is at most the bound of Theorem 2.",
    r"\limsup\sqrt{E\lVert\hat\theta_t-\theta_t\rVert^2}\le"
    r"\frac{\sqrt{k^j}(b^j+\sqrt{(b^j)^2+m^jl^j})}{m^j}",
    "upper",
    "the bound of Theorem 2",
    (WEIGHTS, INDEPENDENT_NOISE, PERTURBATION, SPEEDS, IN_INTERVAL, TWO_INSTANTS),
)

CLAIMS: tuple[Claim, ...] = (
    GRADIENT,
    MU,
    LIPSCHITZ,
    GAMMA,
    C1,
    C2,
    C3,
    C3_EVERY,
    C4,
    DRIFT,
    L_BAR,
    INTERVAL,
    BOUND,
)
