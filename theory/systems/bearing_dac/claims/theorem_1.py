"""Claims about gain, time and start of Theorem 1."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import CLASSICAL, CONNECTED, INCLUSION, LACKING, RATE, START

SYSTEM = "bearing_dac"

GAIN = Claim(
    id="bearing_dac.theorem_1_gain",
    system=SYSTEM,
    source="George, Theorem 1",
    title="A gain of one plus gamma times the root of n over lambda_2 always gives agreement",
    statement="With beta >= 1 + gamma sqrt(n)/lambda_2, the error of consensus reaches zero in "
    "finite time and stays there, from every start and for every admissible disturbance. (The "
    "printed bounds on n and lambda_2 only make beta larger.)",
    formula=r"\beta \ge 1 + \gamma \frac{\sqrt{n}}{\lambda_2}",
    sense="threshold",
    assumes=(RATE, CONNECTED, START, INCLUSION),
    printed="1 + gamma sqrt(n)/lambda_2",
)

TIME = Claim(
    id="bearing_dac.theorem_1_time",
    system=SYSTEM,
    source="George, Theorem 1",
    title="Agreement is reached within the norm of the start over lambda_2",
    statement="With beta >= 1 + gamma sqrt(n)/lambda_2, the error of consensus is zero from the "
    "time t0 + |x(t0)|/lambda_2 on.",
    formula=r"\tilde{x}(t) = 0 \quad \text{for } t \ge t_0 + \frac{\|x(t_0)\|_2}{\lambda_2}",
    sense="upper",
    assumes=(RATE, CONNECTED, START, INCLUSION),
    printed="|x(t0)|/lambda_2",
)

STAYS = Claim(
    id="bearing_dac.theorem_1_stays_filippov",
    system=SYSTEM,
    source="George, Theorem 1",
    title="Once reached, agreement is kept at a tie by signs between -1 and 1",
    statement="At the gain gamma sqrt(n/lambda_2) or above, an error of zero stays zero, whatever "
    "the disturbance. (Reading: solutions in Filippov's sense.)",
    formula=r"\tilde{x}(t) = 0 \quad \text{for all } t \ge t^*",
    sense="property",
    assumes=(RATE, CONNECTED, START, INCLUSION),
)

STAYS_CLASSICAL = Claim(
    id="bearing_dac.theorem_1_stays_classical",
    system=SYSTEM,
    source="George, Theorem 1 with line 9 of Algorithm 1",
    title="Once reached, agreement is kept with sgn(0) = 0",
    statement="An error of zero stays zero while line 9 holds as printed, with sgn(0) = 0. "
    "(Reading: a classical solution.)",
    formula=r"\tilde{x}(t) = 0 \quad \text{for all } t \ge t^*",
    sense="property",
    assumes=(RATE, CONNECTED, START, CLASSICAL),
)

ESTIMATES = Claim(
    id="bearing_dac.theorem_1_estimates",
    system=SYSTEM,
    source="George, Theorem 1",
    title="Estimates of n from above and of lambda_2 from below only raise the gain",
    statement="With n^ >= n and lambda2^ <= lambda_2, 1 + gamma sqrt(n^)/lambda2^ is at least "
    "1 + gamma sqrt(n)/lambda_2. (Reading: the printed condition bounds the estimate.)",
    formula=r"\hat\lambda_2 \le \lambda_2(L)",
    sense="lower",
    assumes=(CONNECTED,),
)

ESTIMATES_PRINTED = Claim(
    id="bearing_dac.theorem_1_estimates_printed",
    system=SYSTEM,
    source="George, Theorem 1",
    title="The gain is enough for every positive estimate of lambda_2",
    statement="The condition lambda_2 <= lambda_2(L) is printed about lambda_2 itself, and leaves "
    "the estimate lambda2^ free. (Reading: as printed.)",
    formula=r"\lambda_2 \le \lambda_2(L)",
    sense="threshold",
    assumes=(RATE, CONNECTED, START, INCLUSION),
    printed="any estimate",
)

TIME_START = Claim(
    id="bearing_dac.theorem_1_time_start",
    system=SYSTEM,
    source="George, Theorem 1",
    title="The start in t* is no smaller than the error at the start",
    statement="With w(t0) = 0 the error starts at x(t0) without its mean, so |x(t0)| is at least "
    "|x~(t0)|; it depends on the origin of positions, the error does not.",
    formula=r"\lVert \tilde x(t_0) \rVert \le \lVert x(t_0) \rVert",
    sense="upper",
    assumes=(START,),
)

TIME_OTHERS = Claim(
    id="bearing_dac.theorem_1_time_incomplete",
    system=SYSTEM,
    source="George, Theorem 1",
    title="The printed time holds on every network that lacks a link",
    statement="On a connected graph in which not all pairs are linked, the printed gain gives "
    "agreement within |x(t0)|/lambda_2. (Reading: Theorem 1 without complete graphs.)",
    formula=r"\tilde{x}(t) = 0 \quad \text{for } t \ge t_0 + \frac{\|x(t_0)\|_2}{\lambda_2}",
    sense="upper",
    assumes=(RATE, CONNECTED, START, INCLUSION, LACKING),
)

CLAIMS: tuple[Claim, ...] = (
    GAIN,
    TIME,
    STAYS,
    STAYS_CLASSICAL,
    ESTIMATES,
    ESTIMATES_PRINTED,
    TIME_START,
    TIME_OTHERS,
)
