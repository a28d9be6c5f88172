"""What certificates about the estimator under measurement noise prove."""

from __future__ import annotations

from ....statements import Case, Statement
from .common import ANY_GAINS, SCHEME, pencil

BOUNDED = (
    "a linear recursion with constant coefficients whose free solutions tend to zero answers "
    "bounded "
    "input with bounded solutions"
)
SUM = "variances of independent variables add"


def _velocity() -> Statement:
    words = (
        "w_k of (24) is computed from velocities measured before sample k, so that the newest "
        "velocity noise is independent of it: the velocity error w - nu has the covariance S + W, "
        "S that of nu and W that of w, and in no direction p is its variance below that of nu"
    )
    return Statement(
        "variational",
        "section_3_velocity_noise",
        {"REFUTED": Case("REFUTED", words, ("T(p)*(S + W)*p >= T(p)*S*p",))},
        symbols={
            "S": "positive semidefinite: n",
            "W": "positive semidefinite: n",
            "p": "vector: n",
        },
        relies_on=(SUM,),
    )


def _robust_a() -> Statement:
    words = (
        "for all M, K, C > 0 of any size and every h > 0 with Q = 4M + 2hC - h^2 K > 0, every "
        "solution of (20) tends to 0; with bounded noise in x and in the measured velocity the "
        "errors stay bounded"
    )
    return Statement(
        "variational",
        "section_3_robust_reading_a",
        {"PROVED": Case("PROVED", words, (f"schur({pencil(SCHEME)})",))},
        symbols=ANY_GAINS | {"Q": "positive definite: n"},
        given=("Q - 4*M - 2*h*C + h**2*K",),
        relies_on=(BOUNDED,),
    )


def _robust_b() -> Statement:
    words = (
        "with x = u = 0 propagated by (16) and (17) themselves, u and x stay 0, and the position "
        "error moves by -h nu in each sample of constant velocity noise nu: it grows without bound"
    )
    return Statement(
        "variational",
        "section_3_robust_reading_b",
        {"REFUTED": Case("REFUTED", words, ("f - e == -h*n",))},
        symbols={"h": "positive"} | dict.fromkeys("efnu", "vector: n"),
        given=("f - e - h*u + h*n", "u"),
    )


STATEMENTS: tuple[Statement, ...] = (_velocity(), _robust_a(), _robust_b())
