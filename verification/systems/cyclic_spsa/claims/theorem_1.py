"""How the claims about Theorem 1 are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from theory.systems.cyclic_spsa.bounds import PRINTED
from verification.verdict import Decision, Verdict

from ..printed.claim_figures import limit, steps_over_perturbations
from ..printed.looseness import Case
from ..printed.promises import promised
from . import theorem_1_assumptions, theorem_1_bound
from .common import limit_document, proofs, replayed
from .theorem_1_assumptions import relied
from .theorem_1_repair import PROOF, corrected

FAST: Mapping[str, Fraction] = {
    "alpha": Fraction(1, 5),
    "beta": Fraction(3, 100),
    "delta": Fraction(1),
}
NOISY: Mapping[str, Fraction] = {"alpha": Fraction(1, 20), "beta": Fraction(1, 100)}
START, GROWTH = Fraction(2), Fraction(3, 2)


def interval() -> Decision:
    """Drift alone, then noise alone, makes the error grow inside the printed interval."""
    drift = promised(FAST)
    noise = promised({**NOISY, "c2": 1})
    every = promised(
        {**FAST, "alpha": Fraction(9, 1000), "c3": Fraction(21, 20), "c4": Fraction(6)}
    )
    at = Case(1, FAST["alpha"], FAST["beta"], Fraction(0), FAST["delta"])
    _, document = limit_document(at.block())
    made = {
        "cyclic_spsa.theorem_1_interval_limit": document,
        **replayed("theorem_1_interval", {**drift, "start": START, "growth": GROWTH}),
        **replayed("theorem_1_interval_noise", {**noise, "growth": Fraction(13)}),
        **replayed("theorem_1_interval_every_point", {**every, "growth": multiplier(every)}),
    }
    sharp, printed = exact_limit(FAST), drift["limit"]
    return corrected(
        made,
        reason="For f_t(x) = (x - t)^2/2 without noise, beta = 3/100 and alpha = 1/5 < mu/gamma = "
        f"{printed}, every path from a distance of 2 on grows by half in each step, whichever sign "
        f"the perturbation has, while (21) promises {float(drift['bound']):.5g}. The same happens "
        "with noise and no drift (the mean square grows 13 times in each step), and with "
        f"Assumption 5 met at every point. In the mean square the limit of the step is {sharp}, by "
        "a certificate. What differs between two instants is divided by beta and multiplies "
        "the error; the printed analysis has no such term.",
        printed=f"alpha < {printed} in the example",
        sharp=f"alpha < {sharp} in the example",
        printed_value=float(printed),
        sharp_value=float(sharp),
        margin_text=f"{float(printed / sharp):.3g} times too large in the example",
        replay=shortest_path(FAST, START),
        figure=steps_over_perturbations(at),
    )


def multiplier(given: Mapping[str, Fraction]) -> Fraction:
    """Mean factor of the squared error in a step for d = 1, mu = M = 1, with drift alone."""
    alpha, beta, delta = (given[name] for name in ("alpha", "beta", "delta"))
    return (1 - alpha) ** 2 + (alpha * delta / (2 * beta)) ** 2


def exact_limit(given: Mapping[str, Fraction]) -> Fraction:
    """The step from which that factor is no longer below 1."""
    alpha, beta, delta = (given[name] for name in ("alpha", "beta", "delta"))
    return Case(1, alpha, beta, Fraction(0), delta).limit


def shortest_path(given: Mapping[str, Fraction], y: Fraction) -> tuple[tuple[str, ...], ...]:
    """The error that grows most slowly: in each step the sign that leaves it smaller."""
    alpha, beta, delta = (given[name] for name in ("alpha", "beta", "delta"))
    rows = [("step", "sign of Delta", "distance from the middle of the two targets")]
    rows.append(("0", "", str(y)))
    for step in range(1, 6):
        ends = {s: y - 2 * delta - alpha * y * (1 - s * delta / (2 * beta)) for s in (1, -1)}
        sign = min(ends, key=lambda s: abs(ends[s]))
        y = ends[sign]
        rows.append((str(step), f"{sign:+d}", f"{y} = {float(y):.6g}"))
    return tuple(rows)


def interval_one_instant() -> Decision:
    """One instant: nothing but the perturbation differs between the two costs."""
    made = proofs(
        "theorem_1_mean_step_at_once",
        "theorem_1_mean_square",
        "theorem_1_recursion",
        "theorem_1_fixed_point",
        "theorem_1_second_branch_repair",
    )
    return Decision(
        verdict=Verdict.PROVED,
        reason="With one instant the two costs differ by the perturbation and the additive noise "
        "alone: the mean step is bounded by less than with two, and c3 and c4 need not be there. "
        "The mean square after a step is then at most (1 - alpha m)q^2 + 2 alpha b q + alpha l "
        "with m = 2(mu - 3 alpha d^2 M^2) > 0, q the root of that before it plus the drift of a "
        "cycle, and this has a fixed point that attracts from above.",
        printed="mu/gamma, gamma = 3d(M^2 d + c3/beta)",
        sharp="at least mu/(3 d^2 M^2)",
        margin_text="c3 need not be there",
        relies_on=relied(made),
        certificates=made,
    )


def static() -> Decision:
    """Where nothing changes between the instants the printed constants are large enough."""
    still = Case(3, Fraction(1, 27), Fraction(1), Fraction(0), Fraction(0))
    printed, (sharp, document) = limit(PRINTED, still.constants()), limit_document(still.block())
    made = proofs("theorem_1_static", *PROOF)
    made |= {"cyclic_spsa.theorem_1_bound_static_limit": document}
    return Decision(
        verdict=Verdict.PROVED,
        reason="With delta = c2 = c3 = c4 = c_v = 0 the printed m is that of the repaired proof, "
        "and the printed b and l are not below its b and l, for all constants; the bound grows "
        "with both. The interval is safe and short: for mu = M = h the error of d coordinates "
        "stays bounded below alpha = 2/(h d), for d = 3 and h = 1 by a certificate of the limit "
        f"{still.limit} beside the printed {printed}.",
        printed="alpha < 1/(3 d^2 h) for mu = M = h",
        sharp="alpha < 2/(h d)",
        printed_value=float(printed),
        sharp_value=sharp,
        margin_text="the interval could be 6 d times as long",
        relies_on=relied(made),
        certificates=made,
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    **theorem_1_assumptions.DECISIONS,
    "cyclic_spsa.theorem_1_interval": interval,
    "cyclic_spsa.theorem_1_interval_one_instant": interval_one_instant,
    **theorem_1_bound.DECISIONS,
    "cyclic_spsa.theorem_1_bound_static": static,
}
