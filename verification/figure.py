"""Figures as data: what a decision shows and a report draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

ROLES = frozenset({"sharp", "printed", "bound", "run", "guide", "target"})
"""Curves: what is true, what is printed, a proved bound, runs, a line for the eye, the truth."""
GROUNDS = frozenset({"false", "proved"})
"""Areas: promised and false, promised and proved."""
DOTS = frozenset({"held", "failed", "refuting", "start"})
"""Points: a run that held, one that failed, the counterexample, where a track begins."""


@dataclass(frozen=True)
class Axis:
    """One axis of a plot.

    Parameters
    ----------
    label, unit : str
        Name and unit; the unit is empty for a pure number.
    low, high : float
        Ends.
    log : bool, optional
        Logarithmic; both ends are then positive.
    ticks : tuple of float, optional
        Values that must be marked, the deciding one among them; others are found.
    """

    label: str
    unit: str
    low: float
    high: float
    log: bool = False
    ticks: tuple[float, ...] = ()


@dataclass(frozen=True)
class Curve:
    """A line; its role decides colour and dash, its label stands at its end."""

    role: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    label: str = ""


@dataclass(frozen=True)
class Area:
    """The ground between two curves over the same x."""

    role: str
    x: tuple[float, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]


@dataclass(frozen=True)
class Dots:
    """Points of one kind; the label stands beside the last."""

    role: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    label: str = ""


@dataclass(frozen=True)
class Plot:
    """A figure that shows why a claim holds or fails.

    Parameters
    ----------
    title : str
        What is drawn.
    finding : str
        What it shows, for who cannot see it.
    caption : str
        One or two sentences below the figure.
    x, y : Axis
    curves, areas, dots : tuple
    equal : bool, optional
        One unit is as long on both axes, as on a map.

    Raises
    ------
    ValueError
        A role is unknown, or lists that belong together differ in length.
    """

    title: str
    finding: str
    caption: str
    x: Axis
    y: Axis
    curves: tuple[Curve, ...] = ()
    areas: tuple[Area, ...] = ()
    dots: tuple[Dots, ...] = ()
    equal: bool = False

    def __post_init__(self) -> None:
        for marks, roles in ((self.curves, ROLES), (self.areas, GROUNDS), (self.dots, DOTS)):
            _check(marks, roles)

    def to_data(self) -> dict[str, Any]:
        """Return the figure as JSON data."""
        return asdict(self)

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> Plot:
        """Read what `to_data` returned, possibly from a file.

        Raises
        ------
        ValueError, TypeError, KeyError
            The data are no figure.
        """
        return cls(
            title=data["title"],
            finding=data["finding"],
            caption=data["caption"],
            x=Axis(**_tupled(data["x"])),
            y=Axis(**_tupled(data["y"])),
            curves=tuple(Curve(**_tupled(entry)) for entry in data.get("curves", ())),
            areas=tuple(Area(**_tupled(entry)) for entry in data.get("areas", ())),
            dots=tuple(Dots(**_tupled(entry)) for entry in data.get("dots", ())),
            equal=bool(data.get("equal", False)),
        )


def _tupled(entry: dict[str, Any]) -> dict[str, Any]:
    return {k: tuple(v) if isinstance(v, list) else v for k, v in entry.items()}


def _check(marks: Sequence[Any], roles: frozenset[str]) -> None:
    for mark in marks:
        if mark.role not in roles:
            raise ValueError(f"role is {mark.role!r}; one of {', '.join(sorted(roles))} is needed")
        lengths = {len(v) for v in vars(mark).values() if isinstance(v, tuple)}
        if len(lengths) != 1:
            raise ValueError(f"{mark.role}: lists of lengths {sorted(lengths)}; one is needed")
