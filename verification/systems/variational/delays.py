"""The largest step of (20) when the position error is used some samples late."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from theory.systems.variational.statements.late import (
    MOST_DELAY,
    PRESENT,
    PULL,
    blocks_of,
)
from verification.answers import Answer
from verification.certificates.make import certificate
from verification.exact.evaluate import Rows, add, at, identity, scaled
from verification.exact.rationals import above, below
from verification.exact.spectra.modes import candidates, integer_matrices
from verification.exact.spectra.stein import decaying_form, staying_form

from .gains import definite_gains
from .steps import step_limit

Floats = NDArray[np.float64]
LONGEST_DELAY = 100
MOST_STATES = 72
"""Size of the stacked state up to which a certificate is sought."""
GRID, DECADES, HALVINGS = 400, 4, 60
WIDTHS = tuple(Fraction(1, 10**k) for k in (11, 10, 9, 8))
FIRST = "the first step at which stability ends, on a grid; certified at the two ends"
FLOATING = "computed in floating point: the stacked state is too large for a certificate"


def delay_step_limit(values: Mapping[str, Any]) -> Answer:
    """Smallest step at which (20) stops being stable when the position error is d samples late.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``, ``C``: exact symmetric positive definite matrices of one size; ``d``: a whole
        number of samples, 0 or more.

    Returns
    -------
    Answer
        A bracket whose lower end is certified stable and whose upper end is certified not to be.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite; d is negative, not whole or above 100.
    """
    delay, gains = _whole_delay(values), definite_gains(values)
    present = step_limit(values)
    if delay == 0 and present.value is not None:
        middle, notes = float(present.value), tuple[str, ...]()
    else:
        middle, notes = _crossing(gains, delay, _scale(present, gains)), (FIRST,)
    if delay > MOST_DELAY or len(gains["M"]) * blocks_of(delay) > MOST_STATES:
        return Answer(value=middle, notes=(FLOATING,))
    for width in WIDTHS:
        answer = _bracketed(gains, delay, Fraction(middle), width)
        if answer:
            exact = present.exact if delay == 0 else None
            return replace(answer, value=middle, exact=exact, notes=notes)
    return Answer(value=middle, notes=("no certificate was found beside the limit",))


def _whole_delay(values: Mapping[str, Any]) -> int:
    delay: Fraction = values["d"]
    if delay.denominator != 1 or not 0 <= delay <= LONGEST_DELAY:
        needed = f"a whole number of samples from 0 to {LONGEST_DELAY} is needed"
        raise InputError("d", str(delay), needed)
    return int(delay)


def _scale(present: Answer, gains: Mapping[str, Rows]) -> float:
    """A step above every limit: without delay, or the natural time of the stiffest direction."""
    if present.value is not None:
        return float(present.value) * 1.01
    return 4 * math.sqrt(float(_largest(gains["M"]) / _largest(gains["K"])))


def _largest(rows: Rows) -> Fraction:
    return max(abs(x) for row in rows for x in row)


def late_pencil(gains: Mapping[str, Rows], delay: int, h: Fraction) -> tuple[Rows, Rows]:
    """E and F of E X+ = F X for the stacked positions, newest first.

    Parameters
    ----------
    gains : mapping of str to Rows
        ``M``, ``K``, ``C``, n by n.
    delay : int
        Samples.
    h : Fraction
        Step.

    Returns
    -------
    E, F : Rows
        n times `blocks_of` (delay) square.
    """
    n, blocks = len(gains["M"]), blocks_of(delay)
    newest, last, first = (at(PRESENT[power], gains, h) for power in (2, 1, 0))
    row = {0: scaled(-1, last), 1: scaled(-1, first)}
    pull, zero = at(PULL, gains, h), scaled(0, identity(n))
    row[delay] = add(row.get(delay, zero), pull, -1)
    left = {(j, j): identity(n) for j in range(1, blocks)} | {(0, 0): newest}
    right = {(j, j - 1): identity(n) for j in range(1, blocks)} | {
        (0, j): m for j, m in row.items()
    }
    return _assembled(left, blocks, zero), _assembled(right, blocks, zero)


def _assembled(parts: Mapping[tuple[int, int], Rows], blocks: int, zero: Rows) -> Rows:
    return tuple(
        tuple(x for j in range(blocks) for x in parts.get((i, j), zero)[k])
        for i in range(blocks)
        for k in range(len(zero))
    )


def _crossing(gains: Mapping[str, Rows], delay: int, most: float) -> float:
    """The first step, on a fine grid, at which the spectral radius passes one, then by halving."""
    grid = most * np.logspace(-DECADES, 0, GRID)
    low = 0.0
    for h in grid:
        if late_radius(gains, delay, float(h)) >= 1:
            break
        low = float(h)
    high = float(h)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if not low < middle < high:
            break
        low, high = (middle, high) if late_radius(gains, delay, middle) < 1 else (low, middle)
    return (low + high) / 2


def late_radius(gains: Mapping[str, Rows], delay: int, h: float) -> float:
    """Spectral radius of one step of the stacked positions, in floating point."""
    left, right = late_pencil(gains, delay, Fraction(h))
    step = np.linalg.solve(np.array(left, dtype=float), np.array(right, dtype=float))
    return float(np.abs(np.linalg.eigvals(step)).max())


def _bracketed(
    gains: Mapping[str, Rows], delay: int, middle: Fraction, width: Fraction
) -> Answer | None:
    """Certificate of a bracket of this relative half-width, or None."""
    lower = Fraction(below(middle * (1 - width)))
    upper = Fraction(above(middle * (1 + width)))
    stable, unstable = _stable(gains, delay, lower), _unstable(gains, delay, upper)
    if stable is None or unstable is None:
        return None
    form, x = unstable
    n, blocks = len(gains["M"]), blocks_of(delay)
    bases = [identity(n), *(block(n, blocks, j) for j in range(blocks))]
    witness: list[dict[str, Any]] = [
        *({"kind": "matrix", "rows": rows} for rows in (*bases, stable, form)),
        {"kind": "vector", "x": list(x)},
    ]
    document = certificate(
        "variational",
        "delay_step_limit",
        {**gains, "d": Fraction(delay)},
        witness,
        case=f"PROVED {delay}",
        lower=lower,
        upper=upper,
    )
    return Answer(lower=float(lower), upper=float(upper), verdict="PROVED", certificate=document)


def block(n: int, blocks: int, j: int) -> Rows:
    """Column block j of the identity."""
    return tuple(tuple(row[j * n : (j + 1) * n]) for row in identity(n * blocks))


def _stable(gains: Mapping[str, Rows], delay: int, h: Fraction) -> Rows | None:
    left, right = integer_matrices(*late_pencil(gains, delay, h))
    found = (decaying_form(left, right, modes) for modes in candidates(left, right))
    return next((form for form in found if form), None)


def _unstable(
    gains: Mapping[str, Rows], delay: int, h: Fraction
) -> tuple[Rows, Sequence[int]] | None:
    left, right = integer_matrices(*late_pencil(gains, delay, h))
    found = (staying_form(left, right, modes) for modes in candidates(left, right))
    return next((form for form in found if form), None)
