"""The error of one update, derived from the laws of Algorithm 1, and its second moments.

The measured positions of the two points are theta + xi at the later and theta - eta + xi_before at
the earlier instant, eta being the drift between them. With

    a   = theta_hat - theta + eta/2,          the error from the middle of the two positions,
    chi = (xi + xi_before)/2,                 the mean of the two noises,
    nu  = (xi - xi_before + eta)/(2 beta),    their difference, in units of the perturbation,

the laws make y_plus - y_minus linear in a. With one instant, q_plus = q_minus = theta + chi, and nu
is absent. What is drawn anew for each update, Delta, nu and chi, is independent of the error
before it, because each update uses measurements of its own.
"""

from __future__ import annotations

from dataclasses import dataclass

from ...algebra.formulas import expanded, form_of
from ...algebra.moments.laws import RADEMACHER
from ...algebra.moments.recursions import Randomness
from ...algebra.noncommuting import Form, letters, scalars
from ...algebra.quadratic_forms import gradient
from .model import LAWS

NUMBERS = ("alpha", "beta", "y_plus", "y_minus")
SYMMETRIC = ("H", "P", "Q", "Y", "Z", "N")

SETTINGS = {
    2: {
        "q_plus": "theta - eta/2 + chi + beta*nu",
        "q_minus": "theta - eta/2 + chi - beta*nu",
        "theta_hat": "theta - eta/2 + a",
    },
    1: {"q_plus": "theta + chi", "q_minus": "theta + chi", "theta_hat": "theta + a"},
}
"""Measurement instants of a step to what the measured positions and the estimate are then."""

USED = ("x_plus", "x_minus", "y_plus", "y_minus", "g", "next(theta_hat)")

RANDOM = Randomness(
    {"Delta": RADEMACHER},
    {"nu": "N"},
    frozenset(SYMMETRIC),
    {("H", "P", "H"): "Q"},
)
"""Delta has independent entries, +1 or -1; E nu nu' is N; HPH is called Q."""


def read(text: str) -> Form:
    """A formula in the names of the laws."""
    return form_of(text, NUMBERS, SYMMETRIC)


@dataclass(frozen=True)
class ErrorStep:
    """a+ = step a + offset, before the target's next move is taken off.

    Parameters
    ----------
    step, offset : Form
        In ``Delta nu chi H``, the scalar ``alpha``, and the empty word for the identity.
    """

    step: Form
    offset: Form


def error_step(instants: int) -> ErrorStep:
    """One update of the error for one or two measurement instants a step.

    Parameters
    ----------
    instants : int
        1 or 2.

    Raises
    ------
    ValueError
        The costs' difference is not linear in the error, or the laws are not as expected.
    """
    laws = {law.left: read(law.right) for law in LAWS if law.left in USED}
    setting = {name: read(text) for name, text in SETTINGS[instants].items()}
    points = {name: laws[name] for name in ("x_plus", "x_minus")} | setting
    difference = expanded(laws["y_plus"] - laws["y_minus"], points)
    per_cost = laws["g"].coefficient("y_plus", 1)
    if laws["g"] != per_cost * read("y_plus - y_minus"):
        raise ValueError("laws: the pseudogradient is not a multiple of the costs' difference")
    if laws["next(theta_hat)"] != read("theta_hat - alpha*g"):
        raise ValueError("laws: the estimate does not move against the pseudogradient")
    row = gradient(difference, "a").T
    if any(word.count("a") + word.count("a'") for _, word in row.terms):
        raise ValueError("laws: the difference of the costs is not linear in the error")
    (alpha,) = scalars("alpha")
    one = read("1")
    rest = difference.substitute({"a": Form({})})
    return ErrorStep(one - alpha * per_cost * row, -(alpha * per_cost * rest))


def second_moment() -> Form:
    """L(P) = E (step P step'), what one update makes of the second moment P."""
    return RANDOM.second_moment(error_step(2).step, letters("P", SYMMETRIC)[0])


def adjoint() -> Form:
    """L*(Y) = E (step' Y step): tr(Y L(P)) = tr(P L*(Y))."""
    return RANDOM.adjoint(error_step(2).step, letters("Y", SYMMETRIC)[0])
