"""What certificates about the action's last term and about unsymmetric damping prove."""

from __future__ import annotations

from ....algebra.noncommuting import letters, scalars
from ....statements import Case, Statement
from .common import ANY_GAINS, EQUATION, HALF, C, K, energy, h
from .late import basis, late_step


def _action() -> Statement:
    words = (
        "the last term of (21), k = N, is the only one that the position x_{N+1} enters; moving "
        "that position by h d changes it by h d'Mu_N and terms of second order, so that a "
        "stationary sum would need Mu_N = 0"
    )
    show = (
        "1/2*h*T(v + d)*M*(v + d) - 1/2*h*T(v)*M*v"
        " == 1/2*h*T(d)*M*v + 1/2*h*T(v)*M*d + 1/2*h*T(d)*M*d",
    )
    return Statement(
        "variational",
        "eq_21_action",
        {"REFUTED": Case("REFUTED", words, show)},
        symbols={"M": "symmetric: n", "h": "positive", "v": "vector: n", "d": "vector: n"},
    )


def _unsymmetric() -> Statement:
    words = (
        "these M, K are symmetric positive definite, C + C' and 4M + h(C + C') - h^2 K are "
        "positive "
        "definite, h > 0, and (20) has a solution that does not tend to 0"
    )
    left, right = late_step(0)
    show = (
        "pd(M)",
        "pd(K)",
        "h > 0",
        "pd(C + T(C))",
        "pd(4*M + h*(C + T(C)) - h**2*K)",
        "pd(T(M + h*C)*(M + h*C))",
        *basis(2),
        f"exists(Q, dips(Q), pd(T({left})*Q*({left}) - T({right})*Q*({right})))",
    )
    inputs = {"M": "matrix", "K": "matrix", "C": "matrix", "h": "number"}
    cases = {"REFUTED": Case("REFUTED", words, show)}
    return Statement("variational", "discrete_stability_unsymmetric", cases, inputs)


def _unsymmetric_repair() -> Statement:
    words = (
        "for all M, K > 0 of any size, every C and h > 0 with S = C + C' - hK > 0: along (20) from "
        "(y, u) to (z, v), y and z being the newer positions, the energy 1/2 u'Mu + 1/2 y'Ky never "
        "grows, and it falls by h/2 v'Sv + 1/2 (v-u)'M(v-u)"
    )
    before, after = "1/2*T(u)*M*u + 1/2*T(y)*K*y", "1/2*T(v)*M*v + 1/2*T(z)*K*z"
    loss = "1/2*h*T(v)*S*v + 1/2*T(v - u)*M*(v - u)"
    show = (f"{before} - ({after}) == {loss}", f"{before} - ({after}) >= 0")
    symbols = dict.fromkeys(("M", "K", "S"), "positive definite: n")
    symbols |= {"C": "matrix: n n", "h": "positive"} | dict.fromkeys("uvyz", "vector: n")
    return Statement(
        "variational",
        "discrete_stability_unsymmetric_repair",
        {"PROVED": Case("PROVED", words, show)},
        symbols=symbols,
        given=("M*v - M*u + h*C*v + h*K*y", "z - y - h*v", "S - C - T(C) + h*K"),
    )


def _pairing() -> Statement:
    """From the y with K y = -C v, (20) repeats v: the position alone moves, by h v."""
    v, y, z = letters("v y z")
    (q,) = scalars("q")
    words = (
        "for all M, K, C > 0 of any size, every h > 0 and every v with q = v'(hK - 2C)v > 0: (20) "
        "leads from the newer position y = -K^{-1} C v and the velocity error v to z = y + hv and "
        "v, and the energy 1/2 v'Mv + 1/2 y'Ky of the newer position grows by hq/2"
    )
    step = EQUATION.substitute({"x": y, "u": v, "v": v})
    growth = energy(z, v) - energy(y, v)
    surplus = v.T * (h * K - 2 * C) * v - q
    return Statement(
        "variational",
        "discrete_energy_pairing",
        {"REFUTED": Case("REFUTED", words, (f"{step} == 0", f"{growth} == {HALF * (h * q)}"))},
        symbols=ANY_GAINS | {"q": "positive"} | dict.fromkeys("vyz", "vector: n"),
        given=(str(K * y + C * v), str(z - y - h * v), str(surplus)),
    )


STATEMENTS: tuple[Statement, ...] = (
    _action(),
    _unsymmetric(),
    _unsymmetric_repair(),
    _pairing(),
)
