"""What certificates about mean-square stability prove, from the derived second moments.

One update takes the second moment P of the error to L(P) = P - alpha (HP + PH) + alpha^2 K(Q), with
Q = HPH, and its adjoint takes Y to L*(Y) = Y - alpha (HY + YH) + alpha^2 H K*(Y) H. With Y = HZH,

    L(P) - P  = alpha (alpha K(Q) - (HP + PH)),
    Y - L*(Y) = alpha H (HZ + ZH - alpha K*(Y)) H:

what is in brackets is linear in the step. L and L* keep definite matrices definite, so that Z > 0
with a positive second bracket shows decay, and P >= 0, not 0, with a first one >= 0 shows none.
K(Q) >= 0 for Q >= 0, so that what does not decay at a step does not at any larger one.
"""

from __future__ import annotations

from ....algebra.noncommuting import Form, letters
from ....statements import BRACKET, Case, Statement
from ..error import SYMMETRIC, adjoint, second_moment
from .common import BLOCK, COVARIANCE, FOR_DATA, HESSIAN, WELL_POSED, in_data

H, P, Y, Z = letters("H P Y Z", SYMMETRIC)
IDENTITY = f"exists(I, I*{HESSIAN} == {HESSIAN})"


def _parts(operator: Form, start: Form) -> tuple[Form, Form]:
    """D and K of the operator start - alpha D + alpha^2 K."""
    drift, kick = -operator.coefficient("alpha", 1), operator.coefficient("alpha", 2)
    rest = (operator.coefficient("alpha", 0) - start).terms
    if rest or len(operator.terms) != len(start.terms) + len(drift.terms) + len(kick.terms):
        raise ValueError("second moments: not of the second degree in the step")
    return drift, kick


def _within(form: Form) -> Form:
    """F of H F H; nothing between the two is the identity.

    Raises
    ------
    ValueError
        A word does not begin and end with H.
    """
    terms = {}
    for (scalars, word), a in form.terms.items():
        if len(word) < 2 or word[0] != "H" or word[-1] != "H":
            raise ValueError(f"second moments: {form} has no H around it")
        terms[scalars, word[1:-1] or ("I",)] = a
    return Form(terms, form.symmetric)


def pull_and_kick() -> tuple[Form, Form]:
    """HP + PH, and K(Q) in the letter Q."""
    return _parts(second_moment(), P)


def adjoint_pull_and_kick() -> tuple[Form, Form]:
    """HZ + ZH, and K*(Y) in the letter Y = HZH."""
    pull, kick = _parts(adjoint(), Y)
    return _within(pull.substitute({"Y": H * Z * H})), _within(kick)


def _stays(moment: str) -> tuple[str, str, str]:
    """Q of a moment, and in the data its pull and K(Q)."""
    pull, kick = pull_and_kick()
    chosen = {"P": letters(moment, (moment,))[0]}
    return in_data(H * chosen["P"] * H), in_data(pull.substitute(chosen)), in_data(kick)


def _decaying(step: str, wrap: str) -> str:
    """Z exists that shows decay at the step; `wrap` puts the step's range around a predicate."""
    pull, kick = (in_data(form) for form in adjoint_pull_and_kick())
    bracket = wrap.format(f"pd({pull} - {step}*({kick}))")
    return f"exists(Z, pd(Z), exists(Y, Y == {in_data(H * Z * H)}, {bracket}))"


def _growing(step: str, wrap: str) -> str:
    """P > 0 exists with L(P) > P."""
    q, pull, kick = _stays("P")
    bracket = wrap.format(f"pd({step}*({kick}) - ({pull}))")
    return f"exists(P, pd(P), exists(Q, Q == {q}, {bracket}))"


def _kept(limit: str) -> str:
    """P > 0 exists with L(P) = P at the step `limit`."""
    q, pull, kick = _stays("P")
    return f"exists(P, pd(P), exists(Q, Q == {q}, {limit}*({kick}) == {pull}))"


def _kept_line(limit: str) -> str:
    """x exists, not 0, with L(xx') = xx' at the step `limit`."""
    q, pull, kick = _stays("(x*T(x))")
    kept = f"exists(Q, Q == {q}, {limit}*({kick}) == {pull})"
    return f"exists(x, T(x)*x > 0, 0*(x*T(x)) == 0*{HESSIAN}, {kept})"


NOT_DECAYING = f"exists(c, alpha >= c, c > 0, {_kept('c')})"
"""The second moments do not all tend to zero at alpha: at a step c <= alpha some are kept."""

BELOW = _decaying("a", "forall(a, 0, lower, {})")
STABLE = "the second moments of the homogeneous error tend to 0 for every step 0 < alpha <= lower"
LIMIT_WORDS = FOR_DATA + STABLE + ", and for no step alpha >= upper"


def _step_limit() -> Statement:
    above = {
        "PROVED": _growing("a", "forall(a, upper, inf, {})"),
        "PROVED exact": _kept("upper"),
        "PROVED line": _kept_line("upper"),
    }
    how = {
        "PROVED": ": some grow",
        "PROVED exact": ": at upper, some definite one is kept",
        "PROVED line": ": at upper, that of an error on some line is kept",
    }
    cases = {
        name: Case(
            "PROVED",
            LIMIT_WORDS + how[name],
            (*WELL_POSED, "lower < upper", IDENTITY, BELOW, show, COVARIANCE),
            BRACKET,
        )
        for name, show in above.items()
    }
    return Statement("cyclic_spsa", "step_limit", cases, inputs=BLOCK)


def _step() -> Statement:
    grow = FOR_DATA + "the second moments of the homogeneous error do not all tend to 0 at alpha: "
    cases = {
        "PROVED": (
            "PROVED",
            FOR_DATA + "the second moments of the homogeneous error tend to 0 at the step alpha",
            _decaying("alpha", "{}"),
        ),
        "REFUTED": ("REFUTED", grow + "some grow", _growing("alpha", "{}")),
        "REFUTED exact": (
            "REFUTED",
            grow + "at some step c <= alpha, a definite one is kept",
            NOT_DECAYING,
        ),
        "REFUTED line": (
            "REFUTED",
            grow + "at some step c <= alpha, that of an error on some line is kept",
            f"exists(c, alpha >= c, c > 0, {_kept_line('c')})",
        ),
    }
    found = {
        name: Case(verdict, words, (*WELL_POSED, "alpha > 0", IDENTITY, show, COVARIANCE))
        for name, (verdict, words, show) in cases.items()
    }
    return Statement("cyclic_spsa", "step", found, inputs=BLOCK | {"alpha": "number"})


STATEMENTS: tuple[Statement, ...] = (_step_limit(), _step())
