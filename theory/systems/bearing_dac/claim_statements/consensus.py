"""What certificates about the consensus laws, their start and their bounds on the gain prove."""

from __future__ import annotations

from dataclasses import replace

from ....algebra import averages, consensus
from ....statements import Case, Statement
from ..statements import COAREA, FIEDLER, SHIFTED
from ..statements import STATEMENTS as THEOREM_1
from ..universal import Universal

FLOW_UNIQUE = "a maximal monotone inclusion has one solution from every start"
FIEDLER_NODES = (
    "Fiedler: lambda_2 is at most the number of nodes whose loss takes a network apart, unless all "
    "pairs are linked; so it is at most the number of links of any node"
)
SIGNS = {
    "B": "matrix: n m",
    "L": "symmetric: n",
    "M": "symmetric: n",
    "P": "positive semidefinite: n",
    "X": "symmetric: n",
    **dict.fromkeys("ewfxudyz", "vector: n"),
    **dict.fromkeys("ghq", "vector: m"),
    "b": "positive",
    "r": "positive",
}
"""Symbols of `theory.algebra.consensus`."""
SIZES = {"l": "positive", "c": "nonnegative", "n": "positive"} | dict.fromkeys("jk", "nonnegative")

CONSENSUS: tuple[Universal, ...] = (
    Universal(
        "section_3_compact",
        "a link from t to g with the sign k of head minus tail adds k at the head, -k at the tail "
        "and nothing at any other node; these are the terms of the sums over neighbours, and "
        "turning the link round changes both the column and the sign, so B sgn(B'x) is these sums "
        "for any directions of the links; entries of x have nothing to do with each other",
        consensus.one_link(),
        dict.fromkeys("tgo", "vector: n") | {"k": "real"},
    ),
    Universal(
        "section_3_error",
        "for every graph, x = w + f and M = I - ee'/n: x - e(e'f/n) = w + Mf",
        consensus.errors()[:1],
        SIGNS | {"m": "real"},
    ),
    Universal(
        "algorithm_1_start",
        "for every graph and every selection g of signs the sum of w never changes, e'w' = 0; and "
        "e'x = e'w + e'f, so that with e'w = 0 the mean of x is the average of f",
        consensus.errors()[1:3],
        SIGNS | {"m": "real"},
    ),
    Universal(
        "algorithm_1_start_needed_repair",
        "for every graph and any start: the sum of the error w + Mf is that of w and never "
        "changes, and errors that all equal m have the mean m; so agreement is on the average if "
        "and only if the internal states start at sum zero, else off by their mean for ever",
        (consensus.errors()[1], *consensus.errors()[3:]),
        SIGNS | {"m": "real"},
    ),
    Universal(
        "section_2_entries",
        "if x = w + f follows the law with the selection g, then e - x = -w + (e - f) follows it "
        "with -g, which selects the signs of B'(e - x) = -B'x: P_22 = 1 - P_11 and P_21 = P_12 "
        "stay so, and of the six numbers two need not be kept",
        consensus.mirrored(),
        SIGNS,
        (FLOW_UNIQUE,),
    ),
    Universal(
        "theorem_1_stays_filippov",
        "for every connected graph (P = L - lambda_2 M >= 0, LX = M) and every u with |u|^2 <= "
        "gamma^2 n, as |u_i| <= gamma gives: the flow q = B'Xu has Bq = Mu and, at a gain b with "
        "b^2 lambda_2 >= gamma^2 n, a length of at most b; so no |q_k| exceeds b, and q/b selects "
        "signs between -1 and 1 that keep the error at zero",
        consensus.selected(),
        SIGNS | SIZES,
        (FIEDLER,),
    ),
    Universal(
        "theorem_1_form_root",
        "for every connected graph (P = L - lambda_2 M >= 0, LX = M) and every u with |u|^2 <= "
        "gamma^2 n: at a gain b with b^2 lambda_2 >= gamma^2 n the flow q = B'Xu, Bq = Mu, is at "
        "most b long, so that q/b is a selection of signs that keeps agreement",
        consensus.selected(),
        SIGNS | SIZES,
        (FIEDLER,),
    ),
    Universal(
        "theorem_1_form_root_one",
        "for every connected graph (P = L - lambda_2 M >= 0), with t the sum of the sizes of all "
        "differences along links, t^2 >= x'Lx, and y = |x|^2: t^2 >= lambda_2 |x|^2 and (u'x)^2 <= "
        "gamma^2 n |x|^2; half the derivative of |x|^2 is u'x - beta t, so |x| falls at a rate of "
        "at least beta sqrt(lambda_2) - gamma sqrt(n), which is sqrt(lambda_2) for beta = 1 + "
        "gamma sqrt(n/lambda_2) and positive for every beta above gamma sqrt(n/lambda_2)",
        consensus.decreasing(),
        SIGNS | SIZES | {"t": "nonnegative", "y": "positive"},
        (FIEDLER,),
    ),
    Universal(
        "theorem_1_stays_classical",
        "at agreement (x = 0) all differences are zero, and with signs g = 0 of them the "
        "derivative of the error under a disturbance u of sum zero is u: x = 0 is a solution for u "
        "= 0 only",
        consensus.resting(),
        SIGNS,
        verdict="REFUTED",
    ),
    Universal(
        "theorem_1_time_start",
        "|x|^2 - |Mx|^2 = (e'x)^2/n >= 0",
        (consensus.centred(),),
        SIGNS,
    ),
    Universal(
        "theorem_2_position",
        "if a sensor has the average N of P and the average m of q, and m = Np as for exact "
        "measurements, then Ym = p with the inverse Y of N",
        averages.agreed(),
        {"N": "symmetric: 2", "A": "symmetric: 2", "Y": "symmetric: 2"}
        | dict.fromkeys("mdp", "vector: 2"),
    ),
)


def any_offset() -> Statement:
    """Internal states that are not zero and whose sum is: agreement on the average."""
    return Statement(
        "bearing_dac",
        "algorithm_1_start_needed",
        {
            "REFUTED": Case(
                "REFUTED",
                "the graph is connected, what is averaged rests at zero, and the internal states "
                "start at w, not zero, of sum zero: the error is w at the start and zero at the "
                "time t",
                (
                    "pd(laplacian(graph) + ones(graph))",
                    "T(w)*w > 0",
                    "run(graph, beta, 0, w, 0*w, t)",
                ),
            )
        },
        inputs={"graph": "unweighted graph", "beta": "number", "w": "nodes", "t": "number"},
    )


def free_estimate() -> Statement:
    """An estimate of lambda_2 that is too large."""
    return Statement(
        "bearing_dac",
        "theorem_1_estimates_printed",
        {
            "REFUTED": Case(
                "REFUTED",
                "a connected graph, an estimate n_hat >= n, a positive estimate lambda_hat and a "
                "gain beta >= 1 + gamma sqrt(n_hat)/lambda_hat: a disturbance of at most gamma "
                "drives the two sides of a cut apart for ever",
                (
                    "pd(laplacian(graph) + ones(graph))",
                    "n_hat >= nodes(graph)",
                    "lambda_hat > 0",
                    "gamma >= 0",
                    "beta >= 1",
                    "(beta - 1)**2*lambda_hat**2 >= gamma**2*n_hat",
                    "cut_drifts(graph, gamma, beta)",
                ),
            )
        },
        inputs={"graph": "unweighted graph"}
        | dict.fromkeys(("gamma", "beta", "n_hat", "lambda_hat"), "number"),
        relies_on=(COAREA,),
    )


def path_of_three() -> Statement:
    """The printed gain on three sensors in a row."""
    return Statement(
        "bearing_dac",
        "theorem_1_form_printed_path",
        {
            "PROVED": Case(
                "PROVED",
                "the graph has three nodes and lambda_2 <= 1, so that beta is at most gamma "
                "sqrt(n)/lambda_2, and beta keeps agreement",
                (
                    "nodes(graph) == 3",
                    f"dips({SHIFTED.format(s='1')})",
                    "beta >= 0",
                    "beta**2 <= gamma**2*nodes(graph)",
                    "cuts_clear(graph, gamma, beta, 1, 0)",
                ),
            )
        },
        inputs={"graph": "unweighted graph", "gamma": "number", "beta": "number"},
        relies_on=(COAREA,),
    )


def _scalars(
    name: str,
    words: str,
    show: tuple[str, ...],
    symbols: dict[str, str],
    relies_on: tuple[str, ...],
) -> Statement:
    case = {"PROVED": Case("PROVED", words, show)}
    return Statement("bearing_dac", name, case, symbols=symbols, relies_on=relies_on)


def estimates() -> Statement:
    """Both estimates only enlarge the bound."""
    return _scalars(
        "theorem_1_estimates",
        "for n^ = n + a and lambda_2 = l + j with l = lambda2^ and a, j >= 0: n^ lambda_2^2 >= n "
        "lambda2^^2, so that sqrt(n^)/lambda2^ >= sqrt(n)/lambda_2",
        ("(n + a)*(l + j)**2 - n*l**2 >= 0",),
        {"n": "positive", "l": "positive", "a": "nonnegative", "j": "nonnegative"},
        (),
    )


def from_four_on() -> Statement:
    """sqrt(n) >= 2."""
    return Statement(
        "bearing_dac",
        "theorem_1_form_printed",
        {
            "PROVED": Case(
                "PROVED",
                "for every connected graph on n = 4 + a nodes and every cut with indicator S, k = "
                "S'LS and p = S'MS: 2 gamma k/lambda_2 >= 2 gamma p = N, and gamma "
                "sqrt(n)/lambda_2 >= 2 gamma/lambda_2 by their squares (P stands for L - lambda_2 "
                "M, which is >= 0; g for gamma/lambda_2, l for lambda_2)",
                ("2*g*T(S)*L*S - 2*g*l*T(S)*M*S >= 0", "g**2*(4 + a) - (2*g)**2 >= 0"),
            )
        },
        symbols={
            "L": "symmetric: n",
            "M": "symmetric: n",
            "P": "positive semidefinite: n",
            "S": "vector: n",
            "l": "positive",
            "g": "nonnegative",
            "a": "nonnegative",
        },
        given=("P - L + l*M",),
        relies_on=(FIEDLER, COAREA),
    )


def repairs_as_forms() -> tuple[Statement, ...]:
    """What repairs Theorem 1 as printed, as forms of it: twice gamma over lambda_2 for the root."""
    forms = {
        "theorem_1_gain_repair": "theorem_1_form_twice",
        "theorem_1_time_repair": "theorem_1_form_twice_one",
    }
    return tuple(replace(s, name=forms[s.name]) for s in THEOREM_1 if s.name in forms)


def time_of_others() -> Statement:
    """The printed time where some pair is not linked."""
    many = "(1 + g*(2 + b))*(l*(1 + a) + j) - 2*g*l*(1 + a) - (l*(1 + a) + j) >= 0"
    single = "(1 + g*(2 + b))*(l + j) - 2*g*l*(1 - a) - (l + j) >= 0"
    return _scalars(
        "theorem_1_time_incomplete",
        "with l = lambda_2, g = gamma/lambda_2, sqrt(n) = 2 + b and the printed gain 1 + g sqrt(n) "
        "or more: a cut with p = 1 + a has k = lambda_2 p + j links, and beta k - 2 gamma p >= k, "
        "k^2 >= lambda_2^2 p; a cut with p = 1 - a separates one node, which has k = lambda_2 + j "
        "links where some pair is not linked, and the same follows; on the path of three lambda_2 "
        "= 1, p = 2/3, k >= 1, and sqrt(3) >= 2p; so the error falls at a rate of at least "
        "lambda_2",
        (
            many,
            "(l*(1 + a) + j)**2 - l**2*(1 + a) >= 0",
            single,
            "(l + j)**2 - l**2*(1 - a) >= 0",
            "3 - (4/3)**2 >= 0",
        ),
        {"l": "positive"} | dict.fromkeys("gbaj", "nonnegative"),
        (FIEDLER, FIEDLER_NODES, COAREA),
    )
