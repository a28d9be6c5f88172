"""How the claims about the positions that sensors compute are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from verification.verdict import Decision, Verdict

from ..claim_figures import determinant_over_time, position_over_time
from ..genuine_bearings import Late, Singular, late_position, singular_later
from .common import disproof, file_of, proofs, reliances

SAMPLES = 5


def position() -> Decision:
    """Exact averages give the position."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="The average of q is the average of P times p, so its product with the inverse is "
        "p, as an identity; it is exact as soon as both averages are, and not before.",
        printed="p_i = p*",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("theorem_2_position"),
    )


def time() -> Decision:
    """The printed time is too early for a position as well."""
    found = late_position()
    if found is None:
        return Decision(Verdict.UNDECIDED, "stage search: no bearings were found")
    certificates = file_of("theorem_2_time", found.document)
    certificates |= proofs("theorem_1_form_root_one", "theorem_2_position")
    wrong = ((found.position[0] - float(found.distance)) ** 2 + found.position[1] ** 2) ** 0.5
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Three sensors, all linked, see a target that rests under genuine bearings with "
        f"rational sines; at t = {found.t}, after t* = {found.printed:.5g}, P_x is exact and q_x "
        f"is not, replayed in rationals: sensor 1 is {wrong:.3g} m off, the target "
        f"{found.distance} m away. With a target that moves the printed gain fails as well, "
        "in floating point only.",
        printed=f"{found.printed:.5g}",
        sharp=f"{found.sharp:.5g}",
        printed_value=found.printed,
        sharp_value=found.sharp,
        margin_text=f"{1 - found.printed / found.sharp:.1%} too early",
        repair="With beta >= 1 + gamma sqrt(n/lambda_2) every p_i is p* from t0 + "
        "|x(t0)|/sqrt(lambda_2) on; in general from the time at which the slowest entry agrees.",
        repair_formula=r"p_i(t)=p^*(t)\quad\text{for }t\ge t_0+"
        r"\frac{\lVert x(t_0)\rVert}{\sqrt{\lambda_2}}",
        relies_on=reliances(certificates),
        certificates=certificates,
        replay=_places(found),
        figure=position_over_time(found),
    )


def _places(found: Late) -> tuple[tuple[str, ...], ...]:
    """Sensors at distances that make short numbers, for the reader: the ranges do not matter."""
    (c, s), rows = found.bearing, [("sensor", "position", "cosine", "sine")]
    for i, (sign, steps) in enumerate(((1, 1), (-1, 1), (-1, 2))):
        far = steps * c.denominator
        place = f"({found.distance - far * c}, {-sign * far * s})"
        rows.append((str(i + 1), place, str(c), str(sign * s)))
    return tuple(rows)


def from_the_start() -> Decision:
    """One bearing is no position."""
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="At t0 each sensor has its own P = hh' only, which takes its line of sight to zero, "
        "as an identity for every sensor and every bearing: there is no inverse to take.",
        printed="all t >= t0",
        sharp="never at t0",
        margin_text="singular for every sensor at the start",
        repair="P_x has an inverse from the time on at which the entries of P agree, if the target "
        "and the sensors are not on one line: its determinant is then (1 - |R|^2)/4. Before, a "
        "sensor has to look at the determinant.",
        repair_formula=r"\det P_{x_i}(t_0)=0,\qquad \det\bar P=\frac{1-\lvert R\rvert^2}{4}",
        certificates=disproof("algorithm_1_line_12") | proofs("assumption_1_count_repair"),
    )


def after_the_start() -> Decision:
    """Entries move one by one, and the matrix can lose its inverse on the way."""
    found = singular_later()
    if found is None:
        return Decision(Verdict.UNDECIDED, "stage search: no bearings were found")
    certificates = file_of("algorithm_1_line_12_later", found.document)
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Three sensors, all linked, and a target that rests: the entries of P_x of sensor 1 "
        f"run towards their averages at the same speed, and at t = {found.t} its determinant, "
        f"positive before, is exactly zero, replayed in rationals; then P_x is indefinite for a "
        f"while.",
        printed="all t > t0",
        sharp=f"singular at t = {found.t}",
        margin_text="singular again on the way",
        repair="P_x has an inverse from the time on at which the entries of P agree, if the target "
        "and the sensors are not on one line.",
        repair_formula=r"\det\bar P=\frac{1-\lvert R\rvert^2}{4}",
        certificates=certificates | proofs("assumption_1_count_repair"),
        replay=_determinants(found),
        figure=determinant_over_time(found),
    )


def _determinants(found: Singular) -> tuple[tuple[str, ...], ...]:
    rows: list[tuple[str, ...]] = [("t", "P_11", "P_12", "determinant")]
    for k in range(SAMPLES):
        t = found.t * Fraction(k, SAMPLES - 1)
        rows.append((str(t), *map(str, found.entries(t)), str(found.determinant(t))))
    return tuple(rows)


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "bearing_dac.theorem_2_position": position,
    "bearing_dac.theorem_2_time": time,
    "bearing_dac.algorithm_1_line_12": from_the_start,
    "bearing_dac.algorithm_1_line_12_later": after_the_start,
}
