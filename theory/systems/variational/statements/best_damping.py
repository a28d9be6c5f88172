"""How fast the continuous estimator can be made by C alone, and where that is reached."""

from __future__ import annotations

from ....algebra.identities import ONE
from ....algebra.noncommuting import scalars
from ....statements import Case, Statement
from .common import DEFINITE, GAINS
from .universal import universal

QUADRATICS = (
    "a real polynomial of even degree whose roots have real parts of at most -r is a product of "
    "quadratics (s+r)^2 + a(s+r) + b with a, b >= 0; det(s^2 M + sC + K) has the leading "
    "coefficient det M and the value det K at s = 0"
)

A, B, c, p, q, r = scalars("A B c p q r")
PRODUCT = A - B - c
RECIPROCAL = r * (p * p + q * q) - ONE


def _ceiling() -> Statement:
    return universal(
        "theorem_3_2_stability_ceiling",
        "if all 2n roots of det(s^2 M + sC + K) have real parts of at most -r, then "
        "r^(2n) <= det K/det M, whatever C is: each quadratic factor has the constant coefficient "
        "r^2 + ar + b, and a product A = B + c >= B of such coefficients, B = r^(2k), times one "
        "more is at least B r^2",
        ("A*(r**2 + a*r + b) >= B*r**2",),
        dict.fromkeys("abcB", "nonnegative") | {"A": "real", "r": "positive"},
        (PRODUCT,),
        (QUADRATICS,),
    )


PLANAR = {
    "c11": "4*p**3*q*r",
    "c22": "4*p*q**3*r",
    "c12": "(p**2 - q**2)*(p**2 - q**2)*r",
}
"""Entries of the best C for M = I, K = diag(p^4, q^4), with r = 1/(p^2 + q^2)."""


def _planar() -> Statement:
    c11, c22, c12 = PLANAR.values()
    diagonal = f"(s**2 + s*{c11} + p**4)*(s**2 + s*{c22} + q**4)"
    return universal(
        "theorem_3_2_stability_planar",
        "M = I, K = diag(p^4, q^4), r = 1/(p^2 + q^2) and C with the entries c11 = 4p^3 q r, "
        "c22 = 4pq^3 r, c12 = (p^2 - q^2)^2 r: det(s^2 M + sC + K) = (s + pq)^4, and det C = "
        "6p^2q^2 - p^4 - q^4, so that C > 0 while this is positive: all four eigenvalues are -pq, "
        "the best that any C can do",
        (
            f"{diagonal} - s**2*({c12})*({c12}) == (s + p*q)**4",
            f"{c11} >= 0",
            f"({c11})*({c22}) - ({c12})*({c12}) == 6*p**2*q**2 - p**4 - q**4",
        ),
        {"p": "positive", "q": "positive", "r": "positive", "s": "real"},
        (RECIPROCAL,),
    )


def _attained() -> Statement:
    """Repeated eigenvalue of exact data, by a power of the system's matrix that vanishes."""
    eye = "(E0*T(E0) + E1*T(E1))"
    motion = "(E0*T(E0) + E1*M*T(E1))*A == E0*T(E1) - E1*(K*T(E0) + C*T(E1))"
    return Statement(
        "variational",
        "theorem_3_2_stability_attained",
        {
            "PROVED": Case(
                "PROVED",
                "M, K, C are symmetric positive definite, s > 0, and the matrix A of (12) in "
                "orthonormal blocks E0, E1 for x and u has (A + sI)^4 = 0: all its eigenvalues are "
                "-s, so that s^(2n) = det K/det M, which no other C can exceed by "
                "theorem_3_2_stability_ceiling",
                (
                    *DEFINITE,
                    "s > 0",
                    "exists(I, I*M == M)",
                    "exists(E0, T(E0)*E0 == I)",
                    "exists(E1, T(E1)*E1 == I, T(E0)*E1 == 0*I)",
                    f"exists(A, {motion}, (A + s*{eye})**4 == 0*A)",
                ),
            )
        },
        inputs=GAINS | {"s": "number"},
    )


STATEMENTS: tuple[Statement, ...] = (_ceiling(), _planar(), _attained())
