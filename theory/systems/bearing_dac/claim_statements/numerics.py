"""What certificates about the simulated parameters and about discrete time prove."""

from __future__ import annotations

from ....algebra import discrete_consensus
from ....statements import Case, Statement
from ..statements import COAREA, FIEDLER, SHIFTED
from ..universal import Universal
from .consensus import SIGNS

GAMMA, NODES, LAMBDA, GAIN, SHARP = "100", "5", "2/5", "28001/50", "240"
"""The printed parameters, the gain that follows from them rounded up, and what suffices."""
BELOW = "56001/100"
"""A number a hundredth below the printed gain, which the formula exceeds."""

DISCRETE: tuple[Universal, ...] = (
    Universal(
        "section_5_discrete_explicit",
        "two sensors, any step h and gain b: from the error x = (hb/2)v, v the column of B, the "
        "explicit step leads to -x and back, because the difference v'x is hb and then -hb",
        discrete_consensus.flipping(),
        dict.fromkeys("vxyz", "vector: 2") | {"h": "positive", "b": "positive"},
        verdict="REFUTED",
    ),
    Universal(
        "section_5_discrete_explicit_repair",
        "an explicit step y = x - hs from an error of the size X, with the pull s'x = rX + j of at "
        "least r X and |s|^2 = Q - k of at most Q: |y|^2 <= X^2 - 2hrX + h^2 Q, so the error falls "
        "where X > Z = hQ/(2r); and for X = Z - a, |y|^2 is at most the mean of Z^2 and h^2 Q with "
        "the weights X/Z and a/Z: in the end errors stay below the larger of h sqrt(Q) and hQ/(2r)",
        discrete_consensus.explicit(),
        dict.fromkeys("xys", "vector: n")
        | dict.fromkeys("hrQZ", "positive")
        | dict.fromkeys("Xajk", "nonnegative"),
    ),
    Universal(
        "section_5_discrete_implicit",
        "for every graph, step h and gain b, with the signs g of the differences of the new error "
        "y: the sum is kept; if a selection f balances the disturbance, bBf = Mu, an error of zero "
        "stays zero; and if b y'Bg - y'Mu is at least a|y|, as at gains above the threshold, "
        "|y|(|y| + ha) <= y'x <= |x||y|, so that each step shortens the error by ha until it is "
        "zero",
        discrete_consensus.implicit(),
        SIGNS
        | {"f": "vector: m", "h": "positive", "w": "real", "a": "positive"}
        | dict.fromkeys("XYj", "nonnegative"),
    ),
)


def example() -> Statement:
    """560.02 from the printed parameters, and that it is enough."""
    gain, gamma = f"{GAIN}", f"2*{GAMMA}"
    words = (
        "1 + 100 sqrt(5)/0.4 lies between 560.01 and 560.02, by the squares; and for every "
        "connected graph with lambda_2 = 2/5 + j, j >= 0, every cut with indicator S, k = S'LS and "
        "p = S'MS has 560.02 k >= 200 p = N, with something left, so that agreement is reached (P "
        "stands for L - lambda_2 M)"
    )
    show = (
        f"({GAIN} - 1)**2*({LAMBDA})**2 - {GAMMA}**2*{NODES} >= 0",
        f"{GAMMA}**2*{NODES} - ({BELOW} - 1)**2*({LAMBDA})**2 >= 0",
        f"{gain}*T(S)*L*S - {gamma}*T(S)*M*S - T(S)*M*S >= 0",
    )
    return Statement(
        "bearing_dac",
        "example_gain",
        {"PROVED": Case("PROVED", words, show)},
        symbols={
            "L": "symmetric: n",
            "M": "positive semidefinite: n",
            "P": "positive semidefinite: n",
            "S": "vector: n",
            "l": "positive",
            "j": "nonnegative",
        },
        given=("P - L + l*M", f"l - {LAMBDA} - j"),
        relies_on=(FIEDLER, COAREA),
    )


def enough() -> Statement:
    """240 is enough on five nodes, with no condition on lambda_2."""
    words = (
        "every cut of a connected graph on at most 5 nodes has k = 1 + j links and p = 6/5 - a "
        "with a, j >= 0, because s(5 - s) <= 6; so 240 k >= 200 p"
    )
    return Statement(
        "bearing_dac",
        "example_gain_enough",
        {"PROVED": Case("PROVED", words, (f"{SHARP}*(1 + j) - 2*{GAMMA}*(6/5 - a) >= 0",))},
        symbols={"a": "nonnegative", "j": "nonnegative"},
        relies_on=(COAREA,),
    )


def attained() -> Statement:
    """A graph of five nodes that needs 240."""
    words = (
        "the graph has 5 nodes and lambda_2 above 0.4, and at no gain below 240 is agreement kept "
        "with gamma = 100"
    )
    return Statement(
        "bearing_dac",
        "example_gain_attained",
        {
            "PROVED": Case(
                "PROVED",
                words,
                (
                    f"nodes(graph) == {NODES}",
                    f"pd({SHIFTED.format(s=LAMBDA)})",
                    f"cut_reaches(graph, {GAMMA}, {SHARP}, 1, 0)",
                ),
            )
        },
        inputs={"graph": "unweighted graph"},
        relies_on=(COAREA,),
    )
