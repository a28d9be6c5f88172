"""Constants for the generated source of one node: what they must satisfy."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from theory.systems.bearing_dac.stepper import STEPPER
from verification.answers import Input
from verification.exact.evaluate import Rows

__all__ = ["INPUTS", "STEPPER", "constants"]

INPUTS = (
    Input("s", "point", "position of this node", "m"),
    Input("period", "number", "time between samples, above 0", "s"),
    Input("beta_P", "number", "gain for the entries of P, above 0", "1/s"),
    Input("beta_q", "number", "gain for the entries of q, above 0", "m/s"),
    Input("det_min", "number", "smallest det P_x that counts as information, 0 to 1/4", "1"),
)
LARGEST_DET = Fraction(1, 4)
"""det P_x of bearings in all directions, the largest of a matrix of trace 1."""


def constants(
    values: Mapping[str, Any], coordinates: int | None
) -> tuple[int, dict[str, Rows], str]:
    """Check the values that become constants of the source.

    Parameters
    ----------
    values : mapping
        Some of ``s`` (two rationals), ``period``, ``beta_P``, ``beta_q``, ``det_min``.
    coordinates : int or None
        2, or not given: bearings are angles in a plane.

    Returns
    -------
    n : int
        2.
    given : dict of str to Rows
        Numbers as 1 by 1 matrices, the position as a column.
    note : str
        Empty.

    Raises
    ------
    InputError
        A period or gain is not positive, det_min is not in [0, 1/4), or other coordinates were
        asked for.
    """
    if coordinates not in (None, STEPPER.coordinates):
        raise InputError("--coordinates", str(coordinates), "2 is needed: bearings lie in a plane")
    for name in ("period", "beta_P", "beta_q"):
        if values.get(name, 1) <= 0:
            raise InputError(name, f"{values[name]}", "a number above 0 is needed")
    if not 0 <= values.get("det_min", 0) < LARGEST_DET:
        needed = "a number of 0 or more, below 1/4, is needed"
        raise InputError("det_min", f"{values['det_min']}", needed)
    given: dict[str, Rows] = {
        name: tuple((x,) for x in value) if name == "s" else ((value,),)
        for name, value in values.items()
    }
    return STEPPER.coordinates, given, ""
