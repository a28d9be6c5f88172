"""Why the printed statements about the discrete estimator fail, as figures."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from theory.algebra.noncommuting import Form, letters
from theory.systems.variational.statements.common import discrete_energy, energy
from verification.figure import Area, Axis, Curve, Dots, Plot

from .numbers import spectral_radius

ONE = ((Fraction(1),),)
GAINS = {"M": ONE, "K": ONE, "C": ONE}
SHOWN_STEP, SAMPLES = Fraction(1, 2), 16


def energy_over_time() -> Plot:
    """The printed and the corrected energy along (20) from rest, M = K = C = 1, h = 1/2."""
    x, u, h = Fraction(1), Fraction(0), SHOWN_STEP
    printed, corrected = [], []
    for _ in range(SAMPLES):
        printed.append(float(_value(energy(*letters("x u")), x, u, h)))
        corrected.append(float(_value(discrete_energy(*letters("x u")), x, u, h)))
        x = x + h * u
        u = (u - h * x) / (1 + h)
    samples = tuple(float(k) for k in range(SAMPLES))
    top = max(printed)
    return Plot(
        title="Two energies along the recursion",
        finding=f"The printed energy rises from {printed[0]:.4g} to {printed[1]:.4g} in the first "
        "step; the corrected energy never rises.",
        caption="M = K = C = 1, h = 1/2, from rest at x = 1: the printed energy (dashed) rises in "
        "the first step, the corrected one never does.",
        x=Axis("sample k", "", 0.0, float(SAMPLES - 1)),
        y=Axis("energy", "J", 0.0, top * 1.08, ticks=(printed[0],)),
        curves=(
            Curve("sharp", samples, tuple(corrected), "corrected W"),
            Curve("printed", samples, tuple(printed), "printed E"),
        ),
        dots=(Dots("refuting", (1.0,), (printed[1],), "rises"),),
    )


def _value(form: Form, x: Fraction, u: Fraction, h: Fraction) -> Fraction:
    """A quadratic form of one coordinate with M = K = C = 1."""
    total = Fraction(0)
    for (scalars, word), a in form.terms.items():
        powers = dict(scalars)
        ends = [x if letter.rstrip("'") == "x" else u for letter in (word[0], word[-1])]
        total += a * h ** powers.get("h", 0) * ends[0] * ends[1]
    return total


def radius_over_step(limit: float) -> Plot:
    """The spectral radius of (20) over the step, M = K = C = 1.

    Parameters
    ----------
    limit : float
        The step limit, where the radius passes one.
    """
    steps = np.concatenate([np.linspace(0.02, limit, 60), np.linspace(limit, 1.3 * limit, 20)[1:]])
    radii = [
        float(spectral_radius({**GAINS, "h": Fraction(float(h)).limit_denominator(10**6)}).value)
        for h in steps
    ]
    end, top = float(steps[-1]), max(radii) * 1.05
    return Plot(
        title="Spectral radius of one step over the sampling period",
        finding=f"The radius passes one at h = {limit:.5g}; beyond it errors grow, where "
        "stability is promised.",
        caption="M = K = C = 1: beyond the limit every error grows in general, although stability "
        "is promised for every h (hatched).",
        x=Axis("sampling period h", "s", 0.0, end, ticks=(limit,)),
        y=Axis("spectral radius", "", 0.0, top, ticks=(1.0,)),
        curves=(
            Curve("sharp", tuple(steps.tolist()), tuple(radii), "spectral radius"),
            Curve("guide", (0.0, end), (1.0, 1.0)),
        ),
        areas=(
            Area("proved", (0.0, limit), (0.0, 0.0), (top, top)),
            Area("false", (limit, end), (0.0, 0.0), (top, top)),
        ),
    )
