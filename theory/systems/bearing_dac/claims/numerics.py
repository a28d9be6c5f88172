"""Claims about the simulated parameters and about discrete time."""

from __future__ import annotations

from ....claims import Assumption, Claim
from .assumptions import CONNECTED, INCLUSION, PULLED, RATE, START

SYSTEM = "bearing_dac"
FIVE = Assumption("A18", "there are at most 5 sensors, and lambda_2 is at least 0.4")
STEPS = Assumption("A19", "the step h is any positive number")

EXAMPLE = Claim(
    id="bearing_dac.example_gain",
    system=SYSTEM,
    source="George, numerical results: gamma = 100, n^ = 5, lambda2^ = 0.4",
    title="The gain of the simulation, 560.02, is large enough",
    statement="With gamma = 100 the gain 1 + 100 sqrt(5)/0.4 = 560.02 gives agreement on every "
    "connected network of at most five sensors with lambda_2 of at least 0.4.",
    formula=r"\beta = 1 + 100\,\frac{\sqrt 5}{0.4} = 560.02",
    sense="threshold",
    assumes=(RATE, CONNECTED, START, INCLUSION, FIVE),
    printed="560.02",
)

EXPLICIT = Claim(
    id="bearing_dac.section_5_discrete_explicit",
    system=SYSTEM,
    source="George, conclusion, point 3",
    title="With an explicit step the sensors agree in finite time as well",
    statement="x+ = x - h beta B sgn(B'x), plus what changed, reaches agreement and stays there. "
    "(Reading: the extension to discrete time is Euler's explicit step.)",
    formula=r"\tilde x_{k+1} = \tilde x_k - h\beta\mathcal{B}\operatorname{sgn}"
    r"(\mathcal{B}^\top \tilde x_k) + h M u_k",
    sense="property",
    assumes=(CONNECTED, START, STEPS),
    printed="agreement",
)

IMPLICIT = Claim(
    id="bearing_dac.section_5_discrete_implicit",
    system=SYSTEM,
    source="George, conclusion, point 3",
    title="With an implicit step the sensors agree in finitely many steps",
    statement="With signs taken at the end of the step, agreement is kept at the same gains as in "
    "continuous time and reached within |x~|/(h r) steps, rounded up, for every step h. "
    "(Reading: the extension to discrete time is the implicit step.)",
    formula=r"\tilde x_{k+1} \in \tilde x_k - h\beta\mathcal{B}\operatorname{SGN}"
    r"(\mathcal{B}^\top \tilde x_{k+1}) + h M u_k",
    sense="property",
    assumes=(RATE, CONNECTED, START, PULLED, STEPS),
)

CLAIMS: tuple[Claim, ...] = (EXAMPLE, EXPLICIT, IMPLICIT)
