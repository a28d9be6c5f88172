"""Formulas as text that knows its units and shapes.

The language is the arithmetic that papers use: names, integers, ``+ - * / **`` and the functions of
`theory.kinds.FUNCTIONS`. ``d(x)`` is the time derivative, ``next(x)`` the value one sample later,
``sum(x)`` and ``mean(x)`` run over the sensors. A formula is read once into a tree of tuples; its
canonical text is ours, so that a digest does not depend on how some library prints.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from typing import Any

from .kinds import FUNCTIONS, FormulaError, Kind, need
from .units import NUMBER

Tree = tuple[Any, ...]

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
            need(len(args) == arity or (arity is None and bool(args)), f"{name}: arguments")
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
            need(name in kinds, f"{name} is not declared")
            return kinds[name]
        case ("power", base, exponent):
            kind = kind_of(base, kinds)
            need(kind.scalar, f"a power of {kind}; a scalar is needed")
            return Kind(kind.unit**exponent)
        case ("call", name, *arguments):
            return FUNCTIONS[name][1](*(kind_of(argument, kinds) for argument in arguments))
        case ("*", left, right):
            return _product(kind_of(left, kinds), kind_of(right, kinds))
        case ("/", left, right):
            below = kind_of(right, kinds)
            need(below.scalar, f"a division by {below}; a scalar is needed")
            return _product(kind_of(left, kinds), Kind(below.unit**-1))
        case ("+" | "-" as sign, left, right):
            kind, other = kind_of(left, kinds), kind_of(right, kinds)
            need(kind == other, f"{kind} {sign} {other}; the same unit and shape are needed")
            return kind
    raise FormulaError(f"{canonical(tree)} has no value")


def _product(left: Kind, right: Kind) -> Kind:
    unit = left.unit * right.unit
    if left.scalar or right.scalar:
        return Kind(unit, right.shape if left.scalar else left.shape)
    need(left.shape[1] == right.shape[0], f"{left} times {right}; inner sizes must agree")
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
    need(comparison, f"{canonical(tree)}; a comparison is needed")
    sides = [kind_of(side, kinds) for side in tree[1:] if side != ("number", 0)]
    need(len({*sides}) == 1, " and ".join(map(str, sides)) + " are compared; one unit is needed")
