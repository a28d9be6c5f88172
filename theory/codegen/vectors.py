"""Test vectors: inputs drawn once and for all, results computed by the generated lines themselves.

Results in single precision are computed by rounding after each operation, which is exact because a
double holds the sum, product and quotient of two singles well enough to round once more.
"""

from __future__ import annotations

import math
import random
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from types import CodeType
from typing import Any

from .lower import Lowered, entries
from .printing import Source
from .python import arguments, python
from .scalars import LIBM
from .stepper import Slot

Numbers = Sequence[Sequence[float]]
NUDGES = ((2, 2), (2, -2), (-2, 2), (-2, -2))
"""Units in the last place by which sine and cosine are moved."""
COUNT = 64
EDGES = (0.0, 2.0**-130, 2.0**100, math.nan)
"""Factors of the last group of the first vector."""
SEED = 20


@dataclass(frozen=True)
class Vector:
    """Numbers of each argument group and of the result.

    `slack` is empty where every language computes the same bits. Else it is what each result may
    be off because libraries round sines and cosines differently: what two units in the last place
    of each do, twice, for what is not of first order.
    """

    given: tuple[tuple[float, ...], ...]
    wanted: tuple[float, ...]
    slack: tuple[float, ...] = ()


class Single:
    """A number that is rounded to single precision after each operation."""

    def __init__(self, value: float) -> None:
        self.value = single(value)

    def __add__(self, other: Single | float) -> Single:
        return Single(self.value + _value(other))

    def __sub__(self, other: Single | float) -> Single:
        return Single(self.value - _value(other))

    def __mul__(self, other: Single | float) -> Single:
        return Single(self.value * _value(other))

    def __truediv__(self, other: Single | float) -> Single:
        return Single(_quotient(self.value, _value(other)))

    def __gt__(self, other: Single | float) -> bool:
        return self.value > _value(other)

    def __lt__(self, other: Single | float) -> bool:
        return self.value < _value(other)

    def __radd__(self, other: float) -> Single:
        return Single(_value(other)) + self

    def __rsub__(self, other: float) -> Single:
        return Single(_value(other)) - self

    def __rmul__(self, other: float) -> Single:
        return Single(_value(other)) * self

    def __rtruediv__(self, other: float) -> Single:
        return Single(_value(other)) / self


def single(value: float) -> float:
    """The single-precision number nearest to a double."""
    try:
        rounded: float = struct.unpack("f", struct.pack("f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)
    return rounded


def _value(number: Single | float) -> float:
    return number.value if isinstance(number, Single) else single(number)


def _quotient(a: float, b: float) -> float:
    try:
        return a / b
    except ZeroDivisionError:
        return math.nan if a == 0 or math.isnan(a) else math.copysign(math.inf, a)


def vectors(source: Source, function: Lowered, precise: bool = True) -> tuple[Vector, ...]:
    """Vectors of one function: drawn ones, then zero, tiny, huge and NaN data.

    Parameters
    ----------
    source : Source
    function : Lowered
    precise : bool, optional
        Double precision; else single.
    """
    rng = random.Random(SEED)
    code = compile(python(source), source.stepper.system, "exec")
    name, nudges = function.program.name, () if source.exact else NUDGES
    run, *nudged = (_runner(code, name, precise, nudge) for nudge in ((0, 0), *nudges))
    drawn = [_drawn(source, function, rng) for _ in range(COUNT)]
    edges = [_scaled(drawn[0], factor) for factor in EDGES]
    return tuple(_vector(run, nudged, given, precise) for given in [*drawn, *edges])


Run = Callable[..., Sequence[float]]


def _runner(code: CodeType, name: str, precise: bool, nudge: tuple[int, int]) -> Run:
    """The function, its sines and cosines moved by some units in the last place."""
    space: dict[str, Any] = {}
    exec(code, space)
    run = space[name]
    for call, units in zip(LIBM, nudge, strict=True):
        if call in space:
            space[call] = _rounded(space[call], precise, units)
    if not precise:
        space["sqrt"] = lambda x: Single(math.sqrt(_value(x)))
        return lambda *groups: [_value(x) for x in run(*([Single(v) for v in g] for g in groups))]
    return lambda *groups: list(run(*groups))


def _rounded(libm: Callable[[float], float], precise: bool, units: int) -> Callable[[Any], Any]:
    """A sine or cosine moved by some units, on doubles or on singles."""
    unit = 2.0 ** (-52 if precise else -23) * units
    if precise:
        return lambda x: (value := libm(x)) + abs(value) * unit
    return lambda x: Single((value := single(libm(_value(x)))) + abs(value) * unit)


def _vector(run: Run, nudged: Sequence[Run], given: Numbers, precise: bool) -> Vector:
    shown = given if precise else [[single(x) for x in group] for group in given]
    wanted = tuple(run(*shown))
    moved = [[abs(a - b) for a, b in zip(n(*shown), wanted, strict=True)] for n in nudged]
    slack = tuple(2 * max(column) for column in zip(*moved, strict=True))
    known = tuple(0.0 if math.isnan(x) else x for x in slack)
    return Vector(tuple(map(tuple, shown)), wanted, known)


def _drawn(source: Source, function: Lowered, rng: random.Random) -> list[list[float]]:
    """Data within the guards: gains diagonally dominant, a step below one."""
    return [
        [_number(group, slot, name, source.n, rng) for slot, name in _named(source, group)]
        for group in arguments(source, function)
    ]


def _named(source: Source, group: str) -> list[tuple[Slot, str]]:
    return [(slot, name) for slot in source.slots(group) for name in entries(slot, source.n)]


def _number(group: str, slot: Slot, name: str, n: int, rng: random.Random) -> float:
    if slot.drawn is not None or group != "context":
        return _short(rng.uniform(*(slot.drawn or (-10, 10))))
    _, _, index = name.partition("_")
    if len(index) != 2:
        return _short(rng.uniform(0.01, 0.5))
    inside = 1.0 / n
    diagonal = index[0] == index[1]
    return _short(rng.uniform(1, 4) if diagonal else rng.uniform(-inside, inside))


def _short(value: float) -> float:
    """A number of few bits, which is short in a file; results use all bits anyway."""
    return round(value * 4096) / 4096


def _scaled(given: Numbers, factor: float) -> list[list[float]]:
    """The same gains, with the last group times a factor."""
    return [*map(list, given[:-1]), [x * factor for x in given[-1]]]
