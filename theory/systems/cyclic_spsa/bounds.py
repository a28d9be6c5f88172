"""Theorem 1 as data: what (21) promises as printed, and what its proof gives once repaired.

Both bounds are lists of definitions in integers, names and ``+ - * / **``, each in the names before
it. Square roots are names too: ``root_d`` and ``root_k`` of the numbers d and k, ``root_q`` of the
last definition, which whoever evaluates puts in, or knows by their squares. The constant c1 is
always 0, because As1 makes the gradient of F_t vanish at theta_t.

Units are F of the cost and L of the positions; steps and gains have those that follow. Several
printed summands do not fit theirs, which `unit_clashes` finds.

References
----------
V. Erofeeva, O. Granichin, Theorem 1 and Assumptions 1 to 7.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ...dimensions import Clash, clashes
from ...expressions import Tree, parse
from ...kinds import Kind
from ...units import Unit, parse_unit

HALF = Fraction(1, 2)
GENERIC = ("F", "L")

GIVEN: Mapping[str, str] = {
    "d": "1",
    "k": "1",
    "root_d": "1",
    "root_k": "1",
    "mu": "F/L^2",
    "M": "F/L^2",
    "alpha": "L^2/F",
    "beta": "L",
    "delta": "L",
    "c2": "F^2/L^2",
    "c3": "F^2/L^2",
    "c4": "F^2",
    "c_v2": "F^2",
}
"""Unit of each number that Assumptions 1 to 7 speak of; c_v2 stands for c_v^2."""


@dataclass(frozen=True)
class Definition:
    """One line of a theorem.

    Parameters
    ----------
    name, text : str
        What is defined, and its formula in the names before it.
    unit : str
        Unit that it must have, in F and L.
    """

    name: str
    text: str
    unit: str

    @property
    def tree(self) -> Tree:
        """The formula, read."""
        return parse(self.text)


@dataclass(frozen=True)
class Bound:
    """A bound on the root-mean-square error, and the steps for which it is promised.

    Parameters
    ----------
    limit : tuple of Definition
        gamma first; the last one is the supremum of the steps.
    lines : tuple of Definition
        In order; the last one, q, is the square of ``root_q``.
    value : Definition
        The bound, with ``root_q``.
    """

    limit: tuple[Definition, ...]
    lines: tuple[Definition, ...]
    value: Definition

    @property
    def definitions(self) -> tuple[Definition, ...]:
        """All lines, the bound last."""
        return (*self.limit, *self.lines, self.value)


def _lines(*entries: tuple[str, str, str]) -> tuple[Definition, ...]:
    return tuple(Definition(*entry) for entry in entries)


LIMIT = ("limit", "mu/gamma", "L^2/F")
SPLIT = _lines(("s", "mu**2 - 2*gamma", "F^2/L^4"))[0]
"""Printed as the condition of the second branch: the interval is cut where it is not negative."""
CUTS = _lines(
    ("cut_low", "(mu - root_s)/(2*gamma)", "L^2/F"),
    ("cut_high", "(mu + root_s)/(2*gamma)", "L^2/F"),
)
"""The ends of what the second branch leaves out, ``root_s`` being the root of `SPLIT`."""

PRINTED = Bound(
    limit=_lines(("gamma", "3*d*(M**2*d + c3/beta)", "F^2/L^4"), LIMIT),
    lines=_lines(
        ("m", "2*(mu - alpha*gamma)", "F/L^2"),
        (
            "b",
            "2*beta*M*d*root_d*(1 + 6*alpha*M*d) + delta*(M + 2*mu + 6*alpha*M**2*d**2)",
            "F/L",
        ),
        ("change", "c4/beta + d*(c2 + M**2*(delta + 2*beta*root_d)**2)", "F^2/L^2"),
        ("spread", "c_v2 + 3*change", "F^2/L^2"),
        ("lag", "4*beta*M*d*root_d + M*delta + 3*mu*delta**2", "F/L"),
        ("l_bar", "2*alpha*d*spread + 2*delta*lag", "F"),
        ("l", "l_bar + 2*b*k*root_k*delta + (1 - alpha*m)/alpha*delta**2", "F"),
        ("q", "b**2 + m*l", "F^2/L^2"),
    ),
    value=Definition("bound", "root_k*(b + root_q)/m", "L"),
)
"""(21) and the constants below it, without c1 = 0 and the arbitrary epsilon. ``change``, ``spread``
and ``lag`` are the brackets of l-bar."""

PROVED = Bound(
    limit=_lines(("gamma", "3*d*(M**2*d + c3/(8*beta**2))", "F^2/L^4"), LIMIT),
    lines=_lines(
        ("m", "2*(mu - alpha*gamma)", "F/L^2"),
        (
            "b",
            "((2*mu + M)*delta + M*beta*d*root_d)/2 + 6*alpha*d**2*root_d*M**2*beta"
            " + 3*alpha*d*c3*delta/(4*beta**2)",
            "F/L",
        ),
        (
            "l",
            "M*delta**2 + 3*alpha*d*(2*d*c2 + 2*d**2*M**2*beta**2"
            " + (c3*(delta**2 + d*beta**2) + c4 + c_v2)/(4*beta**2))",
            "F",
        ),
        ("lag", "2*k*delta/alpha", "F/L"),
        ("q", "b**2 + m*l + 2*lag*b + lag**2*(1 - alpha*m)", "F^2/L^2"),
    ),
    value=Definition("bound", "root_k*((b + lag + root_q)/m - 2*k*delta)", "L"),
)
"""What the printed assumptions give, As5 for every x and with squares: a factor root_k for all
blocks together, each beside the positions of its own last update."""


def units(bound: Bound) -> dict[str, Unit]:
    """Unit of every name of a bound, as it must be."""
    own = {line.name: line.unit for line in (*bound.definitions, SPLIT)}
    found = {name: parse_unit(text, GENERIC) for name, text in {**GIVEN, **own}.items()}
    roots = {f"root_{name}": found[name] ** HALF for name in ("q", "s")}
    return found | roots


def unit_clashes(bound: Bound) -> dict[str, tuple[Clash, ...]]:
    """Sums of a bound whose terms have several units, by the definition that holds them.

    Parameters
    ----------
    bound : Bound

    Returns
    -------
    dict of str to tuple of Clash
        Only the definitions with clashes; each name counts with the unit that it must have.
    """
    kinds = {name: Kind(unit) for name, unit in units(bound).items()}
    found = {line.name: clashes(f"{line.name} == {line.text}", kinds) for line in bound.definitions}
    return {name: entries for name, entries in found.items() if entries}


def evaluated(tree: Tree, values: Mapping[str, Any]) -> Any:
    """Value of a formula in whatever numbers `values` holds.

    Parameters
    ----------
    tree : tuple
        From `theory.expressions.parse`: numbers, names, powers, ``+ - * /``.
    values : mapping of str to number
        Fractions, balls or floats.

    Raises
    ------
    ValueError
        The formula holds something else.
    """
    match tree:
        case ("number", value):
            return value
        case ("name", name):
            return values[name]
        case ("power", base, exponent):
            return evaluated(base, values) ** exponent
        case ("+", left, right):
            return evaluated(left, values) + evaluated(right, values)
        case ("-", left, right):
            return evaluated(left, values) - evaluated(right, values)
        case ("*", left, right):
            return evaluated(left, values) * evaluated(right, values)
        case ("/", left, right):
            return evaluated(left, values) / evaluated(right, values)
    raise ValueError(f"{tree[0]} is no arithmetic of numbers")


def table(bound: Bound, given: Mapping[str, Any], root: Callable[[Any], Any]) -> dict[str, Any]:
    """Every line of a bound, for a step below its limit.

    Parameters
    ----------
    bound : Bound
    given : mapping of str to number
        The names of `GIVEN` without roots.
    root : callable
        Square root of such a number.

    Returns
    -------
    dict of str to number
        `given`, the roots, and each definition; ``bound`` is the bound.
    """
    values = {**given, "root_d": root(given["d"]), "root_k": root(given["k"])}
    for line in (*bound.limit, *bound.lines):
        values[line.name] = evaluated(line.tree, values)
    values["root_q"] = root(values["q"])
    values[bound.value.name] = evaluated(bound.value.tree, values)
    return values
