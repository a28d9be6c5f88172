"""The cycle of Algorithm 1 as data: instants, blocks and lags, as printed and without ambiguity.

Cycle T = 1, 2, ... has k pairs of instants; at the pair u = 1, ..., k block u is active. Instants
count from 1, and the estimate of instant 0 is the initial guess.

References
----------
Erofeeva & Granichin, section 3 before (16), and Algorithm 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple


class Pair(NamedTuple):
    """One pair of instants: cycle, block, and the second of the two instants."""

    cycle: int
    block: int
    t: int


class Use(NamedTuple):
    """A variable of Algorithm 1 with its index, as an offset from t or as a multiple of T."""

    name: str
    back: int = 0
    """How far the index is behind t."""
    twice_cycle: bool = False
    """The index is 2T instead, with cycles counted from 0, so that for one block it is t - 2."""


class Step(NamedTuple):
    """A step of Algorithm 1: what it assigns and what it reads."""

    number: str
    writes: Use
    reads: tuple[Use, ...]


class Missing(NamedTuple):
    """A variable that a step reads before anything has assigned it; ``of`` is its index."""

    step: str
    name: str
    of: int
    t: int


def _whole(name: str, found: int) -> None:
    if found < 1:
        raise ValueError(f"{name} is {found}; at least 1 is needed")


def pairs(k: int, cycles: int) -> Iterator[Pair]:
    """The pairs of instants in their order, each block once in every cycle.

    Parameters
    ----------
    k : int
        Number of blocks.
    cycles : int

    Yields
    ------
    Pair

    Raises
    ------
    ValueError
        There is no block or no cycle.
    """
    _whole("k", k)
    _whole("cycles", cycles)
    for cycle in range(1, cycles + 1):
        for block in range(1, k + 1):
            yield Pair(cycle, block, 2 * k * (cycle - 1) + 2 * block)


def active(k: int, t: int) -> int:
    """The active block of an instant, 1 to k: the same at both instants of a pair."""
    return (t - 1) % (2 * k) // 2 + 1


def printed_active(k: int, t: int) -> int:
    """The active index as printed, (t mod 2k) div 2."""
    return t % (2 * k) // 2


def printed_clock(pair: Pair) -> int:
    """The instant that step 3.1 sets, 2T + 2u."""
    return 2 * pair.cycle + 2 * pair.block


def printed_base(pair: Pair) -> int:
    """The instant of the estimate that is perturbed, 2T with cycles counted from 0."""
    return 2 * (pair.cycle - 1)


def lag(k: int, block: int) -> int:
    """Instants from the last update of a block to the end of the cycle."""
    return 2 * (k - block)


def printed_lag(k: int, block: int) -> int:
    """Shift of lambda^u, where lambda shifts by 2k - 2."""
    return block * (2 * k - 2)


def split_pairs(k: int, cycles: int) -> tuple[tuple[Pair, int, int], ...]:
    """Pairs whose two measurements have different active indices as printed, with these indices."""
    found = []
    for pair in pairs(k, cycles):
        first, second = (printed_active(k, pair.t - back) for back in (1, 0))
        if first != second:
            found.append((pair, first, second))
    return tuple(found)


def clashes(k: int, cycles: int) -> tuple[tuple[Pair, Pair], ...]:
    """Pairs of updates that step 3.1 puts at one instant."""
    every = tuple(pairs(k, cycles))
    return tuple(
        (one, two)
        for i, one in enumerate(every)
        for two in every[i + 1 :]
        if printed_clock(one) == printed_clock(two)
    )


def stale(k: int, cycles: int) -> tuple[Pair, ...]:
    """Pairs whose printed base is older than the last update of the block.

    The base is the estimate of 2T, with cycles counted from 0, so that for one block it is t - 2.
    """
    return tuple(pair for pair in pairs(k, cycles) if printed_base(pair) < pair.t - 2 * k)


DELTA = Use("Delta", twice_cycle=True)
PRINTED_BASE = Use("theta_hat", twice_cycle=True)

PRINTED: tuple[Step, ...] = (
    Step("2", DELTA, ()),
    Step("3.2", Use("x", 1), (PRINTED_BASE, DELTA)),
    Step("3.3", Use("z", 1), ()),
    Step("3.4", Use("y-", 1), (Use("x", 1), Use("z"))),
    Step("3.5", Use("x"), (PRINTED_BASE, DELTA)),
    Step("3.6", Use("z"), ()),
    Step("3.7", Use("g"), (DELTA, Use("y+"), Use("y-", 1))),
    Step("3.8", Use("g"), (DELTA, Use("y+"), Use("y-", 1))),
    Step("3.9", Use("theta_hat"), (Use("theta_hat", 1), Use("g"))),
)
"""Steps 2 to 3.9 as printed; f_t takes the measurement of t."""

BASE = Use("theta_hat", 2)

REPAIRED: tuple[Step, ...] = (
    Step("2", DELTA, ()),
    Step("3.2", Use("x", 1), (BASE, DELTA)),
    Step("3.3", Use("z", 1), ()),
    Step("3.4", Use("y-", 1), (Use("x", 1), Use("z", 1))),
    Step("3.5", Use("x"), (BASE, DELTA)),
    Step("3.6", Use("z"), ()),
    Step("3.7", Use("y+"), (Use("x"), Use("z"))),
    Step("3.8", Use("g"), (DELTA, Use("y+"), Use("y-", 1))),
    Step("3.9", Use("theta_hat"), (BASE, Use("g"))),
)
"""The same with two measurement instants, each cost from its own measurement."""

ONE_INSTANT: tuple[Step, ...] = (
    *REPAIRED[:2],
    Step("3.5", Use("x"), (BASE, DELTA)),
    Step("3.6", Use("z"), ()),
    Step("3.4", Use("y-", 1), (Use("x", 1), Use("z"))),
    *REPAIRED[6:],
)
"""The same with one measurement, for which step 3.4 has to wait."""


def unassigned(program: Sequence[Step], k: int, cycles: int) -> tuple[Missing, ...]:
    """Run through the steps and list what is read before it is assigned.

    Parameters
    ----------
    program : sequence of Step
    k, cycles : int
        Number of blocks, of cycles.

    Returns
    -------
    tuple of Missing

    Raises
    ------
    ValueError
        There is no block or no cycle.
    """
    known, found = {("theta_hat", 0)}, list[Missing]()
    for pair in pairs(k, cycles):

        def at(use: Use, pair: Pair = pair) -> tuple[str, int]:
            return use.name, printed_base(pair) if use.twice_cycle else pair.t - use.back

        for step in program:
            found += [
                Missing(step.number, *at(use), pair.t) for use in step.reads if at(use) not in known
            ]
            known.add(at(step.writes))
    return tuple(found)
