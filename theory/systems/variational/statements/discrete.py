"""What certificates about the discrete variational estimator prove, derived from its action."""

from __future__ import annotations

from fractions import Fraction

from ....algebra.lagrange import Recursion
from ....algebra.noncommuting import Form, letters
from ....statements import BRACKET, Case, Statement
from .common import (
    ANY_GAINS,
    DEFINITE,
    EQUATION,
    GAINS,
    LEAPFROG,
    PRINTED,
    SCHEME,
    SYMMETRIC,
    C,
    K,
    M,
    discrete_energy,
    energy,
    h,
    lagrangian,
    pencil,
)


def step_statements(limit: str, scheme: Recursion, of: str) -> Statement:
    """Two-sided statement about the largest stable step of a scheme."""
    words = (
        f"M, K, C are symmetric positive definite; every solution of {of} tends to 0 for every "
        f"step "
        "0 < h <= lower, and for every step h >= upper some solution does not"
    )
    show = (
        *DEFINITE,
        f"forall(h, 0, lower, schur({pencil(scheme)}))",
        f"forall(h, upper, inf, unstable({pencil(scheme)}))",
    )
    return Statement(
        "variational", limit, {"PROVED": Case("PROVED", words, show, BRACKET)}, inputs=GAINS
    )


def _step() -> Statement:
    stable = (
        "M, K, C are symmetric positive definite and every solution of (20) tends to 0 at this step"
    )
    not_so = "M, K, C are symmetric positive definite and some solution of (20) does not tend to 0"
    coefficients = pencil(SCHEME)
    return Statement(
        "variational",
        "step",
        {
            "PROVED": Case("PROVED", stable, (*DEFINITE, "h > 0", f"schur({coefficients})")),
            "REFUTED": Case("REFUTED", not_so, (*DEFINITE, "h > 0", f"unstable({coefficients})")),
        },
        inputs=GAINS | {"h": "number"},
    )


def _proposition() -> Statement:
    """The action's first variation is the printed recursion, as an identity in the variation."""
    words = (
        "for all M, K, C of any size and every variation h d of an inner node, the action's "
        "change is "
        "h d'(what (23) has in brackets, without the force) plus terms of second order in d, and "
        "with "
        "the force -Cu the brackets are the last line of (20)"
    )
    x, u, v, y, d = letters("x u v y d")
    before = h * (lagrangian(y, v + d) - lagrangian(y, v))
    after = h * (lagrangian(x + h * d, u - d) - lagrangian(x, u))
    bracket = EQUATION + h * C * u
    second = 2 * (h * (d.T * M * d)) - h * h * h * (d.T * K * d)
    symbols = dict.fromkeys(SYMMETRIC, "symmetric: n") | {"h": "positive"}
    symbols |= dict.fromkeys("xuvyd", "vector: n")
    return Statement(
        "variational",
        "prop_4_1",
        {
            "PROVED": Case(
                "PROVED",
                words,
                (
                    f"2*({before + after}) == h*T(d)*({bracket}) + h*T({bracket})*d + {second}",
                    f"{bracket} - h*C*u == -({PRINTED})",
                ),
            )
        },
        symbols=symbols,
    )


def _next_step() -> tuple[str, ...]:
    """(20) from (x, u) to (y, v): y = x + hu, (M + hC)v = Mu - hKy."""
    return ("y - x - h*u", "M*v + h*C*v - M*u + h*K*y")


def _energy_refuted() -> Statement:
    x, v = letters("x v")
    zero = Form({})
    return Statement(
        "variational",
        "discrete_energy",
        {
            "REFUTED": Case(
                "REFUTED",
                "for all M, K, C > 0, every h > 0 and every x: one step of (20) from position "
                "error x "
                "and velocity error 0 leads to (x, v) with an energy larger by 1/2 v'Mv, and v = 0 "
                "only if x = 0, because -v'(M + hC)x = h x'Kx; so the energy (14) at equal index "
                "grows",
                (
                    f"{energy(x, v) - energy(x, zero)} == 1/2*T(v)*M*v",
                    "-T(v)*(M + h*C)*x == h*T(x)*K*x",
                    "h*T(x)*K*x >= 0",
                    "pd(1/2*M)",
                    "pd(h*K)",
                ),
            )
        },
        symbols=ANY_GAINS | {"x": "vector: n", "v": "vector: n"},
        given=("M*v + h*C*v + h*K*x",),
    )


def _energy_repair() -> Statement:
    x, u, y, v = letters("x u y v")
    loss = Fraction(1, 4) * (h * ((u + v).T * C * (u + v)))
    return Statement(
        "variational",
        "discrete_energy_repair",
        {
            "PROVED": Case(
                "PROVED",
                "for all M, K, C > 0 of any size, every h > 0 and every step of (20) from (x, u) "
                "to "
                "(y, v): W = 1/2 u'(M + hC/2)u + 1/2 x'Kx + h/2 x'Ku falls by h/4 (u+v)'C(u+v), "
                "and "
                "W = 1/2 m'Km + 1/8 u'(4M + 2hC - h^2 K)u with the midpoint m = x + hu/2",
                (
                    f"{discrete_energy(x, u) - discrete_energy(y, v)} == {loss}",
                    f"{discrete_energy(x, u) - discrete_energy(y, v)} >= 0",
                    f"{discrete_energy(x, u)} == 1/2*T(x + 1/2*h*u)*K*(x + 1/2*h*u)"
                    " + 1/8*T(u)*(4*M + 2*h*C - h**2*K)*u",
                ),
            )
        },
        symbols=ANY_GAINS | dict.fromkeys("xuyv", "vector: n"),
        given=_next_step(),
    )


def _stability_refuted() -> Statement:
    return Statement(
        "variational",
        "discrete_stability",
        {
            "REFUTED": Case(
                "REFUTED",
                "these M, K, C are symmetric positive definite, h > 0, and (20) has a solution "
                "that "
                "does not tend to 0",
                (*DEFINITE, "h > 0", f"unstable({pencil(SCHEME)})"),
            )
        },
        inputs=GAINS | {"h": "number"},
    )


def _stability_repair() -> Statement:
    return Statement(
        "variational",
        "discrete_stability_repair",
        {
            "PROVED": Case(
                "PROVED",
                "for all M, K, C > 0 of any size and every h > 0 with Q = 4M + 2hC - h^2 K > 0, "
                "every "
                "solution of (20) tends to 0",
                (f"schur({pencil(SCHEME)})",),
            )
        },
        symbols=ANY_GAINS | {"Q": "positive definite: n"},
        given=("Q - 4*M - 2*h*C + h**2*K",),
    )


STATEMENTS = (
    step_statements("step_limit", SCHEME, "(20)"),
    step_statements("leapfrog_step_limit", LEAPFROG, "the leapfrog form of (20)"),
    _step(),
    _proposition(),
    _energy_refuted(),
    _energy_repair(),
    _stability_refuted(),
    _stability_repair(),
)
