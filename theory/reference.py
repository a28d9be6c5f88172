"""Slow literal evaluation of generated steps in many digits: the yardstick for all source.

The laws are evaluated as matrices of multiple-precision numbers, straight from their trees, and
linear systems are solved by elimination with pivoting: nothing is shared with the lowering.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .codegen.stepper import Program, Slot, Stepper
from .expressions import Tree, canonical

DIGITS = 50


def evaluate(
    stepper: Stepper, program: Program, n: int, groups: Mapping[str, Sequence[float]]
) -> list[Any]:
    """State that a program leads to, in 50 digits.

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
        In the order of the state's layout.
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
                right = mp.lu_solve(left_side, right)
            values[assignment.target] = right
        slots = stepper.groups["state"]
        return [x for slot in slots for x in values[program.results[slot.name]]]


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
    from mpmath import mp

    match tree:
        case ("number", number):
            return mp.mpf(number)
        case ("name", name):
            return values[name]
        case ("call", "next", ("name", name)):
            return values[f"next({name})"]
        case ("call", "sum", _):
            return values[sums[canonical(tree)]]
        case ("+", left, right):
            return _value(left, values, sums) + _value(right, values, sums)
        case ("-", left, right):
            return _value(left, values, sums) - _value(right, values, sums)
        case ("*", left, right):
            return _value(left, values, sums) * _value(right, values, sums)
        case ("/", left, right):
            return _value(left, values, sums) / _value(right, values, sums)
    raise ValueError(f"{canonical(tree)} cannot be evaluated")
