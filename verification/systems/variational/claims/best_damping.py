"""The largest decay rate that C alone can give the continuous estimator, certified."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from theory.systems.variational.statements.best_damping import PLANAR
from verification.certificates.make import certificate
from verification.exact.evaluate import Rows, identity, scaled

from .witnesses import derivation

Witness = dict[str, Any]
Certificate = dict[str, Any]

DETERMINANT = "(6*p**2*q**2 - p**4 - q**4)*(r*(p**2 + q**2) + 1)"
"""What (p^2 + q^2)^2 det C = 6p^2q^2 - p^4 - q^4 leaves before r(p^2 + q^2) - 1."""


def ceiling() -> Certificate:
    """No C makes all real parts smaller than -(det K/det M)^(1/2n)."""
    more = "B*(a*r + b) + c*(r**2 + a*r + b)"
    witness = derivation(((more, "1", "1"),), ("r**2 + a*r + b", "0", "1"))
    return certificate("variational", "theorem_3_2_stability_ceiling", {}, [witness])


def planar() -> Certificate:
    """In two dimensions with M = I and K = diag(p^4, q^4), one C reaches that bound."""
    equal = f"4*p*q*s**3 + 4*p**3*q**3*s + {DETERMINANT}*s**2"
    witness = [
        derivation((), (equal, "0", "1")),
        derivation(((PLANAR["c11"], "1", "1"),)),
        derivation((), (DETERMINANT, "0", "1")),
    ]
    return certificate("variational", "theorem_3_2_stability_planar", {}, witness)


def planar_gains(p: Fraction, q: Fraction) -> dict[str, Rows]:
    """M, K and the best C for K = diag(p^4, q^4).

    Parameters
    ----------
    p, q : Fraction
        Square roots of the two undamped frequencies, positive.

    Returns
    -------
    dict
        ``M``, ``K``, ``C``, 2 by 2.
    """
    r, zero = 1 / (p**2 + q**2), Fraction(0)
    c12 = (p**2 - q**2) ** 2 * r
    return {
        "M": identity(2),
        "K": ((p**4, zero), (zero, q**4)),
        "C": ((4 * p**3 * q * r, c12), (c12, 4 * p * q**3 * r)),
    }


def planar_instance(p: Fraction, q: Fraction) -> Certificate:
    """All four eigenvalues of exact gains are -pq.

    Parameters
    ----------
    p, q : Fraction
        As in `planar_gains`; C is positive definite while 6p^2q^2 > p^4 + q^4.

    Returns
    -------
    dict
        The document.

    Raises
    ------
    CertificateError
        C is not positive definite.
    """
    gains = planar_gains(p, q)
    one, none = identity(2), scaled(0, identity(2))
    pull = [
        (*(-k for k in row_k), *(-c for c in row_c))
        for row_k, row_c in zip(gains["K"], gains["C"], strict=True)
    ]
    drift = [(*left, *right) for left, right in zip(none, one, strict=True)]
    witness = [{"kind": "matrix", "rows": rows} for rows in _blocks(one, none, [*drift, *pull])]
    inputs = {**gains, "s": p * q}
    return certificate("variational", "theorem_3_2_stability_attained", inputs, witness)


def _blocks(one: Rows, none: Rows, matrix: list[tuple[Fraction, ...]]) -> list[Any]:
    """I, E0, E1 and A as the statement asks for them."""
    return [one, (*one, *none), (*none, *one), matrix]
