"""How claims about single steps of Algorithm 1, and about a network's limits, are decided."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction

from theory.systems.cyclic_spsa import schedule
from verification.certificates.derivations import Document
from verification.verdict import Decision, Verdict

from .common import column, disproof, proofs, replayed

BLOCKS = 2
STEPS = {"3.3": 3, "3.4": 4, "3.6": 6}


def neighbours() -> Decision:
    """Row and column of C are not the same set."""
    inputs = {"C": [[0, 1], [0, 0]], "a": column((1, 0)), "b": column((0, 1))}
    return Decision(
        verdict=Verdict.REFUTED,
        reason="With one link that carries one way, replayed in integers, the column of the second "
        "sensor holds the first one, to which it cannot speak. The letter j is bound in the set "
        "and means the sensor outside, and k counts blocks elsewhere; with symmetric C the sets "
        "agree once the letters are changed.",
        printed="{j : c_jk > 0}",
        sharp="{k : c_jk > 0} for sensor j",
        margin_text="another letter; one-way links change the set",
        certificates=replayed("section_3_neighbours", inputs),
    )


def feasible() -> Decision:
    """The smallest number of blocks is the number of targets over the limit, rounded up."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="Blocks that are full but for one do it, and k blocks hold at most k m_max targets, "
        "as identities for all numbers; so the least k is N/m_max rounded up. With k given and "
        "smaller than that no such blocks exist, and a target that neither the sensor nor a "
        "neighbour sees fits into none.",
        printed="blocks exist",
        sharp="from k = N/m_max on, rounded up",
        margin_text="k has to be large enough",
        certificates=proofs("eq_17_feasible", "eq_17_feasible_needed"),
    )


def sender() -> Decision:
    """The place of the sensor that measured belongs to the measurement."""
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Put at the receiver, the neighbour's exact angle and distance give a place that is "
        "off by where the two sensors stand, as an identity: between sensors some 100 km apart, by "
        "100 km.",
        printed="s of the receiver",
        sharp="s of the sender",
        margin_text="off by the distance of the two sensors",
        repair="With the place of the sensor that measured, the position is right; so a message "
        "has to carry place, measurement and variance, or the computed position.",
        repair_formula=r"\varphi^{-1}(s^q,z^{i,q})=r^i",
        certificates=disproof("eq_20_sender") | proofs("eq_20_sender_repair"),
    )


def _read_too_early(step: str) -> schedule.Missing:
    """What the printed step reads before it is assigned, in the first cycle."""
    found = schedule.unassigned(schedule.PRINTED, BLOCKS, 1)
    return next(missing for missing in found if missing.step == step)


def first_cost() -> Decision:
    """The measurement of t comes two steps later."""
    missing = _read_too_early("3.4")
    early = {"needed": STEPS["3.4"], "known": STEPS["3.6"]}
    late = {"needed": STEPS["3.4"], "known": STEPS["3.3"]}
    repair = replayed("algorithm_1_first_cost_repair", late, "PROVED")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"A run through the steps finds that step 3.4 reads {missing.name}({missing.of}) "
        "before step 3.6 gets it. Both ways out are followed from here on: f_{t-1} in its place "
        "(two instants), or step 3.4 after 3.6 (one instant). They are different algorithms with "
        "different limits of the step.",
        printed="f_t at step 3.4",
        sharp="f_{t-1}, or f_t after step 3.6",
        margin_text="two steps too early",
        repair="With f_{t-1} every step reads what an earlier one assigned; so it does with f_t if "
        "step 3.4 waits for step 3.6.",
        repair_formula=r"y_{t-1}^-\leftarrow f_{t-1}(x_{t-1})",
        certificates=replayed("algorithm_1_first_cost", early) | repair,
    )


def second_cost() -> Decision:
    """No step computes y+."""
    missing = _read_too_early("3.7")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"A run through the steps finds {missing.name} read in steps 3.7 and 3.8 and "
        "assigned in none; any value satisfies the printed steps, and two values lead to two "
        "estimates, as an identity.",
        printed="the formula of step 3.8",
        sharp="y+ = f_t(x_t)",
        margin_text="one assignment is missing",
        repair="With y+ = f_t(x_t) the next estimate is determined.",
        repair_formula=r"y_t^+\leftarrow f_t(x_t)",
        certificates=disproof("algorithm_1_second_cost") | proofs("algorithm_1_second_cost_repair"),
    )


def previous() -> Decision:
    """Estimates have even instants."""
    missing = _read_too_early("3.9")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"A run through the steps finds the estimate of {missing.of} read at t = "
        f"{missing.t} and assigned by no step: t is even, by the printed clock and by the repaired "
        "one, and t - 1 is odd.",
        printed="index t - 1",
        sharp="index t - 2",
        margin_text="one instant",
        repair="The estimate before is that of t - 2.",
        repair_formula=r"\hat\theta_t\leftarrow\hat\theta_{t-2}-\alpha\hat\nabla_t",
        certificates=disproof("algorithm_1_previous") | proofs("algorithm_1_previous_repair"),
    )


def inactive_active() -> Decision:
    """Costs that do not contain a coordinate do not see it."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="With AA = A the quadratic cost of the active targets is the same at Ax and at x, "
        "as an identity for any Hessian.",
        printed="zeros elsewhere",
        sharp="anything elsewhere",
        margin_text="identical",
        certificates=proofs("algorithm_1_inactive_active"),
    )


FAR, SPREAD, PERTURBED = Fraction(300), Fraction(15), Fraction(3, 100)
"""Section 5 in km: a target across the square, 5 % of that, and the size of the perturbation."""


def _added(name: str) -> tuple[dict[str, Document], Fraction, tuple[tuple[str, ...], ...]]:
    """Certificate of what an inactive coordinate adds, its mean square, and the four outcomes."""
    rows = [("second measurement", "first measurement", "added to the quotient", "probability")]
    squares = Fraction(0)
    for later in (FAR + SPREAD, FAR - SPREAD):
        for earlier in (FAR + SPREAD, FAR - SPREAD):
            extra = (later**2 - earlier**2) / (4 * PERTURBED)
            squares += extra**2 / 4
            rows.append((str(later), str(earlier), str(extra), "1/4"))
    inputs = {"h": 1, "beta": PERTURBED, "r": FAR, "d": SPREAD, "n": squares}
    return replayed(name, inputs), squares, tuple(rows)


def inactive_same() -> Decision:
    """What is the same in both costs cancels."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="Without terms across targets, as in (20), the difference of two costs with the "
        "same measured positions is that of the active targets alone, as an identity for any two "
        "points.",
        printed="nothing is added",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("algorithm_1_inactive_same"),
    )


def inactive_observed() -> Decision:
    """Far targets that nobody estimates drown the pseudogradient."""
    files, square, rows = _added("algorithm_1_inactive_observed")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="One coordinate of one inactive target 300 km away, whose measurements err by +-15 "
        f"km, adds to the difference quotient a term of mean zero and of {math.sqrt(square):.0f} "
        "km in the root mean square at beta = 0.03 km, replayed in rationals for four outcomes of "
        "probability 1/4.",
        printed="nothing is added",
        sharp="(h r d/beta)^2/2 for each coordinate",
        margin_text="grows as the square of distance over beta",
        repair="If (20) has the active targets alone, nothing is added, whatever stands at the "
        "other coordinates.",
        repair_formula=r"f_t(x)=\frac K{2n}\sum_{i\in I_u}\lVert\varphi^{-1}(s,z^i)-x^i\rVert^2/"
        r"(\sigma^i)^2",
        certificates=files | proofs("algorithm_1_inactive_active"),
        replay=rows,
    )


def blocks() -> Decision:
    """A target is one summand of the cost."""
    files, square, _ = _added("eq_15_blocks")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="A block that has one coordinate of a target sets the other to 0, and the target's "
        "summand in (20) then carries that coordinate's whole distance: at 300 km with errors of "
        f"+-15 km it adds {math.sqrt(square):.0f} km in the root mean square to the quotient, "
        "replayed in rationals: with two instants its two measurements differ, and with one it "
        "would drop out.",
        printed="any partition",
        sharp="blocks of whole targets",
        margin_text="one more condition",
        repair="With blocks of whole targets, which are the targets of (20) at that time, the cost "
        "does not see the other coordinates.",
        repair_formula=r"I_u=\bigcup_{i\in M_u}\{2i-1,2i\}",
        certificates=files | proofs("algorithm_1_inactive_active"),
    )


def cheap() -> Decision:
    """A sum over blocks is a sum over coordinates."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="Summed over the blocks of a cycle, a for each active coordinate and b for each "
        "pair make at most (a + b) d, as an identity; the same sum counts the numbers kept. The "
        "constants a and b depend on neither the network nor the other targets.",
        printed="efficient",
        sharp="at most (a + b) d a cycle",
        margin_text="linear",
        certificates=proofs("section_6_cheap"),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "cyclic_spsa.eq_15_blocks": blocks,
    "cyclic_spsa.section_3_neighbours": neighbours,
    "cyclic_spsa.eq_17_feasible": feasible,
    "cyclic_spsa.eq_20_sender": sender,
    "cyclic_spsa.algorithm_1_first_cost": first_cost,
    "cyclic_spsa.algorithm_1_second_cost": second_cost,
    "cyclic_spsa.algorithm_1_previous": previous,
    "cyclic_spsa.algorithm_1_inactive_active": inactive_active,
    "cyclic_spsa.algorithm_1_inactive_observed": inactive_observed,
    "cyclic_spsa.algorithm_1_inactive_same": inactive_same,
    "cyclic_spsa.section_6_cheap": cheap,
}
