"""What the constants of Assumptions 1 to 5 of quadratic and other costs share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer
from verification.certificates.make import Item
from verification.exact.evaluate import Rows, dot
from verification.exact.rationals import above, below, nearest
from verification.exact.semidefinite import Split
from verification.exact.spectra.rayleigh import generalized_ratio
from verification.exact.square_roots import square_root_beside

from ..block_inputs import Block, block_of
from ..errors.settling import LAWS
from ..errors.stationary import law_of

NAMES = ("mu", "M", "c2", "c3", "c4", "delta")
MOVED = "delta = |eta|, the drift of one sample"
ONE_INSTANT = "with one measurement instant a step, c3 = c4 = 0 do: no two costs are compared"


def cost_of(values: Mapping[str, Any]) -> tuple[Block, Fraction]:
    """The cost of a block, and the kurtosis of its noise.

    Raises
    ------
    InputError
        As `block_of`; the law is not known or does not fit Xi.
    """
    kurtosis = LAWS[law_of(values)].excess
    # beta, reading and k do not enter these constants
    block = block_of({**values, "beta": Fraction(1), "reading": "two", "k": Fraction(1)})
    noise, size = block.noise, range(block.size)
    if kurtosis and any(noise[i][j] for i in size for j in size if i != j):
        needed = "a diagonal one: the coordinates of two-point noise are taken as independent"
        raise InputError("Xi", "a covariance that is not diagonal", needed)
    return block, kurtosis


def constant_data(
    block: Block, kurtosis: Fraction, constants: Sequence[Fraction]
) -> dict[str, Any]:
    """Inputs of a certificate about the constants, in the order of `NAMES`."""
    column = [[x] for x in block.drift]
    data = {"H": block.hessian, "Xi": block.noise, "eta": column, "kappa": kurtosis}
    return data | dict(zip(NAMES, constants, strict=True))


def matrix_item(rows: Sequence[Sequence[Fraction]]) -> Item:
    """A matrix as an item of a witness."""
    return {"kind": "matrix", "rows": rows}


def semidefinite_items(parts: Split) -> list[Item]:
    """The factor and the pivots that show a matrix to be positive semidefinite.

    Raises
    ------
    InputError
        It is not.
    """
    if parts.factor is None:
        raise InputError("H", "a form that is negative somewhere", "a bound on it is needed")
    return [matrix_item(parts.factor), matrix_item([[x] for x in parts.pivots])]


def bracketed(
    lows: Sequence[Fraction],
    highs: Sequence[Fraction],
    document: dict[str, Any],
    notes: Sequence[str],
) -> Answer:
    """A list of numbers between certified bounds."""
    low, high = [below(x) + 0.0 for x in lows], [above(x) + 0.0 for x in highs]
    value = [
        nearest(a) if a == b else (c + d) / 2
        for a, b, c, d in zip(lows, highs, low, high, strict=True)
    ]
    return Answer(
        value=value,
        lower=low,
        upper=high,
        verdict="PROVED",
        certificate=document,
        notes=tuple(notes),
    )


def largest_ratio(rows: Rows, weight: Rows) -> tuple[Fraction, Fraction]:
    """Bounds on the largest eigenvalue of (rows, weight); exact ones for diagonal matrices.

    Raises
    ------
    InputError
        No upper bound could be proved.
    """
    size = range(len(rows))
    if not any(m[i][j] for m in (rows, weight) for i in size for j in size if i != j):
        largest = max(rows[i][i] / weight[i][i] for i in size)
        return largest, largest
    found = generalized_ratio(rows, weight)
    if found.lower is None or found.upper is None:
        raise InputError("H", "a matrix too close to a singular one", "bounded eigenvalues")
    return Fraction(found.lower), Fraction(found.upper)


def drift_bounds(block: Block) -> tuple[Fraction, Fraction]:
    """Doubles below and above |eta|; both are it where it is one."""
    square = dot(block.drift, block.drift)
    low, high = (square_root_beside(square, down) or Fraction(0) for down in (True, False))
    return low, high
