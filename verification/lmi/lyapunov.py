"""Quadratic Lyapunov functions from Lyapunov's and Stein's equations, proved like any LMI.

Solving the equation takes milliseconds where the LMI takes seconds (n = 30) or hours (n = 60).

References
----------
A. M. Lyapunov, *The general problem of the stability of motion* (1892); P. Stein, "Some general
theorems on iterants", J. Res. Nat. Bur. Standards 48 (1952) 82-83.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

from verification.exact.evaluate import Rows

from .affine import known, symmetric
from .margin import Lmi, Solution, Stage

LARGEST_LMI = 30
"""Above this size a solver of semidefinite programs takes too long."""


def contraction_lmi(a: Rows, r: Fraction) -> Lmi:
    """P > 0 and r^2 P - A'PA > 0: every solution of z+ = A z shrinks faster than r^k.

    Parameters
    ----------
    a : Rows
        Square, exact.
    r : Fraction
        Positive.
    """
    p, matrix = symmetric("P", len(a)), known(a)
    return Lmi({"P": p, "r^2 P - A'PA": r**2 * p - matrix.T @ p @ matrix})


def decay_lmi(a: Rows, rate: Fraction = Fraction(0)) -> Lmi:
    """P > 0 and -(PA + A'P) - 2 rate P > 0: solutions of z' = A z decay faster than e^(-rate t).

    Parameters
    ----------
    a : Rows
        Square, exact.
    rate : Fraction, optional
        In the inverse of the time unit of `a`.
    """
    p, matrix = symmetric("P", len(a)), known(a)
    fall = -(p @ matrix) - matrix.T @ p - 2 * rate * p
    return Lmi({"P": p, "-(PA + A'P) - 2 rate P": fall})


def contraction(a: Rows, r: Fraction) -> Solution | Stage:
    """Prove that the spectral radius of A is less than r.

    Stein's equation comes first; where its solution cannot be proved and n is at most 30, the
    LMI in margin form.

    Parameters
    ----------
    a : Rows
        Square, exact.
    r : Fraction
        Positive.

    Returns
    -------
    Solution or Stage
        P, with values for the unknown ``P``.
    """
    from scipy.linalg import solve_discrete_lyapunov

    step = _doubles(a) / float(r)
    return _either(contraction_lmi(a, r), lambda: solve_discrete_lyapunov(step.T, np.eye(len(a))))


def decay(a: Rows, rate: Fraction = Fraction(0)) -> Solution | Stage:
    """Prove that every eigenvalue of A has a real part less than -rate.

    Parameters and returns are those of `contraction`, with Lyapunov's equation.
    """
    from scipy.linalg import solve_continuous_lyapunov

    flow = _doubles(a) + float(rate) * np.eye(len(a))
    return _either(decay_lmi(a, rate), lambda: solve_continuous_lyapunov(flow.T, -np.eye(len(a))))


def _either(lmi: Lmi, equation: Callable[[], Any]) -> Solution | Stage:
    """Prove the LMI by the solution of the equation, or else by the solver."""
    found = _by_equation(lmi, equation)
    (size,) = (u.rows for u in lmi.unknowns.values())
    if isinstance(found, Solution) or size > LARGEST_LMI:
        return found
    return lmi.solve()


def _by_equation(lmi: Lmi, equation: Callable[[], Any]) -> Solution | Stage:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            p = equation()
        except (np.linalg.LinAlgError, RuntimeWarning, ValueError) as error:
            return Stage(
                "solver",
                f"the equation has no solution in doubles ({error})",
                None,
                "weaken the inequality a little, or rescale the data",
            )
    p = p / np.abs(p).max()
    least = min(
        float(np.linalg.eigvalsh((value + value.T) / 2)[0])
        for value in (affine.expression({"P": p}) for affine in lmi.positive.values())
    )
    return lmi.prove({"P": p}, least, "the equation in doubles")


def _doubles(a: Rows) -> Any:
    return np.array([[float(x) for x in row] for row in a])
