"""The gain matrices M, K, C: what they must satisfy before any arithmetic."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.exact.definite import asymmetry, negative_vector
from verification.exact.evaluate import Rows, quadratic
from verification.input_words import positive

NAMES = ("M", "K", "C")


def definite_gains(values: Mapping[str, Any]) -> dict[str, Rows]:
    """Return M, K, C after checking that each is symmetric positive definite.

    Parameters
    ----------
    values : mapping
        Exact square matrices of one size under ``M``, ``K`` and ``C``.

    Returns
    -------
    dict of str to Rows

    Raises
    ------
    InputError
        A matrix is not symmetric (two entries are named) or not positive definite (a vector x with
        x'Mx <= 0 is given), or the sizes differ.
    """
    gains: dict[str, Rows] = {name: values[name] for name in NAMES}
    for name, rows in gains.items():
        if len(rows) != len(gains["M"]):
            raise InputError(
                name, f"{len(rows)} x {len(rows)}", f"the size of M, {len(gains['M'])}, is needed"
            )
        definite_gain(name, rows)
    return gains


def positive_step(values: Mapping[str, Any]) -> Fraction:
    """Return h after checking that it is positive.

    Raises
    ------
    InputError
        h is zero or negative.
    """
    return positive(values, "h", "a step")


def definite_gain(name: str, rows: Rows) -> None:
    """Refuse a matrix that is not symmetric positive definite.

    Parameters
    ----------
    name : str
        Of the input.
    rows : Rows
        Square, exact.

    Raises
    ------
    InputError
        Two unlike entries are named, or a vector x with x'Ax <= 0 is given.
    """
    pair = asymmetry(rows)
    if pair:
        i, j = pair
        raise InputError(
            name,
            f"not symmetric: entry {i + 1},{j + 1} is {rows[i][j]}, entry {j + 1},{i + 1} is "
            f"{rows[j][i]}",
            "a symmetric positive definite matrix is needed",
        )
    x = negative_vector(rows)
    if x:
        raise InputError(
            name,
            f"not positive definite: x = ({', '.join(map(str, x))}) gives x'{name}x = "
            f"{quadratic(x, rows)}",
            "a symmetric positive definite matrix is needed",
        )
