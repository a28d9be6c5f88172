"""How much the cost of measured targets changes from sample to sample, in the mean square."""

from __future__ import annotations

from ....algebra.identities import ONE
from ....algebra.noncommuting import letters, scalars
from ....algebra.rewriting import derive
from ..bound_letters import HALF
from ..descent import square, squared
from ..universal import Universal
from .theorem_1_proofs import INNER

CAUCHY = "the square of y'H eta is at most |H y|^2 |eta|^2 (Cauchy)"
ADD = "variances of independent variables add"
HESSIANS = {"H": "positive semidefinite: n", "S": "positive semidefinite: n"}


def _change() -> Universal:
    """Mean square of the change of the cost from sample to sample, at x and at the target."""
    u, w, v, z = letters("u w v z")
    p, q, s = scalars("p q s")
    relations = (
        squared(u) - s,
        squared(w) - s,
        u.T * w,
        u.T * v,
        u.T * z,
        w.T * v,
        w.T * z,
        squared(v) - q,
        squared(z) - q,
        v.T * z - p * p,
    )
    names = ("u' u", "w' w", "u' w", "u' v", "u' z", "w' v", "w' z", "v' v", "z' z", "v' z")
    change = w - u + HALF * (v - z)
    goal = squared(change) - 2 * s - HALF * (q - p * p)
    words = (
        "at x = theta + e the cost of targets at rest changes from sample to sample by -(u - w) + "
        "(v - z)/2, u = xi'He and v = xi'H xi in the later sample, w and z in the earlier one. For "
        "noise that is symmetric and new in each sample, with s = e'H Xi H e, p = E v and "
        "q = E v^2, the mean square of that is 2 s + (q - p^2)/2: Assumption 5 for every x with "
        "c4 = Var(xi'H xi)/2"
    )
    proof = derive("change", goal, relations, dict(enumerate(names)))
    symbols = dict.fromkeys("uwvz", "vector: n") | dict.fromkeys("pqs", "nonnegative")
    return Universal("theorem_2_change", words, (proof,), symbols, (INNER,))


def _change_moving() -> Universal:
    """The same for targets that move; the two parts may be correlated."""
    one, u, w, r, v, z = letters("one u w r v z")
    p, q, s, rho = scalars("p q s rho")
    pull, drift = scalars("pull drift")
    relations = (
        squared(one) - ONE,
        *(one.T * entry for entry in (u, w, r)),
        one.T * v - p,
        one.T * z - p,
        squared(u) - s,
        squared(w) - s,
        u.T * w,
        squared(r) - rho,
        *(r.T * entry for entry in (v, z)),
        squared(v) - q,
        squared(z) - q,
        v.T * z - p * p,
    )
    first = ("one' one", "one' u", "one' w", "one' r", "one' v", "one' z", "u' u", "w' w", "u' w")
    names = (*first, "r' r", "r' v", "r' z", "v' v", "z' z", "v' z")
    linear = pull * one + u - w
    level = HALF * (drift * one + 2 * r + v - z)
    spread = 2 * (pull * pull + 2 * s) + HALF * (drift * drift + 4 * rho + 2 * (q - p * p))
    goal = spread - squared(level - linear)
    words = (
        "at x = theta_(t-1) + y the cost of targets that move by eta changes from sample to sample "
        "by level - linear, linear = pull + u - w with pull = y'H eta, u = y'H xi later and w "
        "earlier, level = (drift + 2 r + v - z)/2 with drift = eta'H eta, r = eta'H xi, v = xi'H "
        "xi later and z earlier. For noise that is symmetric and new in each sample, s = y'H Xi H "
        "y, rho = eta'H Xi H eta, p = E v and q = E v^2, the mean square is at most 2 (pull^2 + 2 "
        "s) + (drift^2 + 4 rho + 2 (q - p^2))/2: Assumption 5 for every x with c3 = 2 M^2 (2 "
        "lambda_1 + delta^2) and c4 = [(eta'H eta)^2 + 4 eta'H Xi H eta + 2 Var(xi'H xi)]/2"
    )
    proof = derive(
        "moving", goal, relations, dict(enumerate(names)), (square(ONE, level + linear),)
    )
    symbols = dict.fromkeys(("one", "u", "w", "r", "v", "z"), "vector: n")
    symbols |= dict.fromkeys(("p", "q", "s", "rho", "drift"), "nonnegative") | {"pull": "real"}
    return Universal("theorem_2_change_moving", words, (proof,), symbols, (INNER, CAUCHY))


def _spread() -> Universal:
    h, s, xi, t, e = letters("H S Xi T e", ("H", "S", "Xi", "T"))
    bound, largest = scalars("M lambda_1")
    relations = (s + h - bound * ONE, xi + t - largest * ONE)
    goal = largest * bound * bound * bound * squared(e) - bound * (e.T * h * xi * h * e)
    squares = (
        square(bound, h * e, t),
        square(largest * bound * bound, e, s),
        square(largest, h * e, s),
        square(largest, s * e, h),
    )
    words = (
        "H >= 0, M - H = S >= 0 and the largest eigenvalue lambda_1 of the covariance Xi, lambda_1 "
        "- Xi = T >= 0: M e'H Xi H e <= M^3 lambda_1 e'e, so that c3 = 2 M^2 lambda_1 serves for "
        "targets at rest"
    )
    proof = derive("spread", goal, relations, {0: "S", 1: "Xi"}, squares)
    symbols = HESSIANS | {"T": "positive semidefinite: n", "Xi": "positive semidefinite: n"}
    symbols |= {"M": "positive", "lambda_1": "nonnegative", "e": "vector: n"}
    return Universal("theorem_2_c3_repair", words, (proof,), symbols)


def _level() -> Universal:
    v, z = letters("v z")
    f, p, q = scalars("f p q")
    relations = (squared(v) - q, squared(z) - q, v.T * z - p * p)
    change = HALF * (f * (v - z))
    goal = squared(change) - HALF * (f * f * (q - p * p))
    words = (
        "at the true positions the cost of a target of weight f = K/(n sigma^2) changes from "
        "sample to sample by f (v - z)/2, v = |xi|^2 later and z earlier, with mean p and mean "
        "square q: the mean square of the change is f^2 (q - p^2)/2, and targets with independent "
        "noises add theirs: c4 = sum (K/n)^2 Var(|xi|^2)/(2 sigma^4)"
    )
    proof = derive("level", goal, relations, {0: "v' v", 1: "z' z", 2: "v' z"})
    symbols = dict.fromkeys("vz", "vector: n") | dict.fromkeys("fpq", "nonnegative")
    return Universal("theorem_2_c4_repair", words, (proof,), symbols, (INNER, ADD))


UNIVERSAL: tuple[Universal, ...] = (_change(), _change_moving(), _spread(), _level())
