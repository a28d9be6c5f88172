"""What noise of the bearings does to the position, in closed form.

A bearing that is off by d gives z = h'p + rho sin d, h being the measured direction, exactly; so
the least-squares position is off by Pbar^-1 (1/n) sum h rho sin d.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError

Floats = NDArray[np.float64]
DET_MIN = 1e-12


def covariance(positions: ArrayLike, target: ArrayLike, sigma: float) -> Floats:
    """Covariance of the position from bearings of one time, to first order in the noise.

    Parameters
    ----------
    positions : array (n, 2)
        Of the sensors, in m.
    target : array (2,)
        In m.
    sigma : float
        Standard deviation of each bearing in rad.

    Returns
    -------
    array (2, 2)
        sigma^2 Pbar^-1 (sum of rho^2 h h') Pbar^-1 / n^2, in m^2.

    Raises
    ------
    InputError
        The target sits on a sensor, or on one line with all of them, or sigma is negative.
    """
    ranges, outer = _geometry(positions, target, sigma)
    inverse = np.linalg.inv(outer.mean(axis=0))
    noise = (ranges[:, None, None] ** 2 * outer).sum(axis=0)
    found: Floats = sigma**2 * inverse @ noise @ inverse / len(ranges) ** 2
    return found


def limit_bias(positions: ArrayLike, target: ArrayLike, sigma: float) -> Floats:
    """What is left of the error after averaging P and q over many samples, exactly.

    Parameters, errors are those of `covariance`; the noise is Gaussian.

    Returns
    -------
    array (2,)
        -a (a I + (1 - 2a) Pbar)^-1 (p - mean s) in m, a = (1 - exp(-2 sigma^2))/2.
    """
    _, outer = _geometry(positions, target, sigma)
    a = -np.expm1(-2 * sigma**2) / 2
    away = np.asarray(target, dtype=float) - np.asarray(positions, dtype=float).mean(axis=0)
    found: Floats = -a * np.linalg.solve(a * np.eye(2) + (1 - 2 * a) * outer.mean(axis=0), away)
    return found


def cramer_rao(positions: ArrayLike, target: ArrayLike, sigma: float) -> Floats:
    """Smallest covariance of an unbiased position: sigma^2 (sum of h h'/rho^2)^-1, in m^2.

    Parameters, errors are those of `covariance`; the noise is Gaussian.
    """
    ranges, outer = _geometry(positions, target, sigma)
    found: Floats = sigma**2 * np.linalg.inv((outer / ranges[:, None, None] ** 2).sum(axis=0))
    return found


def _geometry(positions: ArrayLike, target: ArrayLike, sigma: float) -> tuple[Floats, Floats]:
    """Distances of the target from the sensors, and h h' of each."""
    apart = np.asarray(target, dtype=float) - np.asarray(positions, dtype=float)
    if apart.ndim != 2 or apart.shape[1] != 2 or not len(apart) or not np.isfinite(apart).all():
        raise InputError("positions", f"shape {apart.shape}", "finite rows of two are needed")
    if not (np.isfinite(sigma) and sigma >= 0):
        raise InputError("sigma", f"{sigma}", "a number of 0 or more is needed")
    ranges = np.linalg.norm(apart, axis=1)
    if not (ranges > 0).all():
        raise InputError("target", "it sits on a sensor", "a distance above 0 is needed")
    rows = np.stack([-apart[:, 1], apart[:, 0]], axis=1) / ranges[:, None]
    outer = rows[:, :, None] * rows[:, None, :]
    if not np.linalg.det(outer.mean(axis=0)) > DET_MIN:
        found = "it lies on one line with all sensors"
        raise InputError("target", found, "bearings that are not all parallel are needed")
    return ranges, outer
