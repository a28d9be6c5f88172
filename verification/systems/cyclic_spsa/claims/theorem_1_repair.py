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
    "With Assumption 5 for every x and the squared distance, gamma = 3d(M^2 d + c3/(8 beta^2)) and "
    "0 < alpha < mu/gamma, the root of the mean square of the error of a block tends to at most "
    "[b + 2k delta/alpha + (b^2 + m l + 4k delta b/alpha + (2k delta/alpha)^2 (1 - alpha m))^(1/2)]"
    "/m - 2k delta, with b and l as repaired; all steps of the proof are checked."
)
REPAIR_FORMULA = (
    r"\frac{b+\frac{2k\delta}\alpha+\sqrt{b^2+ml+\frac{4k\delta b}\alpha+"
    r"\bigl(\frac{2k\delta}\alpha\bigr)^2(1-\alpha m)}}{m}-2k\delta,\quad"
    r"\gamma=3d\Bigl(M^2d+\frac{c_3}{8\beta^2}\Bigr)"
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
