"""The limit of the step beside the printed one, for the same block."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np

from theory.systems.cyclic_spsa.bounds import PRINTED
from verification.answers import Answer
from verification.exact.rationals import nearest

from ..block_inputs import Block, block_of
from ..stability.steps import step_limit
from .bounds import interval_end

COARSE = Fraction(1, 10**6)
"""Smallest eigenvalue, over the largest entry, that doubles tell to ten digits."""


def limit_beside_printed(values: Mapping[str, Any]) -> Answer:
    """`step_limit`, and the end of the printed interval for the same block.

    Raises
    ------
    InputError
        As `block_inputs.block_of`.

    References
    ----------
    V. Erofeeva, O. Granichin, Theorem 1.
    """
    return replace(step_limit(values), printed=printed_step(block_of(values)))


def printed_step(block: Block) -> float | None:
    """The end mu/gamma of the printed interval for a quadratic cost: d, mu and M are those of H.

    c3 is 0, which Assumption 5 as printed allows any quadratic cost.

    Returns
    -------
    float or None
        None where doubles do not tell the smallest eigenvalue of H.
    """
    low, high = _extreme_eigenvalues(block)
    if not low > 0:
        return None
    numbers = {"d": Fraction(block.size), "mu": low, "M": high, "beta": block.beta}
    return nearest(interval_end(PRINTED, {**numbers, "c3": Fraction(0)}))


def _extreme_eigenvalues(block: Block) -> tuple[Fraction, Fraction]:
    """Of the Hessian: exact if it is diagonal, else in doubles, zeros where they are too coarse."""
    own = [block.hessian[i][i] for i in range(block.size)]
    if block.diagonal:
        return min(own), max(own)
    unit = max(own)
    found = np.linalg.eigvalsh([[float(x / unit) for x in row] for row in block.hessian])
    low, high = Fraction(float(found[0])), Fraction(float(found[-1]))
    return (low * unit, high * unit) if low > COARSE else (Fraction(0), Fraction(0))
