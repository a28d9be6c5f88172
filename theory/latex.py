"""Laws as LaTeX, from the trees that `theory.expressions.parse` reads."""

from __future__ import annotations

from .expressions import Tree
from .notation import latex as symbol
from .symbols import Law

ADD, MULTIPLY, POWER, ATOM = 1, 2, 3, 4
"""How tightly a formula holds together: sums, products, powers, what never needs brackets."""
NAMED = {"cos": r"\cos", "sin": r"\sin", "sgn": r"\operatorname{sgn}", "det": r"\det"}
RAISED = {"T": r"^{\mathsf T}", "inv": "^{-1}", "next": "^{+}", "previous": "^{-}"}
ORDER = {"==": "=", "!=": r"\ne", "<": "<", "<=": r"\le", ">": ">", ">=": r"\ge"}


def law(given: Law) -> str:
    """LaTeX of a law, left side first.

    Parameters
    ----------
    given : Law

    Returns
    -------
    str
        Without dollar signs. A raised plus is the value one sample later, a dot the time
        derivative, and sums run over the sensors that see the target.
    """
    return formula(given.tree)


def formula(tree: Tree) -> str:
    """LaTeX of a formula or a comparison.

    Parameters
    ----------
    tree : tuple
        From `theory.expressions.parse`.
    """
    return _written(tree)[0]


def _written(tree: Tree) -> tuple[str, int]:
    match tree:
        case ("number", int(value)):
            return str(value), ATOM if value >= 0 else ADD
        case ("name", str(name)):
            return symbol(name), ATOM
        case ("power", base, exponent):
            return f"{_within(base, ATOM)}^{{{exponent}}}", POWER
        case ("*", _, _):
            return _product(_factors(tree))
        case ("/", above, below):
            return rf"\frac{{{formula(above)}}}{{{formula(below)}}}", ATOM
        case ("+" | "-" as sign, left, right):
            return f"{formula(left)} {sign} {_within(right, MULTIPLY)}", ADD
        case ("call", str(name), *arguments):
            return _call(name, arguments)
        case (str(sign), left, right) if sign in ORDER:
            return f"{formula(left)} {ORDER[sign]} {formula(right)}", ADD
    raise ValueError(f"{tree!r} has no LaTeX")


def _factors(tree: Tree) -> list[Tree]:
    """Factors of a product from left to right."""
    return [*_factors(tree[1]), tree[2]] if tree[0] == "*" else [tree]


def _product(factors: list[Tree]) -> tuple[str, int]:
    """A product; a factor of minus one is a sign before it."""
    minus = factors[0] == ("number", -1)
    text = r"\,".join(_within(factor, MULTIPLY) for factor in factors[minus:])
    return (f"-{text}", ADD) if minus else (text, MULTIPLY)


def _within(tree: Tree, hold: int) -> str:
    text, own = _written(tree)
    return text if own >= hold else rf"\left({text}\right)"


def _call(name: str, arguments: list[Tree]) -> tuple[str, int]:
    """A function of the language in the notation of the papers."""
    if name == "d":
        inner = arguments[0]
        text = formula(inner)
        return rf"\dot{{{text}}}" if inner[0] == "name" else rf"\tfrac{{d}}{{dt}}{text}", ATOM
    if name in RAISED:
        return f"{_within(arguments[0], ATOM)}{RAISED[name]}", POWER
    if name in ("norm", "largest"):
        return rf"\left\lVert {formula(arguments[0])}\right\rVert", ATOM
    if name == "sqrt":
        return rf"\sqrt{{{formula(arguments[0])}}}", ATOM
    if name == "sum":
        return rf"\sum_i {_within(arguments[0], MULTIPLY)}", MULTIPLY
    if name == "mean":
        return rf"\overline{{{formula(arguments[0])}}}", ATOM
    if name == "column":
        rows = r" \\ ".join(map(formula, arguments))
        return rf"\begin{{pmatrix}}{rows}\end{{pmatrix}}", ATOM
    head = NAMED.get(name, rf"\operatorname{{{name}}}")
    return rf"{head}\left({', '.join(map(formula, arguments))}\right)", ATOM
