"""Let one consensus estimator follow a scenario, and keep what figures and bounds need."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.estimators.bearing_dac import ENTRIES, BearingDac
from sensortrack.estimators.bearing_state import BearingState
from sensortrack.sensors import Bearing

from .parts import FaultPart, Scenario

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
LEAVING = ("leaves", "fails")


@dataclass(frozen=True, eq=False)
class Trace:
    """What happened, rows by sample.

    Parameters
    ----------
    estimator : BearingDac
    positions : array (samples, n, 2)
        In m, NaN where a sensor has none.
    known, present : array (samples, n) of bool
    apart : array (samples, entries)
        Norm over the sensors of the distance from the mean of their estimates, entry by entry.
    average : array (samples, entries)
        Average of the signals of those who take part.
    moved, spread : array (samples, entries)
        How far the signals moved since the last sample: the largest of a sensor, and the norm of
        what is left when the average is taken out. The first row is zero.
    graphs : array (samples, m) of bool
        Links that carried in the period before.
    restarts : array (samples,) of bool
        Samples before which somebody left or joined; the first is one.
    notes : list of (float, tuple of str)
    biased : bool
        Somebody went without handing over, so that the others agree on another average.
    inexact : (int, float)
        Steps that are not exact up to rounding, and how far the worst may be off, in units of the
        signal.
    """

    estimator: BearingDac
    positions: Floats
    known: Flags
    present: Flags
    apart: Floats
    average: Floats
    moved: Floats
    spread: Floats
    graphs: Flags
    restarts: Flags
    notes: list[tuple[float, tuple[str, ...]]]
    biased: bool = False
    inexact: tuple[int, float] = (0, 0.0)

    def level(self, block: str) -> Floats:
        """Disagreement on the entries of P or q, the largest of them."""
        first = ENTRIES[self.estimator.entries][0]
        part = slice(0, first) if block == "P" else slice(first, None)
        found: Floats = self.apart[:, part].max(axis=1)
        return found

    def record(self) -> Mapping[str, Any]:
        """What bounds on this run are computed from."""
        sets, which = np.unique(self.graphs, axis=0, return_inverse=True)
        sizes = ENTRIES[self.estimator.entries]
        return {
            "entries": self.estimator.entries,
            "beta": np.repeat([self.estimator.beta_P, self.estimator.beta_q], sizes).tolist(),
            "present": _runs(self.present),
            "graphs": [np.flatnonzero(row).tolist() for row in sets],
            "graph": which.ravel().tolist(),
            "restarts": np.flatnonzero(self.restarts).tolist(),
            "origin": np.asarray(self.estimator.origin).tolist(),
            "biased": self.biased,
            "moved": self.moved.tolist(),
            "spread": self.spread.tolist(),
            "average": self.average.tolist(),
            "disagreement": self.apart.tolist(),
        }


def _runs(present: Flags) -> list[list[Any]]:
    """Samples at which the set of those who take part changes, with the new set."""
    change = np.r_[True, (present[1:] != present[:-1]).any(axis=1)]
    return [[int(k), np.flatnonzero(present[k]).tolist()] for k in np.flatnonzero(change)]


@dataclass(frozen=True, eq=False)
class Follower:
    """One estimator with the comings and goings of a scenario."""

    estimator: BearingDac
    scenario: Scenario

    def follow(self, time: Floats, angles: Floats, carry: Flags) -> Trace:
        """Run through all samples.

        Parameters
        ----------
        time : array (samples,)
        angles : array (samples, n)
            Bearings in rad, NaN where there is none.
        carry : array (samples, m) of bool
            Links that carry in the period that ends at a sample.
        """
        estimator, names = self.estimator, self.estimator.names
        state = estimator.init(_bearings(names, angles[0]), float(time[0]))
        rows = [_row(estimator, state)]
        restarts, notes = [True], [(float(time[0]), state.notes)]
        before = self._signals(state)
        moves = [(np.zeros(before.shape[1]),) * 2]
        errors: list[float] = []
        stranded: list[str] = []
        for k, t in enumerate(time[1:], start=1):
            changed, alone = self._membership(state, float(t))
            stranded += alone
            joined = changed.present
            state = estimator.step(float(t), changed, _bearings(names, angles[k]), carry[k])
            after = self._signals(state)
            restarts.append(
                bool((state.present != rows[-1][2]).any() or (joined != rows[-1][2]).any())
            )
            moves.append(_moves(before, after, state.present))
            before = after
            rows.append(_row(estimator, state))
            errors += [] if state.status.exact else [state.status.error]
            notes.append(
                (float(t), (*(f"{s} has nobody to hand over to" for s in alone), *state.notes))
            )
        positions, known, present, apart, average = map(np.array, zip(*rows, strict=True))
        moved, spread = map(np.array, zip(*moves, strict=True))
        graphs = carry & present[:, estimator.network.edges].all(axis=2)
        return Trace(
            estimator,
            positions,
            known,
            present,
            apart,
            average,
            moved,
            spread,
            graphs,
            np.array(restarts),
            notes,
            bool(stranded) or any(fault.kind == "fails" for fault in self.scenario.faults),
            (len(errors), max(errors, default=0.0)),
        )

    def _signals(self, state: BearingState) -> Floats:
        return state.x - state.w

    def _membership(self, state: BearingState, t: float) -> tuple[BearingState, list[str]]:
        """Those who leave or join between the last sample and this one; who has no heir."""
        alone = []
        for fault in self.scenario.faults:
            if fault.kind not in LEAVING:
                continue
            place = self.estimator.names.index(fault.sensor)
            gone = _lasts(fault, t)
            if gone and state.present[place]:
                heir = self.estimator.heir(state, fault.sensor)
                hands_over = fault.kind == "leaves" and heir is not None
                alone += [fault.sensor] if fault.kind == "leaves" and heir is None else []
                state = self.estimator.leave(state, fault.sensor, hands_over)
            elif not gone and _lasts(fault, state.time) and not state.present[place]:
                state = self.estimator.join(state, fault.sensor)
        return state, alone


def _lasts(fault: FaultPart, t: float) -> bool:
    return fault.from_s - 1e-9 <= t < fault.until_s - 1e-9


def _bearings(names: tuple[str, ...], angles: Floats) -> list[Bearing]:
    return [Bearing(name, float(angle)) for name, angle in zip(names, angles, strict=True)]


def _row(estimator: BearingDac, state: BearingState) -> tuple[Any, ...]:
    x = state.x[state.present]
    apart = np.linalg.norm(x - x.mean(axis=0), axis=0)
    return state.positions, state.known, state.present, apart, estimator.average(state)


def _moves(before: Floats, after: Floats, present: Flags) -> tuple[Floats, Floats]:
    step = (after - before)[present]
    return np.abs(step).max(axis=0), np.linalg.norm(step - step.mean(axis=0), axis=0)
