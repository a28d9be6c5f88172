"""What certificates about single steps of Algorithm 1, and about the limits of a network, prove."""

from __future__ import annotations

from ....statements import Case, Statement
from .. import step_identities
from ..universal import Universal

STEPS = dict.fromkeys(("D", "x", "g", "f", "a", "b"), "vector: d") | {
    **dict.fromkeys("yzmc", "real"),
    "alpha": "positive",
    "q": "positive",
}
COSTS = {"A": "symmetric: d", "H": "symmetric: d", **dict.fromkeys("xyq", "vector: d")}
PLACES = dict.fromkeys("ersqpo", "vector: 2") | {"rho": "positive"}
LAGS = {
    **dict.fromkeys(("x", "y", "e", "f", "c"), "real"),
    **dict.fromkeys(("alpha", "h", "B"), "positive"),
    **dict.fromkeys("pw", "nonnegative"),
}
SIZES = dict.fromkeys(("b", "o", "l", "i"), "vector: K") | {
    **dict.fromkeys(("N", "k", "m", "d", "n"), "real"),
    "g": "nonnegative",
}
FULL = {"N": "real", "c": "nonnegative", "m": "positive", "l": "nonnegative", "f": "nonnegative"}
COUNTS = {
    "i": "vector: K",
    "o": "vector: K",
    **dict.fromkeys(("a", "b", "c"), "nonnegative"),
    **dict.fromkeys(("d", "k", "n"), "real"),
}

UNIVERSAL: tuple[Universal, ...] = (
    Universal(
        "algorithm_1_second_cost",
        "steps 3.7 to 3.9 as printed hold for any value of y+: with the values y and z, the "
        "estimates a and b that follow differ by alpha (y - z) Delta/(2 beta), 1/(2 beta) = q, "
        "which is zero only if y = z",
        step_identities.two_costs(),
        STEPS,
        verdict="REFUTED",
    ),
    Universal(
        "algorithm_1_second_cost_repair",
        "with y+ = f_t(x_t) = c in both runs, the estimates a and b that follow are one",
        step_identities.one_cost(),
        STEPS,
    ),
    Universal(
        "algorithm_1_inactive_active",
        "for the matrix A with 1 at active coordinates, AA = A, and a cost of active targets "
        "alone, of the Hessian AHA: it is the same at Ax, where inactive coordinates are zero, and "
        "at x",
        step_identities.inactive(),
        COSTS,
    ),
    Universal(
        "algorithm_1_inactive_same",
        "for the matrix A with 1 at active coordinates and a Hessian H with AH = AHA, all of "
        "observed targets: the cost at Ax less that at Ay, with the same measured q, is the cost "
        "of the active targets at x less that at y",
        step_identities.same_measurement(),
        COSTS,
    ),
    Universal(
        "eq_20_sender",
        "a neighbour at q measures a target at r = q + rho e: the place p = s + rho e that a "
        "sensor at s computes from it is off by s - q, where the two stand",
        step_identities.sender()[:1],
        PLACES,
        verdict="REFUTED",
    ),
    Universal(
        "eq_20_sender_repair",
        "a neighbour at q measures a target at r = q + rho e: the place o = q + rho e, computed "
        "from the neighbour's own place, is r",
        step_identities.sender()[1:],
        PLACES,
    ),
    Universal(
        "section_3_decreasing",
        "along a coordinate with the entry h of H and the drift c between updates, the mean error "
        "goes from e to f = e - alpha h e - c: if the step is so small that 2 alpha h B <= c, B "
        "any bound, an error e >= -B falls by c/2 at least, so that it passes -B",
        step_identities.falling_behind(),
        LAGS,
    ),
    Universal(
        "section_3_decreasing_constant",
        "with a constant step the mean error x at rest has alpha h x = -c",
        step_identities.lagging(),
        LAGS,
    ),
    Universal(
        "eq_17_feasible_needed",
        "k blocks of sizes b, of at most m targets each, hold N = k m - g targets, g >= 0 being "
        "the room left: k >= N/m",
        step_identities.blocks_needed(),
        SIZES,
    ),
    Universal(
        "eq_17_feasible",
        "N = c m + l targets, 0 <= l <= m, fit into c blocks of m and one of l",
        step_identities.blocks_enough(),
        FULL,
    ),
    Universal(
        "section_6_cheap",
        "if a pair of steps takes a operations for each active coordinate, and b besides, and k "
        "<= d blocks of sizes i hold the d coordinates, a cycle takes at most (a + b) d",
        step_identities.operations(),
        COUNTS,
    ),
)


def _refuted(name: str, words: str, show: tuple[str, ...], inputs: dict[str, str]) -> Statement:
    return Statement("cyclic_spsa", name, {"REFUTED": Case("REFUTED", words, show)}, inputs)


def _order(name: str, verdict: str, words: str, *show: str) -> Statement:
    numbers = {"needed": "number", "known": "number"}
    return Statement("cyclic_spsa", name, {verdict: Case(verdict, words, show)}, numbers)


_OUTCOMES = tuple(f"((r {i} d)*(r {i} d) - (r {j} d)*(r {j} d))" for i in "+-" for j in "+-")


def _inactive(name: str, what: str) -> Statement:
    """Four equally likely pairs of measurements of a coordinate that is not active."""
    each = f"h/(4*beta)*{{}}/{len(_OUTCOMES)}"
    mean = " + ".join(each.format(outcome) for outcome in _OUTCOMES)
    square = " + ".join(f"{each.format(outcome)}*{outcome}*h/(4*beta)" for outcome in _OUTCOMES)
    return _refuted(
        name,
        f"{what} is at r, its two measurements err by +-d, four outcomes of probability 1/4, and 0 "
        "stands in both points: it adds h ((r +- d)^2 - (r +- d)^2)/(4 beta) to the difference "
        "quotient, of mean 0 and mean square n = (h r d/beta)^2/2 > 0",
        (
            "h > 0",
            "beta > 0",
            "d > 0",
            f"{mean} == 0",
            f"{square} == n",
            "n == h**2*r**2*d**2/(2*beta**2)",
            "n > 0",
        ),
        dict.fromkeys(("h", "beta", "r", "d", "n"), "number"),
    )


def _neighbours() -> Statement:
    return _refuted(
        "section_3_neighbours",
        "C has c_jk > 0 and c_kj = 0 for the sensors j and k of the unit vectors a and b: sensor j "
        "can speak to k, and {i : c_ik > 0}, the set of column k, holds j, while k cannot speak "
        "to j",
        (
            "T(a)*a == 1",
            "diag(a)*a == a",
            "T(b)*b == 1",
            "diag(b)*b == b",
            "T(a)*b == 0",
            "T(a)*C*b > 0",
            "T(b)*C*a == 0",
        ),
        {"C": "matrix", "a": "matrix", "b": "matrix"},
    )


STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in UNIVERSAL),
    _neighbours(),
    _order(
        "algorithm_1_first_cost",
        "REFUTED",
        "the step whose number is `needed` takes the measurement that only the later step `known` "
        "gets: 4 and 6 for steps 3.4 and 3.6",
        "needed == 4",
        "known == 6",
        "needed < known",
    ),
    _order(
        "algorithm_1_first_cost_repair",
        "PROVED",
        "the step whose number is `needed` takes the measurement that the earlier step `known` "
        "gets: 4 and 3 for steps 3.4 and 3.3",
        "needed == 4",
        "known == 3",
        "needed > known",
    ),
    _inactive("algorithm_1_inactive_observed", "an observed coordinate of an inactive target"),
    _inactive("eq_15_blocks", "the coordinate that a block leaves out of a target"),
)
