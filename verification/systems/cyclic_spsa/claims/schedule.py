"""How claims about the cycle, its instants and lags, are decided; those on steps follow."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from theory.systems.cyclic_spsa import schedule
from verification.verdict import Decision, Verdict

from ..printed.schedule_figures import age_of_the_base, blocks_over_time, lag_of_steps
from . import steps
from .common import disproof, proofs, replayed

BLOCKS, CYCLES = 2, 5
"""The smallest cycle in which the printed schedule fails, and enough rounds of it to see how."""


def decreasing() -> Decision:
    """The smaller the step, the larger the lag."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="In the mean, with Delta independent of the rest, each coordinate's error loses "
        "alpha h times itself and the drift c = 2k eta between updates. Once alpha is below c/(2 h "
        "B) every error above -B falls by c/2 at each update, an identity, so it passes -B, for "
        "every B. A constant step lags by c/(alpha h) for ever.",
        printed="steps must not decrease",
        sharp="lag 2k eta/(alpha h)",
        margin_text="identical; the lag has a value",
        certificates=proofs("section_3_decreasing", "section_3_decreasing_constant"),
        figure=lag_of_steps(0.1, 80),
    )


def active_index() -> Decision:
    """The printed index changes within pairs."""
    rows = [("t", "pair u", "(t mod 2k) div 2", "((t - 1) mod 2k) div 2 + 1")]
    for pair in schedule.pairs(BLOCKS, 1):
        rows += [
            (
                str(t),
                str(pair.block),
                str(schedule.printed_active(BLOCKS, t)),
                str(schedule.active(BLOCKS, t)),
            )
            for t in (pair.t - 1, pair.t)
        ]
    split = schedule.split_pairs(BLOCKS, 1)
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"Enumerated for two blocks, the two measurements of {len(split)} of {BLOCKS} pairs "
        "have different indices; for any k >= 2 the identities show the same for every pair but "
        "the last of each cycle. Their difference quotient would compare costs of different "
        "targets.",
        printed="(t mod 2k) div 2",
        sharp="((t - 1) mod 2k) div 2 + 1",
        margin_text="late by half a pair",
        repair="((t - 1) mod 2k) div 2 + 1 is u at both instants of pair u, for all k, T and u.",
        repair_formula=r"u=\bigl((t-1)\bmod 2k\bigr)\div 2+1",
        certificates=disproof("section_3_active_index") | proofs("section_3_active_index_repair"),
        replay=tuple(rows),
        figure=blocks_over_time(BLOCKS, 2),
    )


def shift() -> Decision:
    """The printed lags belong to no block."""
    wrong = [
        u
        for u in range(1, BLOCKS + 1)
        if schedule.printed_lag(BLOCKS, u) != schedule.lag(BLOCKS, u)
    ]
    u = wrong[0]
    inputs = {"k": BLOCKS, "T": 1, "u": u, "l": schedule.lag(BLOCKS, u)}
    rows = [("blocks k", "block u", "printed lag u(2k - 2)", "lag 2(k - u)")]
    rows += [
        (str(k), str(b), str(schedule.printed_lag(k, b)), str(schedule.lag(k, b)))
        for k in (1, 2, 3)
        for b in range(1, k + 1)
    ]
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"With two blocks, block {u} is updated at the very end of the cycle, and the "
        f"printed shift goes back {schedule.printed_lag(BLOCKS, u)} instants, replayed in "
        "integers; the lags agree for the first block of a cycle only.",
        printed="u (2k - 2)",
        sharp="2 (k - u)",
        printed_value=float(schedule.printed_lag(BLOCKS, u)),
        sharp_value=float(schedule.lag(BLOCKS, u)),
        margin_text="4 instants at k = 2, 12 at k = 3",
        repair="At the end of a cycle block u was updated 2(k - u) instants before, for all k, T "
        "and u: a shift by 2 to the power k - u.",
        repair_formula=r"\mathcal A\theta_t=\sum_{u=1}^kA_u\,\theta_{t-2(k-u)},\qquad t=2kT",
        certificates=replayed("section_3_shift", inputs) | proofs("section_3_shift_repair"),
        replay=tuple(rows),
    )


def clock() -> Decision:
    """Cycles overlap."""
    one, two = schedule.clashes(BLOCKS, CYCLES)[0]
    inputs = {"k": BLOCKS, "T": one.cycle, "S": two.cycle, "u": one.block, "v": two.block}
    rows = [("cycle T", "pair u", "printed 2T + 2u", "2k(T - 1) + 2u")]
    rows += [
        (str(pair.cycle), str(pair.block), str(schedule.printed_clock(pair)), str(pair.t))
        for pair in schedule.pairs(BLOCKS, 3)
    ]
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"With two blocks, pair {one.block} of cycle {one.cycle} and pair {two.block} of "
        f"cycle {two.cycle} both have t = {schedule.printed_clock(one)}, replayed in integers: "
        "cycles overlap as soon as there are two blocks, and t starts at 4.",
        printed="2T + 2u",
        sharp="2k(T - 1) + 2u",
        margin_text="cycles overlap for k >= 2",
        repair="With 2k(T - 1) + 2u each pair is at least 2 instants after each earlier one, for "
        "all k, T and u.",
        repair_formula=r"t\leftarrow 2k(T-1)+2u",
        certificates=replayed("algorithm_1_clock", inputs) | proofs("algorithm_1_clock_repair"),
        replay=tuple(rows),
    )


def base_point() -> Decision:
    """The base ages with every cycle."""
    old = schedule.stale(BLOCKS, CYCLES)
    first = old[0]
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Enumerated for two blocks, with cycles counted from 0 so that the index fits for "
        f"one block: the base of t = {first.t} is the estimate of {schedule.printed_base(first)}, "
        f"and block {first.block} was updated at {first.t - 2 * BLOCKS}. For any k >= 2 the "
        "identity shows the same from the third cycle on, and the base falls behind for ever.",
        printed="index 2T",
        sharp="index t - 2",
        margin_text="older by 2(k - 1) instants with every cycle",
        repair="The estimate of t - 2 holds the newest value of the active block, and so does that "
        "of the start of the cycle, for all k, T and u.",
        repair_formula=r"x_{t-1}=\hat\theta_{t-2}-\beta\Delta_T,\qquad "
        r"x_t=\hat\theta_{t-2}+\beta\Delta_T",
        certificates=disproof("algorithm_1_base_point") | proofs("algorithm_1_base_point_repair"),
        figure=age_of_the_base(BLOCKS, CYCLES),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "cyclic_spsa.section_3_decreasing": decreasing,
    "cyclic_spsa.section_3_active_index": active_index,
    "cyclic_spsa.section_3_shift": shift,
    "cyclic_spsa.algorithm_1_clock": clock,
    "cyclic_spsa.algorithm_1_base_point": base_point,
    **steps.DECISIONS,
}
