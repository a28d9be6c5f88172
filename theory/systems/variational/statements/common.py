"""Symbols, action and recursions that all statements about the variational estimator share."""

from __future__ import annotations

from fractions import Fraction

from ....algebra.lagrange import Recursion, discrete_equation, recursion
from ....algebra.noncommuting import Form, letters, scalars

HALF = Fraction(1, 2)
SYMMETRIC = ("M", "K", "C")
M, K, C = letters("M K C", SYMMETRIC)
(h,) = scalars("h")

GAINS = {"M": "matrix", "K": "matrix", "C": "matrix"}
"""Inputs of the statements: symmetric positive definite matrices of one size."""

ANY_GAINS = dict.fromkeys(SYMMETRIC, "positive definite: n") | {"h": "positive"}
"""Symbols of the universal statements."""

DEFINITE = tuple(f"pd({name})" for name in SYMMETRIC)


def lagrangian(x: Form, u: Form) -> Form:
    """Kinetic minus potential energy-like term, (11) and (18): L = 1/2 u'Mu - 1/2 x'Kx."""
    return HALF * (u.T * M * u) - HALF * (x.T * K * x)


def dissipation(_: Form, u: Form) -> Form:
    """F_D = -C u_k, the force of Proposition 4.1."""
    return -(C * u)


def centred_dissipation(v: Form, u: Form) -> Form:
    """-C (u_{k-1} + u_k)/2: the same force, centred at the node, which makes the scheme order 2."""
    return -(HALF * (C * (u + v)))


def energy(x: Form, u: Form) -> Form:
    """Total energy-like term, (14): E = 1/2 u'Mu + 1/2 x'Kx."""
    return HALF * (u.T * M * u) + HALF * (x.T * K * x)


def discrete_energy(x: Form, u: Form) -> Form:
    """W = E + h/4 u'Cu + h/4 (x'Ku + u'Kx), the energy that (20) does dissipate."""
    return energy(x, u) + Fraction(1, 4) * (h * (u.T * C * u + x.T * K * u + u.T * K * x))


EQUATION = discrete_equation(lagrangian, dissipation)
"""(20) at node k, in u_{k-1} = v, x_k = x, u_k = u."""

PRINTED = (M + h * C) * letters("u")[0] - M * letters("v")[0] + h * K * letters("x")[0]
"""Last line of (20) as printed, with the index shifted by one, right side moved to the left."""

SCHEME: Recursion = recursion(EQUATION)
LEAPFROG: Recursion = recursion(discrete_equation(lagrangian, centred_dissipation))


def pencil(r: Recursion) -> str:
    """The three coefficients of a recursion as arguments of the checker's predicates."""
    return f"{r.a2}, {r.a1}, {r.a0}"
