"""Arguments as numbers, or an error that names them."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError

Floats = NDArray[np.float64]


def real(name: str, value: object, needed: str = "a number is needed") -> float:
    """A number, NaN and infinite ones included.

    Raises
    ------
    InputError
        With this name: it is none, is a text, or is too large for a float.
    """
    try:
        if isinstance(value, str | bytes):
            raise TypeError
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise InputError(name, f"{value!r:.60}", needed) from None


def positive(name: str, value: object) -> float:
    """A finite number above 0.

    Raises
    ------
    InputError
        With this name.
    """
    needed = "a number above 0 is needed"
    found = real(name, value, needed)
    if not (math.isfinite(found) and found > 0):
        raise InputError(name, f"{value}", needed)
    return found


def numbers(name: str, value: ArrayLike, needed: str = "numbers are needed") -> Floats:
    """An array of its own, NaN and infinite numbers included.

    Raises
    ------
    InputError
        With this name: something else than real numbers, or rows of different lengths.
    """
    try:
        return np.array(value, dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise InputError(name, f"{value!r:.60}", needed) from None
