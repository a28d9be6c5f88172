"""What certificates about late data, lost sensors and moving targets prove."""

from __future__ import annotations

import re
from collections.abc import Mapping

from ....algebra.noncommuting import Form, letters, scalars
from ....statements import BRACKET, Case, Statement
from . import simulated
from .common import ANY_GAINS, DEFINITE, GAINS, SCHEME, pencil

MOST_DELAY = 6
"""Samples of delay up to which certificates are offered."""

PRESENT: Mapping[int, Form] = {
    power: form.substitute({"K": Form({})})
    for power, form in ((2, SCHEME.a2), (1, SCHEME.a1), (0, SCHEME.a0))
}
"""The recursion without the pull of K, by the power of the shift."""

PULL: Form = SCHEME.a1 - PRESENT[1]
"""h^2 K, which meets the position error at the power 1 - d when that error is d samples late."""


def blocks_of(delay: int) -> int:
    """Positions that one state of the delayed recursion holds, newest first."""
    return max(2, delay + 1)


def late_step(delay: int) -> tuple[str, str]:
    """E and F of E X+ = F X for the stacked positions, as expressions.

    The newest of the stacked positions is x_{k+1}; E0, E1, ... are the blocks of an orthonormal
    basis, so that X = E0 x_{k+1} + E1 x_k + ...
    """
    blocks = blocks_of(delay)
    shifted = [f"E{j}*T(E{j})" for j in range(1, blocks)]
    moved = [f"E{j}*T(E{j - 1})" for j in range(1, blocks)]
    newest = f"({-PRESENT[1]})*T(E0) - ({PRESENT[0]})*T(E1) - ({PULL})*T(E{delay})"
    left = " + ".join([f"E0*({PRESENT[2]})*T(E0)", *shifted])
    right = " + ".join([f"E0*({newest})", *moved])
    return left, right


def basis(blocks: int) -> tuple[str, ...]:
    """Predicates that E0, E1, ... are orthonormal blocks of the size of M."""
    made = ["exists(I, I*M == M)"]
    for j in range(blocks):
        others = [f"T(E{i})*E{j} == 0*I" for i in range(j)]
        made.append(f"exists(E{j}, {', '.join([f'T(E{j})*E{j} == I', *others])})")
    return tuple(made)


def _at(step: str, delay: int) -> tuple[str, str]:
    left, right = (re.sub(r"\bh\b", step, text) for text in late_step(delay))
    return left, right


def _decrease(form: str, step: str, delay: int) -> str:
    left, right = _at(step, delay)
    return f"pd(T({left})*{form}*({left}) - T({right})*{form}*({right}))"


def _delay_case(delay: int) -> Case:
    words = (
        f"M, K, C are symmetric positive definite and the position error is used {delay} samples "
        "late: at the step h = lower every solution tends to 0, at the step h = upper some "
        "solution does not"
    )
    stable = f"exists(P, pd(P), {_decrease('P', 'lower', delay)})"
    not_so = f"exists(Q, dips(Q), {_decrease('Q', 'upper', delay)})"
    ends = (f"d == {delay}", "lower > 0", "upper > lower")
    show = (*DEFINITE, *ends, *basis(blocks_of(delay)), stable, not_so)
    return Case("PROVED", words, show, BRACKET)


def _delay() -> Statement:
    cases = {f"PROVED {d}": _delay_case(d) for d in range(MOST_DELAY + 1)}
    return Statement("variational", "delay_step_limit", cases, GAINS | {"d": "number"})


def _too_late() -> Statement:
    words = (
        "M, K, C are symmetric positive definite, every solution of (20) tends to 0 at the step h, "
        "and some solution does not when the position error is used one sample late"
    )
    late = f"exists(Q, dips(Q), {_decrease('Q', 'h', 1)})"
    show = (*DEFINITE, "h > 0", f"schur({pencil(SCHEME)})", *basis(blocks_of(1)), late)
    return Statement(
        "variational",
        "section_4_instantaneous",
        {"REFUTED": Case("REFUTED", words, show)},
        inputs=GAINS | {"h": "number"},
    )


ONE_LATE = (SCHEME.a2, PRESENT[1], PRESENT[0] + PULL)
"""Coefficients of the recursion with the position error one sample late, newest first."""


def _one_late() -> Statement:
    C, K, Q = letters("C K Q", "CKQ")
    (h,) = scalars("h")
    words = (
        "for all M, K, C > 0 of any size and every h > 0 with C - hK > 0, every solution tends to "
        "0 when the position error is used one sample late"
    )
    show = f"schur({', '.join(map(str, ONE_LATE))})"
    return Statement(
        "variational",
        "section_4_instantaneous_repair",
        {"PROVED": Case("PROVED", words, (show,))},
        symbols=ANY_GAINS | {"Q": "positive definite: n"},
        given=(str(Q - C + h * K),),
    )


def _one_coordinate() -> Statement:
    """The last coefficient is the product of the roots times the first."""
    m, k, c, s, h = scalars("m k c s h")
    first, _, last = (form.substitute({"M": m, "K": k, "C": c}) for form in ONE_LATE)
    words = (
        "for all numbers m, k, c, h > 0 with hk >= c, one coordinate and the position error one "
        f"sample late: the two roots have a product ({last})/({first}) of one or more, so that "
        "some solution does not tend to 0"
    )
    return Statement(
        "variational",
        "section_4_instantaneous_necessary",
        {"PROVED": Case("PROVED", words, (f"{last} >= {first}",))},
        symbols=dict.fromkeys("mkch", "positive") | {"s": "nonnegative"},
        given=(str(h * k - c - s),),
    )


STATEMENTS: tuple[Statement, ...] = (
    *simulated.STATEMENTS,
    _too_late(),
    _one_late(),
    _one_coordinate(),
    _delay(),
)
