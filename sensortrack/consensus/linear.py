"""Linear dynamic average consensus: the baseline without signs.

References
----------
D. Spanos, R. Olfati-Saber, R. Murray, *Dynamic consensus on mobile networks* (2005).
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError
from sensortrack.networks import Network

from .stepper import StepStatus

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LinearState:
    """Internal states and estimates, each of shape (n, K), by node; every step is exact."""

    w: Floats
    x: Floats
    status: StepStatus


@dataclass(frozen=True, eq=False)
class LinearConsensus:
    """x+ = x - gain L x + r(t+h) - r(t), one round of messages a step.

    Parameters
    ----------
    network : Network
        Connected.
    gain : float, optional
        Below 2/lambda_max; by default 2/(lambda_2 + lambda_max), with which constant signals are
        agreed on fastest.

    Raises
    ------
    InputError
        The network is not connected, or the gain makes steps grow.
    """

    network: Network
    gain: float = 0.0
    edges: NDArray[np.int64] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        values = np.linalg.eigvalsh(self.network.laplacian().toarray())
        if self.network.n > 1 and not self.network.is_connected():
            raise InputError("graph", "not connected", "a connected network is needed")
        if not (np.isfinite(self.gain) and 0 <= self.gain * values[-1] < 2):
            needed = f"a number of 0 or more, below {2 / values[-1]:.6g}, is needed"
            raise InputError("gain", f"{self.gain}", needed)
        fastest = 2 / (values[1] + values[-1]) if self.network.n > 1 else 0.0
        object.__setattr__(self, "gain", float(self.gain or fastest))
        object.__setattr__(self, "edges", np.asarray(self.network.edges))

    def init(self, r: ArrayLike, w: ArrayLike | None = None) -> LinearState:
        """State before the first step; the sum of w over the nodes is zero."""
        rows = np.array(r, dtype=float)
        start = np.zeros_like(rows) if w is None else np.array(w, dtype=float)
        return LinearState(start, start + rows, StepStatus("linear"))

    def step(
        self, state: LinearState, r_next: ArrayLike, active: ArrayLike | None = None
    ) -> LinearState:
        """State one step later.

        Parameters
        ----------
        state : LinearState
            Is not changed.
        r_next : array (n, K)
            The signal at the end of the period, by node.
        active : array of bool, shape (m,), optional
            Which links carry, in the order of the network's edges.
        """
        first, second = self.edges.T
        apart = (state.x[first] - state.x[second]) * self.network.float_weights()[:, None]
        if active is not None:
            apart = apart * np.asarray(active, dtype=float)[:, None]
        pull = np.zeros_like(state.w)
        np.add.at(pull, first, apart)
        np.subtract.at(pull, second, apart)
        w = state.w - self.gain * pull
        return LinearState(w, w + np.asarray(r_next, dtype=float), state.status)
