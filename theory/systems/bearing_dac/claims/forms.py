"""Theorem 1 with the bound on the gain in the forms that its text may have meant."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import CONNECTED, INCLUSION, LARGE, RATE, START

SYSTEM = "bearing_dac"
KEEPS = "keeps agreement whatever the disturbance, and any larger gain reaches it in finite time"
REACHES = "reaches agreement in finite time, within |x(t0)|/sqrt(lambda_2), and keeps it"
GIVEN = (RATE, CONNECTED, START, INCLUSION)

ROOT = Claim(
    id="bearing_dac.theorem_1_form_root",
    system=SYSTEM,
    source="George, Theorem 1",
    title="The root over the whole fraction, without the one, keeps agreement on every network",
    statement=f"On every connected graph the gain gamma sqrt(n/lambda_2) {KEEPS}.",
    formula=r"\beta \ge \gamma \sqrt{\frac{n}{\lambda_2}}",
    sense="threshold",
    assumes=GIVEN,
    printed="gamma sqrt(n/lambda_2)",
)

ROOT_ONE = Claim(
    id="bearing_dac.theorem_1_form_root_one",
    system=SYSTEM,
    source="George, Theorem 1",
    title="One plus the root over the whole fraction gives agreement on every network",
    statement=f"On every connected graph a gain of at least 1 + gamma sqrt(n/lambda_2) {REACHES}.",
    formula=r"\beta \ge 1 + \gamma \sqrt{\frac{n}{\lambda_2}}",
    sense="threshold",
    assumes=GIVEN,
    printed="1 + gamma sqrt(n/lambda_2)",
)

TWICE = Claim(
    id="bearing_dac.theorem_1_form_twice",
    system=SYSTEM,
    source="George, Theorem 1",
    title="Twice gamma over lambda_2 keeps agreement on every network",
    statement=f"On every connected graph the gain 2 gamma/lambda_2 {KEEPS}.",
    formula=r"\beta \ge \frac{2\gamma}{\lambda_2}",
    sense="threshold",
    assumes=GIVEN,
    printed="2 gamma/lambda_2",
)

TWICE_ONE = Claim(
    id="bearing_dac.theorem_1_form_twice_one",
    system=SYSTEM,
    source="George, Theorem 1",
    title="One plus twice gamma over lambda_2 gives agreement on every network",
    statement=f"On every connected graph a gain of at least 1 + 2 gamma/lambda_2 {REACHES}.",
    formula=r"\beta \ge 1 + \frac{2\gamma}{\lambda_2}",
    sense="threshold",
    assumes=GIVEN,
    printed="1 + 2 gamma/lambda_2",
)

PRINTED = Claim(
    id="bearing_dac.theorem_1_form_printed",
    system=SYSTEM,
    source="George, Theorem 1",
    title="The printed gain is right on all networks but the two smallest complete ones",
    statement="On four nodes or more, and on the path of three, gamma sqrt(n)/lambda_2 "
    f"{KEEPS}; with the printed one added it reaches agreement. (Reading: Theorem 1 without two "
    "sensors and without the triangle.)",
    formula=r"\beta \ge 1 + \gamma \frac{\sqrt{n}}{\lambda_2}",
    sense="threshold",
    assumes=(*GIVEN, LARGE),
    printed="1 + gamma sqrt(n)/lambda_2",
)

CLAIMS: tuple[Claim, ...] = (ROOT, ROOT_ONE, TWICE, TWICE_ONE, PRINTED)
