"""What certificates about the stationary mean-square error prove, for Gaussian noise.

The covariance of the error solves HC + CH - alpha K(HCH) = R, R = R0/alpha + alpha R2, see
`theory.systems.cyclic_spsa.stationary`. For a stable step the solution grows with the right side,
so that a matrix which gives more than R is at least the covariance, and one that gives less is at
most that.
"""

from __future__ import annotations

import re

from ....algebra.noncommuting import Form, letters
from ....statements import BRACKET, Case, Statement
from ..error import SYMMETRIC
from ..stationary import kick_of_mean, kick_of_noise
from . import stability
from .common import BLOCK, COVARIANCE, FOR_DATA, HESSIAN, WELL_POSED, in_data
from .stability import IDENTITY, pull_and_kick

H, P = letters("H P", SYMMETRIC)

MEAN = f"exists(m, alpha*{HESSIAN}*((2*k - (reading - 1)/2)*eta - m) == 2*k*eta)"
"""m is where the mean of theta_hat - theta right after an update settles."""

LIMITS = (
    "where theta_hat - theta right after an update, one every 2k samples, settles, for Gaussian "
    "noise: "
)


def _of(form: Form, inner: str) -> str:
    """A form in Q as an expression in the data and another letter for Q."""
    return re.sub(r"\bQ\b", inner, in_data(form))


def _sources() -> tuple[str, ...]:
    """R, from the move c = 2k eta and the noise, named by its letters."""
    chi = f"{HESSIAN}*Xi*{HESSIAN}/reading"
    right = f"({_of(kick_of_mean(), 'J')})/alpha + alpha*({_of(kick_of_noise(), 'S')})"
    moved = "exists(J, J == 4*k**2*eta*T(eta))"
    return moved, f"exists(S, S == {chi})", f"exists(R, R == {right})"


def _side(matrix: str, inner: str, sign: str, end: str) -> str:
    """A matrix that gives more than R, or less, and what its trace then bounds."""
    pull, kick = pull_and_kick()
    chosen = {"P": letters(matrix, (matrix,))[0]}
    image = f"{in_data(pull.substitute(chosen))} - alpha*({_of(kick, inner)})"
    more = f"{image} - R" if sign == "<=" else f"R - ({image})"
    whole = f"exists({inner}, {inner} == {HESSIAN}*{matrix}*{HESSIAN}, pd({more}))"
    bound = f"trace({matrix}) + T(m)*m {sign} {end}"
    # a matrix of one entry would stand for a multiple of the identity, with another trace
    square = f"{matrix} - T({matrix}) == 0*{HESSIAN}"
    return f"exists({matrix}, {square}, {whole}, {bound})"


def _mean_square() -> Statement:
    step = next(entry for entry in stability.STATEMENTS if entry.name == "step").cases
    head = (*WELL_POSED, "alpha > 0", IDENTITY)
    settles = "its mean square tends to a number from lower to upper"
    shown = (*_sources(), _side("P", "Q", "<=", "upper"), _side("U", "V", ">=", "lower"))
    decays = step["PROVED"].show[len(head)]
    show = (*head, decays, MEAN, *shown, COVARIANCE)
    found = {"PROVED": Case("PROVED", FOR_DATA + LIMITS + settles, show, BRACKET)}
    for key, case in step.items():
        if case.verdict == "REFUTED":
            words = f"{case.words}, and the mean square has no limit that holds for every start"
            ends = {"lower": "inf", "upper": "inf"}
            found[key.replace("REFUTED", "INFINITE")] = Case("PROVED", words, case.show, ends)
    return Statement("cyclic_spsa", "stationary_mse", found, inputs=BLOCK | {"alpha": "number"})


STATEMENTS: tuple[Statement, ...] = (_mean_square(),)
