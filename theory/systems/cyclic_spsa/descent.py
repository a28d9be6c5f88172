"""The repaired Theorem 1, step by step, as inequalities that are sums of squares.

Letters are vectors of any inner product space: vectors of numbers, or random vectors of finite mean
square, whose inner product is E x'y. Lengths are taken out of them, so that nothing is divided:
before the update theta_hat - theta_t is length e with e'e = 1, the drift of the last sample is
delta w with w'w <= 1, and what Taylor's formula leaves of the mean step is rest z with z'z <= 1.
``half`` is 1/(2 beta), and ``root_d`` the root of d.

The constants gamma, m, b and l are those of `bounds.PROVED`.

References
----------
V. Erofeeva, O. Granichin, Theorem 1, whose proof is not in the paper.
"""

from __future__ import annotations

from ...algebra.identities import ONE, Identity, Square
from ...algebra.noncommuting import Form, letters, scalars
from ...algebra.rewriting import derive
from ...expressions import parse
from .bound_letters import (
    HALF,
    HALVED,
    HALVED_WORD,
    LETTERS,
    ROOT,
    ROOT_WORD,
    M,
    alpha,
    beta,
    c2,
    c3,
    c4,
    c_v2,
    constants,
    d,
    delta,
    half,
    mu,
    polynomial,
    rate,
    root_d,
)
from .bounds import PROVED

length, rest = scalars("length rest")
slack = scalars("s1 s2 s3 s4")

POSITIVE = "alpha beta mu M d root_d half rate scale inverse"
NONNEGATIVE = (
    "delta length rest c2 c3 c4 c_v2 s1 s2 s3 s4 over more noise "
    "rho lag keep tilt level loss slope x y z gamma m b l root_q "
    "pace k"
)
SYMBOLS: dict[str, str] = {
    **dict.fromkeys(POSITIVE.split(), "positive"),
    **dict.fromkeys(NONNEGATIVE.split(), "nonnegative"),
    **dict.fromkeys(("e", "w", "p", "q", "late", "early"), "vector: n"),
    **dict.fromkeys(("A", "B", "C", "size", "one", "steep"), "vector: n"),
    "Q": "matrix: n",
    "S": "positive semidefinite: n",
}


def squared(vector: Form) -> Form:
    """x'x."""
    return vector.T * vector


def paired(left: Form, right: Form) -> Form:
    """x'y, written so that it equals its transpose."""
    return HALF * (left.T * right + right.T * left)


def term(factor: Form) -> Square:
    """What is not negative by itself."""
    return Square(factor, ONE, ONE)


def square(factor: Form, vector: Form, weight: Form = ONE) -> Square:
    """factor x'Px."""
    return Square(factor, vector, weight)


def pull_bound() -> Form:
    """-2 e'EG is at most this."""
    along = (2 * mu + M) * delta + 2 * rest
    return along * length + M * delta * delta - 2 * mu * length * length


def push_bound() -> Form:
    """E|G|^2 is at most this."""
    reach = length + beta * root_d
    inner = 2 * d * c2 + 2 * d * M * M * reach * reach
    return 3 * d * (inner + half * half * (c3 * _apart() + c4 + c_v2))


def _apart() -> Form:
    """Bound on the square of what the first cost is taken at less its minimum."""
    return (length + delta) * (length + delta) + beta * beta * d


def mean_step() -> Identity:
    """(i) -2 e'EG is at most `pull_bound`.

    EG is the mean of the gradients at the two instants, late and early, and rest z; As1 holds at
    both, and early is M Q(e + eta) with Q'Q <= 1.
    """
    e, w, p, late, early, turn, loss = letters("e w p late early Q S", ("S",))
    s1, s2, s3, s4 = slack
    moved = length * e + delta * w
    relations = (
        squared(e) - ONE,
        squared(w) - ONE + s1,
        squared(p) - ONE + s2,
        length * (e.T * late) - mu * length * length - s3,
        moved.T * early - mu * squared(moved) - s4,
        early - M * turn * moved,
        turn.T * turn + loss - ONE,
    )
    found = ("e' e", "w' w", "p' p", "length e' late", "length e' early", "early", "Q' Q")
    goal = pull_bound() + length * paired(e, late + early) + 2 * rest * length * paired(e, p)
    cross, own = HALF * (M * delta * length), HALF * (M * delta * delta)
    squares = (
        term(s3),
        term(s4),
        square(mu * delta * length, e + w),
        term(mu * delta * length * s1),
        square(mu * delta * delta, w),
        square(rest * length, e + p),
        term(rest * length * s2),
        square(cross, w - turn * e),
        term(cross * s1),
        square(cross, e, loss),
        square(own, w - turn * w),
        term(2 * own * s1),
        square(own, w, loss),
    )
    return derive("mean step", goal, relations, dict(enumerate(found)), squares)


def mean_square() -> Identity:
    """(ii) E|G|^2 is at most `push_bound`.

    The difference of the two costs is A + B + C: A from the perturbation, at most
    2 beta root_d (|grad f(theta_t)| + M(|e| + beta root_d)), B from one sample to the next, by As5
    for every x, and C from the additive noise.
    """
    a, b, c, size, one, steep = letters("A B C size one steep")
    s1, s2, s3, s4 = slack
    spread = M * (length * size + beta * root_d * one)
    relations = (
        HALVED,
        squared(a) - 4 * beta * beta * d * squared(steep + spread) + s1,
        squared(b) - c3 * _apart() - c4 + s2,
        squared(c) - c_v2 + s3,
        squared(steep) - c2 + s4,
        squared(size) - ONE,
        squared(one) - ONE,
        ROOT,
    )
    found = (HALVED_WORD, "A' A", "B' B", "C' C", "steep' steep", "size' size", "one' one")
    share = d * half * half
    squares = (
        square(share, a - b),
        square(share, b - c),
        square(share, c - a),
        *(term(3 * share * entry) for entry in (s1, s2, s3)),
        square(3 * d * d, steep - spread),
        term(6 * d * d * s4),
        square(6 * d * d * M * M * length * beta * root_d, size - one),
    )
    words = dict(enumerate((*found, ROOT_WORD)))
    return derive(
        "mean square", push_bound() - share * squared(a + b + c), relations, words, squares
    )


def recursion() -> Identity:
    """(iii) |e|^2 + alpha (i) + alpha^2 (ii) is (1 - alpha m)|e|^2 + 2 alpha b|e| + alpha l."""
    gamma, m, b, low = scalars("gamma m b l")
    made = constants(PROVED, LETTERS | {"gamma": gamma})
    relations = (
        HALVED,
        ROOT,
        gamma - made["gamma"],
        m - 2 * (mu - alpha * gamma),
        b - made["b"],
        low - made["l"],
        rest - HALF * (M * beta * d * root_d),
    )
    step = length * length + alpha * pull_bound() + alpha * alpha * push_bound()
    promised = (ONE - alpha * m) * length * length + 2 * alpha * b * length + alpha * low
    words = {2: "gamma", 3: "m", 4: "b", 5: "l", 6: "rest", 0: HALVED_WORD, 1: ROOT_WORD}
    words = {k: words[k] for k in (3, 4, 5, 6, 2, 0, 1)}
    return derive("recursion", step - promised, relations, words)


def above_the_fixed_point() -> tuple[Identity, ...]:
    """(iv) rho^2 = keep (rho + lag)^2 + tilt (rho + lag) + level attracts from above.

    For an error rho + x, x >= 0, the square of the next one is lower by loss x^2 + 2 slope x, so
    that the sum of all x^2 is finite; from an error at or below rho, no error gets above it; and
    drift by lag adds at most lag to a root of a mean square.
    """
    rho, lag, keep, tilt, level = scalars("rho lag keep tilt level")
    loss, slope, x, y, z = scalars("loss slope x y z")
    p, q = letters("p q")

    def after(error: Form) -> Form:
        return keep * (error + lag) * (error + lag) + tilt * (error + lag) + level

    relations = (
        rho * rho - after(rho),
        keep + loss - ONE,
        slope - loss * (rho + lag) + lag + HALF * tilt,
        rho - y - z,
        squared(p) - ONE,
        squared(q) - ONE,
    )
    high = (rho + x) * (rho + x)
    above = derive(
        "above",
        high - after(rho + x) - loss * x * x - 2 * slope * x,
        relations,
        {0: "level", 1: "keep", 2: "slope"},
    )
    below = derive(
        "below",
        rho * rho - after(z),
        relations,
        {0: "level", 3: "rho"},
        (term(keep * y * (2 * lag + 2 * z + y)), term(tilt * y)),
    )
    drift = derive(
        "drift",
        (rho + lag) * (rho + lag) - squared(rho * p + lag * q),
        relations,
        {4: "p' p", 5: "q' q"},
        (square(rho * lag, p - q),),
    )
    return above, below, drift


def root() -> tuple[Identity, Identity]:
    """(v) The bound of `bounds.PROVED` for one block is that fixed point.

    With its lines lag and q, W^2 = q, inverse = 1/m, the drift 2k delta of a cycle and its value
    rho, rho^2 is (1 - alpha m) reach^2 + 2 alpha b reach + alpha l, reach = rho + 2k delta, and the
    slope of (iv) is alpha W.
    """
    rho, pace, m, b, low, w = scalars("rho pace m b l root_q")
    k, inverse = scalars("k inverse")
    own = {"k": k, "m": m, "b": b, "l": low, "lag": pace, "root_q": w, "inverse": inverse}
    names = LETTERS | own
    lines = {line.name: line.tree for line in PROVED.lines}
    value = parse(PROVED.value.text.replace("/m", "*inverse"))
    drift = 2 * k * delta
    relations = (
        rho - polynomial(value, names),
        pace - polynomial(lines["lag"], names),
        w * w - polynomial(lines["q"], names),
        alpha * rate - ONE,
        m * inverse - ONE,
    )
    reach = rho + drift
    kept = (ONE - alpha * m) * reach * reach + 2 * alpha * b * reach + alpha * low
    words = {0: "rho", 1: "pace", 2: "root_q**2", 3: "alpha rate", 4: "inverse m"}
    fixed = derive("root", rho * rho - kept, relations, words)
    slope = alpha * m * reach - drift - alpha * b
    return fixed, derive("slope", slope - alpha * w, relations, words)
