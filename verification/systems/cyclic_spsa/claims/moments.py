"""How claims about exact moments of measured distances and positions are decided."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction

from verification.verdict import Decision, Verdict

from ..network.measurement_moments import measurement_moments
from .common import proofs, replayed

RANGE, RELATIVE = Fraction(100), Fraction(1, 20)
"""Distance in km, and the relative error of section 5."""
TURN = Fraction(1, 2)
"""An angle error in rad, large enough to see."""
HALF_DEGREE = math.radians(0.5)


def measured_variance() -> Decision:
    """The measured distance is longer in the mean square than the true one."""
    inputs = {"rho": RANGE, "k": RELATIVE, "d": RANGE * RELATIVE}
    factor = 1 + RELATIVE**2
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="With an error of +-5 % of the distance the mean of (z2 sigma_rho)^2 is "
        f"{factor} of the variance, replayed in rationals. Besides, a covariance that contains the "
        "noise of the measurement is itself random and no covariance.",
        printed="(z2 sigma_rho)^2",
        sharp="(rho sigma_rho)^2",
        printed_value=float(factor),
        sharp_value=1.0,
        margin_text="1 + sigma_rho^2 too large in the mean, 0.25 % at 5 %",
        repair="(rho sigma_rho)^2 with the true distance; (z2 sigma_rho)^2/(1 + sigma_rho^2) has "
        "that mean, for every law of mean zero.",
        repair_formula=r"E\frac{(z_2\sigma_\rho)^2}{1+\sigma_\rho^2}=(\rho\,\sigma_\rho)^2",
        certificates=replayed("eq_14_sigma", inputs) | proofs("eq_14_sigma_repair"),
    )


def gaussian_errors(angle: float, relative: float) -> tuple[float, float, float]:
    """Mean radial error over rho, variances over rho^2 along the line of sight and across it.

    For Gaussian errors, with deviations in rad and relative to the distance.
    """
    given = {"sigma_bearing_rad": Fraction(angle), "sigma_range_rel": Fraction(relative)}
    bias, along, across = measurement_moments(given).value
    return bias, along, across


def gaussian_square(angle: float, relative: float) -> float:
    """E|xi|^2/rho^2 for the same errors."""
    bias, along, across = gaussian_errors(angle, relative)
    return bias**2 + along + across


def exact_trace() -> Decision:
    """A chord is shorter than its arc."""
    x, rho = TURN, RANGE
    inputs = {
        "rho": rho,
        "x": x,
        "e": rho**2 * (x**2 - x**4 / 12 + x**6 / 360),
        "n": rho**2 * x**2,
    }
    angle, relative = HALF_DEGREE, float(RELATIVE)
    exact, printed = gaussian_square(angle, relative), angle**2 + relative**2
    files = replayed("eq_14_trace_exact", inputs)
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="For an angle error of +-1/2 rad and an exact distance, the squared error is 2 - 2 "
        "cos(1/2) times rho^2, bounded in rationals below the printed 1/4. At half a degree and 5 "
        f"% the two agree to {(printed - exact) / exact:.1e} of their size.",
        printed="sigma_psi^2 + sigma_rho^2",
        sharp="2 (1 - E cos) + sigma_rho^2",
        printed_value=printed,
        sharp_value=exact,
        margin_text="too large, by sigma_psi^4/4 to leading order",
        repair="The mean square is rho^2 (2 - 2g + sigma_rho^2), g being the mean cosine of the "
        "angle error, exp(-sigma_psi^2/2) for a Gaussian one.",
        repair_formula=r"E\lVert\xi\rVert^2=\rho^2\bigl(2-2e^{-\sigma_\psi^2/2}+\sigma_\rho^2\bigr)",
        relies_on=tuple(files["cyclic_spsa.eq_14_trace_exact"]["relies_on"]),
        certificates=files | proofs("eq_14_trace_exact_repair"),
    )


def exact_covariance() -> Decision:
    """Positions lie on an arc, which no ellipse is."""
    bound = TURN - TURN**3 / 6 + TURN**5 / 120
    files = replayed("eq_14_exact", {"rho": RANGE, "x": TURN, "y": bound})
    _, along, across = gaussian_errors(HALF_DEGREE, float(RELATIVE))
    rows = (
        ("over rho^2, half a degree and 5 %", "to first order", "exact"),
        ("along the line of sight", f"{float(RELATIVE) ** 2:.10g}", f"{along:.10g}"),
        ("across it", f"{HALF_DEGREE**2:.10g}", f"{across:.10g}"),
    )
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="For an angle error of +-1/2 rad and an exact distance the variance across the line "
        "of sight is sin(1/2)^2 rho^2, bounded in rationals below the 1/4 of (14) with its axes "
        "put right. At half a degree and 5 % the exact one is larger instead, by "
        f"{100 * (across / HALF_DEGREE**2 - 1):.2g} %, because the errors multiply.",
        printed="sigma_rho^2 and sigma_psi^2",
        sharp="(1 + sigma_rho^2) E cos^2 - (E cos)^2 and (1 + sigma_rho^2) E sin^2",
        margin_text="of second order",
        repair="Along the line of sight the variance over rho^2 is (1 + sigma_rho^2) E cos^2 - (E "
        "cos)^2, across it (1 + sigma_rho^2) E sin^2, and nothing is mixed, for all laws that are "
        "symmetric; a Gaussian one has E cos = exp(-sigma_psi^2/2) and E cos^2 = (1 + exp(-2 "
        "sigma_psi^2))/2.",
        repair_formula=r"\begin{array}{l}"
        r"\frac{\Xi_\parallel}{\rho^2}=(1+\sigma_\rho^2)E\cos^2\varepsilon-(E\cos\varepsilon)^2 \\"
        r"\frac{\Xi_\perp}{\rho^2}=(1+\sigma_\rho^2)E\sin^2\varepsilon\end{array}",
        relies_on=tuple(files["cyclic_spsa.eq_14_exact"]["relies_on"]),
        certificates=files | proofs("eq_14_exact_repair"),
        replay=rows,
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "cyclic_spsa.eq_14_sigma": measured_variance,
    "cyclic_spsa.eq_14_trace_exact": exact_trace,
    "cyclic_spsa.eq_14_exact": exact_covariance,
}
