"""What one agent computes from its neighbours' messages; it knows nothing else of the network.

Three protocols: explicit steps, explicit steps that survive lost messages, and the dual steps that
an implicit step is made of. Agents are frozen values; their states go in and come out.

References
----------
J. George, *Distributed tracking of maneuvering target: a finite-time algorithm*, Algorithm 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sensortrack.errors import InputError

from .stepper import SignConsensus

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class NodeState:
    """What an agent holds.

    Parameters
    ----------
    w, x : ndarray of float64, shape (K,)
        What it has added to its signal, and its estimate of the mean.
    """

    w: Floats
    x: Floats


@dataclass(frozen=True, eq=False)
class LinkState:
    """What an agent holds that keeps account of each of its links.

    Parameters
    ----------
    sent : mapping of str to ndarray of float64, shape (K,)
        What it has handed to each neighbour in all; its w is minus the sum.
    x : ndarray of float64, shape (K,)
        Its estimate of the mean.
    """

    sent: Mapping[str, Floats]
    x: Floats


@dataclass(frozen=True, eq=False)
class DualState:
    """An agent within an implicit step.

    Parameters
    ----------
    w, y : ndarray of float64, shape (K,)
        w before the step, and w plus the new signal.
    flow, former : mapping of str to ndarray of float64, shape (K,)
        What it hands to each neighbour, and what it would have one dual step ago.
    momentum, factor : float
        Of the extrapolation; the same for all agents, for it depends on the number of steps only.
    """

    w: Floats
    y: Floats
    flow: Mapping[str, Floats]
    former: Mapping[str, Floats]
    momentum: float = 1.0
    factor: float = 0.0


@dataclass(frozen=True, eq=False)
class SignNode:
    """One agent.

    Parameters
    ----------
    name : str
    gain : ndarray of float64, shape (K,)
        h beta, in units of the signal.
    weights : mapping of str to float
        Of the links to its neighbours.
    owned : frozenset of str
        Neighbours whose common account is kept by this agent, not by them.
    pace : mapping of str to float
        One over the links that meet at either end of the link to a neighbour.
    """

    name: str
    gain: Floats
    weights: Mapping[str, float]
    owned: frozenset[str]
    pace: Mapping[str, float]

    def init(self, r: ArrayLike) -> NodeState:
        """State before the first step: w = 0.

        Raises
        ------
        InputError
            With the name ``r``: not as many finite numbers as components.
        """
        return NodeState(np.zeros_like(self.gain), self._vector("r", r))

    def step(self, own: NodeState, inbox: Mapping[str, ArrayLike], r_next: ArrayLike) -> NodeState:
        """One explicit step: w+ = w - h beta sum_j a_j sgn(x - x_j), x+ = w+ + r+.

        Parameters
        ----------
        own : NodeState
        inbox : mapping of str to array (K,)
            x of the neighbours that are heard; of others nothing is learnt.
        r_next : array (K,)
            The agent's next signal.

        Raises
        ------
        InputError
            With the name ``inbox`` or ``r``: a message of one that is no neighbour, or not as many
            finite numbers as components.
        """
        sums = np.zeros_like(self.gain)
        for other, x in self._heard(inbox).items():
            sums = sums + self.weights[other] * np.sign(own.x - x)
        w = own.w - self.gain * sums
        return NodeState(w, w + self._vector("r", r_next))

    def init_links(self, r: ArrayLike) -> LinkState:
        """State before the first step of the protocol that survives lost messages.

        Raises
        ------
        InputError
            As `init` does.
        """
        none = {other: np.zeros_like(self.gain) for other in self.weights}
        return LinkState(none, self._vector("r", r))

    def step_links(
        self,
        own: LinkState,
        inbox: Mapping[str, tuple[ArrayLike, ArrayLike]],
        r_next: ArrayLike,
    ) -> LinkState:
        """One explicit step with accounts: without loss the same as `step` up to rounding.

        Parameters
        ----------
        own : LinkState
        inbox : mapping of str to (array (K,), array (K,))
            x of the neighbours that are heard, and what they have handed to this agent in all.
        r_next : array (K,)
            The agent's next signal.

        Raises
        ------
        InputError
            As `step` does.

        Notes
        -----
        One end of each link keeps the account, and the other end takes it over with each message. A
        message that only one end has received leaves the two apart, by one step at most, and the
        next one that arrives mends it. Had they exchanged steps only, the mean would stay wrong.
        """
        sent = dict(own.sent)
        heard = self._heard({other: x for other, (x, _) in inbox.items()})
        for other, x in heard.items():
            step = self.gain * self.weights[other] * np.sign(own.x - x)
            if other in self.owned:
                sent[other] = sent[other] + step
            else:
                sent[other] = step - self._vector("inbox", inbox[other][1])
        w = -_sum(sent.values(), self.gain)
        return LinkState(sent, w + self._vector("r", r_next))

    def begin(
        self, own: NodeState, r_next: ArrayLike, flow: Mapping[str, Floats] | None = None
    ) -> DualState:
        """Begin an implicit step, from the flow of the last one if it is given.

        Raises
        ------
        InputError
            As `init` does.
        """
        start = {
            other: np.zeros_like(self.gain)
            if flow is None
            else np.clip(flow[other], -self.gain * weight, self.gain * weight)
            for other, weight in self.weights.items()
        }
        return DualState(own.w, own.w + self._vector("r", r_next), start, start)

    def message(self, state: DualState) -> Floats:
        """What each neighbour is told in a dual step: y less all that is handed out."""
        return state.y - _sum((_ahead(state, other) for other in self.weights), self.gain)

    def ascend(self, state: DualState, inbox: Mapping[str, ArrayLike]) -> DualState:
        """One dual step; both ends of a link find the same flow, with opposite signs.

        Parameters
        ----------
        state : DualState
        inbox : mapping of str to array (K,)
            `message` of the neighbours. All of them have to be heard.

        Raises
        ------
        InputError
            With the name ``inbox``: a neighbour is missing, or as `step` does.
        """
        heard = self._heard(inbox)
        missing = [other for other in self.weights if other not in heard]
        if missing:
            raise InputError("inbox", f"nothing of {missing[0]!r}", "every neighbour is needed")
        own, flow = self.message(state), {}
        for other, x in heard.items():
            goal = _ahead(state, other) + self.pace[other] * (own - x)
            most = self.gain * self.weights[other]
            flow[other] = np.clip(goal, -most, most)
        later = (1 + np.sqrt(1 + 4 * state.momentum**2)) / 2
        factor = (state.momentum - 1) / later
        return replace(
            state, flow=flow, former=state.flow, momentum=float(later), factor=float(factor)
        )

    def finish(self, state: DualState) -> NodeState:
        """End an implicit step: w+ = w - what is handed out, so that no sum changes."""
        handed = _sum(state.flow.values(), self.gain)
        return NodeState(state.w - handed, state.y - handed)

    def _heard(self, inbox: Mapping[str, ArrayLike]) -> dict[str, Floats]:
        """Messages in the order of the neighbours."""
        strange = [other for other in inbox if other not in self.weights]
        if strange:
            found = f"a message of {strange[0]!r} to {self.name!r}"
            raise InputError("inbox", found, "messages of neighbours only are needed")
        return {
            other: self._vector("inbox", inbox[other]) for other in self.weights if other in inbox
        }

    def _vector(self, name: str, given: ArrayLike) -> Floats:
        found = np.asarray(given, dtype=np.float64)
        if found.shape != self.gain.shape or not np.isfinite(found).all():
            needed = f"{len(self.gain)} finite numbers are needed"
            raise InputError(name, f"{found.tolist()} at {self.name!r}", needed)
        return found


def nodes_of(law: SignConsensus, width: int) -> dict[str, SignNode]:
    """The agents of a network, by name.

    Parameters
    ----------
    law : SignConsensus
    width : int
        Number of components K.

    Raises
    ------
    InputError
        With the name ``beta``: there is a gain for each of another number of components.
    """
    if len(law.gains) not in (1, width):
        needed = f"one, or {width}, are needed"
        raise InputError("beta", f"{len(law.gains)} gains", needed)
    gain = law.h * np.broadcast_to(law.gains, (width,))
    names, near = law.network.names, _neighbours(law)
    return {
        names[i]: SignNode(
            names[i],
            gain,
            {names[j]: weight for j, weight in others},
            frozenset(names[j] for j, _ in others if j > i),
            {names[j]: 1 / (len(others) + len(near[j])) for j, _ in others},
        )
        for i, others in enumerate(near)
    }


def _neighbours(law: SignConsensus) -> list[list[tuple[int, float]]]:
    """Neighbours of each node and the weights of the links, increasing."""
    network = law.network
    near: list[list[tuple[int, float]]] = [[] for _ in range(network.n)]
    weights = network.float_weights().tolist()
    for (i, j), weight in zip(network.edges.tolist(), weights, strict=True):
        near[i].append((j, weight))
        near[j].append((i, weight))
    return [sorted(others) for others in near]


def _ahead(state: DualState, other: str) -> Floats:
    flow = state.flow[other]
    return flow + state.factor * (flow - state.former[other])


def _sum(parts: Iterable[Floats], like: Floats) -> Floats:
    total = np.zeros_like(like)
    for part in parts:
        total = total + part
    return total
