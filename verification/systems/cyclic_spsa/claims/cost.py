"""How claims about the weights, the cost and its constraints are decided."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from theory.algebra.constraints import reduction
from verification.verdict import Decision, Verdict

from .common import disproof, proofs, replayed

RANGE, RELATIVE = Fraction(100), Fraction(1, 20)
"""Distance in km, and the relative error of section 5."""
VARIANCES = (Fraction(1), Fraction(4))
FORMATION = ((1, 0, -1, 0), (0, 1, 0, -1))
"""Two targets, in a fixed offset from each other: r1 - r2 = q."""


def mean_risk() -> Decision:
    """K has to be a harmonic mean."""
    a, b = VARIANCES
    k = a + b
    scale = k / 2 * (1 / a + 1 / b)
    rows = [("variances", "printed K, p = 0", "mean risk over (3)", "K for which it is 1")]
    for one, two in ((a, a), (a, b), (a, 100 * a)):
        total, right = one + two, 2 / (1 / one + 1 / two)
        rows.append((f"{one}, {two}", str(total), str(total / right), str(right)))
    inputs = {"a": a, "b": b, "m": 1, "p": 0, "K": k, "l": scale}
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"Two sensors of variances {a} and {b} give {scale} times (3), replayed in "
        "rationals, and two of equal variances 2 times. The printed K also carries the index of a "
        "target and is one constant.",
        printed="K = p sigma_min^2 + (1 - p) sum of variances",
        sharp="K = n/(sum of 1/variance), for each target",
        margin_text="too large by 25/8 for variances 1 and 4",
        repair="The mean of the cost is (3) if and only if K, for each target, is the harmonic "
        "mean of the variances of its n sensors; the mean squares of their errors add a constant.",
        repair_formula=r"K_i=\frac n{\sum_{j}1/(\sigma^{i,j})^2}",
        certificates=replayed("eq_3_mean_risk", inputs) | proofs("eq_3_mean_risk_repair"),
        replay=tuple(rows),
    )


def minimum() -> Decision:
    """A positive factor does not move a minimum."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="The mean exceeds that at the truth by half of (K/n)(sum of 1/variance) times the "
        "squared error, as an identity for any number of sensors: a wrong K changes the speed of "
        "an algorithm, and what its step is worth, but not where it goes.",
        printed="theta_t",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("eq_3_minimum"),
    )


def measurable() -> Decision:
    """A cost that is known beforehand has no mean to take."""
    inputs = {"x": 1, "f": 0, "g": 2, "m": 1}
    return Decision(
        verdict=Verdict.REFUTED,
        reason="For (x - w)^2/2 with w = +-1 drawn at t, replayed in integers, the cost at x = 1 "
        "is 0 or 2 after the same past. The mean in (5) needs the opposite: a cost that is "
        "measurable in w_t, and a past that does not contain w_t.",
        printed="measurable before t",
        sharp="measurable in w_t for each theta",
        margin_text="the wrong field of events",
        certificates=replayed("eq_5_measurable", inputs),
    )


def reduced() -> Decision:
    """A basis of the kernel, and the row space beside it."""
    found = reduction(FORMATION)
    size = len(FORMATION[0])
    inputs = {
        "I": [[int(i == j) for j in range(size)] for i in range(size)],
        "H": FORMATION,
        "N": found.basis,
        "W": found.gram_inverse,
        "Y": found.row_inverse,
    }
    files = proofs("eq_6_reduced")
    return Decision(
        verdict=Verdict.PROVED,
        reason="With a basis N of the kernel of H, h(x) = (N'N)^-1 N'x and g(z) = Nz + H'(HH')^-1 "
        "q are inverse to each other between the constraint set and d - l coordinates, as "
        "identities; for two targets in a fixed offset the exact basis is computed and its "
        "completeness checked in rationals.",
        printed="h and g exist",
        sharp="the same, with formulas",
        margin_text="identical",
        relies_on=tuple(files["cyclic_spsa.eq_6_reduced"]["relies_on"]),
        certificates=files | replayed("eq_6_reduced_formation", inputs, "PROVED"),
    )


def like_copies() -> Decision:
    """A sum of costs does not make copies agree."""
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="For the costs (x - 1)^2 and (x + 1)^2 the least value at a common point is 2, and "
        "the unlike copies 2 and 0 have it as well, replayed exactly; the copies 1 and -1 have "
        "even 0. Nothing in (8) asks copies to agree.",
        printed="the copies agree",
        sharp="they agree if all costs are least at one point",
        margin_text="a constraint is missing",
        repair="If every sensor's mean cost is least at the same point, as those of (20) are at "
        "the true positions, copies other than that point cost more.",
        repair_formula=r"\sum_jE f^j(\theta^j)-\sum_jE f^j(\theta)=\sum_jc_j"
        r"\lVert\theta^j-\theta\rVert^2",
        certificates=disproof("eq_7_copies") | proofs("eq_7_copies_repair"),
    )


def subvectors() -> Decision:
    """Nothing couples the parts."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="Without terms across two parts the quadratic splits into that of one part and that "
        "of all others, as an identity, and so on part by part. (20) is of this kind: its Hessian "
        "is diagonal.",
        printed="sum over parts",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("eq_7_subvectors"),
    )


def measured_weights() -> Decision:
    """Short measurements count more."""
    d = RANGE * RELATIVE
    fit = RANGE * (1 - RELATIVE**2) / (1 + RELATIVE**2)
    rows = (
        ("measured z", "weight 1/z^2 over 1/rho^2", "probability"),
        *((str(z), f"{float((RANGE / z) ** 2):.4f}", "1/2") for z in (RANGE - d, RANGE + d)),
        (f"fit {float(fit):.4f}", "", ""),
    )
    inputs = {"rho": RANGE, "d": d, "x": fit}
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="With errors of +-5 % of the distance and the weights 1/z^2, the mean cost is least "
        f"at {fit / RANGE} of the distance, replayed in rationals: a distance measured too short "
        "weighs more. At 300 km that is 1.5 km too near, more than a hundred times the bias of the "
        "angle.",
        printed="the true distance",
        sharp="(1 - k^2)/(1 + k^2) of it for errors of +-k",
        printed_value=1.0,
        sharp_value=float(fit / RANGE),
        margin_text="0.5 % too near at 5 %",
        repair="With a weight that is the same for all outcomes the fit is right in the mean, as "
        "the largest trace over time gives it.",
        repair_formula=r"\begin{array}{l}\operatorname{argmin}_xE\frac{(z-x)^2}{\sigma^2}=E z \\"
        r"\sigma\ \text{not a function of}\ z\end{array}",
        certificates=replayed("eq_20_weights_measured", inputs) | proofs("eq_20_weights_steady"),
        replay=rows,
    )


def steady_weights() -> Decision:
    """One weight cancels."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="The mean cost at x exceeds that at the mean of z by the weight times the square of "
        "their distance, as an identity for every law of the noise.",
        printed="the true position",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("eq_20_weights_steady"),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "cyclic_spsa.eq_3_mean_risk": mean_risk,
    "cyclic_spsa.eq_3_minimum": minimum,
    "cyclic_spsa.eq_5_measurable": measurable,
    "cyclic_spsa.eq_6_reduced": reduced,
    "cyclic_spsa.eq_7_copies": like_copies,
    "cyclic_spsa.eq_7_subvectors": subvectors,
    "cyclic_spsa.eq_20_weights_measured": measured_weights,
    "cyclic_spsa.eq_20_weights_steady": steady_weights,
}
