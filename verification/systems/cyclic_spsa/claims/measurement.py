"""How claims about the measurement model, weights and cost, (1) to (14), (20), are decided."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction

from verification.verdict import Decision, Verdict

from ..printed.measurement_figures import ellipses, mirrored
from . import cost, moments
from .common import column, disproof, proofs, replayed

SENSOR, TARGET = (150, 150), (180, 110)
"""Places in km, within the square of section 5; the target is behind the second axis."""
TRIPLE = (Fraction(4, 5), Fraction(3, 5))
"""Cosine and sine of an angle, both rational."""
RANGE, RANGE_ERROR, ANGLE_ERROR = 100, Fraction(1, 20), Fraction(873, 100_000)
"""Distance in km; relative error of the distance; half a degree, about, in radians."""
EAST, NORTH = (1, 0), (0, 1)


def zero_mean() -> Decision:
    """Angles that err move the mean of a position towards the sensor."""
    cosine, sine = TRIPLE
    inputs = {"s": column(SENSOR), "e": column(NORTH), "n": column(EAST), "a": cosine, "b": sine}
    inputs |= {"rho": RANGE, "d": RANGE * RANGE_ERROR}
    shift = -300_000 * moments.gaussian_errors(moments.HALF_DEGREE, 0)[0]
    rows = [("angle error, cosine", "sine", "distance", "x1 - s1", "x2 - s2", "probability")]
    rows += [
        (str(cosine), str(b), str(z), str(z * b), str(z * cosine), "1/4")
        for b in (sine, -sine)
        for z in (RANGE - RANGE * RANGE_ERROR, RANGE + RANGE * RANGE_ERROR)
    ]
    rows.append(("mean", "", str(RANGE), "0", str(RANGE * cosine), "1"))
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="Four equally likely measurements of a target 100 km away, with errors of mean zero "
        "in angle and distance, have their mean position at 80 km, replayed in rationals: a chord "
        "is shorter than its arc. For Gaussian angle errors the mean is exp(-sigma^2/2) times the "
        f"offset, which at 0.5 degrees and 300 km is {shift:.2f} m too near.",
        printed="mean 0",
        sharp="mean -(1 - E cos) rho along the line of sight",
        margin_text="towards the sensor by (1 - E cos) of the distance",
        repair="With the offset in (13) divided by the mean cosine g of the angle error the mean "
        "is exact, for every law whose sine has mean zero; a Gaussian one has g = "
        "exp(-sigma^2/2).",
        repair_formula=r"\begin{array}{l}\varphi^{-1}(s,z)=s+\frac{z_2}{g}"
        r"\begin{bmatrix}\sin z_1\\\cos z_1\end{bmatrix} \\"
        r"g=E\cos\varepsilon_1=e^{-\sigma_\psi^2/2}\end{array}",
        certificates=replayed("eq_2_zero_mean", inputs) | proofs("eq_2_zero_mean_repair"),
        replay=tuple(rows),
    )


def independent() -> Decision:
    """The error grows with the distance."""
    cosine, sine = TRIPLE
    inputs = {"e": column(NORTH), "n": column(EAST), "a": cosine, "b": sine, "rho": 1, "l": 2}
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="The same angle errors give four times the squared error at twice the distance, "
        "replayed in rationals, so that xi depends on where sensor and target are.",
        printed="independent",
        sharp="rho times a turned vector of the noise",
        margin_text="the error grows as the distance",
        repair="For given places, error over distance, along the line of sight and across it, is a "
        "function of the noise alone; given the places, errors of different measurements are "
        "therefore independent where the noise is.",
        repair_formula=r"\xi=\rho\,\bigl(((1+d)\cos\varepsilon-1)\,e+(1+d)\sin\varepsilon\,n\bigr)",
        certificates=replayed("eq_2_independent", inputs) | proofs("eq_2_independent_repair"),
    )


def fourth_moment() -> Decision:
    """Errors grow with the distance, and targets may go anywhere."""
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="The error grows as the distance, so that a target which keeps its course passes "
        "every M_4 sooner or later, as an identity.",
        printed="some M_4",
        sharp="rho_max^4 E(1 + |z2|/rho)^4",
        margin_text="none for all distances",
        repair="For distances up to rho_max the fourth moment is at most rho_max^4 times the mean "
        "of (1 + |z2|/rho)^4, about 16 rho_max^4 for small errors, whatever the law of the angle.",
        repair_formula=r"E\lVert\xi\rVert^4\le\rho_{\max}^4\,E\Bigl(1+\frac{\lvert z_2\rvert}{\rho}"
        r"\Bigr)^4",
        certificates=disproof("eq_2_fourth_moment") | proofs("eq_2_fourth_moment_repair"),
    )


def angle() -> Decision:
    """The quotient forgets the quadrant."""
    mirror = tuple(2 * s - r for s, r in zip(SENSOR, TARGET, strict=True))
    rho = math.isqrt(sum((s - r) ** 2 for s, r in zip(SENSOR, TARGET, strict=True)))
    sine, cosine = (Fraction(p - s, rho) for s, p in zip(SENSOR, mirror, strict=True))
    inputs = {"rho": rho, "S": sine, "C": cosine}
    for name, place in (("s", SENSOR), ("r", TARGET), ("p", mirror)):
        inputs |= {f"{name}{k}": x for k, x in enumerate(place, 1)}
    rows = (
        ("", "x1", "x2", "quotient of the offset", "distance"),
        ("sensor", *map(str, SENSOR), "", ""),
        ("target", *map(str, TARGET), str(sine / cosine), str(rho)),
        ("computed by (13)", *map(str, mirror), str(sine / cosine), str(rho)),
    )
    return Decision(
        verdict=Verdict.CORRECTED,
        reason=f"From the sensor at {SENSOR} the target at {TARGET} is computed to be at "
        f"{tuple(mirror)}, replayed in rationals: whenever r2 < s2, (13) returns the mirror image "
        "2s - r. Both places have the same angle and the same distance, so no inverse exists; and "
        "at r2 = s2 the quotient is not defined.",
        printed="arctg of a quotient",
        sharp="angle of the offset in all four quadrants, atan2",
        margin_text="half of all directions come out opposite",
        repair="With the angle whose sine and cosine are (r1 - s1)/rho and (r2 - s2)/rho, (13) is "
        "the inverse everywhere but at the sensor.",
        repair_formula=r"\psi=\mathrm{atan2}(r^1-s^1,\;r^2-s^2)",
        certificates=replayed("eq_11_angle", inputs) | proofs("eq_13_inverse"),
        replay=rows,
        figure=mirrored(SENSOR, TARGET, (float(mirror[0]), float(mirror[1]))),
    )


def inverse() -> Decision:
    """(10), (12) and (13) with the angle in its quadrant."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="An identity of vectors modulo sin^2 + cos^2 = 1, for every place of sensor and "
        "target; the quadrant enters only through the signs of sine and cosine.",
        printed="phi^-1(s, phi(s, r)) = r",
        sharp="the same",
        margin_text="identical",
        certificates=proofs("eq_13_inverse"),
    )


def axes() -> Decision:
    """The two variances stand at each other's place."""
    f, k = ANGLE_ERROR**2, RANGE_ERROR**2
    inputs = {"e": column(NORTH), "n": column(EAST), "rho": RANGE, "f": f, "k": k}
    along, across = RANGE * RANGE_ERROR, RANGE * ANGLE_ERROR
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="For a target straight ahead, 100 km away, with 5 % in distance and half a degree "
        f"in angle, the variance along the line of sight is {float(along**2):g} km^2 and (14) says "
        f"{float(across**2):.3g} km^2, replayed in rationals; the swap is an identity for all "
        "places.",
        printed="diag((rho sigma_psi)^2, (rho sigma_rho)^2)",
        sharp="diag((rho sigma_rho)^2, (rho sigma_psi)^2)",
        margin_text="the two variances are swapped",
        repair="The first column of R(psi) is the line of sight, so the distance's variance comes "
        "first.",
        repair_formula=r"\Xi=R(\psi)\begin{bmatrix}(\rho\sigma_\rho)^2&0\\0&(\rho\sigma_\psi)^2"
        r"\end{bmatrix}R(\psi)^\top",
        certificates=replayed("eq_14_axes", inputs) | proofs("eq_14_axes_repair"),
        figure=ellipses(float(RANGE), float(along), float(across)),
    )


def rotation() -> Decision:
    """R(0) is a quarter turn."""
    inputs = {"u": column(EAST), "v": column(NORTH), "S": 0, "C": 1}
    return Decision(
        verdict=Verdict.CORRECTED,
        reason="R(0) takes the first axis to the second, replayed in integers, while a turn by 0 "
        "moves nothing.",
        printed="turns by psi",
        sharp="turns by pi/2 - psi",
        margin_text="a right angle less the angle",
        repair="R(psi) is a rotation for every psi; it takes the first axis to the line of sight, "
        "which is a right angle less psi away.",
        repair_formula=r"R(\psi)=\mathrm{Rot}\!\left(\tfrac{\pi}{2}-\psi\right)",
        certificates=replayed("eq_14_rotation", inputs) | proofs("eq_14_rotation_repair"),
    )


def trace() -> Decision:
    """The sum of the variances does not mind the swap."""
    return Decision(
        verdict=Verdict.PROVED,
        reason="The trace of the covariance to first order is the printed sum, as an identity for "
        "all places, and it is the same after the swap of (14); the weights of (20), which use "
        "the trace alone, are therefore right to first order.",
        printed="(rho sigma_psi)^2 + (rho sigma_rho)^2",
        sharp="the same",
        margin_text="identical to first order",
        certificates=proofs("eq_14_trace"),
    )


DECISIONS: Mapping[str, Callable[[], Decision]] = {
    "cyclic_spsa.eq_2_zero_mean": zero_mean,
    "cyclic_spsa.eq_2_independent": independent,
    "cyclic_spsa.eq_2_fourth_moment": fourth_moment,
    "cyclic_spsa.eq_11_angle": angle,
    "cyclic_spsa.eq_13_inverse": inverse,
    "cyclic_spsa.eq_14_axes": axes,
    "cyclic_spsa.eq_14_rotation": rotation,
    "cyclic_spsa.eq_14_trace": trace,
    **moments.DECISIONS,
    **cost.DECISIONS,
}
