"""Claims about the consensus laws and their start."""

from __future__ import annotations

from ....claims import Claim
from .assumptions import CONNECTED, INCLUSION, START

SYSTEM = "bearing_dac"

COMPACT = Claim(
    id="bearing_dac.section_3_compact",
    system=SYSTEM,
    source="George, dynamic average consensus, displays 1 and 2",
    title="The compact law is the law of each sensor",
    statement="Row i of B sgn(B'x) is the sum over the neighbours j of sgn(x_i - x_j), for each of "
    "the six entries, however the links are directed in B.",
    formula=r"\dot w = -\beta (\mathcal{B}\otimes I_6)\operatorname{sgn}\{"
    r"(\mathcal{B}^\top\otimes I_6) x\}",
    sense="equality",
    assumes=(CONNECTED,),
)

ERROR = Claim(
    id="bearing_dac.section_3_error",
    system=SYSTEM,
    source="George, dynamic average consensus, display 4",
    title="The error of consensus is w plus the signal without its mean",
    statement="x~ = x - 1 (average of phi) equals w + M phi; Lemma 2 is not needed for it.",
    formula=r"\tilde x = w + (M \otimes I_6)\phi",
    sense="equality",
    assumes=(CONNECTED,),
)

KEPT = Claim(
    id="bearing_dac.algorithm_1_start",
    system=SYSTEM,
    source="George, Algorithm 1, line 1",
    title="Internal states that start at zero keep the mean at the average",
    statement="If w(t0) = 0, the mean of the x_i is the average of the phi_i at all times.",
    formula=r"w(t_0) = 0 \implies \mathbf{1}^\top x(t) = \mathbf{1}^\top \phi(t)",
    sense="property",
    assumes=(CONNECTED, START, INCLUSION),
)

NEEDED = Claim(
    id="bearing_dac.algorithm_1_start_needed",
    system=SYSTEM,
    source="George, Theorem 1 and Algorithm 1, line 1",
    title="Every internal state has to start at zero",
    statement="Agreement on the average needs w(t0) = 0. (Reading: the condition is needed.)",
    formula=r"w(t_0) = 0",
    sense="property",
    assumes=(CONNECTED, INCLUSION),
    printed="w(t0) = 0",
)

CLAIMS: tuple[Claim, ...] = (COMPACT, ERROR, KEPT, NEEDED)
