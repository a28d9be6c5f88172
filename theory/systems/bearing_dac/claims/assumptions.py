"""Hypotheses that the claims of George share."""

from __future__ import annotations

from ....claims import Assumption

RATE = Assumption("A2", "every averaged entry has a rate of at most gamma in size, almost always")
CONNECTED = Assumption("A3", "the graph is undirected, without weights and connected")
START = Assumption("A4", "the internal states start at zero")
INCLUSION = Assumption(
    "A5", "the discontinuous law is read in Filippov's sense: at a tie, any sign between -1 and 1"
)
BALANCED = Assumption(
    "A6",
    "the graph is directed with positive weights, strongly connected, and balanced: the weights "
    "into and out of each node have equal sums",
)
MOORE_PENROSE = Assumption("A7", "( )^+ is the Moore-Penrose inverse")
GENERALIZED = Assumption("A8", "( )^+ is any generalized inverse: any G with A G A = A")
APART = Assumption("A9", "the target sits on no sensor: all distances are positive")
EXACT = Assumption("A10", "bearings are exact")
CROSSING = Assumption("A11", "the rows h' of the sensors have rank 2")
CLASSICAL = Assumption("A12", "the law is read pointwise, with sgn(0) = 0")
AVERAGED = Assumption("A13", "a sensor knows the averages of P and q exactly")
FIXED = Assumption("A14", "sensors do not move")
PULLED = Assumption(
    "A15", "the gain is above the threshold: against any disturbance the error falls at a rate r"
)
LACKING = Assumption("A16", "some two sensors are not linked")
LARGE = Assumption("A17", "there are four sensors or more, or three in a row")
