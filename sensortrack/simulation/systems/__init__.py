"""The systems that scenarios can run: what each reads, checks and does."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from sensortrack.simulation.parts import Scenario

Floats = NDArray[np.float64]
Path = tuple[Floats, Floats]
"""Positions in m and velocities in m/s, rows by time."""
SYSTEMS = ("bearing_dac", "cyclic_spsa", "variational")
"""Names of the modules of this folder, each of which is a `Simulated`."""


@dataclass(frozen=True, eq=False)
class Found:
    """What one system made of a scenario.

    Parameters
    ----------
    digest : str
        Of the generated source that was stepped.
    target : Path
        As the system knows it; times by targets by coordinates where it follows several.
    sensors : mapping of str to array (samples, 3)
    estimates : mapping of str to Path
        The system's own first, then its baselines; NaN where there is no estimate. Where several
        targets are followed: times by sensors by targets by coordinates.
    labels : mapping of str to str
    parameters : mapping
    notes : tuple of str
    events : tuple of dict
        Beside the faults.
    extra : mapping
        Further entries of ``run.json``.
    """

    digest: str
    target: Path
    sensors: Mapping[str, Floats]
    estimates: Mapping[str, Path]
    labels: Mapping[str, str]
    parameters: Mapping[str, Any]
    notes: tuple[str, ...]
    events: tuple[dict[str, Any], ...] = ()
    extra: Mapping[str, Any] = field(default_factory=dict)


class Simulated(Protocol):
    """A module that can run scenarios of one system.

    ``TABLES`` names the dataclass of each table it reads: ``estimator``, with ``system`` and
    ``h_s``, and ``noise`` at least; ``LISTS`` those of its own lists of tables. ``BASELINES`` are
    what a scenario may ask for beside the estimator, all of them by default; ``FAULTS`` says in
    words what happens when a fault of each kind begins and when it ends; ``SEVERAL`` whether it
    follows several targets at once.
    """

    TABLES: Mapping[str, type]
    LISTS: Mapping[str, type]
    BASELINES: tuple[str, ...]
    FAULTS: Mapping[str, tuple[str, str]]
    SEVERAL: bool

    def complete(self, scenario: Scenario) -> Scenario:
        """Fill in what the tables say in short."""

    def check(self, scenario: Scenario) -> None:
        """Raise an `InputError` for what contradicts itself."""

    def run(self, scenario: Scenario, seed: int, time: Floats, target: Path) -> Found:
        """Run it once."""


def simulated(system: str) -> Simulated:
    """The module of one of `SYSTEMS`."""
    module: Any = import_module(f"{__name__}.{system}")
    found: Simulated = module
    return found


def merged(notes: list[tuple[float, tuple[str, ...]]]) -> tuple[str, ...]:
    """Notes with the time at which each begins and how many samples it lasts."""
    first: dict[str, float] = {}
    times: dict[str, int] = {}
    for t, texts in notes:
        for text in texts:
            first.setdefault(text, float(t))
            times[text] = times.get(text, 0) + 1
    return tuple(
        f"{text} ({count} sample{'s' if count > 1 else ''}, first at {first[text]:g} s)"
        for text, count in times.items()
    )
