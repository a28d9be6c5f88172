"""Sign-based dynamic average consensus on a network, in explicit and in implicit steps.

Agent i holds w_i and sees a signal r_i(t). Its estimate x_i = w_i + r_i of the signals' mean
follows from w' = -beta B sgn(B'x), the sum of w being zero.

References
----------
J. George, *Distributed tracking of maneuvering target: a finite-time algorithm*, the consensus law;
V. Acary, B. Brogliato, *Implicit Euler numerical scheme and chattering-free implementation of
sliding mode systems* (2010).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError
from sensortrack.kernels.consensus import sign_step
from sensortrack.kernels.links import Links, checked_active, links_of
from sensortrack.networks import Network

from .chatter import chatter_bound
from .proximal import proximal

Floats = NDArray[np.float64]
METHODS = ("implicit", "explicit")
UNBALANCED = 1e-9
"""Largest sum of w, relative to the sum of its absolute values, that passes for zero."""


@dataclass(frozen=True)
class StepStatus:
    """How a step was found.

    Parameters
    ----------
    method : str
        ``implicit`` or ``explicit``.
    exact : bool
        The law of the step holds up to rounding.
    error : float
        Bound of the Euclidean distance of x, all components together, from the exact step: 0 if
        `exact`.
    iterations : int
        Dual steps taken for the worst component.
    """

    method: str
    exact: bool = True
    error: float = 0.0
    iterations: int = 0

    def __str__(self) -> str:
        return "exact" if self.exact else f"within {self.error:.3g}"


@dataclass(frozen=True, eq=False)
class ConsensusState:
    """What the agents hold; made by `SignConsensus`.

    Parameters
    ----------
    links : Links
        The network's layout, to whose places the rows belong.
    w_rows, x_rows : ndarray of float64, shape (n, K)
        By place.
    status : StepStatus
    flows : ndarray of float64, shape (K, m), or None
        Flows of the last implicit step, from which the next one starts.
    """

    links: Links
    w_rows: Floats
    x_rows: Floats
    status: StepStatus
    flows: Floats | None = None

    @cached_property
    def w(self) -> Floats:
        """What each agent has added to its signal, shape (n, K), by node."""
        return self.links.unpacked(self.w_rows)

    @cached_property
    def x(self) -> Floats:
        """Each agent's estimate of the mean of the signals, shape (n, K), by node."""
        return self.links.unpacked(self.x_rows)


@dataclass(frozen=True, eq=False)
class SignConsensus:
    """The consensus law on a network.

    Parameters
    ----------
    network : Network
        Connected or not: each component agrees on its own mean.
    beta : float or array (K,)
        Gain, in units of the signal per s; one number or one for each component of the signal.
    h : float
        Sampling period in s.
    method : str, optional
        ``implicit``: x+ minimises 1/2 |x - y|^2 + h beta |B'x|_1 with y = w + r(t+h); no
        chattering, and agreement is kept exactly if beta is above the threshold of the network.
        One such step takes many rounds of messages. ``explicit``: w+ = w - h beta B sgn(B'x); one
        round of messages, and x chatters, see `chatter`.
    tolerance : float, optional
        Distance from the exact implicit step, in units of the signal, that is close enough where
        none that is exact up to rounding was found.
    iterations : int, optional
        Dual steps after which an implicit step ends in any case; its status says how close it is.

    Raises
    ------
    InputError
        A number is negative or not finite, or there is no such method.
    """

    network: Network
    beta: float | Floats
    h: float
    method: str = "implicit"
    tolerance: float = 1e-9
    iterations: int = 10_000
    gains: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        gains = np.atleast_1d(np.asarray(self.beta, dtype=np.float64))
        if gains.ndim != 1 or not (np.isfinite(gains).all() and (gains >= 0).all()):
            needed = "one finite number of 0 or more, or one for each component, is needed"
            raise InputError("beta", f"{self.beta}", needed)
        if not (np.isfinite(self.h) and self.h > 0):
            raise InputError("h", f"{self.h}", "a sampling period above 0 s is needed")
        if self.method not in METHODS:
            raise InputError("method", repr(self.method), f"one of {', '.join(METHODS)} is needed")
        if not (np.isfinite(self.tolerance) and self.tolerance >= 0):
            raise InputError("tolerance", f"{self.tolerance}", "a number of 0 or more is needed")
        if self.iterations < 1 or int(self.iterations) != self.iterations:
            raise InputError("iterations", f"{self.iterations}", "a whole number above 0 is needed")
        object.__setattr__(self, "gains", gains)

    @property
    def links(self) -> Links:
        """The network's layout."""
        return links_of(self.network)

    @property
    def jump(self) -> Floats:
        """How far one explicit step moves an agent at most, shape (K,): h beta times its degree."""
        found: Floats = self.h * self.gains * self.links.degree.max()
        return found

    @property
    def chatter(self) -> Floats:
        """Norm of the disagreement that explicit steps may keep for ever, shape (K,).

        It is a bound, from the degrees, for constant signals; 0 for implicit steps. For signals
        that change, and sharper where more is known of the network, see `chatter_bound`.
        """
        if self.method == "implicit":
            return np.zeros_like(self.gains)
        return chatter_bound(self.links, self.gains, self.h)

    def init(self, r: ArrayLike, w: ArrayLike | None = None) -> ConsensusState:
        """State before the first step.

        Parameters
        ----------
        r : array (n, K)
            The first signal, by node.
        w : array (n, K), optional
            Zero by default. Its sum over the nodes must be zero, else all would agree on the mean
            of r plus the mean of w for ever.

        Raises
        ------
        InputError
            With the name ``r`` or ``w``: another shape, a number that is not finite, a sum of w
            that is not zero.
        """
        signal = self._signal("r", r)
        start = np.zeros_like(signal) if w is None else self._signal("w", w)
        if start.shape != signal.shape:
            raise InputError(
                "w", f"shape {start.shape}", f"the shape {signal.shape} of r is needed"
            )
        sums = start.sum(axis=0)
        if (np.abs(sums) > UNBALANCED * np.abs(start).sum(axis=0)).any():
            cure = "hand the w of an agent that leaves to one that stays; one that joins has w = 0"
            raise InputError("w", f"its sum is {sums}", "the sum zero is needed", cure)
        return self._state(self.links, start, start + signal, StepStatus(self.method))

    def step(
        self,
        state: ConsensusState,
        r_next: ArrayLike,
        network: Network | None = None,
        active: ArrayLike | None = None,
    ) -> ConsensusState:
        """State one sampling period later.

        Parameters
        ----------
        state : ConsensusState
            Is not changed.
        r_next : array (n, K)
            The signal at the end of the period, by node.
        network : Network, optional
            The links of this period instead of the usual ones, between the same nodes.
        active : array of bool, shape (m,) or, for explicit steps, (m, 2), optional
            Which links carry in this period, in the order of the network's edges; two columns say
            whether the first and whether the second end of an edge hears the other. A link heard
            one way only moves the mean for ever.

        Returns
        -------
        ConsensusState

        Raises
        ------
        InputError
            With the name ``r``, ``graph`` or ``active``: another shape, a number that is not
            finite, another number of nodes.
        """
        links = self.links if network is None else self._other(network)
        heard = checked_active(active, links.m, 1 if self.method == "implicit" else 2)
        signal = self._signal("r", r_next)
        if signal.shape != state.x_rows.shape:
            found = f"shape {signal.shape}"
            raise InputError("r", found, f"the shape {state.x_rows.shape} of the state is needed")
        if state.links is not links:
            w, x = links.packed(state.w), links.packed(state.x)
            state = ConsensusState(links, w, x, state.status)
        gain = self.h * np.broadcast_to(self.gains, signal.shape[1:])
        if self.method == "explicit":
            weights = links.entry_weights(heard)
            rows = sign_step(links, state.x_rows, state.w_rows, signal, gain, weights)
            return ConsensusState(links, *rows, StepStatus(self.method))
        return self._implicit(state, links.packed(signal), gain, links.link_weights(heard))

    def _implicit(
        self, state: ConsensusState, signal: Floats, gain: Floats, weights: Floats
    ) -> ConsensusState:
        links = state.links
        goal = np.ascontiguousarray((state.w_rows + signal).T)
        share = self.tolerance / float(np.sqrt(len(gain)))
        capacity = gain[:, None] * weights
        found = proximal(links, goal, capacity, state.flows, share, self.iterations)
        error = float(np.linalg.norm(found.error))
        status = StepStatus(self.method, error == 0, error, found.iterations)
        x = np.ascontiguousarray(found.x.T)
        return ConsensusState(links, x - signal, x, status, found.flow)

    def _state(self, links: Links, w: Floats, x: Floats, status: StepStatus) -> ConsensusState:
        return ConsensusState(links, links.packed(w), links.packed(x), status)

    def _other(self, network: Network) -> Links:
        if network.n != self.network.n:
            found = f"{network.n} nodes"
            raise InputError("graph", found, f"the {self.network.n} nodes of the start are needed")
        return links_of(network)

    def _signal(self, name: str, given: ArrayLike) -> Floats:
        rows = np.ascontiguousarray(given, dtype=np.float64)
        n, width = self.network.n, len(self.gains)
        if rows.ndim != 2 or len(rows) != n or rows.shape[1] < 1:
            raise InputError(name, f"shape {rows.shape}", f"a row for each of {n} nodes is needed")
        if width > 1 and rows.shape[1] != width:
            found = f"{rows.shape[1]} components"
            raise InputError(name, found, f"{width} are needed, one for each gain")
        if not np.isfinite(rows).all():
            place = int(np.flatnonzero(~np.isfinite(rows).all(axis=1))[0])
            found = f"{rows[place].tolist()} at node {self.network.names[place]!r}"
            raise InputError(name, found, "finite numbers are needed")
        return rows
