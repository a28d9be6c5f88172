"""Kalman filters that are given measured positions with full covariances, many side by side.

References
----------
Y. Bar-Shalom, X. R. Li, T. Kirubarajan, *Estimation with Applications to Tracking and Navigation*
(2001), sections 6.2 and 10.4: white noise acceleration, converted measurements.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.arguments import numbers, positive
from sensortrack.errors import InputError

from .kalman import constant_velocity

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PositionKalmanState:
    """Means and covariances of any number of filters.

    Parameters
    ----------
    mean : array (..., 4)
        x, y in m, their velocities in m/s.
    covariance : array (..., 4, 4)
    """

    mean: Floats
    covariance: Floats


@dataclass(frozen=True)
class PositionKalman:
    """Filters of targets with nearly constant velocity in a plane, one a leading index.

    Parameters
    ----------
    h : float
        Sampling period in s.
    acceleration : float
        Intensity of the white acceleration in m/s^2 per square root of Hz.
    speed : float
        Standard deviation of each velocity before anything was measured, in m/s.

    Raises
    ------
    InputError
        A parameter is not above zero.
    """

    h: float
    acceleration: float
    speed: float

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            positive(name, value)

    def init(self, position: ArrayLike, noise: ArrayLike) -> PositionKalmanState:
        """Start from measured positions.

        Parameters
        ----------
        position : array (..., 2)
            In m; NaN where nothing is known yet, which starts with the first measurement.
        noise : array (..., 2, 2)
            Covariance in m^2.

        Raises
        ------
        InputError
            With the name ``position`` or ``noise``: a shape does not fit.
        """
        position, noise = _fitting(position, noise)
        mean = np.concatenate([position, np.where(np.isnan(position), np.nan, 0.0)], axis=-1)
        covariance = np.zeros((*position.shape[:-1], 4, 4))
        covariance[..., :2, :2] = noise
        covariance[..., 2, 2] = covariance[..., 3, 3] = self.speed**2
        return PositionKalmanState(mean, covariance)

    def step(
        self, state: PositionKalmanState, position: ArrayLike, noise: ArrayLike
    ) -> PositionKalmanState:
        """Predict, and correct where there is a measurement (Joseph form).

        Parameters
        ----------
        state : PositionKalmanState
        position : array (..., 2)
            In m; NaN where there is none.
        noise : array (..., 2, 2)
            Covariance in m^2.

        Raises
        ------
        InputError
            As `init`.
        """
        position, noise = _fitting(position, noise)
        move, spread = (
            np.kron(part, np.eye(2)) for part in constant_velocity(self.h, self.acceleration)
        )
        mean = state.mean @ move.T
        covariance = move @ state.covariance @ move.T + spread
        gain = np.swapaxes(
            np.linalg.solve(covariance[..., :2, :2] + noise, covariance[..., :2, :]), -1, -2
        )
        off = position - mean[..., :2]
        better = mean + (gain @ off[..., None])[..., 0]
        keep = np.eye(4) - np.concatenate([gain, np.zeros_like(gain)], axis=-1)
        shrunk = keep @ covariance @ np.swapaxes(keep, -1, -2) + gain @ noise @ np.swapaxes(
            gain, -1, -2
        )
        seen: NDArray[np.bool_] = np.asarray(np.isfinite(position).all(axis=-1))
        first = self.init(position, noise)
        fresh: NDArray[np.bool_] = np.asarray(seen & np.isnan(mean[..., 0]))
        mean = np.where(seen[..., None], better, mean)
        covariance = np.where(seen[..., None, None], shrunk, covariance)
        return PositionKalmanState(
            np.where(fresh[..., None], first.mean, mean),
            np.where(fresh[..., None, None], first.covariance, covariance),
        )


def _fitting(position: ArrayLike, noise: ArrayLike) -> tuple[Floats, Floats]:
    place, spread = numbers("position", position), numbers("noise", noise)
    if place.shape[-1:] != (2,):
        raise InputError("position", f"an array of shape {place.shape}", "(..., 2) is needed")
    if spread.shape != (*place.shape, 2):
        needed = f"{(*place.shape, 2)} is needed"
        raise InputError("noise", f"an array of shape {spread.shape}", needed)
    return place, spread
