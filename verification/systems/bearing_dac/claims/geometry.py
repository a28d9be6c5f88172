"""How the claims about bearings, the position and its averages are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from verification.certificates.make import certificate
from verification.verdict import Decision, Verdict

from ..claim_figures import turns_of_a_bearing
from .common import SYSTEM, disproof, file_of, proofs, reliances

TARGET = (Fraction(3), Fraction(4))
COMPASS = ((Fraction(3, 5), Fraction(4, 5)), (Fraction(-5, 13), Fraction(12, 13)))
DISTANCES = (Fraction(5), Fraction(13))


def bearing() -> Decision:
    """The angle's cosine and sine, as a column, are the direction to the target."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="With the bearing as a column, p - s = rho phi has the squared length rho^2, as an "
        "identity modulo cos^2 + sin^2 = 1. It is printed as a row, which p - s is not; and for "
        "rho = 0 every unit vector would do.",
        printed="rho phi = p - s",
        sharp="the same, phi a column, rho > 0",
        margin_text="identical, up to a transpose",
        certificates=proofs("section_1_bearing"),
    )


def identity() -> Decision:
    """Proposition 1, the identity."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="Multiplied out in vectors along the axes modulo cos^2 + sin^2 = 1; it holds for "
        "either turn by a right angle.",
        printed="identity",
        sharp="identity",
        margin_text="identical",
        certificates=proofs("prop_1_identity"),
    )


def clockwise() -> Decision:
    """Proposition 1, the turn."""
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="The clockwise turn takes the second axis to the first; it takes (cos, sin) to "
        "(sin, -cos), the opposite of the printed vector, as an identity. The difference has "
        "length 2 for every bearing.",
        printed="clockwise",
        sharp="counter-clockwise",
        margin_text="the opposite vector",
        repair="(-sin, cos) is the bearing turned counter-clockwise by a right angle. P = hh' and "
        "q = (h's)h are the same for both turns, so nothing else changes.",
        repair_formula=r"\bar\varphi_i=\begin{bmatrix}0&-1\\1&0\end{bmatrix}\varphi_i",
        certificates=disproof("prop_1_clockwise") | proofs("prop_1_clockwise_repair"),
        figure=turns_of_a_bearing(),
    )


def measurement() -> Decision:
    """Each sensor has one linear equation, and so has the network."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="h'(p - s) = rho h'phi = 0 as an identity; one more sensor adds one more such row, "
        "so z = Hp by induction. With noise in the bearing h'(p - s) is rho times the sine of the "
        "noise.",
        printed="h's = h'p, z = Hp",
        sharp="the same, without noise",
        margin_text="identical",
        certificates=proofs("section_1_measurement", "section_1_measurement_rows"),
    )


def count() -> Decision:
    """Two sensors with crossing lines of sight are enough."""
    turned = [(-s, c) for c, s in COMPASS]
    inputs: dict[str, object] = {"p": _column(TARGET)}
    rows = [("sensor", "position", "direction of the target", "distance")]
    for i, ((c, s), h, distance) in enumerate(zip(COMPASS, turned, DISTANCES, strict=True)):
        place = (TARGET[0] - distance * c, TARGET[1] - distance * s)
        inputs |= {f"s{i}": _column(place), f"f{i}": _column((c, s)), f"h{i}": _column(h)}
        inputs[f"l{i}"] = distance
        rows.append((f"s{i}", f"({place[0]}, {place[1]})", f"({c}, {s})", str(distance)))
    refuted = certificate(SYSTEM, "assumption_1_count", inputs, [], "REFUTED")
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Two sensors whose lines of sight cross have a rank of 2, replayed in rationals, "
        "and least squares need the rank only.",
        printed="n > 2",
        sharp="n >= 2",
        printed_value=3.0,
        sharp_value=float(len(COMPASS)),
        margin_text="one sensor fewer is enough",
        repair="rank H = 2 is all that is needed, and n >= 2 follows. It holds unless the target "
        "and all sensors are on one line, because det of the averaged P is (1 - |R|^2)/4, R being "
        "the mean of e^(2 i theta).",
        repair_formula=r"\det\bar P=\frac{1-\lvert R\rvert^2}4,\qquad "
        r"R=\frac1n\sum_i e^{2\mathrm{i}\theta_i}",
        certificates=file_of("assumption_1_count", refuted) | proofs("assumption_1_count_repair"),
        replay=tuple(rows),
    )


def _column(pair: tuple[Fraction, Fraction]) -> list[list[Fraction]]:
    return [[x] for x in pair]


def unique() -> Decision:
    """Normal equations."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="The sum of squares at y exceeds that at (H'H)^-1 H'z by |H(y - p*)|^2, as an "
        "identity for any number of sensors, and H has rank 2. Without it a whole line of "
        "positions is best.",
        printed="(H'H)^-1 H'z",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("section_1_unique"),
    )


def averages() -> Decision:
    """1/n cancels, and sums are built up sensor by sensor."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="H'H and H'z grow by hh' and zh with each sensor, so they are the sums of P and of "
        "q; and 1/n cancels, as an identity of the two inverses.",
        printed="averaged form",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("section_2_averages", "section_2_averages_sums"),
    )


def entries() -> Decision:
    """Six are enough, and four are."""
    certificates = proofs("section_2_entries", "section_2_entries_information")
    return Decision(
        verdict=Verdict.PROVED,
        reason="Two of the six carry nothing: P is symmetric with trace 1, and a solution mirrored "
        "at 1/2 is again a solution because the sign is odd, so P_x keeps both for all times, as "
        "identities. Without the start at sum zero the trace would be off for ever.",
        printed="6",
        sharp="4",
        printed_value=6.0,
        sharp_value=4.0,
        margin_text="two numbers in six can be left out",
        relies_on=reliances(certificates),
        certificates=certificates,
    )


def bounded() -> Decision:
    """A target that comes close turns bearings arbitrarily fast."""
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="A target that passes a sensor at less than speed over gamma turns its line of "
        "sight so fast that an entry of P exceeds gamma, as an identity for every gamma; and noise "
        "in the bearings, however small, has no rate at all.",
        printed="some gamma",
        sharp="none for all distances",
        margin_text="gamma v/rho grows without bound",
        repair="For a target of speed up to v that stays rho away from every sensor, gamma = v/rho "
        "max(1, |s_i|) is a bound, and it is attained: the first for entries of P, the second for "
        "those of q.",
        repair_formula=r"\gamma=\frac{v}{\rho_{\min}}\max_i\max(1,\lVert s_i\rVert)",
        certificates=disproof("assumption_2_exists")
        | proofs("assumption_2_exists_repair", "assumption_2_exists_attained"),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "bearing_dac.section_1_bearing": bearing,
    "bearing_dac.prop_1_identity": identity,
    "bearing_dac.prop_1_clockwise": clockwise,
    "bearing_dac.section_1_measurement": measurement,
    "bearing_dac.assumption_1_count": count,
    "bearing_dac.section_1_unique": unique,
    "bearing_dac.section_2_averages": averages,
    "bearing_dac.section_2_entries": entries,
    "bearing_dac.assumption_2_exists": bounded,
}
