"""Claims about what the sensors average, and about how fast it changes."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import APART, CONNECTED, CROSSING, EXACT, FIXED, INCLUSION, START

SYSTEM = "bearing_dac"

AVERAGES = Claim(
    id="bearing_dac.section_2_averages",
    system=SYSTEM,
    source="George, distributed algorithm, displays 1 and 2",
    title="The position follows from two averages over the sensors",
    statement="p* is the inverse of the average of P_i = h_i h_i' times the average of "
    "q_i = z_i h_i.",
    formula=r"p^* = \left(\tfrac1n\sum_i P_i\right)^{-1} \tfrac1n\sum_i q_i",
    sense="equality",
    assumes=(CROSSING,),
)

ENTRIES = Claim(
    id="bearing_dac.section_2_entries",
    system=SYSTEM,
    source="George, distributed algorithm, displays 3 and 4",
    title="Six numbers for each sensor carry all that is averaged",
    statement="phi_i holds the four entries of P_i and the two of q_i, and the averages of P and q "
    "are those of these six.",
    formula=r"\phi_i = \begin{bmatrix} \operatorname{vec}(P_i) \\ q_i \end{bmatrix} \in "
    r"\mathbb{R}^6",
    sense="upper",
    assumes=(CONNECTED, START, INCLUSION),
    printed="6",
)

BOUNDED = Claim(
    id="bearing_dac.assumption_2_exists",
    system=SYSTEM,
    source="George, Assumption 2",
    title="Some bound limits the rate of what is averaged, however the target moves",
    statement="There is a gamma that bounds the rates of all entries of P_i and q_i for a target "
    "of bounded speed. (Reading: gamma is a constant of the sensors, chosen before the target is "
    "known.)",
    formula=r"\sup_t \lVert\dot\phi_i(t)\rVert_\infty \le \gamma < \infty",
    sense="upper",
    assumes=(APART, EXACT, FIXED),
    printed="gamma exists",
)

CLAIMS: tuple[Claim, ...] = (AVERAGES, ENTRIES, BOUNDED)
