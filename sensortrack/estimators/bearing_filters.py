"""Baselines that have all bearings in one place: least squares, and an extended Kalman filter.

References
----------
Y. Bar-Shalom, X. R. Li, T. Kirubarajan, *Estimation with Applications to Tracking and Navigation*
(2001), sections 6.2 and 10.3.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError

Floats = NDArray[np.float64]
SINGULAR = 1e-12
START_SPEED = 10.0
"""Standard deviation in m/s of a velocity of which nothing is known."""


def intersect(
    angles: ArrayLike, positions: ArrayLike, weights: ArrayLike | None = None, det_min: float = 1e-9
) -> Floats | None:
    """Point nearest to the lines of sight: the solution p* of the averaged equations.

    Parameters
    ----------
    angles : array (n,)
        Bearings in rad; NaN where there is none.
    positions : array (n, 2)
        Of the sensors, in m.
    weights : array (n,), optional
        Of the lines; equal by default.
    det_min : float, optional
        Determinant of the averaged h h', between 0 and 1/4, above which there is an answer.

    Returns
    -------
    array (2,) or None
        In m; None where the lines are parallel, or fewer than two.
    """
    angle, place = np.asarray(angles, dtype=float), np.asarray(positions, dtype=float)
    seen = np.isfinite(angle)
    if seen.sum() < 2:
        return None
    share = np.ones(len(angle)) if weights is None else np.asarray(weights, dtype=float)
    share = share[seen] / share[seen].sum()
    rows = np.stack([-np.sin(angle[seen]), np.cos(angle[seen])], axis=1)
    offsets = (rows * place[seen]).sum(axis=1)
    matrix = (rows * share[:, None]).T @ rows
    if not np.linalg.det(matrix) > det_min:
        return None
    found: Floats = np.linalg.solve(matrix, (rows * share[:, None]).T @ offsets)
    return found


@dataclass(frozen=True, eq=False)
class BearingKalmanState:
    """Mean (position in m, velocity in m/s; four numbers) and covariance (4, 4); None: not yet."""

    mean: Floats | None = None
    covariance: Floats | None = None

    @property
    def position(self) -> Floats:
        """In m; NaN before there is one."""
        return np.full(2, np.nan) if self.mean is None else self.mean[:2]

    @property
    def velocity(self) -> Floats:
        """In m/s; NaN before there is one."""
        return np.full(2, np.nan) if self.mean is None else self.mean[2:]


@dataclass(frozen=True, eq=False)
class BearingKalman:
    """Nearly constant velocity, seen by bearings; linearised at the prediction.

    Parameters
    ----------
    positions : array (n, 2)
        Of the sensors, in m.
    h : float
        Sampling period in s.
    acceleration : float
        Intensity of the white acceleration in m/s^2 per square root of Hz.
    sigma : float
        Standard deviation of a bearing in rad.

    Raises
    ------
    InputError
        A number is not above zero, or positions are not rows of two finite numbers.
    """

    positions: Floats
    h: float
    acceleration: float
    sigma: float

    def __post_init__(self) -> None:
        for name in ("h", "acceleration", "sigma"):
            value = getattr(self, name)
            if not (np.isfinite(value) and value > 0):
                raise InputError(name, f"{value}", "a number above 0 is needed")
        places = np.array(self.positions, dtype=float)
        if places.ndim != 2 or places.shape[1] != 2 or not np.isfinite(places).all():
            found = f"an array of shape {places.shape}"
            raise InputError("positions", found, "finite rows of two are needed")
        object.__setattr__(self, "positions", places)

    def step(self, state: BearingKalmanState, angles: ArrayLike) -> BearingKalmanState:
        """Predict and correct; before the first position, start where lines of sight meet.

        Parameters
        ----------
        state : BearingKalmanState
        angles : array (n,)
            Bearings in rad; NaN where there is none.
        """
        angle = np.asarray(angles, dtype=float)
        if state.mean is None or state.covariance is None:
            return self._started(angle)
        mean, covariance = self._predicted(state.mean, state.covariance)
        apart = mean[:2] - self.positions
        ranges = np.linalg.norm(apart, axis=1)
        used = np.isfinite(angle) & (ranges > 0)
        if not used.any():
            return BearingKalmanState(mean, covariance)
        apart, ranges = apart[used], ranges[used]
        slope = np.zeros((len(ranges), 4))
        slope[:, 0], slope[:, 1] = -apart[:, 1] / ranges**2, apart[:, 0] / ranges**2
        off = angle[used] - np.arctan2(apart[:, 1], apart[:, 0])
        innovation = (off + np.pi) % (2 * np.pi) - np.pi
        noise = self.sigma**2 * np.eye(len(ranges))
        gain = np.linalg.solve(slope @ covariance @ slope.T + noise, slope @ covariance).T
        keep = np.eye(4) - gain @ slope
        joseph = keep @ covariance @ keep.T + gain @ noise @ gain.T
        return BearingKalmanState(mean + gain @ innovation, joseph)

    def _started(self, angle: Floats) -> BearingKalmanState:
        place = intersect(angle, self.positions)
        if place is None:
            return BearingKalmanState()
        apart = place - self.positions[np.isfinite(angle)]
        squares = (apart**2).sum(axis=1)
        apart, squares = apart[squares > 0], squares[squares > 0]
        across = np.stack([-apart[:, 1], apart[:, 0]], axis=1) / squares[:, None]
        information = across.T @ across
        trace = np.trace(information)
        if not np.linalg.det(information) > SINGULAR * trace**2:
            return BearingKalmanState()
        covariance = np.zeros((4, 4))
        covariance[:2, :2] = self.sigma**2 * np.linalg.inv(information)
        covariance[2:, 2:] = START_SPEED**2 * np.eye(2)
        return BearingKalmanState(np.concatenate([place, np.zeros(2)]), covariance)

    def _predicted(self, mean: Floats, covariance: Floats) -> tuple[Floats, Floats]:
        h, one = self.h, np.eye(2)
        move = np.kron([[1.0, h], [0.0, 1.0]], one)
        spread = np.kron([[h**3 / 3, h**2 / 2], [h**2 / 2, h]], one)
        return move @ mean, move @ covariance @ move.T + self.acceleration**2 * spread
