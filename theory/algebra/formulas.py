"""Formulas of `theory.expressions` as polynomials in letters that do not commute."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from ..expressions import Tree, canonical, parse
from .noncommuting import Form, inverse, letters, scalars


def form_of(text: str, numbers: Iterable[str] = (), symmetric: Iterable[str] = ()) -> Form:
    """Read a formula made of names, whole numbers, ``+ - * /`` and ``T``.

    Parameters
    ----------
    text : str
        In the language of `theory.expressions`; what is divided by is a product of whole numbers
        and scalars.
    numbers : iterable of str, optional
        Names that are scalars.
    symmetric : iterable of str, optional
        Names of symmetric matrices.

    Returns
    -------
    Form

    Raises
    ------
    FormulaError
        The text is not in the language.
    ValueError
        It needs more than the above.
    """
    return _form(parse(text), frozenset(numbers), frozenset(symmetric))


def _form(tree: Tree, numbers: frozenset[str], symmetric: frozenset[str]) -> Form:
    match tree:
        case ("number", value):
            return Form({((), ()): Fraction(value)}, symmetric)
        case ("name", name):
            found = scalars(name) if name in numbers else letters(name, symmetric)
            return found[0]
        case ("call", "T", inner):
            return _form(inner, numbers, symmetric).T
        case ("/", left, ("number", value)):
            return _form(left, numbers, symmetric) * Fraction(1, value)
        case ("+" | "-" | "*" | "/" as sign, left, right):
            a, b = (_form(side, numbers, symmetric) for side in (left, right))
            if sign == "+":
                return a + b
            if sign == "-":
                return a - b
            return a * (b if sign == "*" else inverse(b))
    raise ValueError(f"formula: {canonical(tree)}; sums, products and transposes are read here")


def expanded(form: Form, meaning: Mapping[str, Form]) -> Form:
    """Put in what letters stand for, again and again, until none of them is left.

    Parameters
    ----------
    form : Form
    meaning : mapping of str to Form
        None of them stands for something with itself in it.

    Raises
    ------
    ValueError
        The letters stand for each other.
    """
    for _ in range(len(meaning) + 1):
        if not any(x.rstrip("'") in meaning for _, word in form.terms for x in word):
            return form
        form = form.substitute(meaning)
    raise ValueError(f"meaning: {', '.join(meaning)} stand for each other")
