"""Kalman filter of a target with nearly constant velocity: the baseline of position and velocity.

References
----------
Y. Bar-Shalom, X. R. Li, T. Kirubarajan, *Estimation with Applications to Tracking and Navigation*
(2001), section 6.2: white noise acceleration in discrete time.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.sensors import Average

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class KalmanState:
    """Mean and covariance, the same for each coordinate.

    Parameters
    ----------
    mean : array (2, 3)
        Position in m and velocity in m/s.
    covariance : array (2, 2)
        Of position and velocity of one coordinate.
    """

    mean: Floats
    covariance: Floats


def constant_velocity(h: float, acceleration: float) -> tuple[Floats, Floats]:
    """Transition and process noise of position and velocity of one coordinate over a period.

    Parameters
    ----------
    h : float
        In s.
    acceleration : float
        Intensity of the white acceleration in m/s^2 per square root of Hz.
    """
    move = np.array([[1.0, h], [0.0, 1.0]])
    return move, acceleration**2 * np.array([[h**3 / 3, h**2 / 2], [h**2 / 2, h]])


@dataclass(frozen=True)
class Kalman:
    """Filter on the weighted mean of the measurements.

    Parameters
    ----------
    h : float
        Sampling period in s.
    acceleration : float
        Intensity of the white acceleration in m/s^2 per square root of Hz.
    position_sigma, velocity_sigma : float
        Standard deviation of the mean's position in m and velocity in m/s.

    Raises
    ------
    InputError
        A parameter is not above zero.
    """

    h: float
    acceleration: float
    position_sigma: float
    velocity_sigma: float

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not (np.isfinite(value) and value > 0):
                raise InputError(name, f"{value}", "a number above 0 is needed")

    @property
    def noise(self) -> Floats:
        """Covariance of the measured mean."""
        return np.diag([self.position_sigma**2, self.velocity_sigma**2])

    def init(self, seen: Average) -> KalmanState:
        """Start from the first measurement.

        Raises
        ------
        InputError
            No sensor sees the target.
        """
        if seen.position is None or seen.velocity is None:
            raise InputError("measurement", "no sensor sees the target", "one is needed to start")
        return KalmanState(np.stack([seen.position, seen.velocity]), self.noise)

    def step(self, state: KalmanState, seen: Average) -> KalmanState:
        """Predict, and correct if a sensor sees the target (Joseph form)."""
        move, spread = constant_velocity(self.h, self.acceleration)
        mean, covariance = move @ state.mean, move @ state.covariance @ move.T + spread
        if seen.position is None or seen.velocity is None:
            return KalmanState(mean, covariance)
        gain = np.linalg.solve(covariance + self.noise, covariance).T
        mean = mean + gain @ (np.stack([seen.position, seen.velocity]) - mean)
        keep = np.eye(2) - gain
        return KalmanState(mean, keep @ covariance @ keep.T + gain @ self.noise @ gain.T)
