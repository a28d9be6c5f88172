"""What certificates about networks that change, and about gains for each entry, prove.

A family of networks is written as one graph whose components are the networks: what is shown of
every cut of every component is shown of every network.
"""

from __future__ import annotations

from ...statements import BRACKET, Case, Statement
from .statements import COAREA, SHIFTED

LENGTH = (
    "absolutely continuous functions: what |x| does at almost all times decides, so that a bound "
    "on its growth that holds in each network holds while they switch"
)
CLEAR = ("cuts_clear(graph, gamma, upper, 1, 0)", "cut_reaches(graph, gamma, lower, 1, 0)")
APART = (f"dips({SHIFTED.format(s='0')})", "T(gamma)*gamma > 0")


def _family(name: str, each: str, held: str, apart: str) -> Statement:
    words = (
        f"each component of the graph is {each}, with its agents' gamma: at every gain beta >= "
        f"upper agreement is kept, whatever the disturbance{held}; at no gain below lower: in one "
        "of the networks a disturbance drives the two sides of a cut apart"
    )
    ends = {"lower": "inf", "upper": "inf"}
    return Statement(
        "bearing_dac",
        name,
        {
            "PROVED": Case("PROVED", words, CLEAR, BRACKET),
            "INFINITE": Case("PROVED", apart, APART, ends),
        },
        inputs={"graph": "graph", "gamma": "nodes"},
        relies_on=(COAREA, LENGTH),
    )


def _entry_gains() -> Statement:
    words = (
        "with |P_i'| <= gamma_P and |q_i'| <= gamma_q at each agent i, agreement on the entries of "
        "P is kept at every gain beta >= upper_P and agreement on those of q at every gain >= "
        "upper_q, whatever the disturbance; at no gain below lower_P and lower_q"
    )
    show = tuple(
        f"{predicate}(graph, gamma_{entry}, {end}_{entry}, 1, 0)"
        for entry in "Pq"
        for predicate, end in (("cuts_clear", "upper"), ("cut_reaches", "lower"))
    )
    numbers = [f"{end}_{entry}" for entry in "Pq" for end in ("lower", "upper")]
    return Statement(
        "bearing_dac",
        "entry_gains",
        {"PROVED": Case("PROVED", words, show)},
        inputs={
            "graph": "graph",
            "gamma_P": "nodes",
            "gamma_q": "nodes",
            **dict.fromkeys(numbers, "number"),
        },
        relies_on=(COAREA,),
    )


NETWORK_STATEMENTS = (
    _family(
        "switching_threshold",
        "one of the networks between which the links of the same agents switch",
        " and however often and fast the links switch",
        "one of the networks between which the links switch is not connected, and the signal of "
        "some agent may move: while these links hold, the means of its components drift apart at "
        "every gain",
    ),
    _family(
        "node_loss_threshold",
        "what is left of one network when an agent is lost",
        " and whichever agent is lost",
        "what is left of the network when an agent is lost is not connected, and the signal of "
        "some agent may move: the means of its components drift apart at every gain",
    ),
    _entry_gains(),
)
