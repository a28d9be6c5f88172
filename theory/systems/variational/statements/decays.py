"""Functions that fall along the continuous estimator, each with the derivation that proves it.

The motion is M w + C u + K x = 0 with u = dx/dt and w = du/dt. C may be any matrix: S = C + C' is
what decides. E is the energy (14); V = E + e x'Mu has a cross term, which makes its rate definite.
"""

from __future__ import annotations

from fractions import Fraction

from ....algebra.continuous_lagrange import (
    along,
    decay,
    equation,
    unrestricted,
    whole,
)
from ....algebra.identities import ONE, Identity, Square
from ....algebra.noncommuting import Form, letters, scalars
from ....algebra.quadratic_forms import symmetrised
from ....algebra.rewriting import derive
from .common import HALF, dissipation, energy, lagrangian

M, K, S, Q, Y = letters("M K S Q Y", "MKSQ")
x, u, w = letters("x u w")
a, e, g = scalars("a e g")

MOTION: Form = unrestricted(equation(lagrangian, dissipation), "C")
"""(12), last line, everything on the left, for any C."""

(C,) = letters("C")
PRINTED_MOTION: Form = M * w + C * u + K * x
"""The same as the paper prints it."""

WORDS = {0: "S", 1: "C", 2: "M w", 3: "Q"}
"""What each hypothesis of `given` does away with."""


def crossed(factor: Form) -> Form:
    """E + factor x'Mu, the energy with a cross term, as half the sum with its transpose."""
    return symmetrised(energy(x, u) + factor * (x.T * M * u))


def given(strength: Form, rate: Form) -> tuple[Form, ...]:
    """Hypotheses S = C + C', Y = K^-1 C, the motion, and Q = S/2 - strength M - rate Y'KY."""
    condition = Q - HALF * S + strength * M + rate * (Y.T * K * Y)
    return C + C.T - S, K * Y - C, MOTION, condition


def positive(factor: Form, hypotheses: tuple[Form, ...], *rest: Square) -> Identity:
    """K - factor^2 M is positive definite, hence E + factor x'Mu is."""
    squares = (whole(Q, factor), *rest, Square(ONE, ONE - HALF * (factor * Y), K))
    return derive("K outweighs M", K - factor * factor * M, hypotheses, WORDS, squares)


ENERGY_GIVEN = (C + C.T - S, MOTION)
ENERGY_RATE = along(energy(x, u))
_ENERGY_WORDS = {0: "S", 1: "M w"}
ENERGY = (
    derive("E' = -u'Su/2", ENERGY_RATE + HALF * (u.T * S * u), ENERGY_GIVEN, _ENERGY_WORDS),
    decay(energy(x, u), Form({}), ENERGY_GIVEN, _ENERGY_WORDS, (Square(HALF * ONE, u, S),)),
)
"""E' is -u'Su/2, and at most zero."""

STRICT_GIVEN = given(e, Fraction(1, 4) * e)
LAGGING = x + HALF * (Y * u)
STRICT_RATE = e * (LAGGING.T * K * LAGGING) + u.T * Q * u
STRICT = (
    derive("V falls strictly", -along(crossed(e)) - STRICT_RATE, STRICT_GIVEN, WORDS),
    positive(e, STRICT_GIVEN),
)
"""V' = -e (x + Yu/2)'K(x + Yu/2) - u'Qu for V = E + e x'Mu, and V is positive definite."""

RATE_GIVEN = given(6 * a, 2 * a)
RATE = (
    decay(
        crossed(4 * a),
        2 * a,
        RATE_GIVEN,
        WORDS,
        (
            Square(ONE, u, Q),
            Square(2 * a, x + Y * u, K),
            Square(a, u - 4 * a * x, M),
            Square(4 * a * a, x, Q),
            Square(8 * a * a * a, x, M),
            Square(4 * a * a * a, Y * x, K),
            Square(a, x - 2 * a * (Y * x), K),
        ),
    ),
    positive(4 * a, RATE_GIVEN, whole(M, 8 * a * a), Square(4 * a * a, Y, K)),
)
"""V' <= -2a V for V = E + 4a x'Mu, and V is positive definite."""

EXACT_GIVEN = (unrestricted(MOTION.substitute({"C": 2 * g * M}), "C"), Q - K + g * g * M)
EXACT = (
    derive("V' = -2gV", along(crossed(g)) + 2 * g * crossed(g), EXACT_GIVEN, {0: "M w"}),
    derive(
        "V is positive",
        crossed(g) - HALF * ((u + g * x).T * M * (u + g * x)) - HALF * (x.T * Q * x),
        EXACT_GIVEN,
        {1: "Q"},
    ),
)
"""V' = -2gV for V = E + g x'Mu where C = 2gM, and V is positive definite if Q = K - g^2 M is."""

REST_GIVEN = (C + C.T - S, MOTION - K * x)
RESTING = along(energy(x, u), {"u": w})
REST = derive(
    "E' = -u'Su/2 without K",
    RESTING + HALF * (u.T * S * u),
    REST_GIVEN,
    _ENERGY_WORDS,
)
"""Where x rests and Mw = -Cu, E has the same rate."""
