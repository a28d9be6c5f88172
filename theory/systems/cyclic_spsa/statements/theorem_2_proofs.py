"""What holds of Theorem 2 and its proof for all targets and noises."""

from __future__ import annotations

from ....algebra.identities import ONE
from ....algebra.noncommuting import Form, letters, scalars
from ....algebra.rewriting import derive
from ....expressions import parse
from ..bounds import PRINTED
from ..descent import HALF, LETTERS, polynomial, square, squared, term
from ..target_bound import NESTED
from ..universal import Universal
from .theorem_1_proofs import INNER

ADD = "variances of independent variables add"
HESSIANS = {"H": "positive semidefinite: n", "S": "positive semidefinite: n"}


def _gradient() -> Universal:
    weight, x, r, step, up, down = scalars("weight x r step up down")

    def cost(at: Form) -> Form:
        return HALF * (weight * (at - r) * (at - r))

    relations = (up - cost(x + step), down - cost(x - step))
    goal = up - down - 2 * step * weight * (x - r)
    words = (
        "for the cost weight (x - r)^2/2 of one coordinate, weight = K/(n sigma^2), the central "
        "difference of the values up and down at x + step and x - step is 2 step weight (x - r) "
        "for every step: the derivative is K (x - r)/(n sigma^2)"
    )
    symbols = dict.fromkeys(("x", "r", "step", "up", "down"), "real") | {"weight": "positive"}
    proof = derive("gradient", goal, relations, {0: "up", 1: "down"})
    return Universal("theorem_2_gradient_repair", words, (proof,), symbols)


def _mu() -> Universal:
    h, s, e = letters("H S e", ("H", "S"))
    (mu,) = scalars("mu")
    relations = (h - 2 * mu * ONE - s,)
    form, size = e.T * h * e, squared(e)
    proofs = (
        derive(
            "printed", form - mu * size, relations, {0: "H"}, (square(ONE, e, s), square(mu, e))
        ),
        derive("sharp", form - 2 * mu * size, relations, {0: "H"}, (square(ONE, e, s),)),
    )
    words = (
        "H = 2 mu + S with S >= 0 and mu = K/(2 n max sigma^2): e'He >= mu e'e, Assumption 1 with "
        "the printed constant, and e'He >= 2 mu e'e, which is sharp: twice the printed one serves"
    )
    symbols = {"S": "positive semidefinite: n", "H": "symmetric: n", "e": "vector: n"}
    return Universal("theorem_2_mu", words, proofs, symbols | {"mu": "positive"})


def _lipschitz() -> Universal:
    h, s = letters("H S", ("H", "S"))
    (bound,) = scalars("M")
    relations = (s + h - bound * ONE,)
    goal = bound * bound * bound * ONE - bound * h * h
    squares = (square(bound * bound, ONE, s), square(ONE, h, s), square(ONE, s, h))
    words = (
        "H >= 0 and S = M - H >= 0 with M = K/(n min sigma^2): M (M^2 - H^2) >= 0, so that the "
        "gradient H e has at most the length M |e|: Assumption 2 with twice the printed constant"
    )
    proof = derive("lipschitz", goal, relations, {0: "S"}, squares)
    symbols = HESSIANS | {"M": "positive"}
    return Universal("theorem_2_lipschitz_repair", words, (proof,), symbols)


def _gamma() -> Universal:
    d, m, inverse, c3, gamma = scalars("d M inverse c3 gamma")
    relations = (gamma - 3 * d * (m * m * d + c3 * inverse), c3)
    words = (
        "gamma = 3 d (M^2 d + c3 inverse), inverse = 1/beta, with c3 = 0 is 3 d^2 M^2: gamma, and "
        "with it m and b of Theorem 2, are those of Theorem 1"
    )
    proof = derive("gamma", gamma - 3 * d * d * m * m, relations, {0: "gamma", 1: "c3"})
    symbols = dict.fromkeys(("d", "M", "inverse"), "positive")
    symbols |= dict.fromkeys(("c3", "gamma"), "nonnegative")
    return Universal("theorem_2_gamma", words, (proof,), symbols)


def _centred() -> Universal:
    h, g, z = letters("H g z", ("H",))
    relations = (g + h * z, z)
    words = (
        "the mean gradient g = -H z at the true positions, z the mean of the noise xi, is 0 for "
        "z = 0: c1 = 0; nothing is added to the measured costs, so that c_v = 0; and the noise is "
        "independent of the perturbation as Assumption 7 asks for"
    )
    proof = derive("mean", g, relations, {0: "g", 1: "z"})
    symbols = {"H": "symmetric: n", "g": "vector: n", "z": "vector: n"}
    return Universal("theorem_2_c1", words, (proof,), symbols)


def _c2() -> Universal:
    x, y, u, v = letters("x y u v")
    f, g, p, q = scalars("f g p q")
    relations = (u + f * x, v + g * y, squared(x) - p, squared(y) - q)
    goal = squared(u) + squared(v) - f * f * p - g * g * q
    words = (
        "for two targets with weights f, g of the form K/(n sigma^2) and noises x, y of mean "
        "squares p, q the gradient at the true positions has the parts u = -f x and v = -g y, and "
        "the mean square f^2 p + g^2 q; further targets add theirs: c2 = sum (K/n)^2 tr Xi/sigma^4"
    )
    proof = derive("c2", goal, relations, {0: "u", 1: "v", 2: "x' x", 3: "y' y"})
    symbols = dict.fromkeys("xyuv", "vector: n") | dict.fromkeys("fg", "positive")
    symbols |= dict.fromkeys("pq", "nonnegative")
    return Universal("theorem_2_c2_repair", words, (proof,), symbols, (INNER,))


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


def _drift() -> Universal:
    x, y = letters("x y")
    p, q, r, s = scalars("p q r s")
    relations = (squared(x) - p * p + r, squared(y) - q * q + s)
    goal = (p + q) * (p + q) - squared(x) - squared(y)
    words = (
        "two targets that move by x and y, of lengths at most p and q, move together by the root "
        "of x'x + y'y, at most p + q; further ones are added in the same way, and k >= 1 times the "
        "sum is a bound as well"
    )
    squares = (term(2 * p * q), term(r), term(s))
    proof = derive("drift", goal, relations, {0: "x' x", 1: "y' y"}, squares)
    symbols = dict.fromkeys("xy", "vector: n") | dict.fromkeys("pqrs", "nonnegative")
    return Universal("theorem_2_drift", words, (proof,), symbols)


def _nested() -> Universal:
    l_bar, change, spread, lag = scalars("l_bar change spread lag")
    zero = {"c3": ONE * 0, "c_v2": ONE * 0}
    own = {"change": change, "spread": spread, "lag": lag}
    lines = {line.name: line for line in PRINTED.lines}
    relations = tuple(
        scalars(name)[0] - polynomial(lines[name].tree, LETTERS | zero | own)
        for name in ("l_bar", "spread", "change")
    )
    goal = l_bar - polynomial(parse(NESTED), LETTERS | own)
    words = (
        "l_bar, spread, change and lag of Theorem 1 with c3 = c_v = 0 (half = 1/(2 beta)): l_bar = "
        "6 d (alpha/beta) c4 + 6 alpha d^2 (c2 + M^2 (delta + 2 beta d^(1/2))^2) + 2 delta lag, "
        "which is what Theorem 2 would have to print"
    )
    proof = derive("nested", goal, relations, {0: "l_bar", 1: "spread", 2: "change"})
    symbols = dict.fromkeys(("alpha", "beta", "d", "M", "half", "root_d"), "positive")
    symbols |= dict.fromkeys(("delta", "c2", "c4", *own, "l_bar"), "nonnegative")
    return Universal("theorem_2_l_repair", words, (proof,), symbols)


UNIVERSAL: tuple[Universal, ...] = (
    _gradient(),
    _mu(),
    _lipschitz(),
    _gamma(),
    _centred(),
    _c2(),
    _change(),
    _spread(),
    _level(),
    _drift(),
    _nested(),
)
