"""One step of (20) and its energies as block matrices, and the identity that makes it dissipate.

With z = (x, u) and a sample later (y, w), (20) is E z+ = F z.
"""

from __future__ import annotations

from fractions import Fraction

from ...algebra.block_matrices import Blocks, coefficients, hessian
from ...algebra.noncommuting import Form, letters
from .statements.common import EQUATION, SYMMETRIC, C, K, discrete_energy, energy, h

NOW, LATER = ("x", "u"), ("y", "w")
x, u, y, w = letters("x u y w", SYMMETRIC)

STEP = (y - x - h * u, -EQUATION.substitute({"x": y, "v": u, "u": w}))
"""(19) and the last line of (20), zero along every solution."""

LEFT: Blocks = coefficients(STEP, LATER)
RIGHT: Blocks = -coefficients(STEP, NOW)
"""E and F."""

ENERGY: Blocks = hessian(energy(x, u), NOW)
CONSERVED: Blocks = hessian(discrete_energy(x, u), NOW)
"""Of the printed energy (14), and of the one that (20) does dissipate."""


QUARTER, NOTHING, ONE = Fraction(1, 4), Form({}), Form({((), ()): Fraction(1)})
EVERY = (*LATER, *NOW)
CHANGE: Blocks = hessian(
    discrete_energy(y, w) - discrete_energy(x, u) + QUARTER * (h * ((u + w).T * C * (u + w))),
    EVERY,
)
"""W+ - W + h/4 (u + w)'C(u + w), without use of (20), as a form in (y, w, x, u)."""

MULTIPLIERS = Blocks(
    (
        (QUARTER * K, NOTHING),
        (NOTHING, QUARTER * ONE),
        (QUARTER * K, NOTHING),
        (NOTHING, QUARTER * ONE),
    )
)
"""L of the identity CHANGE = L G + (L G)', where G (y, w, x, u) = 0 is (20)."""

CONSTRAINT: Blocks = coefficients(STEP, EVERY)
