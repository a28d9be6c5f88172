"""How the claims about Assumptions 1 to 7, the second branch and the units are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from theory.systems.cyclic_spsa.bounds import PRINTED, unit_clashes
from theory.systems.cyclic_spsa.statements.theorem_1_examples import EXPONENTS
from verification.verdict import Decision, Verdict

from ..printed.promises import promised, root_above
from .common import disproof, proofs, replayed

KILOMETRE = 1000
"""Metres."""


def relied(made: Mapping[str, Mapping[str, Any]]) -> tuple[str, ...]:
    """Theorems that certificates rely on, each once."""
    return tuple(dict.fromkeys(text for entry in made.values() for text in entry["relies_on"]))


def second_branch() -> Decision:
    """gamma is at least 3 mu^2."""
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="M >= mu and d >= 1 make gamma at least 3 mu^2, as a polynomial without a negative "
        "coefficient shows for all constants; the second case needs 2 gamma <= mu^2.",
        printed="two cases",
        sharp="the first case always",
        margin_text="the second case is 6 times out of reach",
        repair="The set of steps is (0, mu/gamma), and 1 - alpha m >= 5/6 for every step.",
        repair_formula=r"\alpha\in(0,\mu/\gamma),\qquad 1-\alpha m\ge\tfrac56",
        certificates=disproof("theorem_1_second_branch") | proofs("theorem_1_second_branch_repair"),
    )


def constant_c1() -> Decision:
    """As1 and As2 make the mean gradient at the minimum vanish."""
    return Decision(
        verdict=Verdict.REFUTED,
        reason="Assumptions 1 and 2 at one point, theta - g/M for the mean gradient g at theta, "
        "give -(mu/M) g'g >= 0, as an identity: g = 0 for every cost, and c1 bounds nothing.",
        printed="c1",
        sharp="0",
        sharp_value=0.0,
        margin_text="the constant can be left out",
        certificates=disproof("theorem_1_c1"),
    )


def every_point() -> Decision:
    """The point does not occur in what is bounded."""
    made = replayed("assumption_5_every_point", {"c3": 0, "c4": 0, "x": 1})
    made |= proofs("theorem_1_mean_square")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="What the printed assumption bounds does not contain x, so that c3 = 0 always does. "
        "For (x - w)^2/2 - w^2/2 with w = 1 or -1 it is zero, with c4 = 0 as well, while the cost "
        "at x = 1 changes by 2 in the mean square from sample to sample, replayed over all signs.",
        printed="left side without x, distance without a square",
        sharp="the change at x, the distance squared",
        margin_text="the assumption says nothing about x",
        repair="With the change of the cost at x on the left and the squared distance of x from "
        "theta_(t-1) on the right, for every x, the mean square of the pseudogradient is bounded.",
        repair_formula=r"\begin{array}{l}E\bigl(f_{w_t}(x)-f_{w_{t-1}}(x)\bigr)^2 \\"
        r"\quad\le c_3\lVert x-\theta_{t-1}\rVert^2+c_4\quad\text{for every }x\end{array}",
        relies_on=relied(made),
        certificates=made,
    )


def not_convex() -> Decision:
    """A derivative that falls in between."""
    inputs = {
        "mu": Fraction(7, 10),
        "M": Fraction(2),
        "near": Fraction(1),
        "far": Fraction(2),
        "steep": Fraction(2),
        "back": Fraction(-1, 2),
        "onward": Fraction(1),
    }
    return Decision(
        verdict=Verdict.REFUTED,
        reason="An even cost whose derivative rises with slope 2 up to x = 1, falls with slope 1/2 "
        "up to x = 2 and rises with slope 1 beyond meets both with mu = 7/10 and M = 2, on every "
        "piece of the line, and its derivative falls from 2 to 3/2. Assumption 1 compares with "
        "the minimum only.",
        printed="convex",
        sharp="one minimum, and no other stationary point",
        margin_text="convexity is not implied",
        certificates=replayed("section_4_convex", inputs),
        replay=(("x", "derivative", "derivative/x"), *_derivative()),
    )


def _derivative() -> tuple[tuple[str, str, str], ...]:
    points = {1: Fraction(2), 2: Fraction(3, 2), 3: Fraction(5, 2), 4: Fraction(7, 2)}
    return tuple((str(x), str(g), str(g / x)) for x, g in points.items())


def clashing(*lines: str) -> str:
    """What the unit checker says about lines of the printed theorem."""
    found = unit_clashes(PRINTED)
    terms = (term for line in lines for entry in found.get(line, ()) for term in entry.terms)
    return ", ".join(f"{_read(text)} is in {unit}" for text, unit in terms)


def _read(text: str) -> str:
    """A formula of `bounds` as a sentence has it."""
    for name, meaning in (
        *(("3*change", "3(c4/beta + ...)"), ("root_d", "d^(1/2)"), ("c_v2", "c_v^2")),
        *(("**", "^"), ("*", " ")),
    ):
        text = text.replace(name, meaning)
    return text


def units_gamma() -> Decision:
    """c3/beta beside M^2 d."""
    names = ("d", "mu", "M", "c3", "beta")
    made = replayed("theorem_1_units_gamma", {**dict.fromkeys(names, 1), "scale": KILOMETRE})
    limits = [float(1 / Fraction(3 * (1 + 1))), _limit_in_metres() / KILOMETRE**2]
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Terms of two units are added: with F that of the cost and L that of length, "
        f"{clashing('gamma')}. With d = mu = M = c3 "
        f"= beta = 1 in km the printed limit is {limits[0]:.5g} km^2; the same constants in metres "
        f"give {limits[1]:.5g} km^2, replayed in rationals.",
        printed="c3/beta",
        sharp="c3/(8 beta^2)",
        margin_text=f"the limit becomes {limits[1] / limits[0]:.3g} times itself with the unit",
        repair="With c3/(8 beta^2), as the proof gives it, m, b and l follow the unit of length.",
        repair_formula=r"\gamma=3d\Bigl(M^2d+\frac{c_3}{8\beta^2}\Bigr)",
        certificates=made | proofs("theorem_1_units_repair"),
    )


def _limit_in_metres() -> float:
    squared, beta = KILOMETRE**2, KILOMETRE
    slope = Fraction(1, squared)
    return float(slope / (3 * (slope**2 + slope / beta)))


def converted(given: Mapping[str, Fraction], scale: int) -> dict[str, Fraction]:
    """The constants of a problem in a unit of length that is `scale` times smaller."""
    names = [name for name in EXPONENTS if not name.startswith("root")]
    return {name: given[name] * Fraction(scale) ** EXPONENTS[name] for name in names}


def units_l() -> Decision:
    """c_v^2 and c4/beta beside others, and a drift too many."""
    first = promised({"alpha": Fraction(1, 20), "beta": 1, "delta": 1})
    second = promised(converted(first, KILOMETRE))
    low = root_above(second["q"]) - Fraction(1, 10**6)
    inputs = {**first, **{f"{name}_new": value for name, value in second.items()}}
    inputs |= {"scale": Fraction(KILOMETRE), "low": low}
    values = float(first["bound"]), float(second["bound"]) / KILOMETRE
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Terms of several units are added: with F that of the cost and L that of length, "
        f"{clashing('change', 'spread', 'lag')}. For f_t(x) = (x - t)^2/2 with alpha = 1/20, beta "
        f"= 1 km and a drift of 1 km, (21) promises {values[0]:.6g} km, and for the same "
        f"constants in metres {values[1]:.6g} km, replayed in rationals.",
        printed=f"{values[0]:.4g} km, or {values[1]:.4g} km in metres",
        sharp="one length in every unit",
        margin_text=f"the bound becomes {values[1] / values[0]:.3g} times itself with the unit",
        repair="With c4 and c_v^2 over 4 beta^2, and the drift terms as the proof gives them, the "
        "bound is one length in every unit.",
        repair_formula=r"\begin{array}{l}l=M\delta^2+6\alpha d^2(c_2+dM^2\beta^2) \\"
        r"\quad+\frac{3\alpha d}{4\beta^2}\bigl(c_3(\delta^2+d\beta^2)+c_4+c_v^2\bigr)"
        r"\end{array}",
        certificates=replayed("theorem_1_units_l", inputs) | proofs("theorem_1_units_repair"),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "cyclic_spsa.theorem_1_second_branch": second_branch,
    "cyclic_spsa.theorem_1_c1": constant_c1,
    "cyclic_spsa.assumption_5_every_point": every_point,
    "cyclic_spsa.section_4_convex": not_convex,
    "cyclic_spsa.theorem_1_units_gamma": units_gamma,
    "cyclic_spsa.theorem_1_units_l": units_l,
}
