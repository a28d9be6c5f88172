"""How the printed claims about the discrete variational estimator are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from theory.algebra.lagrange import first_variation
from theory.algebra.noncommuting import Form, letters
from theory.systems.variational.statements.common import (
    EQUATION,
    PRINTED,
    SCHEME,
    energy,
    lagrangian,
)
from verification.certificates.make import certificate
from verification.exact.evaluate import Rows
from verification.verdict import Decision, Verdict

from ..figures import energy_over_time, radius_over_step
from ..steps import at_minus_one, step_limit
from .witnesses import derivation

ONE: Rows = ((Fraction(1),),)
UNIT_GAINS = {"M": ONE, "K": ONE, "C": ONE}
SAMPLE_STEP = Fraction(1, 10)
SAMPLE_STEPS = 6


def proposition_4_1() -> Decision:
    """(20) is the discrete Lagrange-d'Alembert equation of the action (21).

    The equation is derived from the Lagrangian, compared with the printed recursion, and the
    variation of the last term of the printed sum is taken as well.
    """
    difference = EQUATION + PRINTED
    surplus = first_variation(lagrangian, last_term=True)
    document = certificate("variational", "prop_4_1", {}, [derivation(), derivation()])
    return Decision(
        verdict=Verdict.PROVED if not difference.terms else Verdict.UNDECIDED,
        reason="The first variation of the action is expanded as an identity in non-commuting M, "
        "K, C "
        "and equals the printed recursion; the sum in (21) must end at N - 1, because the "
        "variation of "
        f"its term k = N alone would demand {_words(surplus).replace('v', 'u_N')} = 0.",
        printed="(20)",
        sharp=f"0 = {_words(EQUATION)}",
        margin_text="identical",
        certificates={"variational.prop_4_1": document},
    )


REPAIR_RELATIONS = (
    ("-1/4*T(u + v)", "1", "1"),
    ("-1/4", "1'", "u + v"),
    ("-1/4*T(x + y)*K", "0", "1"),
    ("-1/4", "0'", "K*(x + y)"),
)
"""M(u - v) = hCv + hKy in u'Mu - v'Mv, and hu = y - x in what remains."""


def discrete_energy() -> Decision:
    """The printed energy at equal index grows for every h; a corrected energy falls."""
    refuted = certificate(
        "variational",
        "discrete_energy",
        {},
        [
            derivation(),
            derivation((), ("-1", "0'", "x")),
            derivation((("h", "x", "K"),)),
            derivation((("1/2", "1", "M"),)),
            derivation((("h", "1", "K"),)),
        ],
        case="REFUTED",
    )
    repaired = certificate(
        "variational",
        "discrete_energy_repair",
        {},
        [
            derivation((), *REPAIR_RELATIONS),
            derivation((("1/4*h", "u + v", "C"),), *REPAIR_RELATIONS),
            derivation(),
        ],
    )
    table = _orbit(SAMPLE_STEP, SAMPLE_STEPS)
    growth = Fraction(table[2][3]) / Fraction(table[1][3])
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="One step of (20) from any position error x and velocity error 0 raises the energy "
        "by "
        "1/2 v'Mv, for every h > 0 and all M, K, C > 0, as an identity; the corrected energy W "
        "loses "
        "h/4 (u+v)'C(u+v) in every step, as an identity modulo (20).",
        printed="E(k+1) <= E(k)",
        sharp=f"E(1)/E(0) = {float(growth):.6f}",
        printed_value=1.0,
        sharp_value=float(growth),
        margin_text=f"grows by {float(growth - 1):.2%} in one step at M = K = C = 1, h = 1/10, "
        "from u = 0",
        repair="W = 1/2 u'(M + hC/2)u + 1/2 x'Kx + h/2 x'Ku never grows along (20); it is positive "
        "definite exactly while 4M + 2hC - h^2 K is.",
        repair_formula=r"W_k=\tfrac12u_k^{\mathsf T}\left(M+\tfrac h2C\right)u_k"
        r"+\tfrac12x_k^{\mathsf T}Kx_k+\tfrac h2x_k^{\mathsf T}Ku_k,\qquad "
        r"W_{k+1}-W_k=-\tfrac h4(u_{k+1}+u_k)^{\mathsf T}C(u_{k+1}+u_k)",
        certificates={
            "variational.discrete_energy": refuted,
            "variational.discrete_energy_repair": repaired,
        },
        replay=table,
        figure=energy_over_time(),
    )


def _orbit(h: Fraction, steps: int) -> tuple[tuple[str, ...], ...]:
    """Exact states and energies of (20) for M = K = C = 1 from x = 1, u = 0."""
    x, u = Fraction(1), Fraction(0)
    rows: list[tuple[str, ...]] = [("k", "x", "u", "E", "E as a decimal")]
    for k in range(steps):
        level = _energy_of(x, u)
        rows.append((str(k), str(x), str(u), str(level), f"{float(level):.9f}"))
        x = x + h * u
        u = (u - h * x) / (1 + h)
    return tuple(rows)


def _energy_of(x: Fraction, u: Fraction) -> Fraction:
    """The printed energy of scalar errors, evaluated from its form."""
    total = Fraction(0)
    for (_, word), a in energy(*letters("x u")).terms.items():
        total += a * (x * x if "x" in word else u * u)
    return total


def discrete_stability() -> Decision:
    """(20) is stable only below a step limit."""
    answer = step_limit(UNIT_GAINS)
    h = Fraction(int(answer.upper * 4) + 1, 4)
    refuted = certificate(
        "variational",
        "discrete_stability",
        {**UNIT_GAINS, "h": h},
        [{"kind": "vector", "x": [1]}],
        case="REFUTED",
    )
    repaired = certificate(
        "variational",
        "discrete_stability_repair",
        {},
        [
            derivation((("h", "1", "C"),)),
            derivation((("2", "1", "M"), ("h", "1", "C"))),
            derivation((("h**2", "1", "K"),)),
            derivation((("1", "1", "Q"),), ("-1", "0", "1")),
        ],
    )
    assert answer.certificate is not None
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"At M = K = C = 1 and h = {h} the recursion has a solution that does not decay; "
        f"below "
        "the threshold, Jury's conditions hold for the quadratic form of every vector, because "
        f"{_conditions()} are positive definite.",
        printed="every h > 0",
        sharp=f"h < {answer.value:.5g} at M = K = C = 1",
        sharp_value=answer.value,
        margin_text="the limit is missing",
        repair="(20) is asymptotically stable for all gains and steps with 4M + 2hC - h^2 K "
        "positive definite; for given gains, the step where that ends is certified from both "
        "sides.",
        repair_formula=r"4M+2hC-h^2K\succ0",
        certificates={
            "variational.discrete_stability": refuted,
            "variational.discrete_stability_repair": repaired,
            "variational.discrete_stability_limit": answer.certificate,
        },
        figure=radius_over_step(float(answer.value)),
    )


def _conditions() -> str:
    """The four forms of Jury's conditions."""
    a2, a1, a0 = SCHEME.a2, SCHEME.a1, SCHEME.a0
    forms = (a2 - a0, a2 + a0, a2 + a1 + a0, at_minus_one(SCHEME))
    return ", ".join(map(_words, forms[:-1])) + f" and {_words(forms[-1])}"


def _words(form: Form) -> str:
    """A form for readers: 2 M + h C - h^2 K."""
    return str(form).replace("**", "^").replace("*", " ")


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "variational.prop_4_1": proposition_4_1,
    "variational.discrete_energy": discrete_energy,
    "variational.discrete_stability": discrete_stability,
}
