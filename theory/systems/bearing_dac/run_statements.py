"""What certificates about single runs of the consensus prove: times and numbers of steps."""

from __future__ import annotations

from ...statements import BRACKET, Case, Statement
from .statements import COAREA


def _disagreement_time() -> Statement:
    words = (
        "without disturbance, at the gain beta, the error that starts at x0 (projected to mean "
        "zero in each component) is zero from the time upper on and not zero before"
    )
    return Statement(
        "bearing_dac",
        "disagreement_time",
        {
            "PROVED": Case(
                "PROVED", words, ("lower == upper", "agrees(graph, beta, x0, upper)"), BRACKET
            )
        },
        inputs={"graph": "graph", "beta": "number", "x0": "nodes"},
    )


def _implicit_steps() -> Statement:
    """least is any number of steps above upper - 1 that the bound is not below."""
    words = (
        "from the error x0 (projected to mean zero) implicit steps of length h agree exactly after "
        "upper steps, whatever the disturbance; the bound, |x0| over h times the smallest "
        "(beta k - N)/sqrt(p) of a cut, is above upper - 1"
    )
    never = "beta is at most the threshold: the worst disturbance keeps some cut apart for ever"
    proved = (
        "lower == upper",
        "upper >= 0",
        "h > 0",
        "least > upper - 1",
        "cuts_clear(graph, gamma, beta, h**2*upper**2, x0)",
        "cut_reaches(graph, gamma, beta, h**2*least**2, x0)",
    )
    lost = ("h > 0", "cut_reaches(graph, gamma, beta, 1, 0)")
    return Statement(
        "bearing_dac",
        "implicit_steps",
        {
            "PROVED": Case("PROVED", words, proved, BRACKET),
            "INFINITE": Case("PROVED", never, lost, {"lower": "inf", "upper": "inf"}),
        },
        inputs={
            "graph": "graph",
            "gamma": "nodes",
            "beta": "number",
            "h": "number",
            "x0": "nodes",
            "least": "number",
        },
        relies_on=(COAREA,),
    )


RUN_STATEMENTS = (_disagreement_time(), _implicit_steps())
