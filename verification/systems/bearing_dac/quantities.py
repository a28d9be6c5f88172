"""What `bound` and `certify` offer about sign-based dynamic average consensus."""

from __future__ import annotations

from verification.answers import Condition, Input, Quantity

from .disturbances import disturbance_bound
from .entry_gains import entry_gains
from .gains import decide_gain, gain_threshold, printed_threshold
from .noise import noise_bias, noise_covariance, noise_cramer_rao
from .outages import outage_growth
from .rates import (
    algebraic_connectivity,
    margin_rate_squared,
    printed_settling_time,
    settling_time,
)
from .runs import chattering_bound, disagreement_time, implicit_steps
from .switching import node_loss_threshold, switching_threshold

GRAPH = Input("graph", "graph", "communication network; edge weights scale the signs")
GAMMA = Input(
    "gamma", "node numbers", "bound on the rate of each agent's signal, at least 0", "c/s", "1"
)
BETA = Input("beta", "number", "gain, above 0", "c/s")
X0 = Input("x0", "node numbers", "error at the start, one number a node", "c")
H = Input("h", "number", "length of a step, above 0", "s")
SENSORS = Input("positions", "points", "positions of the sensors", "m")
TARGET = Input("target", "point", "position of the target", "m")
SIGMA = Input(
    "sigma_bearing_rad", "number", "standard deviation of each bearing, at least 0", "rad"
)

LINKS = Input(
    "links",
    "links",
    "lists of the links that hold together, all of them links of the graph",
    "",
    "all",
)
DROP = Input("drop", "number", "links that may be lost at the same time", "", "0")
TAU = Input("tau", "number", "length of an outage, at least 0", "s")
V_MAX = Input("v_max", "number", "largest speed of the target, at least 0", "m/s")
RHO_MIN = Input("rho_min", "number", "smallest distance of the target from a sensor", "m")
POSITIONS = Input("positions", "points", "where the sensors are, one point a sensor", "m")

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
    Quantity(
        "disturbance_bound",
        "gamma of bearing sensors: v_max/rho_min max(1, |s_i|), the least bound on all rates",
        (V_MAX, RHO_MIN, POSITIONS),
        disturbance_bound,
        False,
    ),
    Quantity(
        "switching_threshold",
        "smallest beta that keeps agreement while links switch or are lost, however fast",
        (GRAPH, GAMMA, LINKS, DROP),
        switching_threshold,
        True,
    ),
    Quantity(
        "node_loss_threshold",
        "smallest beta that keeps agreement among the others whichever agent is lost",
        (GRAPH, GAMMA),
        node_loss_threshold,
        True,
    ),
    Quantity(
        "outage_growth",
        "most that |x| can grow while links are down for the time tau",
        (GRAPH, GAMMA, TAU),
        outage_growth,
        False,
    ),
    Quantity(
        "entry_gains",
        "[beta_P, beta_q]: smallest gains for the entries of P and for those of q",
        (GRAPH, V_MAX, RHO_MIN, POSITIONS),
        entry_gains,
        True,
    ),
    Quantity(
        "noise_bias",
        "error left by averaging P and q over many noisy bearings, [x, y] in m",
        (SENSORS, TARGET, SIGMA),
        noise_bias,
        False,
    ),
    Quantity(
        "noise_covariance",
        "covariance of the position from one bearing a sensor, first order, [xx, xy, yy] in m^2",
        (SENSORS, TARGET, SIGMA),
        noise_covariance,
        False,
    ),
    Quantity(
        "noise_cramer_rao",
        "smallest covariance of an unbiased position from the same, [xx, xy, yy] in m^2",
        (SENSORS, TARGET, SIGMA),
        noise_cramer_rao,
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
