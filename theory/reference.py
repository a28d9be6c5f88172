"""Slow literal evaluation of generated steps in many digits: the yardstick for all source.

The laws are evaluated as matrices of multiple-precision numbers, straight from their trees, and
linear systems are solved by elimination with pivoting: nothing is shared with the lowering.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .codegen.stepper import Program, Slot, Stepper
from .expressions import Tree, canonical

DIGITS = 50


def evaluate(
    stepper: Stepper, program: Program, n: int, groups: Mapping[str, Sequence[float]]
) -> list[Any]:
    """What a program leads to, in 50 digits.

    Parameters
    ----------
    stepper, program : Stepper, Program
    n : int
        Coordinates.
    groups : mapping of str to sequence of float
        The numbers of each group, in the order of its layout.

    Returns
    -------
    list of mpmath.mpf
        In the order of the layout of the resulting group.
    """
    from mpmath import mp

    with mp.workdps(DIGITS):
        values: dict[str, Any] = {}
        for group, numbers in groups.items():
            left = list(numbers)
            for slot in stepper.groups[group]:
                values[slot.name] = _taken(slot, n, left)
        for assignment in program.assignments:
            right = _value(assignment.tree, values, stepper.sums)
            if assignment.factor is not None:
                left_side = _value(assignment.factor, values, stepper.sums)
                known = not assignment.guard or mp.det(left_side) > values[assignment.guard]
                right = mp.lu_solve(left_side, right) if known else 0 * right
                values[f"status({assignment.target})"] = mp.mpf(known)
            values[assignment.target] = right
        slots = stepper.groups[program.output]
        found = [values[program.results[slot.name]] for slot in slots]
        return [x for value in found for x in (value if isinstance(value, mp.matrix) else [value])]


def _taken(slot: Slot, n: int, left: list[float]) -> Any:
    """A slot's value from the front of the numbers, which are used up."""
    from mpmath import mp

    if not slot.shape:
        return mp.mpf(left.pop(0))
    if len(slot.shape) == 1:
        return mp.matrix([left.pop(0) for _ in range(n)])
    matrix = mp.matrix(n, n)
    for i in range(n):
        for j in range(i, n):
            matrix[i, j] = matrix[j, i] = left.pop(0)
    return matrix


def _value(tree: Tree, values: Mapping[str, Any], sums: Mapping[str, str]) -> Any:
    match tree:
        case ("name", name):
            return values[name]
        case ("call", "next", ("name", name)):
            return values[f"next({name})"]
        case ("call", "sum", _):
            return values[sums[canonical(tree)]]
        case ("entry", inner, i, j):
            return _value(inner, values, sums)[i, j]
        case ("rows", *rows):
            return _matrix([[_value(x, values, sums) for x in row] for row in rows])
        case ("number", number):
            return _number(number)
        case ("call", str(name), *parts) | (str(name), *parts) if name in OPERATIONS:
            return OPERATIONS[name](*(_value(part, values, sums) for part in parts))
    raise ValueError(f"{canonical(tree)} cannot be evaluated")


def _matrix(rows: list[Any]) -> Any:
    from mpmath import mp

    return mp.matrix(rows)


def _number(number: int) -> Any:
    from mpmath import mp

    return mp.mpf(number)


def _product(left: Any, right: Any) -> Any:
    """A matrix of one entry is that number."""
    product = left * right
    return (
        product[0] if getattr(product, "rows", 0) == getattr(product, "cols", 0) == 1 else product
    )


def _signs(vector: Any) -> Any:
    from mpmath import mp

    return mp.matrix([mp.sign(x) for x in vector])


def _direction(vector: Any) -> Any:
    from mpmath import mp

    return vector / (mp.norm(vector) or 1)


def _angle(name: str) -> Callable[[Any], Any]:
    def call(x: Any) -> Any:
        from mpmath import mp

        return getattr(mp, name)(x)

    return call


OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "+": lambda left, right: left + right,
    "-": lambda left, right: left - right,
    "*": _product,
    "/": lambda left, right: left / right,
    "T": lambda inner: inner.T,
    "column": lambda *parts: _matrix([*parts]),
    "sin": _angle("sin"),
    "cos": _angle("cos"),
    "sgn": _signs,
    "direction": _direction,
}
"""What trees are made of, on numbers and matrices of many digits."""
