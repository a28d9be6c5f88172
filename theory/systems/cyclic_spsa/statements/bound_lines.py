"""Theorem 1 in the language of the checker: what it promises for given constants, line by line."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from ..bounds import GIVEN, PRINTED, Bound, Definition

Cost = Callable[[str], str]
SIGNS = ("1", "-1")
NOT_NEGATIVE = ("delta", "c2", "c3", "c4", "c_v2", "ratio", "level")


def inputs_of(bound: Bound, given: Iterable[str] = GIVEN) -> dict[str, str]:
    """The constants and every line, all of them numbers."""
    names = [*given, *(line.name for line in bound.definitions), "root_q"]
    return dict.fromkeys(names, "number")


def promise(bound: Bound = PRINTED) -> tuple[str, ...]:
    """The step is in the interval, and ``bound`` is what is promised.

    Roots may be rounded up, which does not make the promise smaller.
    """
    rounded = ("root_d > 0", "root_d**2 >= d", "root_k > 0", "root_k**2 >= k")
    sound = ("d >= 1", "k >= 1", "mu > 0", "M >= mu", "beta > 0", "0 < alpha", "alpha < limit")
    used = set(re.findall(r"[a-zA-Z_][a-zA-Z_0-9]*", " ".join(x.text for x in bound.definitions)))
    given = used - {line.name for line in bound.definitions}
    spreads = tuple(f"{name} >= 0" for name in NOT_NEGATIVE if name in given)
    root = ("root_q > 0", "root_q**2 >= q")
    lines = (*map(_defined, bound.limit), *sound, *spreads, *map(_defined, bound.lines), *root)
    return (*rounded, *lines, _defined(bound.value))


def _defined(line: Definition) -> str:
    return f"{line.name} == {line.text}"


def constants(**values: int) -> tuple[str, ...]:
    """The constants of the example; those that are not named are 1 or, from c2 on, 0."""
    known = {"d": 1, "k": 1, "mu": 1, "M": 1, "c2": 0, "c3": 0, "c4": 0, "c_v2": 0, **values}
    return tuple(f"{name} == {value}" for name, value in known.items())


def half_square(z: str) -> str:
    """The cost z^2/2."""
    return f"({z})**2/2"


def update(sign: str, late: str, early: str, costs: tuple[Cost, Cost] = (half_square,) * 2) -> str:
    """The error after one step of one coordinate, all of it written out.

    Parameters
    ----------
    sign : str
        Delta.
    late, early : str
        The estimate before the step less the target at the second and at the first instant.
    costs : pair of callable
        Cost at the second and at the first instant, of the distance from the target.

    Returns
    -------
    str
    """
    plus, minus = f"{late} + {sign}*beta", f"{early} - {sign}*beta"
    return f"({late} - alpha*{sign}*({costs[0](plus)} - ({costs[1](minus)}))/(2*beta))"


def mean(terms: list[str]) -> str:
    """Mean of what is equally likely."""
    return f"({' + '.join(terms)})/{len(terms)}"


def mean_square(terms: list[str]) -> str:
    """Mean of the squares of what is equally likely."""
    return mean([f"{entry}*{entry}" for entry in terms])
