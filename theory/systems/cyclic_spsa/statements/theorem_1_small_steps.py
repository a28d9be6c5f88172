"""What certificates about every small step prove: Theorem 1 asks for a step that is small enough.

The lines of (21) are polynomials in the step, but for 1/alpha in l. All is multiplied by alpha: X
is alpha times the size of the limit of the mean error, and X/alpha is above (b + (b^2 + m
l)^(1/2))/m where m X - alpha b and m X^2 - 2 alpha b X - alpha^2 l are positive.
"""

from __future__ import annotations

import re

from ....statements import Case, Statement
from ..bounds import PRINTED
from .bound_lines import SIGNS, constants, mean, update

RATE = "/alpha"
"""In the last summand of the printed l."""


def inlined(name: str) -> str:
    """A line of (21) in the constants and the step alone; l without its division by the step."""
    texts = {line.name: line.text.replace(RATE, "") for line in PRINTED.definitions}
    return re.sub(
        r"[a-zA-Z_][a-zA-Z_0-9]*",
        lambda found: f"({inlined(found[0])})" if found[0] in texts else found[0],
        texts[name],
    )


def _scaled_l() -> str:
    """The step times the printed l."""
    *others, last = PRINTED_L.split(" + ")
    if [RATE in text for text in (*others, last)] != [False] * len(others) + [True]:
        raise ValueError("l: its last summand alone is divided by the step")
    names = {name: f"({inlined(name)})" for name in ("l_bar", "b", "m")}
    whole = f"alpha*({' + '.join(others)}) + {last.replace(RATE, '')}"
    return re.sub(r"\b(l_bar|b|m)\b", lambda found: names[found[0]], whole)


PRINTED_L = next(line.text for line in PRINTED.definitions if line.name == "l")
SCALED_L = _scaled_l()


def _small(part: str, early: str, lag: str, instants: str) -> Statement:
    """Above the bound at every step up to `upper`."""

    def next_of(x: str) -> str:
        return mean([update(sign, f"({x} - 2*delta)", f"({x} - {early})") for sign in SIGNS])

    m, b, size = f"({inlined('m')})", f"({inlined('b')})", f"(({lag})*delta)"
    steps = (f"{next_of(str(x))} == (1 - alpha)*{x} - {size}" for x in range(3))
    above = f"{m}*{size}*{size} - 2*alpha*{b}*{size} - alpha*({SCALED_L})"
    words = (
        "d = k = 1, f_t(x) = (x - theta_t)^2/2, so that mu = M = 1 and c2 = c3 = c4 = c_v = 0, no "
        f"noise, {instants}, and a target that moves by delta in every sample. For every step "
        f"0 < alpha <= upper, all of them in the printed interval, the mean error x becomes "
        f"(1 - alpha) x - X in a step, X = ({lag}) delta, and so tends to -X/alpha; and "
        "m X - alpha b > 0 and m X^2 - 2 alpha b X - alpha^2 l > 0 for the printed m, b and l, so "
        "that X/alpha is above (b + (b^2 + m l)^(1/2))/m, which is what (21) promises"
    )
    show = (
        *constants(),
        *("root_d == 1", "root_k == 1", "beta > 0", "delta > 0", "upper > 0"),
        f"upper*({inlined('gamma')}) < mu",
        f"forall(alpha, 0, upper, {', '.join(steps)}, pd({m}*{size} - alpha*{b}), pd({above}))",
    )
    names = [
        "d",
        "k",
        "mu",
        "M",
        "c2",
        "c3",
        "c4",
        "c_v2",
        "root_d",
        "root_k",
        "beta",
        "delta",
        "upper",
    ]
    case = Case("REFUTED", words, show)
    inputs = dict.fromkeys(names, "number")
    return Statement("cyclic_spsa", f"theorem_1_bound{part}_small", {"REFUTED": case}, inputs)


STATEMENTS: tuple[Statement, ...] = (
    _small("", "delta", "2 - 3*alpha/2", "two instants"),
    _small("_one_instant", "2*delta", "2 - 2*alpha", "one instant"),
)
