"""How the claims about the action sum and about unsymmetric damping are decided."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any

from theory.algebra.lagrange import first_variation
from theory.systems.variational.statements.common import lagrangian
from verification.certificates.make import certificate
from verification.exact.definite import is_definite
from verification.exact.evaluate import Rows, add, identity, scaled
from verification.exact.spectra.modes import candidates, integer_matrices
from verification.exact.spectra.stein import staying_form
from verification.verdict import Decision, Verdict

from ..claim_figures import growing_errors
from ..delays import block, late_pencil
from ..steps import step_limit
from .discrete import UNIT_GAINS, proposition_4_1
from .witnesses import derivation

UNIT: Rows = identity(2)
ROTATIONS = (1, 2, 5, 10, 20)
DAMPINGS = (Fraction(1), Fraction(1, 10), Fraction(1, 100))
TRIED_STEP = Fraction(1, 2)


def action() -> Decision:
    """The last term of the printed sum asks for an estimator that stands still."""
    surplus = str(first_variation(lagrangian, last_term=True)).replace("v", "u_N")
    refuted = certificate("variational", "eq_21_action", {}, [derivation()], case="REFUTED")
    proposition = proposition_4_1().certificates["variational.prop_4_1"]
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="The variation of the term k = N alone is taken by the same machinery that derives "
        f"(20): it would demand {surplus} = 0, because no other term contains the last position.",
        printed="up to N",
        sharp="up to N - 1",
        margin_text="one term too many",
        repair="The sum ends at N - 1; its variations that vanish at both ends give (20).",
        repair_formula=r"\sum_{k=0}^{N-1} h\,\mathcal{L}_k",
        certificates={
            "variational.eq_21_action": refuted,
            "variational.eq_21_action_repair": proposition,
        },
    )


def unsymmetric() -> Decision:
    """A damping that turns: its form is positive, and the errors grow."""
    found = next(_turning(), None)
    if found is None:
        return Decision(Verdict.UNDECIDED, "stage search: no unsymmetric damping was found")
    damping, document = found
    repaired = _repair()
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"At M = K = I, h = {TRIED_STEP} and C = {_shown(damping)} the form of C and "
        f"that of "
        "the step limit are positive definite and the recursion has a solution that does not "
        "decay, "
        "shown by a quadratic form that falls along all solutions and is not positive.",
        printed="stable",
        sharp="a solution grows",
        margin_text="symmetry is needed",
        repair="Without symmetry C + C' - hK > 0 is enough: the energy of the newer position then "
        "falls in every step.",
        repair_formula=r"hK \prec C + C^{\mathsf T}",
        figure=growing_errors({"M": UNIT, "K": UNIT, "C": damping}, TRIED_STEP),
        certificates={
            "variational.discrete_stability_unsymmetric": document,
            "variational.discrete_stability_unsymmetric_repair": repaired,
        },
    )


def pairing() -> Decision:
    """The energy of the newer position falls up to hK = C + C' and no further."""
    witness = [
        derivation((), ("-h", "0", "1")),
        derivation(
            (),
            ("1/2*T(z)*K", "1", "1"),
            ("1/2", "1'", "K*(y + h*v)"),
            ("1/2*h*T(v)", "0", "1"),
            ("1/2*h", "0'", "v"),
            ("1/2*h", "2", "1"),
        ),
    ]
    refuted = certificate("variational", "discrete_energy_pairing", {}, witness, case="REFUTED")
    falls = 2 * UNIT_GAINS["C"][0][0] / UNIT_GAINS["K"][0][0]
    stable = float(step_limit(UNIT_GAINS).value or 0)
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Where v'(hK - 2C)v > 0, the state with K y = -C v raises this energy by half of "
        "h times that number in one step, as an identity for all gains.",
        printed="every h > 0",
        sharp="h <= 2/lambda_max(C^-1 K)",
        sharp_value=float(falls),
        margin_text=f"h = {falls} at M = K = C = 1, against stability up to {stable:.5g}",
        repair="The energy of the newer position falls in every step while C + C' - hK > 0.",
        repair_formula=r"hK \prec C + C^{\mathsf T}",
        certificates={
            "variational.discrete_energy_pairing": refuted,
            "variational.discrete_energy_pairing_repair": _repair(),
        },
    )


def _turning() -> Iterator[tuple[Rows, dict[str, Any]]]:
    """Dampings d I + r (turn), for which (20) is certified not to be stable."""
    for rotation in ROTATIONS:
        for d in DAMPINGS:
            c: Rows = ((d, Fraction(rotation)), (Fraction(-rotation), d))
            form = add(scaled(4 - TRIED_STEP**2, UNIT), scaled(2 * TRIED_STEP * d, UNIT))
            gains = {"M": UNIT, "K": UNIT, "C": c}
            left, right = integer_matrices(*late_pencil(gains, 0, TRIED_STEP))
            shown = (staying_form(left, right, modes) for modes in candidates(left, right))
            growing = next((entry for entry in shown if entry), None)
            if growing and is_definite(form):
                yield c, _document(gains, *growing)


def _document(gains: Mapping[str, Rows], form: Rows, x: tuple[int, ...]) -> dict[str, Any]:
    bases = [UNIT, block(2, 2, 0), block(2, 2, 1), form]
    witness: list[dict[str, Any]] = [{"kind": "matrix", "rows": rows} for rows in bases]
    witness.append({"kind": "vector", "x": list(x)})
    return certificate(
        "variational",
        "discrete_stability_unsymmetric",
        {**gains, "h": TRIED_STEP},
        witness,
        case="REFUTED",
    )


def _repair() -> dict[str, Any]:
    """The loss of energy in one step, from the recursion alone."""
    relations = (
        ("-1/2*T(v)", "0", "1"),
        ("-1/2", "0'", "v"),
        ("-1/2", "1'", "K*z"),
        ("-1/2*T(y + h*v)*K", "1", "1"),
        ("-1/2*h*T(v)", "2", "v"),
    )
    squares = (("1/2*h", "v", "S"), ("1/2", "v - u", "M"))
    return certificate(
        "variational",
        "discrete_stability_unsymmetric_repair",
        {},
        [derivation((), *relations), derivation(squares, *relations)],
    )


def _shown(rows: Rows) -> str:
    return "[" + "; ".join(", ".join(map(str, row)) for row in rows) + "]"


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "variational.eq_21_action": action,
    "variational.discrete_energy_pairing": pairing,
    "variational.discrete_stability_unsymmetric": unsymmetric,
}
