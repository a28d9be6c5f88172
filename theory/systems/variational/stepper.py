"""What is generated for the variational estimator: (24), its second-order form, and the start."""

from __future__ import annotations

from ...algebra.lagrange import discrete_equation
from ...codegen.stepper import Assignment, Program, Slot, Stepper
from ...expressions import Tree, canonical, parse, walk
from ...symbols import Law, Parameter, Signal
from .model import SYSTEM
from .statements.common import centred_dissipation, lagrangian

KINDS: dict[str, Signal | Parameter] = {symbol.name: symbol for symbol in SYSTEM.symbols}


def _slot(name: str, *shape: str) -> Slot:
    symbol = KINDS[name]
    return Slot(name, shape, symbol.unit, symbol.meaning)


def _sum_of(equation: str) -> Tree:
    """The sum over the sensors in (6) or (7)."""
    return next(t for t in walk(SYSTEM.law(equation).tree) if t[:2] == ("call", "sum"))


SUMS = {canonical(_sum_of("(6)")): "b_bar", canonical(_sum_of("(7)")): "v_bar"}

GROUPS = {
    "context": (
        _slot("M", "n", "n"),
        _slot("K", "n", "n"),
        _slot("C", "n", "n"),
        _slot("h"),
    ),
    "state": (_slot("b_hat", "n"), _slot("v_hat", "n"), _slot("u", "n")),
    "input": (
        Slot("b_bar", ("n",), "m", "weighted mean of the measured positions, (6), new sample"),
        Slot("v_bar", ("n",), "m/s", "weighted mean of the measured velocities, (7), new sample"),
    ),
    "start": (
        Slot("b_start", ("n",), "m", "first estimate of the position"),
        Slot("u_start", ("n",), "m/s", "first velocity error, 0 if nothing is known"),
    ),
}


def _later(tree: Tree, names: frozenset[str]) -> Tree:
    """A formula one sample later: these names, and the inputs, are those of the new sample."""
    if tree[0] == "name":
        return ("call", "next", tree) if tree[1] in names else tree
    if tree[:2] == ("call", "sum"):
        return tree
    return tuple(_later(part, names) if isinstance(part, tuple) else part for part in tree)


def _isolated(law: Law, name: str) -> Tree:
    """The right side of ``left = name - rest`` solved for the name: left + rest."""
    _, left, (sign, unknown, rest) = law.tree
    if (sign, unknown) != ("-", ("name", name)):
        raise ValueError(f"{law.equation}: not of the form left = {name} - rest")
    return ("+", left, rest)


MOVING = frozenset({"b_hat", "v_hat", "u", "x"})
FIRST, LAST = SYSTEM.law("(20), first line"), SYSTEM.law("(20), last line")
POSITION = Assignment("next(b_hat)", FIRST.tree[2], "(20), first line")
ERROR = Assignment("next(x)", _later(SYSTEM.law("(6)").tree[2], MOVING), "(6) at the new sample")
VELOCITY = Assignment(
    "next(v_hat)",
    _later(_isolated(SYSTEM.law("(7)"), "v_hat"), MOVING),
    "(7) at the new sample",
)
PRINTED = Assignment("next(u)", LAST.tree[2], "(20), last line", LAST.tree[1][1])


def _centred() -> Assignment:
    """The last line with the dissipation centred at the node, from the same action."""
    equation = discrete_equation(lagrangian, centred_dissipation)
    factor, kept = (parse(str(form)) for form in (-equation.before("u"), equation.before("v")))
    pull = parse(str(-equation.before("x")))
    new_x: Tree = ("call", "next", ("name", "x"))
    right = ("-", ("*", kept, ("name", "u")), ("*", pull, new_x))
    return Assignment("next(u)", right, "second-order form of (20)", factor)


NEXT = {name: f"next({name})" for name in ("b_hat", "v_hat", "u")}

STEPPER = Stepper(
    system="variational",
    title="Variational estimator of a target's position and velocity",
    groups=GROUPS,
    sums=SUMS,
    programs=(
        Program(
            "init",
            ("start", "input"),
            (
                Assignment("first(b_hat)", ("name", "b_start"), "given"),
                Assignment("first(u)", ("name", "u_start"), "given"),
                Assignment("first(v_hat)", ("+", ("name", "u_start"), _sum_of("(7)")), "(7)"),
            ),
            {name: f"first({name})" for name in ("b_hat", "v_hat", "u")},
            "State before the first step",
        ),
        Program(
            "step",
            ("context", "state", "input"),
            (POSITION, ERROR, PRINTED, VELOCITY),
            NEXT,
            "One step of the estimator as printed, (24)",
        ),
        Program(
            "leapfrog_step",
            ("context", "state", "input"),
            (POSITION, ERROR, _centred(), VELOCITY),
            NEXT,
            "One step of the second-order form, the damper centred at the node",
        ),
    ),
    guards=("M and C symmetric positive definite and h > 0: the pivots are positive",),
    coordinates=3,
)
