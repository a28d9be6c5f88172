"""Identities between matrices of any size, each with the combination of hypotheses that proves it.

A hypothesis is a form that is zero. What follows from hypotheses by adding, multiplying and
transposing is again zero, and `Zero` remembers how it came about, so that a derivation written as
ordinary algebra leaves behind the list of terms that a reader, or a checker, multiplies out.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from .noncommuting import Form


class Term(NamedTuple):
    """One summand ``left * hypothesis * right``, with the hypothesis transposed or not."""

    left: Form
    relation: int
    right: Form
    transposed: bool = False


class Square(NamedTuple):
    """One summand ``factor * inner' * weight * inner`` with a nonnegative factor and weight."""

    factor: Form
    inner: Form
    weight: Form

    @property
    def form(self) -> Form:
        """The summand, multiplied out."""
        return self.factor * self.inner.T * self.weight * self.inner


@dataclass(frozen=True)
class Identity:
    """``goal = 0``, or ``goal >= 0``, whenever the relations are zero.

    Parameters
    ----------
    name : str
        What it says, in words.
    goal : Form
    relations : tuple of Form
        Hypotheses, each of them zero.
    combination : tuple of Term
        Summands whose sum is the goal.
    squares : tuple of Square, optional
        Further summands; with them the goal is at least zero.
    """

    name: str
    goal: Form
    relations: tuple[Form, ...]
    combination: tuple[Term, ...]
    squares: tuple[Square, ...] = ()

    @property
    def residual(self) -> Form:
        """What multiplying out leaves of the goal; no terms if the identity is proved."""
        rest = self.goal
        for square in self.squares:
            rest = rest - square.form
        for left, k, right, transposed in self.combination:
            relation = self.relations[k]
            rest = rest - left * (relation.T if transposed else relation) * right
        return rest

    @property
    def holds(self) -> bool:
        """Whether nothing is left."""
        return not self.residual.terms

    @property
    def predicate(self) -> str:
        """What is proved, in the checker's language."""
        return f"{self.goal} {'>=' if self.squares else '=='} 0"

    def to_data(self) -> dict[str, list[list[str]]]:
        """Squares and combination as text in the checker's language.

        Returns
        -------
        dict
            ``squares``: factor, inner, weight of each; ``relations``: left factor, number of the
            hypothesis (marked ``'`` if transposed), right factor of each.
        """
        relations = [
            [str(left), f"{k}'" if transposed else str(k), str(right)]
            for left, k, right, transposed in self.combination
        ]
        squares = [[str(part) for part in square] for square in self.squares]
        return {"squares": squares, "relations": relations}


@dataclass(frozen=True)
class Zero:
    """A form that is zero by hypothesis, and how it follows.

    Parameters
    ----------
    form : Form
    combination : tuple of Term
        Summands of hypotheses whose sum is the form.
    """

    form: Form
    combination: tuple[Term, ...]

    def __add__(self, other: Zero) -> Zero:
        return Zero(self.form + other.form, self.combination + other.combination)

    def __sub__(self, other: Zero) -> Zero:
        return self + other.times(-1)

    def times(self, factor: Form | int | Fraction) -> Zero:
        """Multiply by a scalar."""
        scaled = tuple(term._replace(left=term.left * factor) for term in self.combination)
        return Zero(self.form * factor, scaled)

    def between(self, left: Form, right: Form) -> Zero:
        """Multiply from both sides."""
        terms = tuple(
            term._replace(left=left * term.left, right=term.right * right)
            for term in self.combination
        )
        return Zero(left * self.form * right, terms)

    def after(self, left: Form) -> Zero:
        """Multiply from the left."""
        return self.between(left, ONE)

    def before(self, right: Form) -> Zero:
        """Multiply from the right."""
        return self.between(ONE, right)

    @property
    def T(self) -> Zero:
        """The transpose, which is zero as well."""
        terms = tuple(
            Term(right.T, k, left.T, not flipped) for left, k, right, flipped in self.combination
        )
        return Zero(self.form.T, terms)


ONE = Form({((), ()): Fraction(1)})
"""The identity of any size."""


def hypotheses(relations: Sequence[Form]) -> tuple[Zero, ...]:
    """Each relation as a `Zero` that rests on itself.

    Parameters
    ----------
    relations : sequence of Form

    Returns
    -------
    tuple of Zero
    """
    return tuple(Zero(form, (Term(ONE, k, ONE),)) for k, form in enumerate(relations))


def identity(
    name: str,
    goal: Form,
    relations: Iterable[Form],
    proof: Zero,
    squares: Iterable[Square] = (),
) -> Identity:
    """Make an identity and multiply it out.

    Parameters
    ----------
    name : str
    goal : Form
    relations : iterable of Form
    proof : Zero
        A derivation whose form is the goal, less the squares.
    squares : iterable of Square, optional

    Returns
    -------
    Identity

    Raises
    ------
    ValueError
        Something is left: the derivation proves another goal.
    """
    made = Identity(name, goal, tuple(relations), _gathered(proof.combination), tuple(squares))
    if not made.holds:
        raise ValueError(f"{name}: the derivation leaves {made.residual}; nothing may be left")
    return made


def _gathered(terms: Iterable[Term]) -> tuple[Term, ...]:
    """Add the left factors of terms that are otherwise alike."""
    found: dict[tuple[int, bool, str], Term] = {}
    for term in terms:
        key = (term.relation, term.transposed, str(term.right))
        old = found.get(key)
        found[key] = term._replace(left=old.left + term.left) if old else term
    return tuple(term for term in found.values() if term.left.terms)
