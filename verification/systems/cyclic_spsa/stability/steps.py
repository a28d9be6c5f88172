"""Where mean-square stability of an update ends: answers with certificates."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from verification.answers import Answer, Detail
from verification.certificates.make import CertificateError, certificate
from verification.exact.evaluate import Rows
from verification.exact.rationals import above, below, nearest
from verification.input_words import positive

from ..block_inputs import Block, block_of
from .iterated import leading
from .limits import BITS, LARGE_BITS, MOST_STACKED, Limit, decaying_at, limit_of
from .moments import noise_moments
from .stacked import Stacked
from .witnesses import (
    Item,
    around,
    covariance_of,
    identity_of,
    items,
    kept_at,
    rounded_decaying,
    rounded_growing,
)

USABLE = 1e-6
WIDE = "no narrower bracket from doubles: the data are too ill-scaled for so many coordinates"
NO_FILE = "proved without a file: {}"
TOO_CLOSE = "alpha is too close to the limit for so many coordinates"


def step_limit(values: Mapping[str, Any]) -> Answer:
    """Supremum of the steps alpha with mean-square stability.

    Parameters
    ----------
    values : mapping
        The inputs of `block_inputs.BLOCK`.

    Returns
    -------
    Answer
        With a two-sided certificate; exact for a diagonal Hessian, and for a full one of up to four
        coordinates.

    Raises
    ------
    InputError
        As `block_inputs.block_of`.

    References
    ----------
    Erofeeva & Granichin, Algorithm 1 and Theorem 1.
    """
    block = block_of(values)
    limit = limit_of(block)
    if limit is None:
        return Answer(verdict="UNDECIDED", notes=(WIDE,))
    document, unwritten = limit_certificate(block, limit)
    found = _readings(block, limit)
    narrow = limit.exact is not None or limit.upper - limit.lower <= USABLE * limit.lower
    return Answer(
        value=limit.value if narrow else None,
        exact=limit.exact.to_data() if limit.exact else None,
        lower=below(limit.lower),
        upper=above(limit.upper),
        verdict="PROVED",
        certificate=document,
        notes=(*unwritten, *found.notes),
        more=found.more,
    )


def limit_certificate(block: Block, limit: Limit) -> tuple[dict[str, Any] | None, tuple[str, ...]]:
    """The two-sided certificate of a limit, or None and a note why the checker reads none."""
    return _written(
        "step_limit",
        block.inputs(),
        limit.witness(block),
        case=limit.case,
        lower=limit.lower,
        upper=limit.upper,
    )


def _written(
    name: str, data: Mapping[str, Any], witness: list[Item], **more: Any
) -> tuple[dict[str, Any] | None, tuple[str, ...]]:
    """A certificate, or None and a note: the checker refuses numbers of too many digits."""
    try:
        return certificate("cyclic_spsa", name, data, witness, **more), ()
    except CertificateError as error:
        return None, (NO_FILE.format(error),)


OTHER = {1: "two", 2: "one"}


def _readings(block: Block, limit: Limit, alpha: Fraction | None = None) -> Answer:
    """What changes with the other number of measurement instants: notes and details."""
    other = replace(block, instants=3 - block.instants)
    if not any(map(any, (*noise_moments(block), *noise_moments(other)))):
        return Answer()
    found = limit_of(other)
    if found is None or math.isinf(above(found.upper)):
        return Answer()
    if not (found.upper < limit.lower or limit.upper < found.lower):
        return Answer()
    word = OTHER[block.instants]
    notes = [
        f"the limit depends on the reading: with measurements of {word} it is {found.value:.6g}"
    ]
    if alpha is not None:
        stable = alpha <= found.lower
        if stable != (alpha <= limit.lower) and (stable or alpha >= found.upper):
            verdict = "stable" if stable else "not stable"
            notes = [f"the verdict depends on the reading: with {word}, alpha is {verdict}"]
    ends = {"lower": below(found.lower), "upper": above(found.upper)}
    data = {"reading": word, "value": found.value, **ends}
    detail = Detail(data, ((f"limit, reading {word}", f"{found.value:.10g}"),))
    return Answer(notes=tuple(notes), more={"other_reading": lambda: detail})


def decide_step(values: Mapping[str, Any]) -> Answer:
    """Decide whether the second moments of the error tend to zero at the step alpha.

    Parameters
    ----------
    values : mapping
        The inputs of `block_inputs.BLOCK`, and ``alpha``.

    Returns
    -------
    Answer
        PROVED or REFUTED with a certificate, UNDECIDED beside the limit of a large full Hessian;
        margin = limit - alpha.

    Raises
    ------
    InputError
        As `block_inputs.block_of`; alpha <= 0.
    """
    block, alpha = block_of(values), positive(values, "alpha", "a step")
    limit = limit_of(block)
    found = at_step(block, alpha, limit)
    if found is None:
        return Answer(verdict="UNDECIDED", notes=(TOO_CLOSE,))
    case, chosen = found
    document, unwritten = _written(
        "step",
        {**block.inputs(), "alpha": alpha},
        items((identity_of(block), *chosen, *covariance_of(block))),
        case=case,
    )
    beside = _readings(block, limit, alpha) if limit else Answer()
    return Answer(
        verdict=case.split()[0],
        certificate=document,
        margin=nearest(limit.centre - alpha) if limit else None,
        notes=(*unwritten, *beside.notes),
        more=beside.more,
    )


def at_step(
    block: Block, alpha: Fraction, limit: Limit | None
) -> tuple[str, tuple[Rows, ...]] | None:
    """Case and matrices of the statement ``step``; None where they are not found."""
    if limit is not None and alpha >= limit.upper:
        if limit.case == "PROVED":
            return "REFUTED", limit.kept
        return limit.case.replace("PROVED", "REFUTED"), (((limit.upper,),), *limit.kept)
    if limit is not None and alpha <= limit.lower:
        return "PROVED", (limit.decaying, around(block, limit.decaying))
    return _beside(block, alpha)


def _beside(block: Block, alpha: Fraction) -> tuple[str, tuple[Rows, ...]] | None:
    """Case and matrices at a step so close to the limit that its bracket does not decide."""
    if block.size > MOST_STACKED and not block.diagonal:
        return _beside_large(block, alpha)
    z = decaying_at(block, alpha)
    if z is not None:
        return "PROVED", (z, around(block, z))
    stacked = Stacked(block)
    for bits in BITS:
        near = stacked.kept(bits)
        if near is None:
            continue
        kept = kept_at(stacked, alpha, near[1])
        if kept is not None:
            return "REFUTED exact", (((alpha,),), kept, around(block, kept))
        rows = rounded_growing(block, near[1], alpha)
        if rows is not None:
            return "REFUTED", (rows, around(block, rows))
    return None


def _beside_large(block: Block, alpha: Fraction) -> tuple[str, tuple[Rows, ...]] | None:
    """The same from iteration in many bits, on the side on which it puts the step."""
    for bits in LARGE_BITS:
        found = leading(block, bits)
        if found is None:
            continue
        stable = alpha < found.limit
        show, start = (
            (rounded_decaying, found.decaying) if stable else (rounded_growing, found.kept)
        )
        rows = show(block, start, alpha)
        if rows is not None:
            return "PROVED" if stable else "REFUTED", (rows, around(block, rows))
    return None
