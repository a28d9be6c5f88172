"""What one sensor computes: position from a measurement (13), two costs (20), Algorithm 1's update.

The costs of a step belong to two instants, so each has a function of its own; `step` is both and
the update at once. Given the same measured positions twice, it is the step of one instant.
"""

from __future__ import annotations

from ...codegen.stepper import Assignment, Program, Slot, Stepper
from ...expressions import Tree
from ...symbols import Parameter, Signal
from .model import SYSTEM

KINDS: dict[str, Signal | Parameter] = {symbol.name: symbol for symbol in SYSTEM.symbols}
AXES = {0: "first axis", 1: "second axis"}


def _slot(name: str, *shape: str, drawn: tuple[float, float] | None = None) -> Slot:
    symbol = KINDS[name]
    return Slot(name, shape, symbol.unit, symbol.meaning, drawn)


def _axes(stem: str) -> tuple[Slot, ...]:
    """One number an axis: the plane has two, however many coordinates the block has."""
    symbol = KINDS[stem]
    return tuple(
        Slot(f"{stem}_{i}", (), symbol.unit, f"{symbol.meaning}, {axis}")
        for i, axis in AXES.items()
    )


GROUPS = {
    "context": (_slot("H", "n", "n"), _slot("alpha"), _slot("beta")),
    "state": (_slot("theta_hat", "n"),),
    "input": (_slot("Delta", "n"), _slot("q_minus", "n"), _slot("q_plus", "n")),
    "start": (Slot("theta_start", ("n",), "m", "first estimate of the block's positions"),),
    "minus": (_slot("Delta", "n"), _slot("q_minus", "n")),
    "plus": (_slot("Delta", "n"), _slot("q_plus", "n")),
    "costs": (_slot("Delta", "n"), _slot("y_minus"), _slot("y_plus")),
    "cost": (Slot("y", (), "m^2", "cost"),),
    "sender": (
        *_axes("s"),
        Slot("growth", (), "1", "1 for (13) as printed, exp(variance of z_1/2) without its bias"),
    ),
    "measurement": (_slot("z_1", drawn=(-3.2, 3.2)), _slot("z_2", drawn=(0.1, 10.0))),
    "place": _axes("p"),
}


def _law(equation: str) -> Assignment:
    law = SYSTEM.law(equation)
    _, left, right = law.tree
    target = f"next({left[2][1]})" if left[0] == "call" else left[1]
    return Assignment(target, right, law.equation)


def _position() -> tuple[Assignment, ...]:
    """(13), its polar part times the factor that takes the bias away, axis by axis."""
    law = SYSTEM.law("(13)")
    sender: Tree = ("call", "column", *(("name", f"s_{i}") for i in AXES))
    match law.tree[2]:
        case ("+", ("name", "s"), polar):
            whole: Tree = ("+", sender, ("*", ("name", "growth"), polar))
        case _:
            raise ValueError(f"{law.equation}: not of the form s + polar part")
    return tuple(
        Assignment(f"position_{i}", ("entry", whole, i, 0), f"{law.equation}, {axis}")
        for i, axis in AXES.items()
    )


MINUS = (_law("Algorithm 1, step 3.2"), _law("(20), first point"))
PLUS = (_law("Algorithm 1, step 3.5"), _law("(20), second point"))
UPDATE = (_law("Algorithm 1, step 3.8"), _law("Algorithm 1, step 3.9"))
NEXT = {"theta_hat": "next(theta_hat)"}

STEPPER = Stepper(
    system="cyclic_spsa",
    title="One block of cyclic simultaneous perturbation stochastic approximation",
    groups=GROUPS,
    sums={},
    programs=(
        Program(
            "init",
            ("start",),
            (Assignment("first(theta_hat)", ("name", "theta_start"), "given"),),
            {"theta_hat": "first(theta_hat)"},
            "State before the first step",
        ),
        Program(
            "step",
            ("context", "state", "input"),
            (*MINUS, *PLUS, *UPDATE),
            NEXT,
            "Both costs and the update of one block",
        ),
        Program(
            "first_cost",
            ("context", "state", "minus"),
            MINUS,
            {"y": "y_minus"},
            "Cost at the first instant",
            "cost",
        ),
        Program(
            "second_cost",
            ("context", "state", "plus"),
            PLUS,
            {"y": "y_plus"},
            "Cost at the second instant",
            "cost",
        ),
        Program(
            "update",
            ("context", "state", "costs"),
            UPDATE,
            NEXT,
            "Update from both costs, which may be those of a larger block",
        ),
        Program(
            "position",
            ("sender", "measurement"),
            _position(),
            {f"p_{i}": f"position_{i}" for i in AXES},
            "Position of a target from one measurement",
            "place",
        ),
    ),
    guards=("beta > 0: it is divided by",),
    coordinates=2,
)
