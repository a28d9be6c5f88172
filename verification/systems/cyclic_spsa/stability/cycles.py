"""The limit of the step for a cycle of blocks of whole targets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Answer, Detail, Input
from verification.exact.evaluate import Rows
from verification.exact.rationals import above, below

from ..block_inputs import BETA, DRIFT, HESSIAN, NOISE, READING, Block, block_of
from .limits import Limit, limit_of
from .steps import USABLE, WIDE, limit_certificate

PLANE = 2
"""Coordinates of a target: target i has the coordinates 2i and 2i + 1."""

LISTS = Input("blocks", "blocks", "coordinates of each block of the cycle, counted from 0")
CYCLE = (*HESSIAN, NOISE, DRIFT, BETA, READING, LISTS)


def blocks_step_limit(values: Mapping[str, Any]) -> Answer:
    """Supremum of the steps at which every block of a cycle is stable in mean square.

    A block's cost holds its own targets only, so that blocks do not disturb each other, and the
    smallest of their limits decides.

    Parameters
    ----------
    values : mapping
        The inputs of `CYCLE`; the Hessian, noise and drift of all targets of a sensor.

    Returns
    -------
    Answer
        With the certificate of the block that decides.

    Raises
    ------
    InputError
        As `block_inputs.block_of`; the blocks miss or repeat a coordinate, split a target, or the
        Hessian couples two of them.
    """
    lists = values["blocks"]
    whole = block_of({**values, "k": Fraction(len(lists))})
    _whole_targets(lists, whole.size)
    _uncoupled(whole.hessian, lists)
    blocks = [part(whole, places) for places in lists]
    limits = [limit_of(block) for block in blocks]
    found = [limit for limit in limits if limit is not None]
    if len(found) < len(blocks):
        return Answer(verdict="UNDECIDED", notes=(WIDE,))
    k = min(range(len(found)), key=lambda i: (found[i].upper, found[i].lower))
    return _answer(blocks[k], found, k, lists)


def part(block: Block, places: Sequence[int]) -> Block:
    """The block of these coordinates."""

    def within(rows: Rows) -> Rows:
        return tuple(tuple(rows[i][j] for j in places) for i in places)

    drift = tuple(block.drift[i] for i in places)
    return replace(block, hessian=within(block.hessian), noise=within(block.noise), drift=drift)


def _answer(block: Block, found: list[Limit], k: int, lists: Sequence[Sequence[int]]) -> Answer:
    limit, low = found[k], min(entry.lower for entry in found)
    clear = all(limit.upper <= entry.lower or _equal(limit, entry) for entry in found)
    exact = limit.exact if clear else None
    value = limit.value if exact or limit.upper - low <= USABLE * low else None
    document, unwritten = limit_certificate(block, limit)
    data = [
        {"coordinates": list(places), "limit": entry.value}
        for places, entry in zip(lists, found, strict=True)
    ]
    lines = tuple((f"block {i + 1}", f"{entry['limit']:.10g}") for i, entry in enumerate(data))
    return Answer(
        value=value,
        exact=exact.to_data() if exact else None,
        lower=below(low),
        upper=above(limit.upper),
        verdict="PROVED",
        certificate=document,
        notes=(f"block {k + 1} decides, and the certificate is about it", *unwritten),
        more={"blocks_limits": lambda: Detail(data, lines)},
    )


def _equal(a: Limit, b: Limit) -> bool:
    """Whether two limits are known to be one number, or are one entry."""
    if a.exact is None or b.exact is None:
        return a is b
    same = a.exact.polynomial == b.exact.polynomial
    return same and max(a.lower, b.lower) < min(a.upper, b.upper)


def _whole_targets(lists: Sequence[Sequence[int]], size: int) -> None:
    """Each coordinate once, and those of a target in one block."""
    if size % PLANE:
        needed = "two coordinates a target are needed"
        raise InputError("blocks", f"{size} coordinates", needed)
    home: dict[int, int] = {}
    for k, places in enumerate(lists, start=1):
        for place in places:
            if place >= size:
                needed = f"coordinates from 0 to {size - 1} are needed"
                raise InputError("blocks", f"list {k} has {place}", needed)
            if place in home:
                found = f"coordinate {place} is in lists {home[place]} and {k}"
                raise InputError("blocks", found, "each coordinate once is needed")
            home[place] = k
    for place in range(size):
        if place not in home:
            raise InputError("blocks", f"no list has {place}", "every coordinate is needed")
    for i in range(size // PLANE):
        if home[PLANE * i] != home[PLANE * i + 1]:
            found = f"coordinates {PLANE * i} and {PLANE * i + 1} are in two lists"
            raise InputError("blocks", found, "whole targets are needed: they are one target")


def _uncoupled(hessian: Rows, lists: Sequence[Sequence[int]]) -> None:
    home = {place: k for k, places in enumerate(lists) for place in places}
    for i, row in enumerate(hessian):
        for j, x in enumerate(row):
            if x and home[i] != home[j]:
                found = f"the Hessian couples {i} and {j} of two lists"
                raise InputError("blocks", found, "blocks with costs of their own are needed")
