"""Consensus whose links pull along the difference: (x_i - x_j)/|x_i - x_j| instead of signs.

It does not depend on the axes, and with constant signals implicit steps keep every closed convex
set C that holds all x_i: the nearest point of C to each part of a minimiser of

    1/2 |x - y|^2 + sum over links ij of c_ij |x_i - x_j|,    y_i in C,

is no farther from y_i, and no two of them are farther apart, because that map does not stretch; and
there is one minimiser. So matrices P_x stay positive semidefinite. Where signals move, x_i is no
farther from C than y_i, which is what the signal has moved.

Agreement is kept for moves |dr_i| <= h gamma if beta is at least gamma times the congestion bound
of a routing, the upper end of a certified bracket of the gain threshold: a routing is linear in
what it routes, so that it carries vectors as it carries numbers.

An explicit step keeps C while h beta (sum over the neighbours of 1/|x_i - x_j|) <= 1, because then
it is a convex combination. Nearer to agreement it leaves C by h beta times the degree at most.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import coo_array, csr_array

from sensortrack.errors import InputError
from sensortrack.networks import Network

from .stepper import METHODS, StepStatus

Floats = NDArray[np.float64]
SATURATED = 1e-15
TRIED = 8
"""Dual steps between looks for agreement."""


@dataclass(frozen=True, eq=False)
class IsotropicState:
    """What the agents hold, by node.

    Parameters
    ----------
    w, x : array (n, K)
        What each has added to its signal; its estimate of the mean.
    status : StepStatus
    flows : array (m, K) or None
        Flows of the last implicit step, from which the next one starts.
    """

    w: Floats
    x: Floats
    status: StepStatus
    flows: Floats | None = None


@dataclass(frozen=True, eq=False)
class IsotropicConsensus:
    """The consensus law with directions, block by block.

    Parameters
    ----------
    network : Network
        Weights multiply the gain link by link.
    beta : sequence of float
        Gain of each block, in units of the signal per s.
    sizes : sequence of int
        Components of each block.
    h : float
        Sampling period in s.
    method : str, optional
        ``implicit`` or ``explicit``.
    tolerance : float, optional
        Distance from the implicit step, relative to the size of the step's data, that is close
        enough; agreement is found exactly.
    iterations : int, optional
        Dual steps after which an implicit step ends in any case.

    Raises
    ------
    InputError
        A gain is negative or not finite, h is not positive, or there is no such method.
    """

    network: Network
    beta: Sequence[float]
    sizes: Sequence[int]
    h: float
    method: str = "implicit"
    tolerance: float = 1e-8
    iterations: int = 2000
    incidence: csr_array = field(init=False, repr=False)
    degrees: Floats = field(init=False, repr=False)
    weights: Floats = field(init=False, repr=False)
    inverse: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if not all(np.isfinite(b) and b >= 0 for b in self.beta):
            raise InputError("beta", f"{[*self.beta]}", "finite numbers of 0 or more are needed")
        if not (np.isfinite(self.h) and self.h > 0):
            raise InputError("h", f"{self.h}", "a sampling period above 0 s is needed")
        if self.method not in METHODS:
            raise InputError("method", repr(self.method), f"one of {', '.join(METHODS)} is needed")
        n, m = self.network.n, self.network.m
        rows, columns = np.asarray(self.network.edges).T.ravel(), np.tile(np.arange(m), 2)
        values = np.repeat([1.0, -1.0], m)
        made = csr_array(coo_array((values, (rows, columns)), shape=(n, m)))
        object.__setattr__(self, "incidence", made)
        object.__setattr__(self, "weights", self.network.float_weights())
        object.__setattr__(self, "degrees", np.bincount(rows, minlength=n).astype(float))
        object.__setattr__(self, "inverse", np.linalg.pinv((made @ made.T).toarray()))

    def init(self, r: ArrayLike, w: ArrayLike | None = None) -> IsotropicState:
        """State before the first step; the sum of w over the nodes is zero."""
        signal = np.array(r, dtype=float)
        start = np.zeros_like(signal) if w is None else np.array(w, dtype=float)
        return IsotropicState(start, start + signal, StepStatus(self.method))

    def step(
        self, state: IsotropicState, r_next: ArrayLike, active: ArrayLike | None = None
    ) -> IsotropicState:
        """State one sampling period later.

        Parameters
        ----------
        state : IsotropicState
            Is not changed.
        r_next : array (n, K)
            The signal at the end of the period, by node.
        active : array of bool, shape (m,), optional
            Which links carry in this period, in the order of the network's edges.
        """
        signal = np.asarray(r_next, dtype=float)
        carry = self.weights if active is None else self.weights * np.asarray(active, dtype=float)
        if self.method == "explicit":
            w = state.w - self.incidence @ np.hstack(self._pulls(state.x, carry))
            return IsotropicState(w, w + signal, StepStatus(self.method))
        flows = state.flows if state.flows is not None else np.zeros((len(carry), signal.shape[1]))
        found = [
            self._proximal(goal, self.h * beta * carry, flow)
            for goal, flow, beta in zip(
                self._blocks(state.w + signal), self._blocks(flows), self.beta, strict=True
            )
        ]
        x = np.hstack([part[0] for part in found])
        status = StepStatus(
            self.method,
            all(part[2] == 0 for part in found),
            float(np.sqrt(sum(part[2] ** 2 for part in found))),
            max(part[3] for part in found),
        )
        return IsotropicState(x - signal, x, status, np.hstack([part[1] for part in found]))

    def crowding(self, state: IsotropicState) -> float:
        """Largest h beta (sum over the neighbours of 1/|x_i - x_j|) of a node and a block.

        Up to 1 an explicit step from here is a convex combination of estimates, so that it keeps
        every convex set; infinite where two neighbours agree.
        """
        worst = 0.0
        for block, beta in zip(self._blocks(state.x), self.beta, strict=True):
            length = np.linalg.norm(self.incidence.T @ block, axis=1)
            with np.errstate(divide="ignore"):
                shares = self.h * beta * self.weights / length
            worst = max(worst, float((abs(self.incidence) @ shares).max(initial=0.0)))
        return worst

    def _blocks(self, rows: Floats) -> list[Floats]:
        return np.split(rows, np.cumsum(self.sizes)[:-1], axis=1)

    def _pulls(self, x: Floats, carry: Floats) -> list[Floats]:
        """h beta times the direction of each link's difference, 0 between equal estimates."""
        made = []
        for block, beta in zip(self._blocks(x), self.beta, strict=True):
            apart = self.incidence.T @ block
            length = np.linalg.norm(apart, axis=1)
            share = np.divide(
                self.h * beta * carry, length, out=np.zeros_like(length), where=length > 0
            )
            made.append(share[:, None] * apart)
        return made

    def _proximal(
        self, y: Floats, capacity: Floats, start: Floats
    ) -> tuple[Floats, Floats, float, int]:
        """Minimiser of the law of the step, its flow, a bound of its error, and the dual steps.

        The dual is the shortest y - B f over flows of lengths up to c_ij, by accelerated
        projected steps. The square root of the duality gap bounds the distance from the minimiser.
        """
        b = self.incidence
        step = 0.5 / max(float(self.degrees.max()), 1.0)
        scale = float(np.abs(y - y.mean(axis=0)).max()) or 1.0
        flow = ahead = _shortened(start, capacity)
        momentum, done = 1.0, 0
        while True:
            agreed = self._agreed(y, flow, capacity)
            if agreed is not None:
                return *agreed, 0.0, done
            x = y - b @ flow
            error = float(np.sqrt(_gap(b.T @ x, flow, capacity)))
            if error <= self.tolerance * scale or done >= self.iterations:
                return x, flow, error, done
            for _ in range(TRIED):
                moved = _shortened(ahead + step * (b.T @ (y - b @ ahead)), capacity)
                if ((ahead - moved) * (moved - flow)).sum() > 0:
                    momentum = 1.0  # it points uphill: start again, which makes the rate linear
                heavier = (1 + np.sqrt(1 + 4 * momentum**2)) / 2
                ahead = moved + (momentum - 1) / heavier * (moved - flow)
                flow, momentum = moved, heavier
            done += TRIED

    def _agreed(self, y: Floats, flow: Floats, capacity: Floats) -> tuple[Floats, Floats] | None:
        """Agreement of each part that links join, if a feasible flow is that of now plus the least.

        The least flow is the shortest one for what the flow of now leaves.
        """
        b, inverse = self.incidence, self.inverse
        if not (capacity > 0).all():
            b = csr_array(b.multiply(capacity > 0))
            inverse = np.linalg.pinv((b @ b.T).toarray())
        means = y - b @ (b.T @ (inverse @ y))
        whole = flow + b.T @ (inverse @ (y - b @ flow - means))
        if (np.linalg.norm(whole, axis=1) > capacity).any():
            return None
        return np.asarray(means), np.asarray(whole)


def _gap(apart: Floats, flow: Floats, capacity: Floats) -> float:
    """Sum of c |d| - f d over the links, without the cancellation where f points along d.

    With u = d/|d| it is |d| (|c u - f|^2 + c^2 - |f|^2)/(2 c); a flow that was shortened to its
    capacity is as long as that but for rounding.
    """
    size, length = (np.linalg.norm(rows, axis=1) for rows in (apart, flow))
    used = (capacity > 0) & (size > 0)
    c, d, f = capacity[used], size[used], length[used]
    along = apart[used] / d[:, None]
    short = np.where(f < c * (1 - SATURATED), (c - f) * (c + f), 0.0)
    away = ((c[:, None] * along - flow[used]) ** 2).sum(axis=1)
    return float((d * (away + short) / (2 * c)).sum())


def _shortened(flow: Floats, capacity: Floats) -> Floats:
    """Each link's flow within its capacity."""
    size = np.linalg.norm(flow, axis=1)
    share = np.divide(capacity, size, out=np.ones_like(size), where=size > capacity)
    found: Floats = flow * share[:, None]
    return found
