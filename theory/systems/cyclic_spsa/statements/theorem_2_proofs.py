"""What holds of Theorem 2 and its proof for all targets and noises."""

from __future__ import annotations

from ....algebra.identities import ONE
from ....algebra.noncommuting import Form, letters, scalars
from ....algebra.rewriting import derive
from ....expressions import parse
from ..bound_letters import HALF, LETTERS, polynomial
from ..bounds import PRINTED
from ..descent import square, squared, term
from ..target_bound import NESTED
from ..universal import Universal
from . import theorem_2_changes
from .theorem_1_proofs import INNER
from .theorem_2_changes import HESSIANS


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
    _drift(),
    _nested(),
    *theorem_2_changes.UNIVERSAL,
)
