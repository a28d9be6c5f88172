"""What certificates about sign-based dynamic average consensus prove."""

from __future__ import annotations

from ...statements import BRACKET, Case, Statement

COAREA = (
    "co-area formula on graphs and linear programming duality: the supremum over |u_i| <= gamma_i "
    "of "
    "(Mu)'x - beta |B'x|_1 over |x| is attained on cuts"
)
FIEDLER = "Courant-Fischer: x'Lx >= lambda_2 |x|^2 for x orthogonal to the ones"

SHIFTED = "laplacian(graph) + ({s} + 1)/nodes(graph)*ones(graph) - {s}*eye(graph)"
"""L - sI + (s + 1) 11'/n: positive definite if and only if lambda_2 > s."""


def _shifted(s: str) -> str:
    return SHIFTED.format(s=s)


def _gain_threshold() -> Statement:
    words = (
        "with |phi_i'| <= gamma_i, agreement is kept for ever at every gain beta >= upper, "
        "whatever the "
        "disturbance; at no gain below lower: a disturbance drives the two sides of a cut apart"
    )
    show = ("cuts_clear(graph, gamma, upper, 1, 0)", "cut_reaches(graph, gamma, lower, 1, 0)")
    return Statement(
        "bearing_dac",
        "gain_threshold",
        {"PROVED": Case("PROVED", words, show, BRACKET)},
        inputs={"graph": "graph", "gamma": "nodes"},
        relies_on=(COAREA,),
    )


def _margin() -> Statement:
    words = (
        "lower <= min over cuts of k^2/p <= upper, with k the weight of the cut and p = s(n-s)/n: "
        "without "
        "disturbance the error falls at a rate of at least beta sqrt(lower)"
    )
    show = ("cuts_clear(graph, 0, 1, 1, lower)", "cut_reaches(graph, 0, 1, 1, upper)")
    return Statement(
        "bearing_dac",
        "margin_rate_squared",
        {"PROVED": Case("PROVED", words, show, BRACKET)},
        inputs={"graph": "graph"},
        relies_on=(COAREA,),
    )


def _connectivity() -> Statement:
    between = "the second smallest eigenvalue of the graph's Laplacian lies in [lower, upper]"
    zero = (
        "the graph is not connected, so that the second smallest eigenvalue of its Laplacian is 0"
    )
    return Statement(
        "bearing_dac",
        "algebraic_connectivity",
        {
            "PROVED": Case(
                "PROVED",
                between,
                ("gap_above(graph, lower)", "gap_below(graph, upper)"),
                BRACKET,
            ),
            "PROVED 0": Case(
                "PROVED", zero, ("gap_below(graph, 0)",), {"lower": "0", "upper": "0"}
            ),
        },
        inputs={"graph": "graph"},
    )


def _settling_time() -> Statement:
    inputs = {"graph": "graph", "gamma": "nodes", "beta": "number", "x0": "nodes"}
    words = (
        "from the error x0 (projected to mean zero) agreement is reached within upper, whatever "
        "the "
        "disturbance; the bound |x0|/min over cuts of (beta k - N)/sqrt(p) is at least lower"
    )
    never = "beta is at most the threshold: the worst disturbance keeps some cut apart for ever"
    return Statement(
        "bearing_dac",
        "settling_time",
        {
            "PROVED": Case(
                "PROVED",
                words,
                (
                    "upper >= lower",
                    "lower >= 0",
                    "cuts_clear(graph, gamma, beta, upper**2, x0)",
                    "cut_reaches(graph, gamma, beta, lower**2, x0)",
                ),
                BRACKET,
            ),
            "INFINITE": Case(
                "PROVED",
                never,
                ("cut_reaches(graph, gamma, beta, 1, 0)",),
                {"lower": "inf", "upper": "inf"},
            ),
        },
        inputs=inputs,
        relies_on=(COAREA,),
    )


def _gain() -> Statement:
    kept = "at this gain agreement is kept whatever the disturbance: beta >= threshold"
    lost = (
        "at this gain a disturbance drives the two sides of a cut apart for ever: beta < threshold"
    )
    return Statement(
        "bearing_dac",
        "gain",
        {
            "PROVED": Case("PROVED", kept, ("cuts_clear(graph, gamma, beta, 1, 0)",)),
            "REFUTED": Case("REFUTED", lost, ("cut_drifts(graph, gamma, beta)",)),
        },
        inputs={"graph": "graph", "gamma": "nodes", "beta": "number"},
        relies_on=(COAREA,),
    )


RUN = {
    "graph": "unweighted graph",
    "gamma": "number",
    "lambda_2": "number",
    "beta": "number",
    "x0": "nodes",
    "x1": "nodes",
    "t": "number",
}
"""Data of a counterexample to Theorem 1: the error runs from x0 to x1 in the time t."""

WITHIN_THEOREM = (
    f"pd({_shifted('lambda_2')})",
    "lambda_2 > 0",
    "gamma >= 0",
    "beta >= 1",
    "(beta - 1)**2*lambda_2**2 >= gamma**2*nodes(graph)",
)
"""The hypotheses of Theorem 1, lambda_2 being any number below the algebraic connectivity."""

BROKEN = (
    "run(graph, beta, gamma, x0, x1, t)",
    "t**2*lambda_2**2 > T(x0)*x0",
    "T(x1)*x1 > 0",
)
"""The error is not zero at a time t after the printed |x(t0)|/lambda_2."""


def _theorem_gain() -> Statement:
    words = (
        "a connected graph without weights, a gain beta >= 1 + gamma sqrt(n)/lambda_2 as printed "
        "and an admissible disturbance: the error, which starts at x0, is x1 at the time t after "
        "the printed settling time, and that cut's disturbance drives it apart for ever"
    )
    return Statement(
        "bearing_dac",
        "theorem_1_gain",
        {
            "REFUTED": Case(
                "REFUTED", words, (*WITHIN_THEOREM, *BROKEN, "cut_drifts(graph, gamma, beta)")
            )
        },
        inputs=RUN,
    )


def _theorem_time() -> Statement:
    words = (
        "a connected graph without weights, a gain beta >= 1 + gamma sqrt(n)/lambda_2 as printed "
        "that is above the true threshold, and an admissible disturbance: the error, which starts "
        "at x0, is x1, not zero, at the time t after the printed settling time"
    )
    clear = "cuts_clear(graph, gamma, beta, 1, 0)"
    return Statement(
        "bearing_dac",
        "theorem_1_time",
        {"REFUTED": Case("REFUTED", words, (*WITHIN_THEOREM, *BROKEN, clear))},
        inputs=RUN,
    )


def _gain_repair() -> Statement:
    """k = S'LS and p = S'MS for the indicator S of a cut; L - lambda_2 M >= 0."""
    return Statement(
        "bearing_dac",
        "theorem_1_gain_repair",
        {
            "PROVED": Case(
                "PROVED",
                "for every connected graph of any size, every cut with indicator S, k = S'LS and "
                "p = S'MS, "
                "and every gamma: with beta = 2 gamma/lambda_2, beta k >= 2 gamma p = N; so every "
                "gain "
                "beta >= 2 gamma/lambda_2 keeps agreement, and every larger one reaches it in "
                "finite time "
                "(P stands for L - lambda_2 M, which is >= 0; g for gamma/lambda_2, l for "
                "lambda_2)",
                ("2*g*T(S)*L*S - 2*g*l*T(S)*M*S >= 0",),
            )
        },
        symbols={
            "L": "symmetric: n",
            "M": "symmetric: n",
            "P": "positive semidefinite: n",
            "S": "vector: n",
            "l": "positive",
            "g": "nonnegative",
        },
        given=("P - L + l*M",),
        relies_on=(FIEDLER, COAREA),
    )


def _time_repair() -> Statement:
    return Statement(
        "bearing_dac",
        "theorem_1_time_repair",
        {
            "PROVED": Case(
                "PROVED",
                "for every connected graph without weights, every cut (k = 1 + j edges, k = "
                "lambda_2 p + s, "
                "j >= 0, s >= 0) and every gain beta = 1 + 2 gamma/lambda_2 + d, d >= 0: "
                "(beta k - 2 gamma p)^2 >= lambda_2 p, written with g = gamma/lambda_2 and "
                "lambda_2 p = 1 + j - s; so agreement is reached within |x(t0)|/sqrt(lambda_2)",
                (
                    "(1 + 2*g + d)*(1 + j) - 2*g*(1 + j - s) == 1 + j + d*(1 + j) + 2*g*s",
                    "(1 + j + d*(1 + j) + 2*g*s)**2 - (1 + j - s) >= 0",
                ),
            )
        },
        symbols=dict.fromkeys("jsgd", "nonnegative"),
        relies_on=(FIEDLER, COAREA),
    )


STATEMENTS = (
    _gain_threshold(),
    _margin(),
    _connectivity(),
    _settling_time(),
    _gain(),
    _theorem_gain(),
    _theorem_time(),
    _gain_repair(),
    _time_repair(),
)
