"""Almost-sure stability of one coordinate: the exponent of its error, and where it is zero.

The homogeneous error of one coordinate is multiplied by 1 - x + x Delta nu at each update, x being
alpha h. For Gaussian noise Delta nu is a Gaussian number about plus or minus the mean m of nu, each
with probability one half, of variance S = Xi/(2 beta^2).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Detail
from verification.exact.log_means import gaussian_log_mean
from verification.exact.rationals import above, below, nearest
from verification.exact.spectra.modes import exact
from verification.input_words import positive

from ..block_inputs import Block, block_of
from .witnesses import diagonal_limit

FORGETS = "for Gaussian noise; below it the error forgets its start with probability 1"
WORD = "mean-square limit"
HALVINGS = 200
USABLE = Fraction(1, 10**6)
"""Relative width up to which a bracket is an answer."""


def lyapunov_exponent(values: Mapping[str, Any]) -> Answer:
    """Limit of ln|a_n|/n for the homogeneous error a_n of one coordinate, Gaussian noise.

    Parameters
    ----------
    values : mapping
        The inputs of `block_inputs.BLOCK`, for one coordinate, and ``alpha``.

    Returns
    -------
    Answer
        In certified bounds; ``-inf`` where an update may leave nothing of the error.

    Raises
    ------
    InputError
        As `block_inputs.block_of`; alpha <= 0; there are several coordinates.
    """
    block, step = _scalar(values), positive(values, "alpha", "a step")
    found = _exponent(block, step)
    if found is None:
        note = "an update leaves nothing of the error with a positive probability"
        return Answer(value="-inf", verdict="PROVED", notes=(note,))
    low, high = _ends(found)
    value = nearest((low + high) / 2) if high - low <= USABLE * max(abs(low), abs(high)) else None
    return Answer(value=value, lower=below(low), upper=above(high), verdict="PROVED")


def almost_sure_limit(values: Mapping[str, Any]) -> Answer:
    """Supremum of the steps at which the error of one coordinate dies out with probability 1.

    Without drift the exponent falls and then rises with the step, so that it has one zero.

    Parameters
    ----------
    values : mapping
        The inputs of `block_inputs.BLOCK`, for one coordinate without drift.

    Returns
    -------
    Answer
        In certified bounds, neighbouring doubles or nearly so; exact without noise.

    Raises
    ------
    InputError
        As `block_inputs.block_of`; there are several coordinates, or a drift.
    """
    block = _scalar(values)
    mean, variance = _difference(block)
    if mean:
        needed = "no drift is needed: with it the stable steps may be several intervals"
        raise InputError("eta", f"{block.drift[0]}", needed)
    square = diagonal_limit(block)
    detail = Detail(nearest(square), ((WORD, f"{nearest(square):.10g}"),))
    more = {"mean_square_limit": lambda: detail}
    if not variance:
        exact_limit = {"kind": "rational", "value": str(square)}
        value = nearest(square)
        ends = (below(square), above(square))
        return Answer(value, exact_limit, *ends, verdict="PROVED", notes=(FORGETS,), more=more)
    low, high = _zero(block, square)
    return Answer(
        value=nearest((Fraction(low) + Fraction(high)) / 2),
        lower=low,
        upper=high,
        verdict="PROVED",
        notes=(FORGETS,),
        more=more,
    )


def _scalar(values: Mapping[str, Any]) -> Block:
    block = block_of(values)
    if block.size > 1:
        raise InputError(block.given, f"{block.size} coordinates", "one coordinate is needed")
    return block


def _difference(block: Block) -> tuple[Fraction, Fraction]:
    """Mean and variance of nu."""
    two = block.instants - 1
    return two * block.drift[0] / (2 * block.beta), two * block.noise[0][0] / (2 * block.beta**2)


def _exponent(block: Block, step: Fraction) -> Any | None:
    """E ln|1 - x + x Delta nu| as a ball; None if it is minus infinity."""
    mean, variance = _difference(block)
    x = step * block.hessian[0][0]
    centres = (1 - x + x * mean, 1 - x - x * mean)
    if not variance and 0 in centres:
        return None
    return sum(gaussian_log_mean(centre, x * x * variance) for centre in centres) / 2


def _ends(ball: Any) -> tuple[Fraction, Fraction]:
    middle, radius = exact(ball), exact(ball.rad())
    return middle - radius, middle + radius


def _sign(block: Block, step: float) -> int:
    """Sign of the exponent, 0 if the ball does not tell."""
    low, high = _ends(_exponent(block, Fraction(step)))
    return 1 if low > 0 else -1 if high < 0 else 0


def _zero(block: Block, square: Fraction) -> tuple[float, float]:
    """Doubles with a negative and a positive exponent, as near to each other as balls tell.

    Up to the mean-square limit the exponent is not positive, by Jensen's inequality.
    """
    low = below(square) * (1 - 2**-40)
    high = 2 * low
    while _sign(block, high) <= 0:
        low, high = (high, 2 * high) if _sign(block, high) < 0 else (low, 2 * high)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        sign = _sign(block, middle) if low < middle < high else 0
        if not sign:
            break
        low, high = (middle, high) if sign < 0 else (low, middle)
    return low, high
