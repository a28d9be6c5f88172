"""Formulas whose terms do not have one unit, reported term by term.

`theory.expressions.kind_of` stops at the first thing that does not fit, which is right for our own
formulas. A printed formula deserves more: which of its terms have which units. The number that such
a formula gives depends on the units that its reader happens to use.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from .expressions import Tree, kind_of, parse
from .kinds import FormulaError, Kind
from .units import parse_unit

COMPARISONS = {"==", "!=", "<", "<=", ">", ">="}
TIGHTNESS: Mapping[str, int] = {
    **dict.fromkeys(COMPARISONS, 0), "+": 1, "-": 1, "*": 2, "/": 2, "power": 3,
}  # fmt: skip
ATOM = 4
ZERO = ("number", 0)
"""The one number that fits every unit."""


@dataclass(frozen=True)
class Clash:
    """A sum or comparison whose parts do not have one unit and shape, or a call that does not fit.

    Parameters
    ----------
    formula : str
        The sum, comparison or call.
    terms : tuple of (str, str)
        Its parts, and the unit of each; with the shape where the parts are not all scalars.
    reason : str
        What is wrong, in words.
    """

    formula: str
    terms: tuple[tuple[str, str], ...]
    reason: str

    def __str__(self) -> str:
        """Return one sentence."""
        listed = ", ".join(f"{text} is in {unit}" for text, unit in self.terms)
        return f"{self.formula}: {self.reason}" + (f": {listed}" if listed else "")


def clashes(
    formula: str, units: Mapping[str, str | Kind], generic: Iterable[str] = ()
) -> tuple[Clash, ...]:
    """Everything in a formula that has no unit, from the inside out.

    Parameters
    ----------
    formula : str
        In the language of `theory.expressions`; a comparison is welcome.
    units : mapping of str to str or Kind
        Of each name: the unit of a number as text, or unit and shape.
    generic : iterable of str, optional
        Further base units, for quantities whose unit is left open: ``("F", "L")``.

    Returns
    -------
    tuple of Clash
        Empty where units and shapes fit. What is built upon a part that clashes is not judged.

    Raises
    ------
    FormulaError
        The formula cannot be read, or holds a name without a unit.
    ValueError
        A unit cannot be read.
    """
    open_units = tuple(generic)
    kinds = {
        name: given if isinstance(given, Kind) else Kind(parse_unit(given, open_units))
        for name, given in units.items()
    }
    found: list[Clash] = []
    _judge(parse(formula), kinds, found)
    return tuple(found)


def terms_of(tree: Tree) -> tuple[Tree, ...]:
    """The terms of a sum, from left to right; the signs are left out."""
    if tree[0] in {"+", "-"}:
        return (*terms_of(tree[1]), *terms_of(tree[2]))
    return (tree,)


def written(tree: Tree, tightness: int = 0) -> str:
    """A formula as text that `theory.expressions.parse` reads as the same tree."""
    match tree:
        case ("number" | "name", value):
            return str(value)
        case ("call", name, *arguments):
            return f"{name}({', '.join(written(argument) for argument in arguments)})"
    text = _operation(*tree)
    return f"({text})" if TIGHTNESS[tree[0]] < tightness else text


def _operation(sign: str, left: Tree, right: Any) -> str:
    own = TIGHTNESS[sign]
    if sign == "power":
        return f"{written(left, ATOM)}**{right}"
    if (sign, left) == ("*", ("number", -1)):
        return f"-{written(right, TIGHTNESS['power'])}"
    gap = " " if own < TIGHTNESS["*"] else ""
    return f"{written(left, own)}{gap}{sign}{gap}{written(right, own + 1)}"


def _judge(tree: Tree, kinds: Mapping[str, Kind], found: list[Clash]) -> Kind | None:
    """Unit and shape of a formula; None where a part of it clashes."""
    if tree[0] in {"number", "name"}:
        return kind_of(tree, kinds)
    if tree[0] in {"+", "-"}:
        return _alike(tree, terms_of(tree), kinds, found)
    if tree[0] in COMPARISONS:
        return _alike(tree, tree[1:], kinds, found)
    parts = [_judge(part, kinds, found) for part in tree if isinstance(part, tuple)]
    if None in parts:
        return None
    try:
        return _joined(tree, parts)
    except FormulaError as error:
        found.append(Clash(written(tree), (), str(error)))
        return None


def _joined(tree: Tree, parts: list[Kind | None]) -> Kind:
    """Unit and shape of one operation on parts that are known."""
    known = {f"part {i}": part for i, part in enumerate(parts) if part is not None}
    names = iter(known)
    flat = tuple(("name", next(names)) if isinstance(part, tuple) else part for part in tree)
    return kind_of(flat, known)


def _alike(
    tree: Tree, terms: Iterable[Tree], kinds: Mapping[str, Kind], found: list[Clash]
) -> Kind | None:
    """The one kind that all terms have, a literal zero aside."""
    judged = [(term, _judge(term, kinds, found)) for term in terms if term != ZERO]
    known = [(term, kind) for term, kind in judged if kind is not None]
    different = {kind for _, kind in known}
    if len(different) > 1:
        plain = all(kind.scalar for kind in different)
        listed = tuple((written(term), str(kind.unit if plain else kind)) for term, kind in known)
        what = "terms of different units" if plain else "terms of different units or shapes"
        found.append(Clash(written(tree), listed, what))
    return different.pop() if len(different) == 1 and len(known) == len(judged) else None
