"""What `bound` and `certify` offer about sign-based dynamic average consensus."""

from __future__ import annotations

from verification.answers import Condition, Input, Quantity

from .gains import decide_gain, gain_threshold, printed_threshold
from .rates import (
    algebraic_connectivity,
    margin_rate_squared,
    printed_settling_time,
    settling_time,
)
from .runs import chattering_bound, disagreement_time, implicit_steps

GRAPH = Input("graph", "graph", "communication network; edge weights scale the signs")
GAMMA = Input(
    "gamma", "node numbers", "bound on the rate of each agent's signal, at least 0", "c/s", "1"
)
BETA = Input("beta", "number", "gain, above 0", "c/s")
X0 = Input("x0", "node numbers", "error at the start, one number a node", "c")
H = Input("h", "number", "length of a step, above 0", "s")

QUANTITIES = (
    Quantity(
        "gain_threshold",
        "smallest beta at or above which no disturbance drives agents apart",
        (GRAPH, GAMMA),
        gain_threshold,
        True,
    ),
    Quantity(
        "margin_rate_squared",
        "c^2 in d|x|/dt <= -(beta - beta*) c: smallest k^2 n/(s(n-s)) of a cut",
        (GRAPH,),
        margin_rate_squared,
        True,
    ),
    Quantity(
        "algebraic_connectivity",
        "lambda_2, second smallest eigenvalue of the Laplacian",
        (GRAPH,),
        algebraic_connectivity,
        True,
    ),
    Quantity(
        "printed_threshold",
        "1 + gamma sqrt(n)/lambda_2",
        (GRAPH, GAMMA),
        printed_threshold,
        False,
    ),
    Quantity("printed_settling_time", "|x0|/lambda_2", (GRAPH, X0), printed_settling_time, False),
    Quantity(
        "settling_time",
        "largest time to agreement from x0: |x0| over the smallest (beta k - N)/sqrt(p) of a cut",
        (GRAPH, GAMMA, BETA, X0),
        settling_time,
        True,
    ),
    Quantity(
        "disagreement_time",
        "exact time of agreement from x0 without disturbance, in Filippov's sense",
        (GRAPH, BETA, X0),
        disagreement_time,
        True,
    ),
    Quantity(
        "implicit_steps",
        "implicit steps of length h to exact agreement: settling_time over h, rounded up",
        (GRAPH, GAMMA, BETA, H, X0),
        implicit_steps,
        True,
    ),
    Quantity(
        "chattering_bound",
        "what |x| is at most in the long run under explicit steps of length h",
        (GRAPH, GAMMA, BETA, H),
        chattering_bound,
        False,
    ),
)

CONDITIONS = (
    Condition(
        "gain",
        "agreement is kept whatever the disturbance: beta >= gain_threshold",
        (GRAPH, GAMMA, BETA),
        decide_gain,
    ),
)
