"""Mean and mean square of the error right after an update, once both have settled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Input
from verification.enclosures import enclosure, ends, listed, single
from verification.exact.definite import congruence
from verification.exact.rationals import nearest, text
from verification.input_words import positive

from ..block_inputs import ALPHA, BLOCK, Block, block_of
from .second_moments import BITS, Moments, moments_of
from .settling import LAWS, Settling, mean_square
from .solutions import TooClose
from .stationary_certificates import settled, unbounded

LAW = Input("law", "word", "law of the measured positions: gaussian or two_point", "", "gaussian")
MEAN = (*BLOCK, ALPHA)
MEAN_SQUARE = (*BLOCK, ALPHA, LAW)
BEST = (*BLOCK, LAW)
Document = dict[str, Any]
LONGEST = 400
"""Digits of a rational that an answer carries."""

GROWS = "the second moments grow at this step"
MEAN_GROWS = "the mean itself grows at this step: alpha times the largest eigenvalue of H is >= 2"
SPREADS = "the mean settles, but the second moments grow at this step"
NO_FILE = (
    "proved without a file: certificates are for Gaussian noise, up to 12 coordinates and numbers "
    "that are not too long"
)
NO_WORD = "floating point does not tell whether this step is stable: it is too close to the limit"


def stationary_mean(values: Mapping[str, Any]) -> Answer:
    """Limit of the mean of theta_hat - theta right after an update.

    Parameters
    ----------
    values : mapping
        The inputs of a block, and ``alpha``, above 0.

    Returns
    -------
    Answer
        D numbers in m, each the double nearest to the exact rational; ``"inf"`` for all of them
        where the mean has no limit. It may have one where second moments do not.

    Raises
    ------
    InputError
        An input of the block or alpha is out of range.
    """
    import flint

    block, alpha = block_of(values), positive(values, "alpha")
    if not mean_settles(block, alpha):
        return Answer(value=["inf"] * block.size, verdict="PROVED", notes=(MEAN_GROWS,))
    found = Settling(block).mean(alpha)
    notes = (f"exact: {', '.join(map(text, found))}",) if _short(found) else ()
    with flint.ctx.workprec(BITS):
        if is_stable(moments_of(block, alpha)) is False:
            notes = (*notes, SPREADS)
    return listed([enclosure(x, x) for x in found], notes)


def stationary_mse(values: Mapping[str, Any], certified: bool = True) -> Answer:
    """Limit of E|theta_hat - theta|^2 right after an update.

    Parameters
    ----------
    values : mapping
        The inputs of a block; ``alpha``, above 0; ``law`` of the noise, of `LAWS`.
    certified : bool, optional
        Whether to write a certificate: for Gaussian noise, up to twelve coordinates.

    Returns
    -------
    Answer
        In m^2, in certified bounds, and exact where the noise is Gaussian or its covariance
        diagonal, for a diagonal Hessian or up to twelve coordinates; ``"inf"`` where second moments
        grow; no value where floating point does not tell.

    Raises
    ------
    InputError
        An input of the block, alpha or the law is out of range.
    """
    import flint

    block, alpha, law = block_of(values), positive(values, "alpha"), law_of(values)
    with flint.ctx.workprec(BITS):
        moments = moments_of(block, alpha)
        stable = is_stable(moments)
        if stable is None:
            return Answer(verdict="UNDECIDED", notes=(NO_WORD,))
        if not stable:
            document = unbounded(block, alpha) if certified else None
            return Answer(value="inf", verdict="PROVED", notes=(GROWS,), certificate=document)
        settling = Settling(block, law)
        document = settled(settling, moments) if certified else None
        notes = (NO_FILE,) if certified and document is None else ()
        return mean_square_answer(mean_square(settling, moments), document, notes)


def mean_settles(block: Block, alpha: Fraction) -> bool:
    """Whether the mean tends to a limit from every start: alpha H < 2 I."""
    rest = tuple(
        tuple(2 * (i == j) - alpha * x for j, x in enumerate(row))
        for i, row in enumerate(block.hessian)
    )
    return congruence(rest) is not None


def law_of(values: Mapping[str, Any]) -> str:
    """The law of the noise.

    Raises
    ------
    InputError
        There is none of that name.
    """
    law: str = values["law"]
    if law not in LAWS:
        raise InputError("law", repr(law), f"one of {', '.join(LAWS)} is needed")
    return law


def is_stable(moments: Moments) -> bool | None:
    """Whether second moments tend to their limit; None where floating point does not tell."""
    try:
        return moments.stable
    except TooClose:
        return None


def mean_square_answer(
    found: Any, document: Document | None = None, notes: tuple[str, ...] = ()
) -> Answer:
    """A mean square, exact or in a ball, as an answer; bounds are those of its certificate."""
    import flint

    if not isinstance(found, flint.fmpq):
        return single(enclosure(*ends(found)), notes)
    exact = Fraction(int(found.p), int(found.q))
    data = {"kind": "rational", "value": text(exact)} if _short((exact,)) else None
    low, high = exact, exact
    if document is not None:
        low, high = (max(Fraction(document[end]), Fraction(0)) for end in ("lower", "upper"))
    bounds = replace(enclosure(low, high), value=nearest(exact))
    return single(bounds, notes, exact=data, certificate=document)


def _short(numbers: tuple[Fraction, ...]) -> bool:
    """Whether a reader can bear these rationals."""
    bits = sum(x.numerator.bit_length() + x.denominator.bit_length() for x in numbers)
    return bits <= LONGEST * 3
