"""Constants for the generated stepper: what they must satisfy, and what to know about them."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from theory.systems.variational.stepper import STEPPER
from verification.exact.evaluate import Rows, identity, scaled

from .gains import NAMES, definite_gain, positive_step
from .quantities import GAINS, STEP
from .steps import decide_step

__all__ = ["INPUTS", "STEPPER", "constants"]

INPUTS = (*GAINS, STEP)
MOST = 12
"""Coordinates up to which straight-line source is sensible."""


def constants(
    values: Mapping[str, Any], coordinates: int | None
) -> tuple[int, dict[str, Rows], str]:
    """Check the values that become constants of the source.

    Parameters
    ----------
    values : mapping
        Some of ``M``, ``K``, ``C`` (exact square matrices) and ``h``.
    coordinates : int or None
        As asked for; by default the size of the matrices, else that of the shipped source.

    Returns
    -------
    n : int
        Coordinates.
    given : dict of str to Rows
        ``h`` as a 1 by 1 matrix.
    note : str
        A warning, or empty.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, h <= 0, or a size does not fit.
    """
    sizes = {name: len(values[name]) for name in NAMES if name in values}
    n = _size(sizes, coordinates)
    given = {name: _sized(values[name], n) for name in sizes}
    for name, rows in given.items():
        definite_gain(name, rows)
    if "h" in values:
        given["h"] = ((positive_step(values),),)
    return n, given, _warning(given)


def _size(sizes: Mapping[str, int], coordinates: int | None) -> int:
    own = max(sizes.values(), default=1)
    default = own if own > 1 else STEPPER.coordinates
    n = default if coordinates is None else coordinates
    if not 1 <= n <= MOST:
        needed = f"1 to {MOST} are needed: longer straight-line source is slower than a loop"
        raise InputError("--coordinates", str(n), needed)
    if own not in (1, n):
        name = next(name for name in sizes if sizes[name] == own)
        raise InputError(name, f"{own} x {own}", f"{n} x {n} is needed for {n} coordinates")
    return n


def _sized(rows: Rows, n: int) -> Rows:
    """A number means that multiple of the identity."""
    return scaled(rows[0][0], identity(n)) if len(rows) == 1 < n else rows


def _warning(given: Mapping[str, Rows]) -> str:
    if {*given} != {*NAMES, "h"}:
        return ""
    h: Fraction = given["h"][0][0]
    answer = decide_step({**given, "h": h})
    if answer.verdict == "PROVED":
        return ""
    return f"these gains are not stable at h = {h}: see 'sensortrack bound variational.step_limit'"
