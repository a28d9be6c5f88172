"""Quadratic forms in letters: gradients, completed squares, energies along a recursion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from .identities import Square
from .noncommuting import Form, letters, scalars
from .rewriting import reduce, rules


def gradient(form: Form, letter: str) -> Form:
    """Gradient with respect to a vector.

    Parameters
    ----------
    form : Form
        1 by 1, a polynomial in the vector and its transpose.
    letter : str
        The vector.

    Returns
    -------
    Form
        The g with: form at x + d = form at x + d'g + terms of higher order in d.
    """
    x, d = letters(f"{letter} direction", form.symmetric)
    (step,) = scalars("step")
    slope = form.substitute({letter: x + step * d}).coefficient("step", 1)
    return slope.after("direction'") + slope.before("direction").T


def complete(form: Form, letter: str, weight: str) -> tuple[Square, Form]:
    """Complete the square of one vector.

    Parameters
    ----------
    form : Form
        1 by 1 and equal to its transpose: c x'Kx + x'K b + b'K x + what has no x.
    letter, weight : str
        The vector x and the symmetric matrix K.

    Returns
    -------
    Square
        c (x + b/c)' K (x + b/c).
    Form
        What is left, without x.

    Raises
    ------
    ValueError
        The form has no term x'Kx, or x meets another matrix than K.
    """
    x, k = letters(f"{letter} {weight}", form.symmetric | {weight})
    factor = form.after(f"{letter}'").before(letter).after(weight)
    if not factor.terms or any(word for _, word in factor.terms):
        raise ValueError(f"form: {form}; a multiple of {letter}'{weight}{letter} is needed")
    cross = form.after(f"{letter}'").after(weight)
    linear = Form({key: a for key, a in cross.terms.items() if key[1] != (letter,)}, form.symmetric)
    square = Square(factor, x + _reciprocal(factor) * linear, k)
    rest = form - square.form
    if any(part.rstrip("'") == letter for _, word in rest.terms for part in word):
        raise ValueError(f"form: {form}; {letter} must meet {weight} only, {rest} is left")
    return square, rest


def _reciprocal(factor: Form) -> Form:
    """1/factor for a number, or a number times powers of scalars."""
    ((powers, _), a), *more = factor.terms.items()
    if more:
        raise ValueError(f"form: the factor {factor} of a square; one term is needed")
    return Form({(tuple((name, -power) for name, power in powers), ()): 1 / a})


def split(form: Form, pivots: Sequence[tuple[str, str]]) -> tuple[tuple[Square, ...], Form]:
    """Complete the squares of several vectors, one after the other.

    Parameters
    ----------
    form : Form
        As in `complete`.
    pivots : sequence of (str, str)
        Vector and matrix of each square.

    Returns
    -------
    tuple of Square
        Their sum and what is left are the form.
    Form
        What is left.

    Raises
    ------
    ValueError
        As in `complete`.
    """
    squares, rest = [], form
    for letter, weight in pivots:
        square, rest = complete(rest, letter, weight)
        squares.append(square)
    return tuple(squares), rest


def symmetrised(form: Form) -> Form:
    """Half the sum with the transpose: for forms that are 1 by 1, the same number."""
    return (form + form.T) * Fraction(1, 2)


def decrease(
    before: Form, after: Form, relations: Sequence[Form], words: Mapping[int, str]
) -> Form:
    """How much an energy falls along a recursion.

    Parameters
    ----------
    before, after : Form
        The energy at two successive states, 1 by 1.
    relations : sequence of Form
        The recursion from one state to the other, each side moved to the left.
    words : mapping of int to str
        The word that each relation does away with, as in `theory.algebra.rewriting.rules`.

    Returns
    -------
    Form
        before - after, without those words, symmetrised. Two forms that agree along the recursion
        come out the same.
    """
    _, rest = reduce(before - after, relations, rules(relations, words))
    return symmetrised(rest)
