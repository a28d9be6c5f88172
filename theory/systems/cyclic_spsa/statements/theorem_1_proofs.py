"""What holds of Theorem 1 for all costs, noises and drifts that its assumptions allow."""

from __future__ import annotations

from fractions import Fraction

from ....algebra.identities import ONE
from ....algebra.noncommuting import letters, scalars
from ....algebra.rewriting import derive
from .. import descent
from ..bound_letters import (
    HALF,
    LETTERS,
    ROOT,
    ROOT_WORD,
    M,
    alpha,
    beta,
    c2,
    c3,
    constants,
    delta,
    half,
    without_root,
)
from ..bounds import PRINTED, PROVED
from ..descent import SYMBOLS, paired, square, squared, term
from ..universal import Universal

INNER = "random vectors of finite mean square form an inner product space with the product E x'y"
TAYLOR = (
    "Taylor's formula: f(x + h) differs from f(x) + h'grad f(x) by at most M |h|^2/2 if the "
    "gradient has the Lipschitz constant M"
)
CONTRACTION = "a vector p with |p| <= M |v| is M Q v for some Q with Q'Q <= 1"
FINITE_SUM = "what is not negative and has a finite sum tends to zero"

SIXTH = ONE * Fraction(1, 6)
mu, over, more, noise, gamma = scalars("mu over more noise gamma")
SQUARES = 3 * (ONE + more) * (ONE + more) * (mu + over) * (mu + over)
"""3 d^2 M^2 for M = mu + over >= mu and d = 1 + more >= 1."""
GAMMA = (gamma - SQUARES - noise,)


def _second_branch() -> Universal:
    rest = 2 * (SQUARES + noise) - 6 * mu * mu
    goal = 2 * gamma - 6 * mu * mu
    words = (
        "for all mu > 0, M = mu + over >= mu, d = 1 + more >= 1 and noise = 3 d c3/beta >= 0: "
        "gamma = 3 d^2 M^2 + noise has 2 gamma >= 6 mu^2 > mu^2, so that the case mu^2 >= 2 gamma "
        "never occurs and the set of steps is the one interval (0, mu/gamma)"
    )
    proof = derive("branch", goal, GAMMA, {0: "gamma"}, (term(rest),))
    return Universal("theorem_1_second_branch", words, (proof,), SYMBOLS, verdict="REFUTED")


def _kept() -> Universal:
    goal = SIXTH - 2 * alpha * mu + 2 * alpha * alpha * gamma
    extra = SQUARES + noise - 3 * mu * mu
    squares = (square(ONE * 6, alpha * mu - SIXTH), term(2 * alpha * alpha * extra))
    words = (
        "for all mu > 0, M = mu + over >= mu, d = 1 + more >= 1 and noise >= 0: "
        "gamma = 3 d^2 M^2 + noise has 1 - alpha m = 1 - 2 alpha mu + 2 alpha^2 gamma >= 5/6 for "
        "every alpha > 0. What the second branch is to guarantee, 1 - alpha m > 0, always holds, "
        "and (0, mu/gamma) is where m > 0"
    )
    proof = derive("kept", goal, GAMMA, {0: "gamma"}, squares)
    return Universal("theorem_1_second_branch_repair", words, (proof,), SYMBOLS)


def _no_c1() -> Universal:
    g, r = letters("g r")
    step, beyond = scalars("step beyond")
    loss = step * mu * squared(g)
    relations = (squared(r) - squared(g) + noise, -paired(g, g + r) - loss - beyond)
    squares = (square(HALF * ONE, g + r), term(HALF * noise), term(beyond))
    words = (
        "let g be the mean gradient at the minimum theta, g + r that at theta - g/M. As2 gives "
        "r'r = g'g - noise and As1, with step = 1/M, -g'(g + r) = mu step g'g + beyond, where "
        "noise and beyond are not negative. Then -mu step g'g >= 0, so that g = 0: the constant c1 "
        "of As3 is 0 for every cost"
    )
    symbols = SYMBOLS | {"step": "positive", "beyond": "nonnegative"}
    symbols |= dict.fromkeys("gr", "vector: n")
    proof = derive("gradient", -loss, relations, {1: "beyond", 0: "r' r"}, squares)
    return Universal("theorem_1_c1", words, (proof,), symbols, verdict="REFUTED")


def _mean_step() -> Universal:
    words = (
        "step (i) of the repaired proof, two instants: with the error length e before the update "
        "(e'e = 1), the drift delta w of the last sample (w'w <= 1), mean gradients late and early "
        "at the two instants that satisfy As1 and As2, and EG = (late + early)/2 + rest p "
        "(p'p <= 1): -2 e'EG length <= -2 mu length^2 + [(2 mu + M) delta + 2 rest] length + "
        "M delta^2; Taylor's formula gives rest = M beta d^(3/2)/2"
    )
    proof = (descent.mean_step(),)
    reasons = (INNER, TAYLOR, CONTRACTION)
    return Universal("theorem_1_mean_step", words, proof, SYMBOLS, reasons)


def _mean_step_at_once() -> Universal:
    e, p, late = letters("e p late")
    length, rest = scalars("length rest")
    s1, s2, *_ = descent.slack
    relations = (
        squared(e) - ONE,
        squared(p) - ONE + s1,
        length * (e.T * late) - mu * length * length - s2,
    )
    pulled = 2 * length * paired(e, late) + 2 * rest * length * paired(e, p)
    goal = 2 * rest * length - 2 * mu * length * length + pulled
    squares = (square(rest * length, e + p), term(rest * length * s1), term(2 * s2))
    words = (
        "step (i), one instant: with the error length e before the update (e'e = 1), the mean "
        "gradient late with As1, and EG = late + rest p (p'p <= 1): -2 e'EG length <= -2 mu "
        "length^2 + 2 rest length, which does not depend on drift or noise; Taylor's formula gives "
        "rest = M beta d^(3/2)/2"
    )
    words_at = {0: "e' e", 1: "p' p", 2: "length e' late"}
    proof = derive("at once", goal, relations, words_at, squares)
    return Universal("theorem_1_mean_step_at_once", words, (proof,), SYMBOLS, (INNER, TAYLOR))


def _mean_square() -> Universal:
    words = (
        "step (ii): the difference of the two costs is A + B + C, A'A <= 4 beta^2 d |steep + M "
        "(length size + beta root_d one)|^2 from the perturbation, with the mean square c2 of the "
        "gradient at the minimum, B'B <= c3 ((length + delta)^2 + beta^2 d) + c4 from sample to "
        "sample by As5 for every x, C'C <= c_v2 from the additive noise; G has the square "
        "d (A + B + C)^2/(4 beta^2), half = 1/(2 beta). Then E|G|^2 <= 3 d {2 d c2 + 2 d M^2 "
        "(length + beta root_d)^2 + [c3 ((length + delta)^2 + beta^2 d) + c4 + c_v2]/(4 beta^2)}; "
        "with one instant the same holds without B, for c3 = c4 = 0"
    )
    proof = (descent.mean_square(),)
    return Universal("theorem_1_mean_square", words, proof, SYMBOLS, (INNER, TAYLOR))


def _recursion() -> Universal:
    words = (
        "step (iii): with gamma, m, b, l as repaired, length^2 + alpha (i) + alpha^2 (ii) = "
        "(1 - alpha m) length^2 + 2 alpha b length + alpha l, which bounds the mean square of the "
        "error after an update by the root of that before it"
    )
    return Universal("theorem_1_recursion", words, (descent.recursion(),), SYMBOLS)


def _fixed_point() -> Universal:
    words = (
        "step (iv): let rho^2 = keep (rho + lag)^2 + tilt (rho + lag) + level with keep = 1 - "
        "alpha m, tilt = 2 alpha b, level = alpha l, lag = 2 k delta. After an error rho + x the "
        "square of the next one is lower by loss x^2 + 2 slope x at least, so that the sum of all "
        "x^2 is finite; after an error z <= rho it is at most rho^2; and drift adds at most lag to "
        "a root of a mean square: no limit of the errors is above rho"
    )
    proof = descent.above_the_fixed_point()
    return Universal("theorem_1_fixed_point", words, proof, SYMBOLS, (INNER, FINITE_SUM))


def _root() -> Universal:
    words = (
        "step (v): with pace = 2k delta/alpha, root_q^2 = b^2 + m l + 2 pace b + pace^2 (1 - alpha "
        "m) and inverse = 1/m, rho = (b + pace + root_q) inverse - 2k delta, the bound of one "
        "block, has rho^2 = (1 - alpha m) (rho + 2k delta)^2 + 2 alpha b (rho + 2k delta) + alpha "
        "l, the equation of (iv), whose slope alpha m (rho + 2k delta) - 2k delta - alpha b is "
        "alpha root_q, which is not negative; rate = 1/alpha"
    )
    return Universal("theorem_1_root", words, descent.root(), SYMBOLS)


def _static() -> Universal:
    still = dict.fromkeys(("delta", "c2", "c3", "c4", "c_v2"), ONE * 0)
    printed, proved = (constants(bound, LETTERS | still) for bound in (PRINTED, PROVED))
    above = {name: printed[name] - proved[name] for name in ("b", "l")}
    identities = [
        derive(name, excess, (ROOT,), {0: ROOT_WORD}, (term(without_root(excess)),))
        for name, excess in above.items()
    ]
    words = (
        "without drift, random costs and additive noise (delta = c2 = c3 = c4 = c_v = 0) the "
        "printed m is the proved one, and the printed b and l are not below the proved ones; "
        "(b + (b^2 + m l)^(1/2))/m grows with both"
    )
    return Universal("theorem_1_static", words, tuple(identities), SYMBOLS)


def _units() -> Universal:
    """A length of 1 becomes one of `scale`, and whatever has lengths in its unit follows."""
    scale, inverse = scalars("scale inverse")
    up, down = scale * scale, inverse * inverse
    moved = {
        "mu": mu * down, "M": M * down, "alpha": alpha * up, "beta": beta * scale,
        "delta": delta * scale, "c2": c2 * down, "c3": c3 * down,
        "half": half * inverse,
    }  # fmt: skip
    powers = {"m": down, "b": inverse, "l": ONE}
    made = constants(PROVED, LETTERS)
    identities = tuple(
        derive(
            name,
            made[name].substitute(moved) - made[name] * power,
            (scale * inverse - ONE,),
            {0: "inverse scale"},
        )
        for name, power in powers.items()
    )
    words = (
        "in another unit of length, which makes a length of 1 one of scale (inverse = 1/scale, "
        "half = 1/(2 beta)), the repaired m, b and l are multiplied by scale^-2, scale^-1 and "
        "1: the interval and the bound are those of the old unit, converted"
    )
    return Universal("theorem_1_units_repair", words, identities, SYMBOLS)


UNIVERSAL: tuple[Universal, ...] = (
    _second_branch(),
    _kept(),
    _no_c1(),
    _mean_step(),
    _mean_step_at_once(),
    _mean_square(),
    _recursion(),
    _fixed_point(),
    _root(),
    _static(),
    _units(),
)
