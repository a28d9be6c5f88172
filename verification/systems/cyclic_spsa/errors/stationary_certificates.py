"""Certificates of the stationary mean-square error, for Gaussian noise and few coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from verification.certificates.make import CertificateError, certificate
from verification.exact.definite import congruence
from verification.exact.evaluate import Rows, dot, trace

from ..block_inputs import Block
from ..stability.limits import decaying_at, limit_of
from ..stability.moments import fmpq, rows_of
from ..stability.steps import at_step
from ..stability.witnesses import around, covariance_of, identity_of, items
from .second_moments import Moments
from .settling import Settling, right_side
from .solutions import flint_trace

UP_TO = 12
"""Coordinates up to which a certificate is made."""
CLOSE = Fraction(1, 2**70)
"""How far a bound is from the part of the number that it bounds."""
GUARD = (8, 16, 32, 64, 128)
"""Bits beyond these to which matrices are rounded; the first that do are kept."""


def unbounded(block: Block, alpha: Fraction) -> dict[str, Any] | None:
    """That second moments do not tend to zero at the step; None where that is not shown."""
    found = at_step(block, alpha, limit_of(block)) if block.size <= UP_TO else None
    if found is None or not found[0].startswith("REFUTED"):
        return None
    ends = {"case": found[0].replace("REFUTED", "INFINITE"), "lower": "inf", "upper": "inf"}
    return _document(block, alpha, found[1], ends)


def settled(settling: Settling, moments: Moments) -> dict[str, Any] | None:
    """Bounds on the mean square of a stable step.

    Parameters
    ----------
    settling : Settling
    moments : Moments

    Returns
    -------
    dict or None
        None for many coordinates, for other than Gaussian fourth moments, where the moments are not
        exact, and where no matrices of few bits show the bounds.
    """
    block, alpha = settling.block, moments.alpha
    if block.size > UP_TO or settling.beyond != 0 or not moments.exact:
        return None
    z, right = decaying_at(block, alpha), right_side(settling, moments)
    above, below = (_bounding(moments, right, sign) for sign in (1, -1))
    if z is None or above is None or below is None:
        return None
    mean = settling.mean(alpha)
    sources = (rows_of(part) for part in (settling.moved, settling.shaken, right))
    chosen = (tuple((x,) for x in mean), *sources, above, around(block, above))
    chosen = (z, around(block, z), *chosen, below, around(block, below))
    square = dot(mean, mean)
    ends = {"lower": trace(below) + square, "upper": trace(above) + square}
    return _document(block, alpha, chosen, ends)


def _document(
    block: Block, alpha: Fraction, chosen: tuple[Rows, ...], ends: Mapping[str, Any]
) -> dict[str, Any] | None:
    """The certificate; None where the data have more digits than the checker reads."""
    inputs = {**block.inputs(), "alpha": alpha}
    witness = items((identity_of(block), *chosen, *covariance_of(block)))
    try:
        return certificate("cyclic_spsa", "stationary_mse", inputs, witness, **ends)
    except CertificateError:
        return None


def _bounding(moments: Moments, right: Any, sign: int) -> Rows | None:
    """A matrix of few bits that gives more than the right side, or less."""
    import flint

    found, unit = moments.solved(right).matrix, moments.unit.matrix
    size = flint_trace(found) / flint_trace(unit) if flint_trace(found) != 0 else flint.fmpq(1)
    slack = size * flint.fmpq(CLOSE.numerator, CLOSE.denominator)
    near = rows_of(found + unit * (sign * slack))
    grain = Fraction(int(slack.p), int(slack.q)) / trace(moments.block.hessian)
    for bits in GUARD:
        rows = _rounded(near, grain / 2**bits)
        matrix = fmpq(rows)
        rest = moments.operators.pull(matrix) - moments.operators.kick(matrix) * moments.step
        if congruence(rows_of((rest - right) * sign)) is not None:
            return rows
    return None


def _rounded(rows: Rows, grain: Fraction) -> Rows:
    """Entries to multiples of a power of two close to the grain."""
    exponent = grain.numerator.bit_length() - grain.denominator.bit_length()
    unit = Fraction(2) ** exponent
    return tuple(tuple(round(x / unit) * unit for x in row) for row in rows)
