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
from typing import Any

from .lower import Lowered
from .printing import Source
from .python import arguments, python

COUNT = 64
SEED = 20


@dataclass(frozen=True)
class Vector:
    """Numbers of each argument group and of the resulting state."""

    given: tuple[tuple[float, ...], ...]
    wanted: tuple[float, ...]


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
    run = _runner(source, function, precise)
    drawn = [_drawn(source, function, rng) for _ in range(COUNT)]
    edges = [_scaled(drawn[0], factor) for factor in (0.0, 2.0**-130, 2.0**100, math.nan)]
    return tuple(_vector(run, given, precise) for given in [*drawn, *edges])


def _runner(source: Source, function: Lowered, precise: bool) -> Callable[..., Sequence[Any]]:
    space: dict[str, Any] = {}
    exec(python(source), space)
    run: Callable[..., Sequence[Any]] = space[function.program.name]
    if precise:
        return run
    return lambda *groups: [x.value for x in run(*([Single(v) for v in group] for group in groups))]


def _vector(
    run: Callable[..., Sequence[Any]], given: Sequence[Sequence[float]], precise: bool
) -> Vector:
    shown = given if precise else [[single(x) for x in group] for group in given]
    return Vector(tuple(map(tuple, shown)), tuple(run(*shown)))


def _drawn(source: Source, function: Lowered, rng: random.Random) -> list[list[float]]:
    """Data within the guards: gains diagonally dominant, a step below one."""
    return [
        [_number(name, source.n, rng) for name, _ in source.layout(group)]
        if group == "context"
        else [_short(rng.uniform(-10, 10)) for _ in source.layout(group)]
        for group in arguments(source, function)
    ]


def _number(name: str, n: int, rng: random.Random) -> float:
    _, _, index = name.partition("_")
    if len(index) != 2:
        return _short(rng.uniform(0.01, 0.5))
    inside = 1.0 / n
    diagonal = index[0] == index[1]
    return _short(rng.uniform(1, 4) if diagonal else rng.uniform(-inside, inside))


def _short(value: float) -> float:
    """A number of few bits, which is short in a file; results use all bits anyway."""
    return round(value * 4096) / 4096


def _scaled(given: list[list[float]], factor: float) -> list[list[float]]:
    """The same gains, with the last group times a factor."""
    return [*given[:-1], [x * factor for x in given[-1]]]
