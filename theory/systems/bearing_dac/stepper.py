"""What one node computes: its signal from a bearing, the sign of a link, its step, its position.

P_x has trace 1 and is symmetric for ever, so four entries are kept: the first row of P_x and q_x.
A link's sign is taken entry by entry, as printed, or as the direction of the difference, block by
block ("isotropic"): the rows of P as (P_00 - P_11, 2 P_01)/2 and q as vectors of the plane.
"""

from __future__ import annotations

from ...codegen.stepper import Assignment, Program, Slot, Stepper
from ...expressions import Tree
from ...symbols import Parameter, Signal
from .model import SYSTEM

KINDS: dict[str, Signal | Parameter] = {symbol.name: symbol for symbol in SYSTEM.symbols}
BLOCKS = {"P": "first row of P", "q": "q"}
UNITS = {"P": "1", "q": "m"}
LARGE, SMALL = (-3.0, 3.0), (0.001, 0.05)


def _pair(stem: str, meaning: str, drawn: tuple[float, float] = LARGE) -> tuple[Slot, ...]:
    """One slot a block, two numbers each."""
    return tuple(
        Slot(f"{stem}_{block}", ("n",), UNITS[block], f"{words}: {meaning}", drawn)
        for block, words in BLOCKS.items()
    )


def _links(stem: str, meaning: str) -> tuple[Slot, ...]:
    return tuple(
        Slot(f"{stem}_{block}", ("n",), "1", f"{words}: {meaning}", LARGE)
        for block, words in BLOCKS.items()
    )


THETA = KINDS["theta"].meaning
FIX = (
    Slot("p", ("n",), "m", "position that this node computes, 0 without status", LARGE),
    Slot("status", (), "1", "1 if det P_x is above det_min, so that there is a position", (0, 1)),
)
GROUPS = {
    "context": (
        Slot("s", ("n",), "m", "position of this node", (-9.0, 9.0)),
        Slot("period", (), "s", "time between samples", (0.01, 0.5)),
        Slot("beta_P", (), "1/s", "gain for the entries of P", SMALL),
        Slot("beta_q", (), "m/s", "gain for the entries of q", SMALL),
        Slot("det_min", (), "1", "smallest det P_x that counts as information", SMALL),
    ),
    "state": (
        *_pair("w", "internal state", (-0.2, 0.2)),
        *_pair("x", "estimate of the average", (-0.2, 1.2)),
        *FIX,
    ),
    "input": (
        Slot("theta", (), "rad", f"{THETA}, new sample", (-3.2, 3.2)),
        *_links("pull", "sum of link over the neighbours, old sample"),
    ),
    "start": (Slot("theta_start", (), "rad", f"{THETA}, first sample", (-3.2, 3.2)),),
    "own": _pair("own", "estimate of this node"),
    "other": _pair("other", "estimate of a neighbour"),
    "signs": _links("sign", "what one link adds to the sum"),
    "signal": _pair("r", "what is averaged"),
    "estimate": _pair("mean", "estimate of the average", (-0.2, 1.2)),
    "fix": (
        Slot("place", ("n",), "m", "position, 0 where it is not known"),
        Slot("known", (), "1", "1 if it is known, else 0"),
    ),
}


def _renamed(tree: Tree, names: dict[str, str]) -> Tree:
    if tree[0] == "name":
        return ("name", names.get(tree[1], tree[1]))
    return tuple(_renamed(part, names) if isinstance(part, tuple) else part for part in tree)


def _signal(theta: str) -> tuple[Assignment, ...]:
    """h, z and the entries of P and q from a bearing."""
    direction, angle = SYSTEM.law("Proposition 1"), {"theta": theta}
    measured, outer = SYSTEM.law("measurement"), SYSTEM.law("Algorithm 1, line 5").tree[2]
    row: Tree = ("call", "column", ("entry", outer, 0, 0), ("entry", outer, 0, 1))
    last = SYSTEM.law("Algorithm 1, line 6")
    return (
        Assignment("h", _renamed(direction.tree[2], angle), direction.equation),
        Assignment("z", measured.tree[2], measured.equation),
        Assignment("r_P", row, "Algorithm 1, line 5, first row"),
        Assignment("r_q", last.tree[2], last.equation),
    )


def _position(rows: Tree, right: Tree) -> Assignment:
    """inv(P_x) q_x, where P_x has the trace 1, if its determinant allows it."""
    a, b = (("entry", rows, i, 0) for i in (0, 1))
    matrix: Tree = ("rows", (a, b), (b, ("-", ("number", 1), a)))
    law = SYSTEM.law("Algorithm 1, line 12")
    if law.tree[2] != ("*", ("call", "inv", ("name", "P_x")), ("name", "q_x")):
        raise ValueError(f"{law.equation}: not of the form inv(P_x)*q_x")
    return Assignment("p_i", right, law.equation, matrix, "det_min")


def _moved(block: str) -> Assignment:
    """w + period (-beta) pull: line 9 by explicit Euler, B sgn(B'x) being the sum over links."""
    law = SYSTEM.law("Algorithm 1, line 9")
    match law.tree[2]:
        case ("*", ("*", gain, ("name", "B")), ("call", "sgn", _)):
            rate = ("*", _renamed(gain, {"beta": f"beta_{block}"}), ("name", f"pull_{block}"))
        case _:
            raise ValueError(f"{law.equation}: not of the form gain*B*sgn(...)")
    step: Tree = ("*", ("name", "period"), rate)
    source = f"{law.equation}, explicit Euler"
    return Assignment(f"next(w_{block})", ("+", ("name", f"w_{block}"), step), source)


def _seen(block: str, w: str) -> Assignment:
    law = SYSTEM.law("Algorithm 1, line 8")
    names = {"w": f"{w}(w_{block})", "r": f"r_{block}"}
    return Assignment(f"{w}(x_{block})", _renamed(law.tree[2], names), law.equation)


def _rest(block: str) -> Assignment:
    zero: Tree = ("*", ("number", 0), ("name", f"r_{block}"))
    return Assignment(f"first(w_{block})", zero, "Algorithm 1, line 1")


def _sign(block: str, isotropic: bool) -> Assignment:
    difference: Tree = ("-", ("name", f"own_{block}"), ("name", f"other_{block}"))
    tree: Tree = ("direction", difference) if isotropic else ("call", "sgn", difference)
    return Assignment(f"sign_{block}", tree, "Algorithm 1, line 9, one link")


def _state(when: str) -> dict[str, str]:
    moved = {f"{part}_{block}": f"{when}({part}_{block})" for part in "wx" for block in BLOCKS}
    return moved | {"p": "p_i", "status": "status(p_i)"}


def _both(stem: str, target: str) -> dict[str, str]:
    return {f"{stem}_{block}": f"{target}_{block}" for block in BLOCKS}


def _link(name: str, isotropic: bool, about: str) -> Program:
    signs = tuple(_sign(block, isotropic) for block in BLOCKS)
    return Program(name, ("own", "other"), signs, _both("sign", "sign"), about, "signs")


STEPPER = Stepper(
    system="bearing_dac",
    title="One node of bearing sensors with sign-based dynamic average consensus",
    groups=GROUPS,
    sums={},
    programs=(
        Program(
            "init",
            ("context", "start"),
            (
                *_signal("theta_start"),
                *map(_rest, BLOCKS),
                *(_seen(block, "first") for block in BLOCKS),
                _position(("name", "first(x_P)"), ("name", "first(x_q)")),
            ),
            _state("first"),
            "State before the first step",
        ),
        Program(
            "step",
            ("context", "state", "input"),
            (
                *map(_moved, BLOCKS),
                *_signal("theta"),
                *(_seen(block, "next") for block in BLOCKS),
                _position(("name", "next(x_P)"), ("name", "next(x_q)")),
            ),
            _state("next"),
            "One explicit step of Algorithm 1",
        ),
        _link("link", False, "What one neighbour adds to the sum of signs, as printed"),
        _link("link_isotropic", True, "The same with the direction of the difference"),
        Program(
            "measure",
            ("context", "start"),
            _signal("theta_start"),
            _both("r", "r"),
            "What a node averages, from its bearing",
            "signal",
        ),
        Program(
            "position",
            ("context", "estimate"),
            (_position(("name", "mean_P"), ("name", "mean_q")),),
            {"place": "p_i", "known": "status(p_i)"},
            "Position from an estimate of the average, if det P_x allows it",
            "fix",
        ),
    ),
    guards=("nothing: where det P_x <= det_min there is no division, and status is 0",),
    coordinates=2,
    unknown="A bearing that is NaN gives status 0 and no position; a link's sign of NaN is 0.",
)
