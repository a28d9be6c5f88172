"""The numbers of one block of coordinates, checked for a simulation."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.arguments import numbers
from sensortrack.errors import InputError

Floats = NDArray[np.float64]
ROUNDING = 1e-12
"""Part of the largest eigenvalue by which rounding may make the least negative."""


def hessian_of(value: ArrayLike) -> Floats:
    """A Hessian: its diagonal, or the matrix.

    Raises
    ------
    InputError
        With the name ``h`` or ``H``: it has another shape, or is not symmetric positive definite.
    """
    rows = np.atleast_1d(np.asarray(value, dtype=object))
    name = "H" if any(map(np.ndim, rows)) else "h"
    found = numbers(name, value)
    if found.ndim not in (1, 2) or not found.size or found.shape != found.shape[:1] * found.ndim:
        raise InputError(name, f"an array of shape {found.shape}", "a list or D x D is needed")
    if not np.isfinite(found).all():
        raise InputError(name, "an entry that is not finite", "finite numbers are needed")
    if found.ndim == 2 and not np.array_equal(found, found.T):
        raise InputError(name, "a matrix that is not symmetric", "a symmetric one is needed")
    least = found.min() if found.ndim == 1 else np.linalg.eigvalsh(found)[0]
    if least <= 0:
        needed = "a symmetric positive definite one is needed"
        raise InputError(name, f"the eigenvalue {least:.4g}", needed)
    return found


def covariance_root(value: ArrayLike, size: int) -> Floats:
    """Symmetric root of a covariance, as a diagonal where it is one.

    Raises
    ------
    InputError
        With the name ``Xi``: it does not fit the size, or is not symmetric positive semidefinite.
    """
    found = numbers("Xi", value)
    if found.ndim == 0:
        found = np.diag(np.full(size, float(found)))
    if found.shape != (size, size):
        needed = f"a number or {size} x {size} is needed"
        raise InputError("Xi", f"an array of shape {found.shape}", needed)
    if not np.isfinite(found).all() or not np.array_equal(found, found.T):
        raise InputError("Xi", "a matrix that is not symmetric and finite", "such a one is needed")
    values, vectors = np.linalg.eigh(found)
    if values[0] < -ROUNDING * max(abs(values[-1]), abs(values[0])):
        raise InputError("Xi", f"the eigenvalue {values[0]:.4g}", "a covariance is needed")
    diagonal = np.diag(found)
    if np.array_equal(found, np.diag(diagonal)):
        return np.sqrt(diagonal)
    return np.ascontiguousarray((vectors * np.sqrt(np.maximum(values, 0.0))) @ vectors.T)


def drift_of(value: ArrayLike, size: int) -> Floats:
    """A drift, of which one number stands for all coordinates.

    Raises
    ------
    InputError
        With the name ``eta``: it does not fit the size, or is not finite.
    """
    found = numbers("eta", value)
    found = np.full(size, float(found)) if found.ndim == 0 else found
    if found.shape != (size,) or not np.isfinite(found).all():
        raise InputError("eta", f"{value!r:.60}", f"a number or {size} finite ones are needed")
    return found


def start_of(value: ArrayLike, runs: int, size: int) -> Floats:
    """First errors of all runs, runs by coordinates, as an array of its own.

    Raises
    ------
    InputError
        With the name ``start``: it does not fit, or is not finite.
    """
    found = numbers("start", value)
    if found.shape not in ((), (size,), (runs, size)) or not np.isfinite(found).all():
        needed = f"a number, {size} or {runs} x {size} finite ones are needed"
        raise InputError("start", f"an array of shape {found.shape}", needed)
    return np.broadcast_to(found, (runs, size)).copy()
