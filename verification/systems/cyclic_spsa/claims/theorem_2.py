"""How the claims about Theorem 2 and its proof are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..printed.promises import promised, promised_2
from ..stability.steps import decide_step
from . import theorem_2_constants
from .common import limit_document, proofs
from .theorem_1_assumptions import relied
from .theorem_1_repair import PROOF, REPAIR_FORMULA

Document = dict[str, Any]

CONSTANTS = (
    "theorem_2_mu",
    "theorem_2_lipschitz_repair",
    "theorem_2_c2_repair",
    "theorem_2_c3_repair",
    "theorem_2_change",
    "theorem_2_change_moving",
)
REPAIR = (
    "The repaired Theorem 1 with mu = K/(n max sigma^2), M = K/(n min sigma^2), c2 = sum (K/n)^2 "
    "tr Xi/sigma^4, c_v = 0 and, for symmetric noise, c3 = 2 M^2 lambda_max(Xi) and c4 = "
    "Var(xi'H xi)/2 for targets at rest, c3 = 2 M^2 (2 lambda_max(Xi) + delta^2) and c4 = "
    "[(eta'H eta)^2 + 4 eta'H Xi H eta + 2 Var(xi'H xi)]/2 for targets that move by eta: the "
    "root of the mean square of the error of a block is in the long run at most the first formula "
    "below."
)
STEP, BETA = Fraction(1, 20), Fraction(3, 100)
UNIT = {"K": 1, "n": 1, "d": 2, "k": 1, "high": 1, "low": 1, "ratio": 1, "level": 0}
"""One sensor, one target, sigma = 1."""
CLEAR = Fraction(1, 100)
"""sigma^2 for the moving target."""


def block(alpha: Fraction, beta: Fraction, high: Fraction) -> dict[str, Any]:
    """Inputs of the questions about stability for one target at rest."""
    half = high / 2
    return {
        "h": (Fraction(1), Fraction(1)),
        "H": None,
        "Xi": ((half, Fraction(0)), (Fraction(0), half)),
        "eta": (Fraction(0),),
        "beta": beta,
        "reading": "two",
        "k": Fraction(1),
        "alpha": alpha,
    }


def diverging(name: str, lines: Mapping[str, Any], at: dict[str, Any]) -> Document:
    """The promise beside moments that do not decay."""
    step = decide_step(at).certificate
    if step is None:
        raise ValueError("alpha: the step is not decided; one above the limit is needed")
    # the identity, the step, P and Q; that Xi is a covariance follows from its form
    kept = [item for item in step["witness"] if item["kind"] == "matrix"][:4]
    inputs = {**step["inputs"], **lines}
    return certificate("cyclic_spsa", name, inputs, kept, "REFUTED")


def corrected(certificates: Mapping[str, Document], **fields: Any) -> Decision:
    """A claim that the repaired theorem replaces."""
    made = {**certificates, **proofs(*CONSTANTS, *PROOF)}
    return Decision(
        verdict=Verdict.CORRECTED,
        repair=REPAIR,
        repair_formula=REPAIR_FORMULA,
        certificates=made,
        relies_on=relied(made),
        **fields,
    )


def constants(factor: Fraction, high: Fraction, **more: Fraction) -> dict[str, Fraction]:
    """Theorem 1's lines with mu = M = factor: 1/2 is printed, 1 is sharp."""
    given = {"d": Fraction(2), "mu": factor, "M": factor, "c2": factor * high, **more}
    return {**promised(given), "high": high}


def interval() -> Decision:
    """The difference of two noises multiplies the error."""
    at = block(STEP, BETA, Fraction(1))
    own = {"alpha": STEP, "beta": BETA}
    literal = promised_2({**UNIT, **own, "delta": 0})
    made = {
        "cyclic_spsa.theorem_2_interval": diverging("theorem_2_interval", literal, at),
    }
    for stem, factor in (("nested", Fraction(1, 2)), ("sharp_constants", Fraction(1))):
        lines = constants(factor, Fraction(1), **own)
        document = diverging("theorem_2_interval_nested", lines, at)
        made[f"cyclic_spsa.theorem_2_interval_{stem}"] = document
    limit, document = limit_document(at)
    made["cyclic_spsa.theorem_2_interval_limit"] = document
    return corrected(
        made,
        reason="For one sensor and one target at rest, K = sigma^2 = 1, alpha = 1/20 and beta = "
        f"3/100 the interval of Theorem 2 is (0, 1/6) and its bound {float(literal['bound']):.5g}, "
        "and second moments of the error do not decay, by an exact certificate. The same holds "
        "with the sharp constants mu = M = 1 in the printed Theorem 1. The limit of the step, "
        f"{limit:.6g}, has a certificate too.",
        printed="alpha < 1/6 in the example",
        sharp=f"alpha < {limit:.6g} in the example",
        printed_value=1 / 6,
        sharp_value=limit,
        margin_text=f"{1 / 6 / limit:.3g} times too large in the example",
    )


def bound() -> Decision:
    """The lag of Theorem 1's first counterexample."""
    delta, beta = Fraction(1), Fraction(1)
    own = {"alpha": STEP, "beta": beta, "delta": delta}
    error = (Fraction(3, 2) - 2 / STEP) * delta
    literal = promised_2({**UNIT, **own, "K": CLEAR, "high": CLEAR, "low": CLEAR})
    made = {"cyclic_spsa.theorem_2_bound": lagging("theorem_2_bound", literal, error)}
    values = [float(literal["bound"])]
    for stem, factor in (("nested", Fraction(1, 2)), ("sharp_constants", Fraction(1))):
        lines = constants(factor, CLEAR, **own)
        made[f"cyclic_spsa.theorem_2_bound_{stem}"] = lagging(
            "theorem_2_bound_nested", lines, error
        )
        values.append(float(lines["bound"]))
    size = float(-error)
    return corrected(
        made,
        reason="For one sensor and one target that moves by 1 in every sample, sigma = 1/10, alpha "
        f"= 1/20 and beta = 1, the mean error tends to {error}, replayed from the costs; Theorem "
        f"2 promises {values[0]:.5g} as printed, {values[1]:.5g} with its constants in Theorem 1, "
        f"and {values[2]:.5g} with the sharp ones in Theorem 1.",
        printed=f"{values[0]:.6g} in the example",
        sharp=f"at least {-error} in the example",
        printed_value=values[0],
        sharp_value=size,
        margin_text=f"the error is {size / values[0]:.3g} times the bound in the example",
    )


def lagging(name: str, lines: Mapping[str, Any], error: Fraction) -> Document:
    """The promise beside the mean error that a step returns."""
    return certificate("cyclic_spsa", name, {**lines, "error": error}, [], "REFUTED")


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    **theorem_2_constants.DECISIONS,
    "cyclic_spsa.theorem_2_interval": interval,
    "cyclic_spsa.theorem_2_bound": bound,
}
