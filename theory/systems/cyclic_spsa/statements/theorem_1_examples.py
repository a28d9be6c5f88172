"""Examples in numbers: what Assumptions 1, 2 and 5 do not say, and units that do not fit."""

from __future__ import annotations

import re
from itertools import product

from ....statements import Case, Statement
from ..bounds import PRINTED
from .bound_lines import inputs_of, mean, promise

EXPONENTS = {
    "alpha": 2, "beta": 1, "delta": 1, "mu": -2, "M": -2, "c2": -2, "c3": -2, "c4": 0, "c_v2": 0,
    "d": 0, "k": 0, "root_d": 0, "root_k": 0,
}  # fmt: skip
"""Powers of the unit of length in the constants; the unit of the cost stays."""


def _example(name: str, words: str, show: tuple[str, ...], inputs: dict[str, str]) -> Statement:
    return Statement("cyclic_spsa", name, {"REFUTED": Case("REFUTED", words, show)}, inputs)


def _converted(name: str, power: int) -> str:
    """The constant in the new unit: no power of a power later on."""
    factor = "*scale" if power > 0 else "/scale"
    return name + factor * abs(power)


def _gamma_units() -> Statement:
    new = {name: f"({_converted(name, power)})" for name, power in EXPONENTS.items()}
    old_limit = "mu/(3*d*(M**2*d + c3/beta))"
    new_limit = re.sub(r"[a-zA-Z_0-9]+", lambda found: new.get(found[0], found[0]), old_limit)
    words = (
        "one problem in two units of length, a length of 1 in the first being one of scale in the "
        "second: its steps, of unit length^2/cost, are multiplied by scale^2, the printed limit "
        "mu/gamma is not, because c3/beta has another unit than M^2 d (c3 that of (cost/length)^2)"
    )
    positive = tuple(f"{name} > 0" for name in ("mu", "M", "c3", "beta"))
    show = ("d >= 1", *positive, "scale > 1", f"{new_limit} != ({old_limit})*scale**2")
    names = ("d", "mu", "M", "c3", "beta", "scale")
    return _example("theorem_1_units_gamma", words, show, dict.fromkeys(names, "number"))


def _bound_units() -> Statement:
    one = inputs_of(PRINTED)

    def renamed(text: str) -> str:
        return re.sub(r"[a-zA-Z][a-zA-Z_0-9]*", lambda found: found[0] + "_new", text)

    words = (
        "one problem in two units of length, a length of 1 in the first being one of scale in the "
        "second, whose constants have `_new` in their names; the unit of the cost stays. (21) "
        "promises at most `bound` in the first (a root rounded up), and in the second at least "
        "k^(1/2)(b_new + low)/m_new (low a root rounded down), which is more than twice the first "
        "promise, converted"
    )
    moved = tuple(f"{name}_new == {_converted(name, power)}" for name, power in EXPONENTS.items())
    show = (
        *promise(),
        *moved,
        *map(renamed, promise()),
        "root_d**2 == d",
        "root_k**2 == k",
        "low >= 0",
        "low**2 <= q_new",
        "(b_new + low)/m_new > 2*scale*bound",
    )
    inputs = one | {renamed(name): kind for name, kind in one.items()}
    return _example("theorem_1_units_l", words, show, inputs | {"scale": "number", "low": "number"})


def _no_point() -> Statement:
    def level(x: str, w: str) -> str:
        return f"(({x} - ({w}))**2/2 - ({w})**2/2)"

    def change(x: str) -> str:
        pairs = product(("1", "-1"), repeat=2)
        return mean(
            [f"({level(x, w)} - {level(x, v)})*({level(x, w)} - {level(x, v)})" for w, v in pairs]
        )

    words = (
        "f_w(x) = (x - w)^2/2 - w^2/2 with w = 1 or -1, equally likely and new in every sample, "
        "has its mean minimum at 0: what is bounded by the printed Assumption 5, the mean square "
        "of f_t(theta_t) - f_(t-1)(theta_(t-1)), is 0, so that c3 = c4 = 0 meet it, while the mean "
        "square of f_t(x) - f_(t-1)(x) is 2 x^2 at every x, here above c3 (x - theta)^2 + c4"
    )
    show = (
        "c3 == 0",
        "c4 == 0",
        f"{change('0')} <= c4",
        f"forall(z, 0, 1, {change('z')} == 2*z**2)",
        f"{change('x')} > c3*x**2 + c4",
    )
    return _example(
        "assumption_5_every_point", words, show, dict.fromkeys(("c3", "c4", "x"), "number")
    )


def _not_convex() -> Statement:
    words = (
        "an even cost whose derivative g is continuous and straight in pieces: of slope steep up "
        "to near, back < 0 up to far, onward beyond; g(x) > mu x for x > 0, and every slope is at "
        "most M in size, so that Assumptions 1 and 2 hold with the minimum 0. But g falls from "
        "near to far: the cost is not convex"
    )
    ends = ("steep*near", "(steep*near + back*(far - near))")
    pieces = (
        "forall(x, 0, near, pd(steep*x - mu*x))",
        f"forall(x, near, far, pd({ends[0]} + back*(x - near) - mu*x))",
        f"forall(x, far, inf, pd({ends[1]} + onward*(x - far) - mu*x))",
    )
    slopes = tuple(f"{s}**2 <= M**2" for s in ("steep", "back", "onward"))
    show = ("mu > 0", "M >= mu", *pieces, *slopes, f"{ends[0]} > {ends[1]}")
    names = ("mu", "M", "near", "far", "steep", "back", "onward")
    return _example("section_4_convex", words, show, dict.fromkeys(names, "number"))


STATEMENTS: tuple[Statement, ...] = (_gamma_units(), _bound_units(), _no_point(), _not_convex())
