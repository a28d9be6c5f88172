"""How the claims about the continuous estimator are decided."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any

from theory.algebra.continuous_lagrange import principle
from theory.algebra.identities import Identity
from theory.systems.variational.statements.common import dissipation, lagrangian
from theory.systems.variational.statements.decays import (
    ENERGY,
    EXACT,
    MOTION,
    PRINTED_MOTION,
    RATE,
    REST,
    STRICT,
)
from verification.certificates.make import certificate
from verification.exact.evaluate import Rows
from verification.verdict import Decision, Verdict

from ..energies import energies_over_time
from .best_damping import ceiling, planar, planar_gains, planar_instance
from .witnesses import derivation

ROOTS = Fraction(1), Fraction(2)
"""Square roots of the undamped frequencies 1 and 4 of the planar example."""


def _derived(*identities: Identity) -> list[dict[str, Any]]:
    return [{"kind": "derivation", **entry.to_data()} for entry in identities]


def proposition_3_1() -> Decision:
    """(12) is the Lagrange-d'Alembert equation of the Lagrangian (11) with the force -Cu."""
    difference = MOTION - PRINTED_MOTION
    document = certificate(
        "variational", "prop_3_1", {}, _derived(*principle(lagrangian, dissipation))
    )
    return Decision(
        verdict=Verdict.UNDECIDED if difference.terms else Verdict.PROVED,
        reason="The first variation of (11) plus the work of -Cu is d/dt(d'Mu) - d'(Mu' + Cu + "
        "Kx), as an identity in non-commuting M, K, C for every path and every variation d; C "
        "need be neither symmetric nor positive.",
        printed="Mu' = -Cu - Kx",
        sharp=f"{_words(MOTION)} = 0",
        margin_text="identical",
        relies_on=tuple(document["relies_on"]),
        certificates={"variational.prop_3_1": document},
    )


def eq_15_dissipation() -> Decision:
    """The energy has the printed rate, whether C is symmetric or not."""
    document = certificate(
        "variational", "eq_15_dissipation", {}, [derivation(), *_derived(*ENERGY)]
    )
    return Decision(
        verdict=Verdict.PROVED,
        reason="E' = u'Mu' + u'Kx becomes -u'(C + C')u/2 when Mu' is replaced by (12), as an "
        "identity for gains of any size; it is at most zero because C + C' is positive, so that "
        "C need not be symmetric.",
        printed="E' = -u'Cu <= 0",
        sharp="E' = -u'(C + C')u/2 <= 0",
        margin_text="holds without symmetry of C",
        certificates={"variational.eq_15_dissipation": document},
    )


def theorem_3_2_stability() -> Decision:
    """Errors tend to zero, even exponentially, by a strict Lyapunov function."""
    main = certificate(
        "variational",
        "theorem_3_2_stability",
        {},
        [derivation(), *_derived(RATE[0]), derivation(), *_derived(RATE[1])],
    )
    exact = certificate(
        "variational", "theorem_3_2_stability_rate", {}, [derivation(), *_derived(*EXACT)]
    )
    attained = planar_instance(*ROOTS)
    return Decision(
        verdict=Verdict.PROVED,
        reason="V = E + 4a x'Mu is positive definite and V' <= -2aV for every a > 0 with "
        "(C + C')/2 - 6aM - 2aC'K^-1 C > 0, as sums of squares modulo (12); small a satisfy this, "
        "C need not be symmetric, and no invariance principle is used. With C = 2gM and "
        "g^2 M < K, V' = -2gV exactly.",
        printed="x, u tend to 0",
        sharp="V(t) <= exp(-2at) V(0)",
        margin_text="exponential; by choice of C no faster than (det K/det M)^(1/2n), which is "
        f"reached with s = {attained['inputs']['s']} at K = diag(1, 16), M = I",
        relies_on=tuple(dict.fromkeys((*main["relies_on"], *ceiling()["relies_on"]))),
        certificates={
            "variational.theorem_3_2_stability": main,
            "variational.theorem_3_2_stability_rate": exact,
            "variational.theorem_3_2_stability_ceiling": ceiling(),
            "variational.theorem_3_2_stability_planar": planar(),
            "variational.theorem_3_2_stability_attained": attained,
        },
        replay=tuple(_polynomials()),
        figure=energies_over_time(),
    )


def _polynomials() -> Iterator[tuple[str, ...]]:
    """Characteristic polynomials of two dampings for K = diag(1, 16), M = I."""
    gains = planar_gains(*ROOTS)
    a, b = (gains["K"][i][i] for i in range(2))
    s = ROOTS[0] * ROOTS[1]
    modal = ((2 * ROOTS[0] ** 2, Fraction(0)), (Fraction(0), 2 * ROOTS[1] ** 2))
    yield "C", "det(s^2 I + sC + K): coefficients", "roots"
    powers = f"{-(ROOTS[0] ** 2)} and {-(ROOTS[1] ** 2)}, twice each"
    for name, c, roots in (
        ("critical damping of each mode", modal, powers),
        ("best C", gains["C"], f"{-s}, four times"),
    ):
        yield f"{name}: {_shown(c)}", ", ".join(map(str, _coefficients(c, a, b))), roots


def _coefficients(c: Rows, a: Fraction, b: Fraction) -> tuple[Fraction, ...]:
    """det(s^2 I + s C + diag(a, b)) by falling powers of s."""
    determinant = c[0][0] * c[1][1] - c[0][1] * c[1][0]
    trace = c[0][0] + c[1][1]
    return Fraction(1), trace, a + b + determinant, b * c[0][0] + a * c[1][1], a * b


def _shown(rows: Rows) -> str:
    return "; ".join(" ".join(map(str, row)) for row in rows)


def theorem_3_2_citation() -> Decision:
    """What the cited theorem concludes is weaker than what is drawn from it."""
    definite = [derivation((("1/2", "1", letter),)) for letter in ("M", "K")]
    refuted = certificate(
        "variational",
        "theorem_3_2_citation",
        {},
        [derivation(), *_derived(REST), derivation((("1", "u", "S"),)), *definite],
        case="REFUTED",
    )
    repaired = certificate(
        "variational",
        "theorem_3_2_citation_repair",
        {},
        [derivation(), *_derived(STRICT[0]), derivation(), *_derived(STRICT[1])],
    )
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="The system x' = 0, Mu' = -Cu has the same E > 0 and the same E' = -u'Cu, so that "
        "it satisfies what the cited theorem supposes, with W = u'Cu; W tends to 0 along it, and "
        "x stays where it is. The theorem for z' = f(t, z) has no invariant set; the argument is "
        "LaSalle's for z' = f(z), which does apply to (12).",
        printed="W = u'Cu tends to 0, hence x and u do",
        sharp="u tends to 0",
        margin_text="nothing follows about x",
        repair="V = E + e x'Mu is positive definite and V' is negative definite in both errors for "
        "every e > 0 with (C + C')/2 - eM - (e/4) C'K^-1 C positive definite; for V' the condition "
        "is necessary as well.",
        repair_formula=r"\dot V=-e\left(x+\tfrac12K^{-1}Cu\right)^{\mathsf T}K"
        r"\left(x+\tfrac12K^{-1}Cu\right)-u^{\mathsf T}\left(\tfrac12(C+C^{\mathsf T})-eM"
        r"-\tfrac e4C^{\mathsf T}K^{-1}C\right)u",
        relies_on=tuple(repaired["relies_on"]),
        certificates={
            "variational.theorem_3_2_citation": refuted,
            "variational.theorem_3_2_citation_repair": repaired,
        },
        replay=tuple(_resting()),
    )


def _resting() -> Iterator[tuple[str, ...]]:
    """x' = 0, u' = -u from (1, 1): u halves every ln 2 seconds."""
    yield "t / ln 2", "x", "u", "E = (x^2 + u^2)/2", "E' = -u^2"
    x = Fraction(1)
    for k in range(5):
        u = Fraction(1, 2**k)
        yield str(k), str(x), str(u), str((x * x + u * u) / 2), str(-u * u)


def _words(form: object) -> str:
    """A form for readers: M w + C u."""
    return str(form).replace("**", "^").replace("*", " ").replace("w", "u'")


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "variational.prop_3_1": proposition_3_1,
    "variational.eq_15_dissipation": eq_15_dissipation,
    "variational.theorem_3_2_stability": theorem_3_2_stability,
    "variational.theorem_3_2_citation": theorem_3_2_citation,
}
