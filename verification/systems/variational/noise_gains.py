"""What (20) makes of measurement noise: stationary traces and peak gains.

With position noise chi and velocity noise nu, averaged over the sensors, the position error e and
the internal state w obey

    e+ = e + h(w - nu),    (M + hC) w+ = M w - hK(e+ + chi+),

and the velocity error is w - nu: its newest noise enters undamped. The coefficients are those of
the recursion that `theory` derives from the action.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from theory.systems.variational.statements.common import EQUATION, SCHEME
from verification.answers import Answer
from verification.exact.definite import negative_vector
from verification.exact.evaluate import Rows, at
from verification.exact.peaks import Channel, peak
from verification.exact.rationals import nearest
from verification.exact.stationary import covariance, float_covariance, trace_of

from .gains import definite_gains, positive_step
from .steps import at_minus_one

Floats = NDArray[np.float64]
EXACT_UP_TO = 4
"""Coordinates up to which the stationary covariance is solved in rationals."""
UNSTABLE = "(20) is not stable at this step: errors grow without any noise"
SOLVED = "solved in rationals and rounded to the nearest double"
FLOATING = "computed in floating point, with a residual below 1e-9 of the trace"


@dataclass(frozen=True)
class ErrorSystem:
    """z+ = A z + B_chi chi+ + B_nu nu for z = (e, w), n coordinates each; exact flint matrices."""

    n: int
    a: Any
    b_chi: Any
    b_nu: Any


def error_system(gains: Mapping[str, Rows], h: Fraction) -> ErrorSystem:
    """The recursion of the errors under noise.

    Parameters
    ----------
    gains : mapping of str to Rows
        ``M``, ``K``, ``C``, n by n.
    h : Fraction
        Step, in the time unit of the gains.
    """
    import flint

    n = len(gains["M"])
    newer, position, older = (_matrix(at(EQUATION.before(letter), gains, h)) for letter in "uxv")
    pull, keep = -newer.solve(position), -newer.solve(older)
    one = flint.fmpq_mat(flint.fmpz_mat([[int(i == j) for j in range(n)] for i in range(n)]))
    step = flint.fmpq(h.numerator, h.denominator)
    zero = 0 * one
    return ErrorSystem(
        n,
        _stacked([[one, step * one], [pull, step * pull + keep]]),
        _stacked([[zero], [pull]]),
        _stacked([[-step * one], [-step * pull]]),
    )


def noise_gain(values: Mapping[str, Any]) -> Answer:
    """Stationary traces for white noise of unit covariance.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size; ``h``: a
        positive rational in the time unit of the gains.

    Returns
    -------
    Answer
        Trace of cov(e) from chi, of cov(e) from nu, of the velocity error's covariance from nu.
        ``"inf"`` thrice where (20) is unstable. Solved in rationals up to four coordinates.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, or h <= 0.
    """
    h, gains = positive_step(values), definite_gains(values)
    if negative_vector(at(at_minus_one(SCHEME), gains, h)):
        return _unbounded()
    system = error_system(gains, h)
    if system.n > EXACT_UP_TO:
        return _float_traces(system)
    exact = _traces(system)
    shown = (f"exactly {', '.join(map(str, exact))}",) if system.n == 1 else ()
    return Answer(value=[nearest(x) for x in exact], notes=(SOLVED, *shown))


def peak_gain(values: Mapping[str, Any]) -> Answer:
    """H-infinity norms of the three maps of `noise_gain`.

    Parameters, errors and the unstable case are those of `noise_gain`.

    Returns
    -------
    Answer
        Largest singular values over all frequencies: chi to e, nu to e, nu to the velocity error.
        SUPPORTED: computed in floating point, each attained at a frequency and crossed at none.
    """
    h, gains = positive_step(values), definite_gains(values)
    if negative_vector(at(at_minus_one(SCHEME), gains, h)):
        return _unbounded()
    system = error_system(gains, h)
    n, one, zero = system.n, np.eye(system.n), np.zeros((system.n, system.n))
    a, b_chi, b_nu = (_floats(m) for m in (system.a, system.b_chi, system.b_nu))
    error, speed = np.hstack([one, zero]), np.hstack([zero, one])
    # e_k sees chi_k through e_{k-1} and w_{k-1}: a delay that changes no norm
    channels = (
        Channel(a, b_chi, error, np.zeros((n, n))),
        Channel(a, b_nu, error, np.zeros((n, n))),
        Channel(a, b_nu, speed, -one),
    )
    return Answer(value=[peak(channel) for channel in channels])


def _unbounded() -> Answer:
    return Answer(value=["inf"] * 3, notes=(UNSTABLE,))


def _traces(system: ErrorSystem) -> tuple[Fraction, Fraction, Fraction]:
    """Position error from both noises; velocity error, whose newest noise is independent of w."""
    n = system.n
    from_chi, from_nu = (covariance(system.a, b) for b in (system.b_chi, system.b_nu))
    return (
        trace_of(from_chi, range(n)),
        trace_of(from_nu, range(n)),
        trace_of(from_nu, range(n, 2 * n)) + n,
    )


def _float_traces(system: ErrorSystem) -> Answer:
    n, a = system.n, _floats(system.a)
    found = [float_covariance(a, _floats(b)) for b in (system.b_chi, system.b_nu)]
    if any(solution is None for solution in found):
        return Answer(verdict="UNDECIDED", notes=("the covariance could not be solved",))
    from_chi, from_nu = (np.diag(solution) for solution in found if solution is not None)
    traces = [from_chi[:n].sum(), from_nu[:n].sum(), from_nu[n:].sum() + n]
    return Answer(value=[float(x) for x in traces], notes=(FLOATING,))


def _matrix(rows: Rows) -> Any:
    import flint

    return flint.fmpq_mat([[flint.fmpq(x.numerator, x.denominator) for x in row] for row in rows])


def _stacked(blocks: list[list[Any]]) -> Any:
    """One matrix of blocks."""
    import flint

    rows = [
        [x for block in row for x in block.tolist()[i]]
        for row in blocks
        for i in range(row[0].nrows())
    ]
    return flint.fmpq_mat(rows)


def _floats(matrix: Any) -> Floats:
    return np.array([[int(x.p) / int(x.q) for x in row] for row in matrix.tolist()])
