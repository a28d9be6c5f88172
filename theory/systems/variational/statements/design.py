"""What a certificate of chosen gains proves: their decay, and what noise leaves of the error."""

from __future__ import annotations

from ....statements import Case, Statement
from .common import DEFINITE, EQUATION, GAINS, SCHEME
from .late import basis

NEWER, POSITION, OLDER = -EQUATION.before("u"), -EQUATION.before("x"), EQUATION.before("v")
"""(20) with the error a sample later on its left side: NEWER w+ + POSITION x+ = OLDER w."""


def _design() -> Statement:
    words = (
        "M, K, C are symmetric positive definite; without noise every solution of (20) at the step "
        "h decays faster than r^k, and with white measurement noise of the covariances chi I "
        "(positions) and nu I (velocities) the stationary covariance of the position error is "
        "less than noise I and that of the velocity error less than speed I"
    )
    left = f"E0*T(E0) + E1*({POSITION})*T(E0) + E1*({NEWER})*T(E1)"
    right = f"E0*T(E0) + E0*h*T(E1) + E1*({OLDER})*T(E1)"
    driven = f"h**2*nu*E0*T(E0) + chi*E1*({POSITION})*T({POSITION})*T(E1)"
    stationary = f"({left})*P*T({left}) == ({right})*P*T({right}) + {driven}"
    scaled = f"schur(r**2*({SCHEME.a2}), r*({SCHEME.a1}), {SCHEME.a0})"
    small = ("pd(noise*I - T(E0)*P*E0)", "pd((speed - nu)*I - T(E1)*P*E1)")
    show = (
        *DEFINITE,
        "h > 0",
        "r > 0",
        "chi >= 0",
        "nu >= 0",
        scaled,
        "1 >= r",
        *basis(2),
        f"exists(P, {stationary}, {', '.join(small)})",
    )
    numbers = dict.fromkeys(("h", "r", "chi", "nu", "noise", "speed"), "number")
    case = Case("PROVED", words, show)
    return Statement("variational", "design", {"PROVED": case}, inputs=GAINS | numbers)


STATEMENTS: tuple[Statement, ...] = (_design(),)
