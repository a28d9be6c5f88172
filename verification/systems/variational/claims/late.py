"""How the claims about late data and about the noise that a lost sensor leaves are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from verification.certificates.make import certificate
from verification.exact.evaluate import Rows, identity
from verification.exact.spectra.modes import candidates, integer_matrices
from verification.exact.spectra.stein import staying_form
from verification.verdict import Decision, Verdict

from ..claim_figures import radii_of_late_data
from ..delays import block, delay_step_limit, late_pencil
from ..steps import step_limit
from .simulated import EXAMPLE
from .witnesses import derivation

ONE_SAMPLE = Fraction(1)
ROUNDED = 100
"""Steps are tried in hundredths."""


def instantaneous() -> Decision:
    """Between the limit with one sample of delay and the one without, the claim fails."""
    now = float(step_limit(EXAMPLE).value or 0)
    late = float(delay_step_limit({**EXAMPLE, "d": ONE_SAMPLE}).value or 0)
    step = Fraction(round((now + late) / 2 * ROUNDED), ROUNDED)
    refuted = _too_late(step)
    if refuted is None:
        return Decision(Verdict.UNDECIDED, f"no growing solution was certified at h = {step}")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"At h = {step} the shown gains are certified stable where the position error is "
        "known at once, and certified not to be where it is known one sample late.",
        printed="no limit of its own",
        sharp=f"h < {late:.6g}, against {now:.6g} without delay",
        printed_value=now,
        sharp_value=late,
        margin_text=f"{now / late:.3g} times too large at these gains",
        repair="One sample late, h K < C is enough for gains of any size and needed for a single "
        "coordinate; delay_step_limit gives the limit of given gains and delays.",
        repair_formula=r"hK \prec C",
        figure=radii_of_late_data(EXAMPLE, now, late),
        certificates={
            "variational.section_4_instantaneous": refuted,
            "variational.section_4_instantaneous_repair": _enough(),
            "variational.section_4_instantaneous_necessary": _needed(),
        },
    )


def _too_late(step: Fraction) -> dict[str, Any] | None:
    left, right = integer_matrices(*late_pencil(EXAMPLE, 1, step))
    shown = (staying_form(left, right, modes) for modes in candidates(left, right))
    found = next((entry for entry in shown if entry), None)
    if found is None:
        return None
    form, x = found
    n = len(EXAMPLE["M"])
    matrices: list[Rows] = [identity(n), block(n, 2, 0), block(n, 2, 1), form]
    witness: list[dict[str, Any]] = [{"kind": "matrix", "rows": rows} for rows in matrices]
    witness.append({"kind": "vector", "x": list(x)})
    inputs = {**EXAMPLE, "h": step}
    return certificate("variational", "section_4_instantaneous", inputs, witness, case="REFUTED")


def _enough() -> dict[str, Any]:
    """Jury's conditions with the position error one sample late."""
    witness = [
        derivation((("h", "1", "Q"),), ("-h", "0", "1")),
        derivation((("2", "1", "M"), ("h", "1", "C"), ("h**2", "1", "K"))),
        derivation((("h**2", "1", "K"),)),
        derivation((("4", "1", "M"), ("2*h", "1", "C"), ("h**2", "1", "K"))),
    ]
    return certificate("variational", "section_4_instantaneous_repair", {}, witness)


def _needed() -> dict[str, Any]:
    witness = [derivation((("h*s", "1", "1"),), ("h", "0", "1"))]
    return certificate("variational", "section_4_instantaneous_necessary", {}, witness)


def noise_robust() -> Decision:
    """The covariance of the errors is that of the averaged noise times a fixed matrix."""
    mean = derivation((), ("T(l)", "3", "1"), ("g", "3'", "j"), ("g**2", "4", "1"), ("g", "1", "1"))
    covariance = derivation((), ("f*N", "0", "1"), ("f", "1", "G*V*T(G)"))
    document = certificate("variational", "section_4_noise_robust", {}, [mean, covariance])
    return Decision(
        verdict=Verdict.PROVED,
        reason="The errors are linear in the averaged noise, whose covariance is V/N: with one of "
        "N sensors lost, N/(N-1) times the stationary covariance is stationary, as an identity for "
        "every stable linear recursion.",
        printed="sqrt(3/2)",
        sharp="sqrt(N/(N-1))",
        margin_text="exact for white noise, like sensors and rescaled weights",
        certificates={"variational.section_4_noise_robust": document},
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "variational.section_4_instantaneous": instantaneous,
    "variational.section_4_noise_robust": noise_robust,
}
