"""What certificates about Assumptions 1 to 7 and Theorem 1 prove."""

from __future__ import annotations

from itertools import product

from ....statements import Case, Statement
from ..bounds import PRINTED
from . import theorem_1_examples, theorem_1_small_steps
from .bound_lines import (
    SIGNS,
    Cost,
    constants,
    half_square,
    inputs_of,
    mean,
    mean_square,
    promise,
    update,
)
from .theorem_1_proofs import UNIVERSAL

PROMISED = (
    "the step is in the printed interval, and (21) promises in the long run at most `bound` for "
    "the root of the mean square of the error (roots rounded up)"
)
QUADRATIC = "d = k = 1, f_t(x) = (x - theta_t)^2/2, so that mu = M = 1 and c2 = c3 = c4 = c_v = 0"
SECOND = "x - 2*delta"
"""The error x after a step, seen from the target two samples later, and one later."""
FIRST = "x - delta"


def refuted(
    name: str, words: str, show: tuple[str, ...], more: tuple[str, ...] = (), bound: bool = True
) -> Statement:
    """A counterexample in numbers: the lines of the promise, and what happens instead."""
    inputs = (inputs_of(PRINTED) if bound else {}) | dict.fromkeys(more, "number")
    lines = promise() if bound else ()
    case = Case("REFUTED", words, (*lines, *show))
    return Statement("cyclic_spsa", name, {"REFUTED": case}, inputs)


def _lag(name: str, early: str, instants: str) -> Statement:
    def next_of(x: str) -> str:
        places = (text.replace("x", x) for text in (SECOND, early))
        late, first = places
        return mean([update(sign, late, first) for sign in SIGNS])

    words = (
        f"{PROMISED}; {QUADRATIC}, no noise, {instants}. The target moves by delta in every "
        "sample. One step makes of the error x in the mean of both signs of the perturbation an "
        "affine function of slope 1 - alpha, which returns `error`: the mean error tends to it, "
        "and its size is above the bound"
    )
    show = (
        *constants(),
        "delta > 0",
        f"{next_of('error')} == error",
        f"forall(x, 0, 1, {next_of('(error + x)')} == error + (1 - alpha)*x)",
        "-error > bound",
    )
    return refuted(name, words, show, ("error",))


def _every_path() -> Statement:
    words = (
        f"{PROMISED}; {QUADRATIC}, no noise, two instants. The target moves by delta in every "
        "sample. In y = x - 3 delta/2, x the error after a step: from every |y| >= start either "
        "sign of the perturbation leads to a |y| at least growth > 1 times as large, so that the "
        "error tends to infinity on every path"
    )

    def next_of(sign: str, y: str) -> str:
        return update(sign, f"({y} - delta/2)", f"({y} + delta/2)")

    def gains(sign: str) -> str:
        turned = "-" if sign == "-1" else ""
        forward = f"{turned}({next_of(sign, 'y')} - 3*delta/2) - growth*y"
        back = f"-{turned}({next_of(sign, '(-y)')} - 3*delta/2) - growth*y"
        return f"forall(y, start, inf, pd({forward}), pd({back}))"

    show = (*constants(), "delta > 0", "start > 0", "growth > 1", *map(gains, SIGNS))
    return refuted("theorem_1_interval", words, show, ("start", "growth"))


def _noise_divergence() -> Statement:
    def cost(noise: str) -> Cost:
        return lambda z: f"(({z} - {noise})**2/2 - {noise}**2/2)"

    def next_of(x: str) -> list[str]:
        return [
            update(sign, x, x, (cost(f"({late})"), cost(f"({early})")))
            for sign, late, early in product(SIGNS, repeat=3)
        ]

    words = (
        f"{PROMISED}; d = k = 1, a target at rest, f_w(x) = (x - w)^2/2 - w^2/2 with w = 1 or -1, "
        "equally likely and new in every sample: mu = M = 1, c2 = E w^2 = 1, and c3 = c4 = 0 "
        "because f_w(0) = 0. With two instants the mean square of the error x grows in every step "
        "by a factor of growth > 1 at least"
    )
    grown = [f"pd({mean_square(next_of(x))} - growth*x**2)" for x in ("x", "(-x)")]
    show = (*constants(c2=1), "delta == 0", "growth > 1", f"forall(x, 0, inf, {', '.join(grown)})")
    return refuted("theorem_1_interval_noise", words, show, ("growth",))


def _every_x() -> Statement:
    words = (
        f"{PROMISED}; d = k = 1, f_t(x) = (x - theta_t)^2/2, no noise, two instants, and the "
        "target moves by delta in every sample. With z the distance of x from the first minimum, "
        "the cost changes by delta^2/2 - delta z, whose square is at most c3 z^2 + c4 for every z, "
        "because the discriminant of the difference is not positive: Assumption 5 is met at every "
        "point. Yet the mean square of the error grows by growth > 1 in every step: with y the "
        "error before it, seen from the middle of the two targets, the mean square of y after it "
        "is growth y^2 - 4 (1 - alpha) delta y + 4 delta^2, and the mean of y is (1 - alpha) times "
        "that before less 2 delta, so that it is negative in the long run"
    )
    steps = [f"({update(s, '(y - delta/2)', '(y + delta/2)')} - 3*delta/2)" for s in SIGNS]
    after = "growth*y**2 - 4*(1 - alpha)*delta*y + 4*delta**2"
    show = (
        *(text for text in constants() if not text.startswith(("c3", "c4"))),
        "delta > 0",
        "c3 > delta**2",
        "c4 > delta**4/4",
        "4*(c3 - delta**2)*(c4 - delta**4/4) >= delta**3*delta**3",
        f"forall(y, 0, 1, {mean_square(steps)} == {after})",
        f"forall(y, 0, 1, {mean(steps)} == (1 - alpha)*y - 2*delta)",
        "growth > 1",
    )
    return refuted("theorem_1_interval_every_point", words, show, ("growth",))


def _additive(name: str, source: str, constant: str) -> Statement:
    def cost(noise: str) -> Cost:
        return lambda z: f"({half_square(z)} + {noise})"

    steps = [
        update(sign, "x", "x", (cost(f"({late})"), cost(f"({early})")))
        for sign, late, early in product(SIGNS, repeat=3)
    ]
    words = (
        f"{PROMISED}; d = k = 1, a target at rest, f(x) = x^2/2 {source} that is 1 or -1, equally "
        f"likely and new in every sample: mu = M = 1, {constant} = 2. One step makes of the error "
        "x the mean square keep x^2 + fresh, so that it tends to `square`, whose root is above the "
        "bound"
    )
    values = {"c_v2" if "v" in constant else "c4": 2}
    show = (
        *constants(**values),
        "delta == 0",
        f"forall(x, 0, 1, {mean_square(steps)} == keep*x**2 + fresh)",
        "0 <= keep",
        "keep < 1",
        "square == keep*square + fresh",
        "square > bound**2",
    )
    return refuted(name, words, show, ("keep", "fresh", "square"))


def _walk() -> Statement:
    steps = [
        update(sign, f"(x - ({p})*delta - ({q})*delta)", f"(x - ({p})*delta)")
        for sign, p, q in product(SIGNS, repeat=3)
    ]
    words = (
        f"{PROMISED}; {QUADRATIC}, no noise, two instants. The target moves in every sample by "
        "delta or -delta, equally likely and independent of the past, which meets Assumption 4 for "
        "random drift; no move is above delta, so that for moves fixed beforehand it is met "
        "as well, and what is above in the mean over all moves is so for some of them. One step "
        "makes of the error x the mean square keep x^2 + fresh, so that it tends to `square`, "
        "whose root is above the bound"
    )
    show = (
        *constants(),
        "delta > 0",
        f"forall(x, 0, 1, {mean_square(steps)} == keep*x**2 + fresh)",
        "0 <= keep",
        "keep < 1",
        "square == keep*square + fresh",
        "square > bound**2",
    )
    return refuted("theorem_1_bound_walk", words, show, ("keep", "fresh", "square"))


def _found() -> Statement:
    def cost(noise: str) -> Cost:
        return lambda z: f"M*({z} - ({noise})*sigma)**2/2"

    steps = [
        update(sign, f"({SECOND})", f"({FIRST})", (cost(late), cost(early)))
        for sign, late, early in product(SIGNS, repeat=3)
    ]
    words = (
        f"{PROMISED}; d = k = 1, the cost M (x - theta - w)^2/2 with w = sigma or -sigma, equally "
        "likely and new in every sample, so that mu = M, c2 = M^2 sigma^2 and c3 = c4 = 0, two "
        "instants, and a target that moves by delta in every sample. One step makes of the error x "
        "the mean slope x + shift and the mean square keep x^2 + tilt x + fresh; they tend to "
        "`error` and `square`, and the root of `square` is above the bound"
    )
    show = (
        *(text for text in constants() if not text.startswith(("mu", "M", "c2"))),
        "mu == M",
        "c2 == M**2*sigma**2",
        f"forall(x, 0, 1, {mean(steps)} == slope*x + shift)",
        f"forall(x, 0, 1, {mean_square(steps)} == keep*x**2 + tilt*x + fresh)",
        "slope**2 < 1",
        "keep < 1",
        "error == slope*error + shift",
        "square == keep*square + tilt*error + fresh",
        "square > bound**2",
    )
    names = ("sigma", "slope", "shift", "keep", "tilt", "fresh", "error", "square")
    return refuted("theorem_1_bound_found", words, show, names)


STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in UNIVERSAL),
    _lag("theorem_1_bound", FIRST, "two instants"),
    _lag("theorem_1_bound_one_instant", SECOND, "one instant"),
    _every_path(),
    _noise_divergence(),
    _every_x(),
    _additive("theorem_1_bound_noise", "measured with additive noise v", "c_v^2"),
    _additive("theorem_1_bound_level", "+ w with a level w, two instants,", "c4"),
    _walk(),
    _found(),
    *theorem_1_small_steps.STATEMENTS,
    *theorem_1_examples.STATEMENTS,
)
