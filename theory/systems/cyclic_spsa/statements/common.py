"""Data and formulas that statements about one block of coordinates share.

The Hessian is diag(h) + H: the one of the two that is not given is zero. The second moments N of
nu follow from its definition, `theory.systems.cyclic_spsa.error`: the two noises are independent
with covariance Xi each, so that E nu nu' = (2 Xi + eta eta')/(4 beta^2), and with one instant nu is
absent.
"""

from __future__ import annotations

import re

from ....algebra.noncommuting import Form

BLOCK = {
    "h": "matrix",
    "H": "matrix",
    "Xi": "matrix",
    "eta": "matrix",
    "beta": "number",
    "reading": "number",
    "k": "number",
}
"""Inputs of the statements: h and eta are columns, the other matrices D by D."""

HESSIAN = "(diag(h) + H)"
NU = "((reading - 1)*(Xi/(2*beta**2) + eta*T(eta)/(4*beta**2)))"

WELL_POSED = (
    "beta > 0",
    "k >= 1",
    "(reading - 1)*(reading - 2) == 0",
    f"pd{HESSIAN}",
    "T(h)*h >= 0",
    "T(eta)*eta >= 0",
    f"Xi - T(Xi) == 0*{HESSIAN}",
)
"""Predicates that the data are those of a block; what is missing is `COVARIANCE`.

A matrix of one entry multiplies any other as a number does, so that sizes are asked for: h and eta
are columns, and Xi is as large as the Hessian. The sum Xi + eta eta' in `NU` fits eta to both.
"""

COVARIANCE = "exists(F, exists(G, pd(G), exists(f, f > 0, f*Xi == F*G*T(F))))"
"""Xi is positive semidefinite."""

FOR_DATA = (
    "for the Hessian diag(h) + H, symmetric positive definite, noise of covariance Xi at each "
    "instant, the drift eta a sample and the perturbation beta, with the measurements of one or "
    "two instants as reading says: "
)

MEANING = {"H": HESSIAN, "N": NU}


def in_data(form: Form) -> str:
    """A form in H and N as an expression in the data of a block."""
    return re.sub(r"\b[HN]\b", lambda found: MEANING[found.group()], str(form))
