"""The variational estimator of a target's position and velocity.

References
----------
A. Sanyal, H. Eslamiat, *Target Localization Using Mobile Sensors and a Decentralized and
Distributed Variational Estimator*, (20) and (24).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError
from sensortrack.kernels.steppers import stepper
from sensortrack.sensors import Average, View, average, checked_weights, vector

Floats = NDArray[np.float64]
SCHEMES = {"printed": "step", "leapfrog": "leapfrog_step"}
ON_TIME = 1e-6
LONGEST_DELAY = 100


@dataclass(frozen=True, eq=False)
class VariationalState:
    """What the estimator carries from sample to sample; inertial frame.

    Parameters
    ----------
    time : float
        In s.
    position, velocity : array (3,)
        Estimates of the target's position in m and velocity in m/s.
    error_rate : array (3,)
        u, the internal velocity error in m/s.
    past : tuple of (array (3,), array (3,))
        Estimated and measured mean position of earlier samples, as long as the delay.
    notes : tuple of str
        What was remarkable in the last step: measurements skipped, nobody sees the target.
    """

    time: float
    position: Floats
    velocity: Floats
    error_rate: Floats
    past: tuple[tuple[Floats, Floats], ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def flat(self) -> Floats:
        """The nine numbers of the generated source's state."""
        return np.concatenate([self.position, self.velocity, self.error_rate])


@dataclass(frozen=True, eq=False)
class Variational:
    """The estimator (24), or its second-order form.

    Parameters
    ----------
    M, K, C : float or array (3, 3)
        Gains in kg, kg/s^2 and kg/s, symmetric positive definite; a number is that multiple of the
        identity.
    h : float
        Sampling period in s.
    weights : mapping of str to float
        Of all sensors, positive, of sum one.
    scheme : str, optional
        ``printed`` or ``leapfrog``.
    delay : int, optional
        Samples by which measured positions are late, the hops of the relay; velocities are not.

    Raises
    ------
    InputError
        A gain is not symmetric positive definite, h is not positive, weights do not sum to one, or
        a name or number is out of its range.
    """

    M: Floats | float
    K: Floats | float
    C: Floats | float
    h: float
    weights: Mapping[str, float]
    scheme: str = "printed"
    delay: int = 0
    context: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        gains = {name: _gain(name, getattr(self, name)) for name in "MKC"}
        if not (np.isfinite(self.h) and self.h > 0):
            raise InputError("h", f"{self.h}", "a sampling period above 0 s is needed")
        if self.scheme not in SCHEMES:
            raise InputError("scheme", repr(self.scheme), f"one of {', '.join(SCHEMES)} is needed")
        if not 0 <= self.delay <= LONGEST_DELAY or int(self.delay) != self.delay:
            needed = f"a whole number of samples from 0 to {LONGEST_DELAY} is needed"
            raise InputError("delay", f"{self.delay}", needed)
        upper = np.triu_indices(3)
        flat = np.concatenate([*(gains[name][upper] for name in "MKC"), [self.h]])
        for name, value in (*gains.items(), ("weights", checked_weights(self.weights))):
            object.__setattr__(self, name, value)
        object.__setattr__(self, "context", flat)

    def init(
        self,
        views: Sequence[View],
        time: float = 0.0,
        position: ArrayLike | None = None,
        error_rate: ArrayLike = (0.0, 0.0, 0.0),
    ) -> VariationalState:
        """State before the first step.

        Parameters
        ----------
        views : sequence of View
            The first measurement; at least one sensor sees the target.
        time : float, optional
            In s.
        position : array (3,), optional
            First estimate in m; the mean of the measured positions by default.
        error_rate : array (3,), optional
            First internal velocity error in m/s.

        Raises
        ------
        InputError
            No sensor sees the target, or a vector has not three numbers.
        """
        seen = average(views, self.weights)
        if seen.position is None or seen.velocity is None:
            needed = "one finite measurement is needed to start"
            raise InputError("measurement", "no sensor sees the target", needed)
        first = seen.position if position is None else vector("position", position)
        start = np.concatenate([first, vector("error_rate", error_rate)])
        given = np.concatenate([seen.position, seen.velocity])
        flat = stepper("variational").call("init", start, given)
        past = ((first, seen.position),) * self.delay
        return VariationalState(time, flat[:3], flat[3:6], flat[6:], past, _notes(seen))

    def step(self, t: float, state: VariationalState, views: Sequence[View]) -> VariationalState:
        """State one sample later.

        Parameters
        ----------
        t : float
            Time of the new sample in s: one sampling period after the state's.
        state : VariationalState
            Is not changed.
        views : sequence of View
            The new measurement. Where no sensor sees the target, the estimate moves on with its
            velocity and a note says so.

        Raises
        ------
        InputError
            The measurement is out of order or off the sampling grid; a sensor is unknown or
            reports twice.
        """
        self._on_time(t, state)
        seen = average(views, self.weights)
        if seen.position is None or seen.velocity is None:
            moved = state.position + self.h * state.velocity
            notes = (*_notes(seen), "no sensor sees the target: moved on with its velocity")
            return replace(state, time=t, position=moved, notes=notes)
        measured, past = self._late(state, seen.position, seen.velocity)
        given = np.concatenate([measured, seen.velocity])
        flat = stepper("variational").call(SCHEMES[self.scheme], self.context, state.flat, given)
        return VariationalState(t, flat[:3], flat[3:6], flat[6:], past, _notes(seen))

    def replay(self, state: VariationalState, inputs: Floats) -> Floats:
        """Many samples at once, all on time and seen: the states after each.

        Parameters
        ----------
        state : VariationalState
        inputs : array (samples, 6)
            Mean measured position in m and velocity in m/s.

        Returns
        -------
        array (samples, 9)
            Position, velocity, internal velocity error.

        Raises
        ------
        InputError
            With the name ``inputs`` or ``scheme``: an input is not finite, or the form is not the
            printed one without delay.
        """
        if self.scheme != "printed" or self.delay:
            found = f"{self.scheme} with delay {self.delay}"
            raise InputError("scheme", found, "the printed form without delay is needed")
        given = np.asarray(inputs, dtype=float)
        if given.ndim != 2 or given.shape[1] != 6 or not np.isfinite(given).all():
            raise InputError("inputs", f"shape {given.shape}", "finite rows of six are needed")
        return stepper("variational").run(self.context, state.flat, given)

    def _on_time(self, t: float, state: VariationalState) -> None:
        late = t - state.time - self.h
        if t <= state.time:
            found = f"{t} s after {state.time} s"
            raise InputError("t", found, "measurements in order of time are needed")
        if abs(late) > ON_TIME * self.h:
            needed = f"{state.time + self.h} s is needed, one sampling period later"
            raise InputError("t", f"{t} s", needed)

    def _late(
        self, state: VariationalState, measured: Floats, rate: Floats
    ) -> tuple[Floats, tuple[tuple[Floats, Floats], ...]]:
        """Mean position to use, and what is kept for later.

        A position error that is d samples old is used as it was: the measurement of then is moved
        by what the estimate has moved since.
        """
        if not self.delay:
            return measured, ()
        probe = np.concatenate([measured, rate])
        moved = stepper("variational").call("step", self.context, state.flat, probe)[:3]
        queue = (*state.past, (moved, measured))
        estimated, seen = queue[0]
        return seen + (moved - estimated), queue[1:]


def _gain(name: str, value: ArrayLike) -> Floats:
    found = np.array(value, dtype=float)
    found = float(found) * np.eye(3) if found.ndim == 0 else found
    if found.shape != (3, 3):
        raise InputError(name, f"an array of shape {found.shape}", "a number or 3 x 3 is needed")
    if not np.isfinite(found).all():
        raise InputError(name, "an entry that is not finite", "finite numbers are needed")
    if not np.array_equal(found, found.T):
        raise InputError(name, "not symmetric", "a symmetric positive definite matrix is needed")
    smallest = float(np.linalg.eigvalsh(found)[0])
    if smallest <= 0:
        needed = "a symmetric positive definite matrix is needed"
        raise InputError(name, f"not positive definite: eigenvalue {smallest:.4g}", needed)
    return found


def _notes(seen: Average) -> tuple[str, ...]:
    return tuple(f"measurement of {name} is not finite: skipped" for name in seen.skipped)
