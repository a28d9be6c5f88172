"""Which targets a sensor works on when, and whose measurements it uses: blocks and sources as data.

A cycle has two samples for each block. Sample 2k(T - 1) + 2u - 1 and the one after it belong to
block u of cycle T, where k is the number of blocks; all three count from 1.

References
----------
V. Erofeeva, O. Granichin, *Distributed State Estimation of Moving Targets Using Cyclic Simultaneous
Perturbation Stochastic Approximation*, (15) to (19). The printed indices of block and time pair
measurements of different blocks; these do not.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sensortrack.errors import InputError
from sensortrack.random_numbers import whole


@dataclass(frozen=True)
class Turn:
    """What happens at one sample.

    Parameters
    ----------
    cycle, block : int
        From 1.
    second : bool
        Whether it is the second sample of the block, the one with the update.
    """

    cycle: int
    block: int
    second: bool


@dataclass(frozen=True)
class Schedule:
    """Blocks of whole targets in the order of their turns, and the source of each target.

    Parameters
    ----------
    blocks : sequence of sequence of str
        Targets by name; each in one block.
    sources : mapping of str to str
        Target to the sensor whose measurement is used.

    Raises
    ------
    InputError
        With the name ``blocks``: there is none, one is empty or a text, or a target is in two
        places, so that its coordinates would be split; ``sources``: a target has none, or it is in
        no block.
    """

    blocks: Sequence[Sequence[str]]
    sources: Mapping[str, str]

    def __post_init__(self) -> None:
        blocks = tuple(_names(block) for block in _names(self.blocks))
        if not isinstance(self.sources, Mapping):
            raise InputError("sources", f"{self.sources!r:.60}", "target to sensor is needed")
        if not blocks or not all(blocks):
            found = "an empty block" if blocks else "no block"
            needed = "blocks of one target or more are needed: the sensor has to see some"
            raise InputError("blocks", found, needed)
        place: dict[str, int] = {}
        for u, block in enumerate(blocks, start=1):
            for target in block:
                if target in place:
                    found = f"target {target} in block {place[target]} and in block {u}"
                    needed = "one place a target is needed, which holds both coordinates"
                    raise InputError("blocks", found, needed)
                place[target] = u
        for target in self.sources:
            if target not in place:
                found = f"target {target} is in no block"
                raise InputError("blocks", found, "each target that has a source is needed")
        for target in place:
            if target not in self.sources:
                found = f"none of target {target}"
                raise InputError("sources", found, "a sensor is needed whose measurement is used")
        object.__setattr__(self, "blocks", blocks)
        object.__setattr__(self, "sources", {target: self.sources[target] for target in place})

    @property
    def targets(self) -> tuple[str, ...]:
        """All targets, in the order of their turns."""
        return tuple(self.sources)

    @property
    def period(self) -> int:
        """Samples of a cycle: 2k."""
        return 2 * len(self.blocks)

    def turn(self, t: int) -> Turn:
        """What happens at sample t = 1, 2, ...

        Raises
        ------
        InputError
            With the name ``t``: it is no whole number from 1 on.
        """
        cycle, inside = divmod(whole("t", t, 1) - 1, self.period)
        return Turn(cycle + 1, inside // 2 + 1, bool(inside % 2))


def _names(value: object) -> tuple[Any, ...]:
    """A list as a tuple; a text would fall apart into its letters."""
    if isinstance(value, str) or not isinstance(value, Iterable):
        needed = "lists of names are needed: [['a', 'b'], ['c']]"
        raise InputError("blocks", f"{value!r:.60}", needed)
    return tuple(value)
