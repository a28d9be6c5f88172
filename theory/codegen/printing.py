"""What all languages share: expressions with full brackets, layouts, digest, file heads."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from .lower import Given, Lowered, entries, lower
from .scalars import FUNCTIONS, LIBM, Expr
from .stepper import Slot, Stepper

GENERATOR = "sensortrack 0.1"
ABI = 1
"""Rises when a layout or a signature changes."""


@dataclass(frozen=True)
class Source:
    """One stepper, lowered: what printers print.

    Parameters
    ----------
    stepper : Stepper
    n : int
        Coordinates.
    given : mapping
        Values that are constants; their slots are not in the context.
    functions : tuple of Lowered
    """

    stepper: Stepper
    n: int
    given: Given
    functions: tuple[Lowered, ...]

    def slots(self, group: str) -> tuple[Slot, ...]:
        """The slots of a group that are not constants."""
        return tuple(slot for slot in self.stepper.groups[group] if slot.name not in self.given)

    def layout(self, group: str) -> tuple[tuple[str, str], ...]:
        """Name and unit of each number of a group, in order."""
        return tuple(
            (name, slot.unit) for slot in self.slots(group) for name in entries(slot, self.n)
        )

    @cached_property
    def operations(self) -> Mapping[str, int]:
        """Arithmetic operations of each function."""
        return {
            f.program.name: sum(_count(f, line.expr) for line in f.lines) for f in self.functions
        }

    @cached_property
    def calls(self) -> frozenset[str]:
        """The ``FUNCTIONS`` that are used."""
        found: set[str] = set()
        stack = [line.expr for f in self.functions for line in f.lines]
        while stack:
            part = stack.pop()
            found.add(part.op)
            stack.extend(part.args)
        return frozenset(found & {*FUNCTIONS})

    @property
    def exact(self) -> bool:
        """Whether every language computes the same bits: no sine, no cosine."""
        return self.calls.isdisjoint(LIBM)

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the statement lists, the layouts and the options."""
        content = {
            "system": self.stepper.system,
            "abi": ABI,
            "coordinates": self.n,
            "layouts": {group: self.layout(group) for group in self.stepper.groups},
            "functions": {
                f.program.name: [
                    [[line.name, text(f, line.expr, PLAIN, own=True)] for line in f.lines],
                    [text(f, result, PLAIN) for result in f.results],
                ]
                for f in self.functions
            },
        }
        canonical = json.dumps(content, sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(canonical.encode()).hexdigest()


def source_of(stepper: Stepper, n: int | None = None, given: Given | None = None) -> Source:
    """Lower all functions of a stepper.

    Parameters
    ----------
    stepper : Stepper
    n : int, optional
        Coordinates; those of the committed source by default.
    given : mapping, optional
        Constants, by slot of the context.
    """
    size, constants = n or stepper.coordinates, dict(given or {})
    functions = tuple(lower(stepper, program, size, constants) for program in stepper.programs)
    return Source(stepper, size, constants, functions)


@dataclass(frozen=True)
class Language:
    """How numbers and functions are written.

    Parameters
    ----------
    literal : callable
        Writes an exact number.
    forms : mapping of str to str
        Each of ``FUNCTIONS`` to a pattern of its arguments.
    """

    literal: Callable[[Fraction], str]
    forms: Mapping[str, str]


CALLS = {
    "sin": "sin({0})",
    "cos": "cos({0})",
    "sqrt": "sqrt({0})",
    "sgn": "sgn({0}, {1})",
    "select": "select({0} > {1}, {2}, {3})",
}
PLAIN = Language(str, CALLS)
"""No language: for digests."""


def text(function: Lowered, expr: Expr, language: Language, own: bool = False) -> str:
    """An expression with full brackets; named parts by name, but for the line's own.

    Parameters
    ----------
    function : Lowered
    expr : Expr
    language : Language
    own : bool, optional
        The expression is the right side of its own line.
    """
    if expr.op == "name":
        return expr.name
    if expr.op == "const":
        return language.literal(expr.value)
    if not own and id(expr) in function.names:
        return function.names[id(expr)]
    parts = [text(function, part, language) for part in expr.args]
    if expr.op in language.forms:
        return language.forms[expr.op].format(*parts)
    return f"({parts[0]} {expr.op} {parts[1]})"


def decimal(value: Fraction) -> str:
    """The double nearest to an exact number, as decimal text that is read back to it."""
    return repr(float(value))


def _count(function: Lowered, expr: Expr, own: bool = True) -> int:
    if expr.leaf or (not own and id(expr) in function.names):
        return 0
    return 1 + sum(_count(function, part, own=False) for part in expr.args)


def heading(source: Source) -> list[str]:
    """What a reader of generated source must know, one line each."""
    stepper = source.stepper
    lines = [
        f"{stepper.title}: {source.n} coordinates.",
        "",
        f"Generated by {GENERATOR} from the laws of {stepper.system}; changes are lost.",
        f"digest {source.digest}",
        f"ABI {ABI}; operations: "
        + ", ".join(f"{name} {count}" for name, count in source.operations.items()),
        "",
    ]
    for group in stepper.groups:
        if source.slots(group):
            lines.append(f"{group}:")
            lines += [_slot_line(slot, source.n) for slot in source.slots(group)]
    lines += [
        "",
        "Assumed, so that no division fails:",
        *(f"  {guard}" for guard in stepper.guards),
    ]
    lines.append(stepper.unknown)
    return lines


def _slot_line(slot: Slot, n: int) -> str:
    count = len(entries(slot, n))
    shape = {0: "number", 1: f"{n} numbers"}.get(
        len(slot.shape), f"upper triangle, {count} numbers"
    )
    return f"  {slot.name:<6} {slot.unit:<7} {shape}: {slot.meaning}"
