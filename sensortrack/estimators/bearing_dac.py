"""Position of a target from bearings, by consensus of the sensors on what they see.

Every sensor turns its bearing into equations, P = h h' and q = P s, and the sensors agree on the
averages of P and q, so that each can solve for the target. The generated source says what one node
computes; here all nodes step together.

References
----------
J. George, *Distributed Tracking of Maneuvering Target: A Finite-Time Algorithm*, Algorithm 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike

from sensortrack.consensus import (
    ConsensusState,
    IsotropicConsensus,
    IsotropicState,
    LinearConsensus,
    LinearState,
    SignConsensus,
)
from sensortrack.errors import InputError
from sensortrack.generated import bearing_dac_numpy as generated
from sensortrack.networks import Network
from sensortrack.sensors import Bearing, once_each

from .bearing_state import BearingState, Flags, Floats, on_time, pair

SIGNS = ("componentwise", "isotropic", "linear")
Engine = SignConsensus | IsotropicConsensus | LinearConsensus
Held = ConsensusState | IsotropicState | LinearState
ENTRIES: Mapping[str, tuple[int, int]] = {"reduced": (2, 2), "printed": (4, 2)}
"""How many entries of P and of q are agreed on."""
MISSING = ("hold", "withdraw")
LARGEST_DET = 0.25
NO_INFORMATION = "no position: P_x is singular or not positive"


@dataclass(frozen=True, eq=False)
class BearingDac:
    """Algorithm 1 with a guarded inverse, in explicit or implicit steps.

    Parameters
    ----------
    network : Network
        Its nodes are the sensors.
    positions : mapping of str to array (2,)
        Of the sensors, in m.
    beta_P, beta_q : float
        Gains for the entries of P in 1/s and of q in m/s. The paper has one for both, which
        depends on the unit of length.
    h : float
        Sampling period in s.
    method : str, optional
        ``implicit``: agreement is exact and does not chatter, a step takes many rounds of
        messages. ``explicit``: one round a step, as the generated source of one node.
    sign : str, optional
        ``componentwise``, as printed, or ``isotropic``: the direction of the difference, with which
        implicit steps keep P_x positive semidefinite while the target rests, and explicit steps
        only while h beta (sum over the neighbours of 1/|x_i - x_j|) <= 1. ``linear`` is the
        baseline without signs: the difference itself, at the gain that agrees fastest.
    entries : str, optional
        ``reduced``: the first row of P and q, since P has the trace 1; ``printed``: all six.
    missing : str, optional
        A sensor without bearing goes on with its last (``hold``), or counts no longer
        (``withdraw``, for which all six entries are needed: the trace tells how many count).
    det_min : float, optional
        det P_x, at trace 1, above which a position is computed: below 1/4, which is that of
        bearings in all directions. The error of a position grows as its inverse.
    origin : array (2,), optional
        In m; q is taken about this point. Near the sensors, small gains do.

    Raises
    ------
    InputError
        A sensor has no position or one that is not finite, a position belongs to no sensor, a
        number is out of its range, or a name is unknown.
    """

    network: Network
    positions: Mapping[str, ArrayLike]
    beta_P: float
    beta_q: float
    h: float
    method: str = "implicit"
    sign: str = "componentwise"
    entries: str = "reduced"
    missing: str = "hold"
    det_min: float = 1e-9
    origin: ArrayLike = (0.0, 0.0)
    engine: Engine = field(init=False, repr=False)
    context: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        for name, known in (("sign", SIGNS), ("entries", (*ENTRIES,)), ("missing", MISSING)):
            if getattr(self, name) not in known:
                needed = f"one of {', '.join(known)} is needed"
                raise InputError(name, repr(getattr(self, name)), needed)
        for name in ("beta_P", "beta_q", "h"):
            if not (np.isfinite(getattr(self, name)) and getattr(self, name) > 0):
                raise InputError(name, f"{getattr(self, name)}", "a number above 0 is needed")
        if not 0 <= self.det_min < LARGEST_DET:
            needed = f"a number of 0 or more, below {LARGEST_DET}, is needed"
            raise InputError("det_min", f"{self.det_min}", needed)
        if self.missing == "withdraw" and self.entries == "reduced":
            needed = "entries = printed is needed: with the trace 1 assumed every sensor counts"
            raise InputError("missing", "withdraw with reduced entries", needed)
        object.__setattr__(self, "origin", pair("origin", self.origin))
        object.__setattr__(self, "engine", self._engine())
        object.__setattr__(self, "context", self._context())

    def _engine(self) -> Engine:
        sizes, gains = ENTRIES[self.entries], (self.beta_P, self.beta_q)
        if self.sign == "linear":
            return LinearConsensus(self.network)
        if self.sign == "isotropic":
            return IsotropicConsensus(self.network, gains, sizes, self.h, self.method)
        return SignConsensus(self.network, np.repeat(gains, sizes), self.h, self.method)

    def _context(self) -> Floats:
        """The context of the generated source, one lane a sensor."""
        names = self.network.names
        for name in self.positions:
            if name not in names:
                raise InputError("positions", f"no sensor is called {name}", "a node's is needed")
        rows = []
        for name in names:
            if name not in self.positions:
                raise InputError("positions", f"none of sensor {name}", "one a sensor is needed")
            rows.append(pair("positions", self.positions[name]) - np.asarray(self.origin))
        rest = np.array([self.h, self.beta_P, self.beta_q, self.det_min])
        return np.vstack([np.array(rows).T, np.tile(rest[:, None], len(rows))])

    @property
    def names(self) -> tuple[str, ...]:
        """The sensors, in the order of the network's nodes."""
        return tuple(self.network.names)

    def signal(self, angles: ArrayLike, counted: ArrayLike | None = None) -> Floats:
        """What the sensors average.

        Parameters
        ----------
        angles : array (n,)
            Bearings in rad.
        counted : array (n,) of bool, optional
            Sensors that count; all by default.

        Returns
        -------
        array (n, entries)
            The first row of P and q about the origin; or vec P and q.
        """
        angles = np.asarray(angles, dtype=float)
        rows = generated.measure(self.context, angles[None, :]).T
        if self.entries == "printed":
            first, mixed, *q = rows.T
            rows = np.stack([first, mixed, mixed, 1 - first, *q], axis=1)
        if counted is not None:
            rows = np.where(np.asarray(counted)[:, None], rows, 0.0)
        return rows

    def solve(self, x: ArrayLike) -> tuple[Floats, Flags]:
        """Positions that sensors compute from estimates of the averages.

        Parameters
        ----------
        x : array (rows, entries)

        Returns
        -------
        positions : array (rows, 2)
            In m; NaN where there is none.
        known : array (rows,) of bool
        """
        rows = np.asarray(x, dtype=float)
        if self.entries == "printed":
            trace = rows[:, 0] + rows[:, 3]
            share = np.where(trace > self.det_min, trace, 1.0)[:, None]
            rows = np.where(trace[:, None] > self.det_min, rows[:, [0, 1, 4, 5]] / share, 0.0)
        context = self.context[:, :1]
        *place, known = generated.position(np.tile(context, len(rows)), rows.T)
        good: Flags = known > 0
        found = np.stack(place, axis=1) + np.asarray(self.origin)
        return np.where(good[:, None], found, np.nan), good

    def init(self, bearings: Sequence[Bearing], time: float = 0.0) -> BearingState:
        """State before the first step, w = 0.

        Parameters
        ----------
        bearings : sequence of Bearing
            A sensor without one takes part from its first on; with ``withdraw`` from the start.
        time : float, optional
            In s.

        Raises
        ------
        InputError
            With the name ``measurement``: a sensor is unknown or reports twice, or none sees the
            target.
        """
        angles, fresh = self._read(bearings)
        if not fresh.any():
            raise InputError("measurement", "no sensor sees the target", "one is needed to start")
        present = fresh.copy() if self.missing == "hold" else np.ones_like(fresh)
        consensus = self.engine.init(self._averaged(angles, fresh))
        return self._state(time, consensus, angles, fresh, present, self._silent(fresh))

    def step(
        self,
        t: float,
        state: BearingState,
        bearings: Sequence[Bearing],
        active: ArrayLike | None = None,
    ) -> BearingState:
        """State one sample later.

        Parameters
        ----------
        t : float
            Time of the new sample in s: one sampling period after the state's.
        state : BearingState
            Is not changed.
        bearings : sequence of Bearing
            The new bearings; one that is missing or NaN is treated as `missing` says.
        active : array of bool, shape (m,), optional
            Which links carry in this period, in the order of the network's edges; both ends know.

        Raises
        ------
        InputError
            The measurement is out of order or off the sampling grid; a sensor is unknown or
            reports twice; `active` has not one entry a link.
        """
        on_time(t, state.time, self.h)
        new, fresh = self._read(bearings)
        present = state.present.copy()
        if self.missing == "hold":
            present |= fresh & ~np.isfinite(state.angles)
        fresh &= present
        angles = np.where(fresh, new, state.angles)
        carry = self._active(active, present)
        consensus = self._step(state.consensus, self._averaged(angles, fresh), carry)
        return self._state(t, consensus, angles, fresh, present, self._silent(fresh | ~present))

    def leave(self, state: BearingState, sensor: str, hand_over: bool = True) -> BearingState:
        """Take a sensor out.

        Parameters
        ----------
        state : BearingState
            Is not changed.
        sensor : str
        hand_over : bool, optional
            Its internal state goes to a neighbour that stays, so that the others agree on their own
            average at once. Without, they keep the average of old for ever.

        Raises
        ------
        InputError
            The sensor is unknown, has left or is the last, or no neighbour stays.
        """
        place = self._place(sensor)
        if not state.present[place]:
            raise InputError("sensor", f"{sensor} has left", "one that takes part is needed")
        present = state.present.copy()
        present[place] = False
        if not present.any():
            raise InputError("sensor", f"{sensor} is the last", "one that stays is needed")
        w = state.w.copy()
        if hand_over:
            heir = self.heir(state, sensor)
            if heir is None:
                needed = "a neighbour that stays is needed to hand over to"
                raise InputError("sensor", f"{sensor} has no neighbour left", needed)
            w[self._place(heir)] += w[place]
            w[place] = 0.0
        return self._with(replace(state, present=present), w)

    def heir(self, state: BearingState, sensor: str) -> str | None:
        """The neighbour to which a sensor that leaves hands over; None if it has none that stays.

        Raises
        ------
        InputError
            The sensor is unknown.
        """
        neighbours = self._neighbours(self._place(sensor))
        return next((self.names[j] for j in neighbours if state.present[j]), None)

    def join(self, state: BearingState, sensor: str) -> BearingState:
        """Take a sensor in again, with what it held when it left.

        After a hand-over that is nothing, which leaves the others' average unbiased.

        Raises
        ------
        InputError
            The sensor is unknown or takes part, or never had a bearing.
        """
        place = self._place(sensor)
        if state.present[place] or not np.isfinite(state.angles[place]):
            raise InputError("sensor", f"{sensor} takes part or saw nothing", "one that left")
        present = state.present.copy()
        present[place] = True
        return self._with(replace(state, present=present), state.w)

    def average(self, state: BearingState) -> Floats:
        """Average that the sensors taking part should agree on, from what they see now."""
        rows = self._averaged(state.angles, state.fresh)
        return np.asarray(rows[state.present].mean(axis=0))

    def _with(self, state: BearingState, w: Floats) -> BearingState:
        r = self._averaged(state.angles, state.fresh)
        consensus = self.engine.init(r, w)
        return self._state(
            state.time, consensus, state.angles, state.fresh, state.present, state.notes
        )

    def _step(self, state: Held, r: Floats, active: Flags | None) -> Held:
        step: Callable[..., Held] = self.engine.step
        return step(state, r, active=active)

    def _averaged(self, angles: Floats, fresh: Flags) -> Floats:
        """Signals; a sensor that does not count has zeros."""
        counted = fresh if self.missing == "withdraw" else np.isfinite(angles)
        return self.signal(np.where(counted, angles, 0.0), counted)

    def _state(
        self,
        time: float,
        consensus: Held,
        angles: Floats,
        fresh: Flags,
        present: Flags,
        notes: tuple[str, ...],
    ) -> BearingState:
        positions, known = self.solve(consensus.x)
        known = known & present
        positions = np.where(known[:, None], positions, np.nan)
        if not known[present].all():
            notes = (*notes, NO_INFORMATION)
        return BearingState(time, consensus, angles, positions, known, fresh, present, notes)

    def _read(self, bearings: Sequence[Bearing]) -> tuple[Floats, Flags]:
        names = self.names
        once_each([entry.sensor for entry in bearings], names)
        given = {entry.sensor: entry.angle for entry in bearings if entry.seen}
        angles = np.array([given.get(name, np.nan) for name in names], dtype=float)
        return angles, np.isfinite(angles)

    def _silent(self, fresh: Flags) -> tuple[str, ...]:
        held = "its last bearing is used" if self.missing == "hold" else "it counts no longer"
        return tuple(
            f"no bearing from {name}: {held}"
            for name, seen in zip(self.names, fresh, strict=True)
            if not seen
        )

    def _active(self, active: ArrayLike | None, present: Flags) -> Flags | None:
        edges = np.asarray(self.network.edges)
        joined: Flags = present[edges[:, 0]] & present[edges[:, 1]]
        if active is None:
            return None if joined.all() else joined
        given = np.asarray(active, dtype=bool)
        if given.shape != joined.shape:
            found = f"shape {given.shape}"
            raise InputError(
                "active", found, f"one entry for each of {len(joined)} links is needed"
            )
        joined &= given
        return joined

    def _neighbours(self, place: int) -> list[int]:
        edges = np.asarray(self.network.edges)
        return sorted({int(x) for x in edges[(edges == place).any(axis=1)].ravel()} - {place})

    def _place(self, sensor: str) -> int:
        if sensor not in self.network.names:
            raise InputError("sensor", f"no sensor is called {sensor}", "a node's name is needed")
        return self.names.index(sensor)
