"""What certificates about the measurement model, weights and cost, (1) to (14), (20), prove."""

from __future__ import annotations

from ....algebra import polar
from ....statements import Case, Statement
from ..universal import Universal
from . import cost, moments

PLANE = (
    dict.fromkeys("uvensrp", "vector: 2")
    | dict.fromkeys("SCabd", "real")
    | {"rho": "positive", "J": "matrix: 2 2", "Q": "matrix: 2 2"}
    | dict.fromkeys("XYi", "symmetric: 2")
    | dict.fromkeys("fkgq", "positive")
)
"""Symbols of `theory.algebra.polar`, without those of laws of the noise."""
LAWS = PLANE | dict.fromkeys("wklo", "vector: N") | dict.fromkeys("vzt", "vector: M")

MOMENTS = {"B": "nonnegative", "c": "nonnegative", "q": "positive"} | {
    "rho": "positive",
    "p": "nonnegative",
}

_SHAPE, _RADIAL, _PRINTED_RADIAL, _TRACE, _PRINTED_TRACE = polar.covariance()

SIGHTS: tuple[Universal, ...] = (
    Universal(
        "eq_2_zero_mean_repair",
        "for independent laws of finitely many outcomes, of the angle's error with probabilities "
        "w, cosines k and sines l, the mean cosine g and the mean sine 0, and of the distance with "
        "probabilities v and values z of mean rho, for a target at r = s + rho e: the mean of s + "
        "z (k e + l n)/g is r, and without the division by g it is r - (1 - g) rho e",
        polar.mean_position(),
        LAWS,
    ),
    Universal(
        "eq_2_independent_repair",
        "for a target at r = s + rho e and a measurement whose angle errs by the cosine a and the "
        "sine b, and whose distance by rho d: the error of the position is rho (((1 + d) a - 1) e "
        "+ (1 + d) b n), so that error over distance, along the line of sight e and across it, "
        "depends on the noise alone; its square is rho^2 ((1 + d)^2 + 1 - 2 (1 + d) a)",
        polar.error(),
        PLANE,
    ),
    Universal(
        "eq_2_fourth_moment",
        "for an angle that errs, so that the squared error of the position at the distance 1 is c "
        "> 0: at the squared distance q = (B + 1)/c the fourth power of the error is B^2 + 2B + 1, "
        "above the bound B^2, whatever B is",
        polar.unbounded(),
        MOMENTS,
        verdict="REFUTED",
    ),
    Universal(
        "eq_2_fourth_moment_repair",
        "for the distance rho, measured as p times rho, and an angle whose error has the cosine c "
        "- 1: the squared error of the position is at most rho^2 (1 + p)^2, so that its fourth "
        "power is at most rho^4 (1 + p)^4",
        polar.fourth_moment(),
        MOMENTS,
    ),
    Universal(
        "eq_13_inverse",
        "if r = s + rho (S u + C v) with axes u, v and S^2 + C^2 = 1, then p = s + rho (S u + C v) "
        "is r, rho^2 = |r - s|^2, and rho S and rho C are the two entries of r - s, which give the "
        "angle its quadrant",
        polar.inverse(),
        PLANE,
    ),
    Universal(
        "eq_14_axes_repair",
        "for orthonormal e, n, the derivative J = [rho n, e] of the position by angle and "
        "distance (axes u, v) and deviations f of the angle, rho k of the distance: the "
        "covariance to first order, J diag(f^2, (rho k)^2) J', is Q diag((rho k)^2, (rho f)^2) Q'"
        " with Q = [e, -n]; along the line of sight e it is (rho k)^2, and Q diag((rho f)^2, (rho"
        " k)^2) Q' is (rho f)^2 there",
        (_SHAPE, _RADIAL, _PRINTED_RADIAL),
        PLANE,
    ),
    Universal(
        "eq_14_trace",
        "for orthonormal e, n, the derivative J = [rho n, e] of the position by angle and distance "
        "(axes u, v) and deviations f of the angle, rho k of the distance: "
        "the trace of J diag(f^2, (rho k)^2) J' is (rho f)^2 + (rho k)^2, and so is that of the "
        "matrix with the two swapped",
        (_TRACE, _PRINTED_TRACE),
        PLANE,
    ),
    Universal(
        "eq_14_rotation_repair",
        "Q = S I + C (vu' - uv'), with axes u, v and S^2 + C^2 = 1, has Q'Q = I and determinant 1 "
        "and takes u to S u + C v: it turns from the first axis to the second by the angle whose "
        "cosine is S = sin psi and whose sine is C = cos psi, a right angle less psi",
        polar.rotation(),
        PLANE,
    ),
)


def _refuted(name: str, words: str, show: tuple[str, ...], inputs: dict[str, str]) -> Statement:
    return Statement("cyclic_spsa", name, {"REFUTED": Case("REFUTED", words, show)}, inputs)


def _frame(e: str, n: str) -> tuple[str, ...]:
    return (f"T({e})*{e} == 1", f"T({n})*{n} == 1", f"T({e})*{n} == 0")


def _zero_mean() -> Statement:
    """Four equally likely measurements."""
    near, far, up, down = "(rho - d)", "(rho + d)", "(a*e + b*n)", "(a*e - b*n)"
    four = " + ".join(f"{length}*{way}" for length in (near, far) for way in (up, down))
    return _refuted(
        "eq_2_zero_mean",
        "the distance rho errs by +-d and the angle by +- the angle of cosine a and sine b, four "
        "outcomes of probability 1/4, each error of mean zero and independent of the other: the "
        "mean of the computed positions is the target's place s + rho e less (1 - a) rho e, which "
        "is not zero",
        (
            *_frame("e", "n"),
            "a**2 + b**2 == 1",
            "b > 0",
            "d > 0",
            "rho > d",
            f"s + ({four})/4 == (s + rho*e) - (1 - a)*rho*e",
            "(1 - a)*rho > 0",
        ),
        dict.fromkeys("sen", "matrix") | {**dict.fromkeys("abd", "number"), "rho": "number"},
    )


def _independent() -> Statement:
    return _refuted(
        "eq_2_independent",
        "the distance is exact and the angle errs by +- the angle of cosine a and sine b: at the "
        "distance rho the square of the position's error is rho^2 (2 - 2a) in both outcomes, at l "
        "it is l^2 (2 - 2a), and these differ",
        (
            *_frame("e", "n"),
            "a**2 + b**2 == 1",
            *(
                f"{k}**2*T(a*e {sign} b*n - e)*(a*e {sign} b*n - e) == {k}**2*(2 - 2*a)"
                for k in ("rho", "l")
                for sign in "+-"
            ),
            "rho > 0",
            "l > 0",
            "rho**2*(2 - 2*a) != l**2*(2 - 2*a)",
        ),
        dict.fromkeys("en", "matrix")
        | {"a": "number", "b": "number"}
        | {"rho": "number", "l": "number"},
    )


def _angle() -> Statement:
    numbers = ("s1", "s2", "r1", "r2", "p1", "p2", "rho", "S", "C")
    return _refuted(
        "eq_11_angle",
        "the angle of sine S and cosine C > 0 is the arctangent of (r1 - s1)/(r2 - s2), and rho "
        "the distance of r from s: (13) gives p = 2s - r, another place than r; angle and distance "
        "of p are the same, so that no function of them tells the two apart",
        (
            "C > 0",
            "S**2 + C**2 == 1",
            "r2 - s2 != 0",
            "S*(r2 - s2) == C*(r1 - s1)",
            "rho > 0",
            "rho**2 == (r1 - s1)**2 + (r2 - s2)**2",
            "p1 == s1 + rho*S",
            "p2 == s2 + rho*C",
            "p1 == 2*s1 - r1",
            "p2 == 2*s2 - r2",
            "(p1 - r1)**2 + (p2 - r2)**2 > 0",
            "p2 - s2 != 0",
            "S*(p2 - s2) == C*(p1 - s1)",
            "rho**2 == (p1 - s1)**2 + (p2 - s2)**2",
        ),
        dict.fromkeys(numbers, "number"),
    )


def _axes() -> Statement:
    return _refuted(
        "eq_14_axes",
        "a target in the direction e, the second axis, at the distance rho, with variances f of "
        "the angle and rho^2 k of the distance, f > 0, k > 0: along e the covariance to first "
        "order, rho^2 (f nn' + k ee'), is rho^2 k, and the printed one, rho^2 (f ee' + k nn'), is "
        "rho^2 f, which is another number",
        (
            *_frame("e", "n"),
            "rho > 0",
            "f > 0",
            "k > 0",
            "T(e)*(rho**2*(f*n*T(n) + k*e*T(e)))*e == rho**2*k",
            "T(e)*(rho**2*(f*e*T(e) + k*n*T(n)))*e == rho**2*f",
            "rho**2*k != rho**2*f",
        ),
        dict.fromkeys("en", "matrix") | {"rho": "number", "f": "number", "k": "number"},
    )


def _rotation() -> Statement:
    return _refuted(
        "eq_14_rotation",
        "at psi = 0, sine S = 0 and cosine C = 1, the matrix S I + C (vu' - uv') takes the axis u "
        "to the axis v, and a turn by psi = 0 would leave it where it is",
        (
            *_frame("u", "v"),
            "S == 0",
            "C == 1",
            "(S*(u*T(u) + v*T(v)) + C*(v*T(u) - u*T(v)))*u == v",
        ),
        {"u": "matrix", "v": "matrix", "S": "number", "C": "number"},
    )


UNIVERSAL: tuple[Universal, ...] = (*SIGHTS, *moments.UNIVERSAL, *cost.UNIVERSAL)

STATEMENTS: tuple[Statement, ...] = (
    *(entry.statement for entry in SIGHTS),
    _zero_mean(),
    _independent(),
    _angle(),
    _axes(),
    _rotation(),
    *moments.STATEMENTS,
    *cost.STATEMENTS,
)
