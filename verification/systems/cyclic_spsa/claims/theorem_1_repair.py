"""The repaired Theorem 1, which several decisions put in the place of the printed one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from verification.verdict import Decision, Verdict

from .common import proofs
from .theorem_1_assumptions import relied

Document = dict[str, Any]

PROOF = (
    "theorem_1_mean_step",
    "theorem_1_mean_square",
    "theorem_1_recursion",
    "theorem_1_fixed_point",
    "theorem_1_root",
    "theorem_1_second_branch_repair",
)
"""Steps (i) to (v) of the repaired proof, and that 1 - alpha m is positive."""
REPAIR = (
    "With Assumption 5 for every x and the squared distance, gamma = 3d(M^2 d + c3/(8 beta^2)), m "
    "= 2(mu - alpha gamma) as printed, b and l as below, and 0 < alpha < mu/gamma, the root of the "
    "mean square of the error of a block of d coordinates is in the long run at most the first "
    "formula below; k blocks together, each beside the targets at its own last update, have at "
    "most k^(1/2) times it. Every step of the proof is checked, down to what it relies on."
)
REPAIR_FORMULA = (
    r"\begin{array}{l}"
    r"\frac{b+q+\sqrt{b^2+ml+2qb+q^2(1-\alpha m)}}{m}-2k\delta,\quad q=\frac{2k\delta}\alpha \\"
    r"b=\frac{(2\mu+M)\delta+M\beta d^{3/2}}2+6\alpha d^{5/2}M^2\beta+"
    r"\frac{3\alpha dc_3\delta}{4\beta^2} \\"
    r"l=M\delta^2+6\alpha d^2(c_2+dM^2\beta^2) \\"
    r"\qquad+\frac{3\alpha d}{4\beta^2}\bigl(c_3(\delta^2+d\beta^2)+c_4+c_v^2\bigr)"
    r"\end{array}"
)


def corrected(certificates: Mapping[str, Document], **fields: Any) -> Decision:
    """A claim that the repaired theorem replaces."""
    made = {**certificates, **proofs(*PROOF)}
    return Decision(
        verdict=Verdict.CORRECTED,
        repair=REPAIR,
        repair_formula=REPAIR_FORMULA,
        certificates=made,
        relies_on=relied(made),
        **fields,
    )
