"""Formulas as text that knows its units and shapes.

The language is the arithmetic that papers use: names, integers, ``+ - * / **`` and the functions of
`FUNCTIONS`. ``d(x)`` is the time derivative, ``next(x)`` the value one sample later, ``sum(x)`` and
``mean(x)`` run over the sensors. A formula is read once into a tree of tuples; its canonical text
is ours, so that a digest does not depend on how some library prints.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from .units import NUMBER, Unit, parse_unit

Size = int | str
Tree = tuple[Any, ...]
SECOND = parse_unit("s")


class FormulaError(ValueError):
    """A formula that cannot be read, or whose units or shapes do not fit."""


@dataclass(frozen=True)
class Kind:
    """Unit and shape of a quantity.

    Parameters
    ----------
    unit : Unit
    shape : tuple of (int or str)
        Rows and columns; a vector has one column, a scalar is 1 by 1. A text is a dimension.
    """

    unit: Unit
    shape: tuple[Size, Size] = (1, 1)

    @property
    def scalar(self) -> bool:
        """Whether it is one number."""
        return self.shape == (1, 1)

    def __str__(self) -> str:
        """Return shape and unit for messages."""
        return f"{self.shape[0]} by {self.shape[1]} in {self.unit}"


def _need(condition: bool, message: str) -> None:
    if not condition:
        raise FormulaError(message)


# ------------------------------------------------------------------------------- functions


def _transpose(x: Kind) -> Kind:
    return Kind(x.unit, x.shape[::-1])


def _inverse(x: Kind) -> Kind:
    _need(x.shape[0] == x.shape[1], f"inv of {x}; a square matrix is needed")
    return Kind(x.unit**-1, x.shape)


def _rate(x: Kind) -> Kind:
    return Kind(x.unit / SECOND, x.shape)


def _same(x: Kind) -> Kind:
    return x


def _size(x: Kind) -> Kind:
    return Kind(x.unit)


def _sign(x: Kind) -> Kind:
    return Kind(NUMBER, x.shape)


def _root(x: Kind) -> Kind:
    _need(x.scalar, f"sqrt of {x}; a scalar is needed")
    return Kind(x.unit ** Fraction(1, 2))


def _angle(x: Kind) -> Kind:
    _need(x == Kind(NUMBER), f"sin or cos of {x}; an angle is needed")
    return x


def _determinant(x: Kind) -> Kind:
    rows, columns = x.shape
    _need(rows == columns, f"det of {x}; a square matrix is needed")
    _need(isinstance(rows, int) or x.unit == NUMBER, f"det of {x}; a size is needed")
    return Kind(x.unit**rows if isinstance(rows, int) else NUMBER)


def _column(*entries: Kind) -> Kind:
    good = {entry.shape for entry in entries} == {(1, 1)} and len({*entries}) == 1
    _need(good, "column of unlike entries; scalars of one unit are needed")
    return Kind(entries[0].unit, (len(entries), 1))


FUNCTIONS: Mapping[str, tuple[int | None, Callable[..., Kind]]] = {
    "T": (1, _transpose),
    "inv": (1, _inverse),
    "d": (1, _rate),
    "next": (1, _same),
    "previous": (1, _same),
    "sum": (1, _same),
    "mean": (1, _same),
    "norm": (1, _size),
    "largest": (1, _size),
    "sgn": (1, _sign),
    "sqrt": (1, _root),
    "sin": (1, _angle),
    "cos": (1, _angle),
    "det": (1, _determinant),
    "column": (None, _column),
}
"""Name to number of arguments (None: any) and what the result is."""

OPERATORS: Mapping[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
}


# ------------------------------------------------------------------------------- reading


def parse(text: str) -> Tree:
    """Read a formula or one comparison of two formulas.

    Parameters
    ----------
    text : str

    Returns
    -------
    tuple
        ``("number", 2)``, ``("name", "x")``, ``("power", tree, 2)``, ``("+", tree, tree)``,
        ``("call", "T", tree)`` and so on.

    Raises
    ------
    FormulaError
        The text is not in the language.
    """
    try:
        return _read(ast.parse(text.strip(), mode="eval").body)
    except SyntaxError as error:
        raise FormulaError(f"formula {text!r}: {error.msg}") from error


def _read(node: ast.AST) -> Tree:
    match node:
        case ast.Constant(value=value) if type(value) is int:
            return ("number", value)
        case ast.Name(id=name):
            return ("name", name)
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return ("*", ("number", -1), _read(inner))
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=power)) if (
            type(power) is int and power > 0
        ):
            return ("power", _read(left), power)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
            return (OPERATORS[type(op)], _read(left), _read(right))
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in OPERATORS:
            return (OPERATORS[type(op)], _read(left), _read(right))
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if name in FUNCTIONS:
            arity = FUNCTIONS[name][0]
            _need(len(args) == arity or (arity is None and bool(args)), f"{name}: arguments")
            return ("call", name, *map(_read, args))
    raise FormulaError(f"formula: {ast.unparse(node)!r} is not in the language")


def canonical(tree: Tree) -> str:
    """One text for one tree: operator first, everything in brackets."""
    parts = [canonical(part) if isinstance(part, tuple) else str(part) for part in tree]
    return f"({' '.join(parts)})"


def walk(tree: Tree) -> Iterator[Tree]:
    """Every subtree, the whole first."""
    yield tree
    for part in tree:
        if isinstance(part, tuple):
            yield from walk(part)


def names(tree: Tree) -> frozenset[str]:
    """Names that a formula uses."""
    return frozenset(part[1] for part in walk(tree) if part[0] == "name")


def calls(tree: Tree) -> frozenset[str]:
    """Functions that a formula uses."""
    return frozenset(part[1] for part in walk(tree) if part[0] == "call")


# ------------------------------------------------------------------------------- units and shapes


def kind_of(tree: Tree, kinds: Mapping[str, Kind]) -> Kind:
    """Work out unit and shape of a formula.

    Parameters
    ----------
    tree : tuple
        From `parse`.
    kinds : mapping of str to Kind
        Unit and shape of each name.

    Returns
    -------
    Kind

    Raises
    ------
    FormulaError
        A name is unknown, or units or shapes do not fit.
    """
    match tree:
        case ("number", _):
            return Kind(NUMBER)
        case ("name", name):
            _need(name in kinds, f"{name} is not declared")
            return kinds[name]
        case ("power", base, exponent):
            kind = kind_of(base, kinds)
            _need(kind.scalar, f"a power of {kind}; a scalar is needed")
            return Kind(kind.unit**exponent)
        case ("call", name, *arguments):
            return FUNCTIONS[name][1](*(kind_of(argument, kinds) for argument in arguments))
        case ("*", left, right):
            return _product(kind_of(left, kinds), kind_of(right, kinds))
        case ("/", left, right):
            below = kind_of(right, kinds)
            _need(below.scalar, f"a division by {below}; a scalar is needed")
            return _product(kind_of(left, kinds), Kind(below.unit**-1))
        case ("+" | "-" as sign, left, right):
            kind, other = kind_of(left, kinds), kind_of(right, kinds)
            _need(kind == other, f"{kind} {sign} {other}; the same unit and shape are needed")
            return kind
    raise FormulaError(f"{canonical(tree)} has no value")


def _product(left: Kind, right: Kind) -> Kind:
    unit = left.unit * right.unit
    if left.scalar or right.scalar:
        return Kind(unit, right.shape if left.scalar else left.shape)
    _need(left.shape[1] == right.shape[0], f"{left} times {right}; inner sizes must agree")
    return Kind(unit, (left.shape[0], right.shape[1]))


def check_comparison(tree: Tree, kinds: Mapping[str, Kind]) -> None:
    """Demand that both sides of an equation or inequality have one unit and one shape.

    Parameters
    ----------
    tree : tuple
        From `parse`; the literal 0 fits every unit and shape.
    kinds : mapping of str to Kind

    Raises
    ------
    FormulaError
        They differ, or it is no comparison.
    """
    comparison = tree[0] in {"==", "!=", "<", "<=", ">", ">="}
    _need(comparison, f"{canonical(tree)}; a comparison is needed")
    sides = [kind_of(side, kinds) for side in tree[1:] if side != ("number", 0)]
    _need(len({*sides}) == 1, " and ".join(map(str, sides)) + " are compared; one unit is needed")
