"""What certificates about exact moments of measured distances and positions prove."""

from __future__ import annotations

from ....statements import Statement
from .. import moment_identities
from ..universal import Universal
from .replays import case, numbers

NOISE = {"P": "positive semidefinite: N", **dict.fromkeys("oxz", "vector: N")} | {
    "rho": "positive",
    "k": "positive",
    "q": "positive",
}
SQUARES = (
    dict.fromkeys("wko", "vector: N")
    | {"V": "positive semidefinite: M", "t": "vector: M", "x": "vector: M"}
    | {"rho": "positive", "g": "real", "f": "positive"}
)
TURNS = (
    dict.fromkeys("klo", "vector: N")
    | {"W": "positive semidefinite: N", "V": "positive semidefinite: M"}
    | {"t": "vector: M", "x": "vector: M", "f": "positive"}
    | {"g": "real", "a": "nonnegative", "b": "nonnegative"}
)

UNIVERSAL: tuple[Universal, ...] = (
    Universal(
        "eq_14_sigma_repair",
        "for any law of finitely many errors x of the distance, of mean 0 and variance (rho k)^2: "
        "the mean of ((rho + x) k)^2 is (1 + k^2) (rho k)^2, and divided by 1 + k^2 it is the "
        "variance",
        moment_identities.measured_variance(),
        NOISE,
    ),
    Universal(
        "eq_14_trace_exact_repair",
        "for independent laws of finitely many outcomes, of the angle error with the mean cosine "
        "g, and of the relative error of the distance with mean 0 and variance f^2: rho^2 times "
        "the mean of 1 + (1 + x)^2 - 2 (1 + x) cos, the squared error of the position, is rho^2 (2 "
        "+ f^2 - 2g)",
        moment_identities.mean_square(),
        SQUARES,
    ),
    Universal(
        "eq_14_exact_repair",
        "for independent laws of finitely many outcomes, of the angle error with the mean cosine "
        "g, mean squares a of the cosine and b of the sine, mean sine 0 and mean product 0, and of "
        "the relative error of the distance with mean 0 and variance f^2: over the squared "
        "distance, the variance of the position along the line of sight is (1 + f^2) a - g^2, "
        "across it (1 + f^2) b, and nothing is mixed",
        moment_identities.covariance(),
        TURNS,
    ),
)

STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in UNIVERSAL),
    case(
        "REFUTED",
        "eq_14_sigma",
        "the distance rho errs by +-d with probability 1/2 each, d = rho k: the mean of (z k)^2 is "
        "(1 + k^2) d^2, which is not d^2, the variance",
        (
            "rho > 0",
            "k > 0",
            "d == rho*k",
            "((rho + d)**2 + (rho - d)**2)*k**2/2 == (1 + k**2)*d**2",
            "(1 + k**2)*d**2 != d**2",
        ),
        numbers("rho", "k", "d"),
    ),
    case(
        "REFUTED",
        "eq_14_trace_exact",
        "the distance rho is exact and the angle errs by +-x with probability 1/2 each: the square "
        "of the position's error is rho^2 (2 - 2 cos x), at most rho^2 (x^2 - x^4/12 + x^6/360) = "
        "e, which is below rho^2 x^2 = n",
        (
            "rho > 0",
            "x > 0",
            "e == rho**2*(x**2 - x**4/12 + x**2*x**4/360)",
            "n == rho**2*x**2",
            "e < n",
        ),
        numbers("rho", "x", "e", "n"),
        ("cos x >= 1 - x^2/2 + x^4/24 - x^6/720 for every x",),
    ),
    case(
        "REFUTED",
        "eq_14_exact",
        "the distance rho is exact and the angle errs by +-x with probability 1/2 each: across the "
        "line of sight the variance of the position is rho^2 sin(x)^2, at most rho^2 y^2 with y = "
        "x - x^3/6 + x^5/120, which is below rho^2 x^2",
        (
            "rho > 0",
            "x > 0",
            "y == x - x**3/6 + x**4*x/120",
            "y > 0",
            "rho**2*y**2 < rho**2*x**2",
        ),
        numbers("rho", "x", "y"),
        ("sin x <= x - x^3/6 + x^5/120 for every x >= 0",),
    ),
)
