"""The errors of (20) under measurement noise, as a recursion and as a state space.

With position noise chi and velocity noise nu, averaged over the sensors, the position error e and
the internal state w obey

    e+ = e + h(w - nu),    (M + hC) w+ = M w - hK(e+ + chi+),

and the velocity error is w - nu: its newest noise enters undamped. The last line is the equation
that `theory` derives from the action, with the measured error x = e + chi put in.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from theory.algebra.noncommuting import Form, inverse, letters, scalars
from theory.systems.variational.statements.common import EQUATION, SCHEME
from verification.answers import Answer
from verification.exact.definite import negative_vector
from verification.exact.evaluate import Rows, at

from .gains import definite_gains, positive_step
from .steps import at_minus_one

(STEP,) = scalars("h")
OLD, NOW, NEW, CHI, NU_OLD, NU = letters("e0 e1 e2 chi nu0 nu1")
NOISY: Form = -(
    STEP
    * EQUATION.substitute(
        {
            "x": NOW + CHI,
            "v": inverse(STEP) * (NOW - OLD) + NU_OLD,
            "u": inverse(STEP) * (NEW - NOW) + NU,
        }
    )
)
"""Zero along every solution, in e_{k-1}, e_k, e_{k+1}, chi_k, nu_{k-1} and nu_k."""

UNSTABLE = "(20) is not stable at this step: errors grow without any noise"


@dataclass(frozen=True)
class ErrorSystem:
    """z+ = A z + B_chi chi+ + B_nu nu for z = (e, hw), n coordinates each, and w - nu.

    The matrices are exact, `flint.fmpq_mat`, or enclosures, `flint.arb_mat`.
    """

    n: int
    a: Any
    b_chi: Any
    b_nu: Any


def stable_question(values: Mapping[str, Any]) -> tuple[dict[str, Rows], Fraction, bool]:
    """Gains and step of a question, checked, and whether (20) is stable there.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, or h <= 0.
    """
    h, gains = positive_step(values), definite_gains(values)
    return gains, h, negative_vector(at(at_minus_one(SCHEME), gains, h)) is None


def unbounded(count: int) -> Answer:
    """The answer where (20) is not stable: every noise reaches every error without bound."""
    return Answer(value=["inf"] * count, verdict="PROVED", notes=(UNSTABLE,))


def error_system(gains: Mapping[str, Rows], h: Fraction, exact: bool = True) -> ErrorSystem:
    """The recursion of the errors under noise.

    Parameters
    ----------
    gains : mapping of str to Rows
        ``M``, ``K``, ``C``, n by n.
    h : Fraction
        Step, in the time unit of the gains.
    exact : bool, optional
        Rationals, else balls of the precision that is set.
    """
    import flint

    kind = flint.fmpq_mat if exact else flint.arb_mat
    n = len(gains["M"])
    newer, position, older = (_matrix(at(EQUATION.before(x), gains, h), kind) for x in "uxv")
    step = flint.fmpq(h.numerator, h.denominator)
    pull, keep = -newer.solve(position * step), -newer.solve(older)
    one = kind([[int(i == j) for j in range(n)] for i in range(n)])
    zero = one - one
    return ErrorSystem(
        n,
        _stacked([[one, one], [pull, pull + keep]], kind),
        _stacked([[zero], [pull]], kind),
        _stacked([[one * -step], [pull * -step]], kind),
    )


def _matrix(rows: Rows, kind: Any) -> Any:
    import flint

    return kind([[flint.fmpq(x.numerator, x.denominator) for x in row] for row in rows])


def _stacked(blocks: list[list[Any]], kind: Any) -> Any:
    """One matrix of blocks."""
    lists = [[block.tolist() for block in row] for row in blocks]
    return kind(
        [[x for block in row for x in block[i]] for row in lists for i in range(len(row[0]))]
    )
