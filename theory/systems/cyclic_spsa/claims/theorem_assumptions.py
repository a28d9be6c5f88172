"""Assumptions 1 to 6 as the claims about Theorems 1 and 2 name them."""

from __future__ import annotations

from ....claims import Assumption

CONVEX = Assumption(
    "A1", "(x - theta_t)'grad F_t(x) >= mu |x - theta_t|^2 for every x, mu > 0, theta_t the minimum"
)
SMOOTH = Assumption("A2", "every gradient has the Lipschitz constant M, M >= mu")
GRADIENTS = Assumption("A3", "the mean square of the gradient at the minimum is at most c2")
BOUNDED_DRIFT = Assumption("A4", "in a sample the minimum moves by at most delta")
CHANGE = Assumption("A5", "the cost changes from sample to sample as c3 and c4 allow, as printed")
ADDITIVE_NOISE = Assumption(
    "A6", "additive noise of the costs changes in a step by at most c_v, or by c_v in mean square"
)
CONSTANT_COST = Assumption(
    "A8", "the cost is the same in every sample, a sum over the blocks, and measured without noise"
)
IN_INTERVAL = Assumption("T1", "the step is in the printed interval")
RANDOM_DRIFT = Assumption("T2", "the drift is random, of mean zero, and bounded in the mean square")
WEIGHTS = Assumption("W1", "the cost is (20): weights K/(n sigma^2), sigma^2 the largest tr Xi")
INDEPENDENT_NOISE = Assumption(
    "W2", "the noise xi has mean zero and fourth moment M_4 at most, and is new in every sample"
)
EVERY_POINT = Assumption("W3", "the change of the cost is meant at every point x")
SPEEDS = Assumption("W4", "target i moves by at most delta_i in a sample")
