"""Constants for the generated source of one block: what they must satisfy, what to know of them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from theory.systems.cyclic_spsa.stepper import STEPPER
from verification.exact.evaluate import Rows, identity, scaled
from verification.input_words import positive

from .block_inputs import ALPHA, BETA, HESSIAN, hessian_of
from .stability.steps import decide_step

__all__ = ["INPUTS", "STEPPER", "constants"]

INPUTS = (*HESSIAN, ALPHA, BETA)
MOST = 12
"""Coordinates up to which straight-line source is sensible: six targets."""
LARGEST = 10**30
"""Of a constant, and of its inverse: numbers of single precision hold it, and its products."""


def constants(
    values: Mapping[str, Any], coordinates: int | None
) -> tuple[int, dict[str, Rows], str]:
    """Check the values that become constants of the source.

    Parameters
    ----------
    values : mapping
        Some of ``h`` (rationals) or ``H`` (exact square matrix), ``alpha``, ``beta``. A single
        number stands for that multiple of the identity.
    coordinates : int or None
        As asked for; by default the size of the Hessian, else that of one target.

    Returns
    -------
    n : int
        Coordinates.
    given : dict of str to Rows
        The Hessian as H, numbers as 1 by 1 matrices.
    note : str
        A warning, or empty.

    Raises
    ------
    InputError
        The Hessian is given twice or is not symmetric positive definite, alpha or beta is not
        positive, a size does not fit, or a number is too large or too small for source.
    """
    given: dict[str, Rows] = {}
    n = STEPPER.coordinates if coordinates is None else coordinates
    if {"h", "H"} & {*values}:
        hessian, name = hessian_of({"h": None, "H": None} | dict(values))
        n = _size(len(hessian), name, coordinates)
        given["H"] = scaled(hessian[0][0], identity(n)) if len(hessian) == 1 else hessian
    if not 1 <= n <= MOST:
        needed = f"1 to {MOST} are needed: longer straight-line source is slower than a loop"
        raise InputError("--coordinates", str(n), needed)
    for name in ("alpha", "beta"):
        if name in values:
            given[name] = ((positive(values, name),),)
    for name, rows in given.items():
        _check_size("h" if name == "H" and values.get("h") is not None else name, rows)
    return n, given, _warning(given)


def _size(own: int, name: str, coordinates: int | None) -> int:
    n = coordinates or (own if own > 1 else STEPPER.coordinates)
    if own not in (1, n):
        found = f"{own} numbers" if name == "h" else f"{own} x {own}"
        raise InputError(name, found, f"{n} coordinates are needed, or a single number")
    return n


def _check_size(name: str, rows: Rows) -> None:
    for value in (entry for row in rows for entry in row if entry):
        if not 1 <= abs(value) * LARGEST <= LARGEST**2:
            digits = math.log10(abs(value.numerator)) - math.log10(value.denominator)
            needed = f"numbers from {1 / LARGEST:.0e} to {LARGEST:.0e} are needed"
            raise InputError(name, f"about 10^{digits:.0f}", needed)


def _warning(given: Mapping[str, Rows]) -> str:
    """Without noise and drift the limit of the step is the largest: beyond it nothing helps."""
    if not {"H", "alpha"} <= {*given}:
        return ""
    n, alpha = len(given["H"]), given["alpha"][0][0]
    quiet = {"Xi": scaled(Fraction(0), identity(n)), "eta": (Fraction(0),) * n}
    block = {"h": None, "H": given["H"], "beta": Fraction(1), "reading": "one", "k": Fraction(1)}
    if decide_step({**block, **quiet, "alpha": alpha}).verdict != "REFUTED":
        return ""
    return (
        f"alpha = {alpha} is not stable even without noise: "
        "see 'sensortrack bound cyclic_spsa.step_limit'"
    )
