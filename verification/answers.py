"""What a system offers to a user's question, and what it answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sensortrack.networks import Network


@dataclass(frozen=True)
class Input:
    """One named input of a quantity or condition.

    Parameters
    ----------
    name : str
        Name as typed after ``--set`` (``graph`` means ``--graph``).
    kind : str
        ``matrix``, ``number``, ``point``, ``points``, ``node numbers`` or ``graph``.
    meaning : str
        One phrase for lists and error messages.
    unit : str, optional
        SI unit, empty for a pure number.
    default : str or None, optional
        Exact text used when the input is not given; None makes it required.
    optional : bool, optional
        It may be left out, and is None then.
    """

    name: str
    kind: str
    meaning: str
    unit: str = ""
    default: str | None = None
    optional: bool = False


@dataclass(frozen=True)
class Detail:
    """Something that explains an answer.

    Parameters
    ----------
    data : object
        What the ``--json`` document has under the detail's name.
    lines : tuple of (str, str)
        The same for a reader: a label and a text each.
    """

    data: Any
    lines: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Answer:
    """A quantity's or condition's answer; the fields are those of the ``--json`` document.

    `more` has further keys of the document, each made when somebody shows it; None leaves it out.
    `proved` says to a reader how the bounds are.
    """

    value: Any = None
    exact: dict[str, Any] | None = None
    lower: Any = None
    upper: Any = None
    printed: float | None = None
    verdict: str = "SUPPORTED"
    certificate: dict[str, Any] | None = None
    margin: float | None = None
    notes: tuple[str, ...] = ()
    more: Mapping[str, Callable[[], Detail | None]] = field(default_factory=dict)
    proved: str = "certified"


@dataclass(frozen=True)
class Quantity:
    """Something `bound` computes; `certified` says whether it writes a certificate."""

    name: str
    summary: str
    inputs: tuple[Input, ...]
    answer: Callable[[Mapping[str, Any]], Answer]
    certified: bool


@dataclass(frozen=True)
class Condition:
    """Something `certify` decides; it always writes a certificate or a counterexample."""

    name: str
    summary: str
    inputs: tuple[Input, ...]
    answer: Callable[[Mapping[str, Any]], Answer]


@dataclass(frozen=True)
class Designed:
    """What `design` chose.

    Parameters
    ----------
    gains : mapping of str to rational or rows, optional
        Valid as ``--params`` of the system's questions; empty where nothing was found.
    objective : str
        The sense in which the choice is the best.
    bound : mapping of str to float, optional
        Numbers that are proved of the choice, by name.
    verdict : str, optional
    certificate : dict, optional
    notes : tuple of str, optional
    edges : tuple of (str, str), optional
        Edges to add, by the names of their ends.
    network : Network, optional
        The network with them.
    """

    gains: Mapping[str, Any] = field(default_factory=dict)
    objective: str = ""
    bound: Mapping[str, Any] = field(default_factory=dict)
    verdict: str = "UNDECIDED"
    certificate: dict[str, Any] | None = None
    notes: tuple[str, ...] = ()
    edges: tuple[tuple[str, str], ...] = ()
    network: Network | None = None


@dataclass(frozen=True)
class Design:
    """Something `design` chooses, known by the inputs that it is given."""

    name: str
    summary: str
    inputs: tuple[Input, ...]
    answer: Callable[[Mapping[str, Any]], Designed]
