"""What certificates about the continuous estimator prove, derived from its Lagrangian.

Statements hold for gains of any size. C need not be symmetric: S = C + C' is what decides.
"""

from __future__ import annotations

from collections.abc import Callable

from ....algebra.continuous_lagrange import along, first_variation
from ....algebra.noncommuting import Form
from ....statements import Statement
from . import best_damping
from .common import energy, lagrangian
from .decays import (
    ENERGY_GIVEN,
    EXACT_GIVEN,
    PRINTED_MOTION,
    RATE_GIVEN,
    REST_GIVEN,
    RESTING,
    STRICT_GIVEN,
    K,
    M,
    a,
    crossed,
    e,
    g,
    u,
    x,
)
from .universal import universal

GAINS = {"M": "positive definite: n", "K": "positive definite: n"}
VECTORS = dict.fromkeys("xuw", "vector: n") | {"h": "real"}
DAMPED = GAINS | {"C": "matrix: n", "Y": "matrix: n"} | dict.fromkeys("SQ", "positive definite: n")

GRONWALL = (
    "Gronwall: what falls at least at the rate r times itself is at most exp(-rt) of its start"
)
SMALL = (
    "a positive definite matrix dominates every small enough multiple of a symmetric matrix, so "
    "that Q > 0 for every small enough positive scalar"
)
LYAPUNOV = "Lyapunov's direct method: a positive definite form that falls strictly tends to 0"
ARBITRARY = (
    "fundamental lemma of the calculus of variations: if the integral of d'f vanishes for every "
    "smooth d that vanishes at both ends, the continuous f is zero"
)


def energy_text(at: str = "x", speed: str = "u") -> str:
    """(14) in the checker's language, at any position and velocity."""
    return f"1/2*T({speed})*M*({speed}) + 1/2*T({at})*K*({at})"


def crossed_text(factor: str, at: str = "x", speed: str = "u") -> str:
    """The energy with a cross term, factor x'Mu, in the checker's language."""
    cross = f"T({at})*M*({speed}) + T({speed})*M*({at})"
    return f"{energy_text(at, speed)} + 1/2*{factor}*({cross})"


def _grows(form: Form, text: Callable[[str, str], str]) -> str:
    """Predicate that names the time derivative of a form: what stands before h a time h later."""
    later, tail = text("x + h*u", "u + h*w"), text("u", "w")
    return f"{later} == {text('x', 'u')} + h*({along(form)}) + h**2*({tail})"


def _proposition() -> Statement:
    """The principle for the Lagrangian (11), the force -Cu and every variation d."""
    first = first_variation(lagrangian)
    boundary = "1/2*T(d)*M*u + 1/2*T(u)*M*d"
    moved = "1/2*T(d + h*p)*M*(u + h*w) + 1/2*T(u + h*w)*M*(d + h*p)"
    rate = "1/2*(T(p)*M*u + T(d)*M*w + T(w)*M*d + T(u)*M*p)"
    work = "1/2*(T(d)*C*u + T(C*u)*d)"

    def action(at: str, speed: str) -> str:
        return f"1/2*T({speed})*M*({speed}) - 1/2*T({at})*K*({at})"

    return universal(
        "prop_3_1",
        "for all symmetric M, K and every C of any size, every path x with velocity u and "
        "acceleration w, and every variation e d with rate e p: the integrand (11) changes by e "
        "times its first variation plus terms of second order in e; d'Mu has the rate "
        "p'Mu + d'Mw; and the first variation plus the work of -Cu is that rate less "
        "d'(Mw + Cu + Kx), so that with d = 0 at both ends the last line of (12) is what remains "
        "(numbers are written as half the sum with their transpose)",
        (
            f"{action('x + e*d', 'u + e*p')} == "
            f"{action('x', 'u')} + e*({first}) + e**2*({action('d', 'p')})",
            f"{moved} == {boundary} + h*({rate}) + h**2*(1/2*T(p)*M*w + 1/2*T(w)*M*p)",
            f"{first} - {work} == {rate} - 1/2*(T(d)*({PRINTED_MOTION}) + T({PRINTED_MOTION})*d)",
        ),
        {"M": "symmetric: n", "K": "symmetric: n", "C": "matrix: n"}
        | dict.fromkeys("xuwdp", "vector: n")
        | {"e": "real", "h": "real"},
        relies_on=(ARBITRARY,),
    )


def _dissipation() -> Statement:
    return universal(
        "eq_15_dissipation",
        "for all symmetric M, K and every C of any size with S = C + C' >= 0, symmetric or not, "
        "and w with Mw = -Cu - Kx: E a time h after (x, u) is E + h E' + h^2 E(u, w) with "
        "E' = -u'Su/2 = -u'Cu <= 0",
        (
            _grows(energy(x, u), energy_text),
            f"{along(energy(x, u))} == -1/2*T(u)*S*u",
            f"-({along(energy(x, u))}) >= 0",
        ),
        {
            "M": "symmetric: n",
            "K": "symmetric: n",
            "C": "matrix: n",
            "S": "positive semidefinite: n",
        }
        | VECTORS,
        ENERGY_GIVEN,
    )


def _positive(factor: Form, text: str) -> tuple[str, str]:
    """E + factor x'Mu as two squares, the second with a positive definite weight."""
    weight = K - factor * factor * M
    squares = f"1/2*T(u + {text}*x)*M*(u + {text}*x) + 1/2*T(x)*({weight})*x"
    return f"{crossed_text(text)} == {squares}", f"pd({weight})"


def _stability() -> Statement:
    form = crossed(4 * a)
    return universal(
        "theorem_3_2_stability",
        "for all M, K > 0 and every C of any size with S = C + C' > 0, symmetric or not, and every "
        "a > 0 with Q = S/2 - 6aM - 2aC'K^-1 C > 0 (Y = K^-1 C): V = E + 4a x'Mu is positive "
        "definite and V' <= -2aV along x' = u, Mu' = -Cu - Kx, so that V(t) <= exp(-2at) V(0) and "
        "x, u tend to 0 exponentially",
        (
            _grows(form, lambda at, speed: crossed_text("(4*a)", at, speed)),
            f"-({along(form)}) - 2*a*({crossed_text('(4*a)')}) >= 0",
            *_positive(4 * a, "(4*a)"),
        ),
        DAMPED | {"a": "positive"} | VECTORS,
        RATE_GIVEN,
        (SMALL, GRONWALL),
    )


def _exact_rate() -> Statement:
    form = crossed(g)
    return universal(
        "theorem_3_2_stability_rate",
        "for all M, K > 0 of any size, C = 2gM and every g > 0 with Q = K - g^2 M > 0: "
        "V = E + g x'Mu is positive definite and V' = -2gV exactly, so that V(t) = exp(-2gt) V(0)",
        (
            _grows(form, lambda at, speed: crossed_text("g", at, speed)),
            f"{along(form)} == -2*g*({crossed_text('g')})",
            f"{crossed_text('g')} == 1/2*T(u + g*x)*M*(u + g*x) + 1/2*T(x)*Q*x",
        ),
        GAINS | {"Q": "positive definite: n", "g": "positive"} | VECTORS,
        EXACT_GIVEN,
        (GRONWALL,),
    )


def _citation() -> Statement:
    return universal(
        "theorem_3_2_citation",
        "for all M, K > 0, every C of any size with S = C + C' > 0, and w with Mw = -Cu: along "
        "x' = 0, u' = w, E a time h after (x, u) is E + h E' + h^2 E(0, w) with E' = -u'Su/2 = "
        "-u'Cu, the same as (15), with E > 0; but from (x, 0) with x not 0 nothing moves (-u'Cu "
        "is 0 there, and Mw = 0), so that what the cited theorem supposes and concludes does not "
        "make x tend to 0",
        (
            f"{energy_text('x', 'u + h*w')} == "
            f"{energy_text()} + h*({RESTING}) + h**2*(1/2*T(w)*M*w)",
            f"{RESTING} == -1/2*T(u)*S*u",
            "T(u)*S*u >= 0",
            "pd(1/2*M)",
            "pd(1/2*K)",
        ),
        GAINS | {"C": "matrix: n", "S": "positive definite: n"} | VECTORS,
        REST_GIVEN,
        verdict="REFUTED",
    )


def _citation_repair() -> Statement:
    form = crossed(e)
    return universal(
        "theorem_3_2_citation_repair",
        "for all M, K > 0 and every C of any size with S = C + C' > 0, and every e > 0 with "
        "Q = S/2 - eM - (e/4) C'K^-1 C > 0 (Y = K^-1 C): V = E + e x'Mu is positive definite, and "
        "-V' = e (x + Yu/2)'K(x + Yu/2) + u'Qu is positive definite in (x, u) along (12), so that "
        "Lyapunov's direct method suffices; it is so only if Q > 0, as x = -Yu/2 shows",
        (
            _grows(form, lambda at, speed: crossed_text("e", at, speed)),
            f"-({along(form)}) == e*T(x + 1/2*Y*u)*K*(x + 1/2*Y*u) + T(u)*Q*u",
            *_positive(e, "e"),
        ),
        DAMPED | {"e": "positive"} | VECTORS,
        STRICT_GIVEN,
        (SMALL, LYAPUNOV),
    )


STATEMENTS: tuple[Statement, ...] = (
    _proposition(),
    _dissipation(),
    _stability(),
    _exact_rate(),
    *best_damping.STATEMENTS,
    _citation(),
    _citation_repair(),
)
