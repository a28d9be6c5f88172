"""Derive identities by replacing words: every hypothesis names the word that it does away with.

A word is letters, powers of scalars or both, like ``a' b``, ``s**2`` or ``r e' k``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from .identities import Identity, Square, Term, Zero, identity
from .noncommuting import Form, Key

LIMIT = 2_000


class Rule(NamedTuple):
    """A word, the hypothesis that contains it, and the word's coefficient there."""

    word: Key
    relation: int
    transposed: bool
    coefficient: Fraction


def rules(relations: Sequence[Form], words: Mapping[int, str]) -> tuple[Rule, ...]:
    """Turn hypotheses into replacements of words, and of the transposed words.

    Parameters
    ----------
    relations : sequence of Form
    words : mapping of int to str
        Number of the hypothesis to a blank-separated word that occurs in it, like ``"a' b"``;
        powers of scalars come first, like ``"s**2"``.

    Returns
    -------
    tuple of Rule

    Raises
    ------
    ValueError
        The word does not occur by itself in the hypothesis.
    """
    found: dict[Key, Rule] = {}
    for k, text in words.items():
        matching = [key for key in relations[k].terms if _text(key) == text]
        if not matching:
            raise ValueError(f"words: {text!r} does not occur in {relations[k]}; it has to")
        (word,) = matching
        coefficient = relations[k].terms[word]
        flipped = _flipped(word, relations[k])
        found.setdefault(word, Rule(word, k, False, coefficient))
        found.setdefault(flipped, Rule(flipped, k, True, coefficient))
    return tuple(found.values())


def _text(key: Key) -> str:
    """A word as it is written in `rules`."""
    powers, word = key
    factors = [name if power == 1 else f"{name}**{power}" for name, power in powers]
    return " ".join([*factors, *word])


def _flipped(word: Key, relation: Form) -> Key:
    (transposed,) = Form({word: Fraction(1)}, relation.symmetric).T.terms
    return transposed


def reduce(goal: Form, relations: Sequence[Form], known: Sequence[Rule]) -> tuple[Zero, Form]:
    """Replace words until none is left.

    Parameters
    ----------
    goal : Form
    relations : sequence of Form
    known : sequence of Rule

    Returns
    -------
    Zero
        What was taken away, with its derivation.
    Form
        What is left; goal = taken away + left.

    Raises
    ------
    ValueError
        The replacements do not come to an end.
    """
    rest, terms = goal, list[Term]()
    for _ in range(LIMIT):
        term = _first(rest, known)
        if term is None:
            return Zero(goal - rest, tuple(terms)), rest
        relation = relations[term.relation]
        rest = rest - term.left * (relation.T if term.transposed else relation) * term.right
        terms.append(term)
    raise ValueError(f"words: replacements go on after {LIMIT} steps; each must make words simpler")


def _first(form: Form, known: Sequence[Rule]) -> Term | None:
    """The first place where a rule fits, as the multiple of its hypothesis to take away."""
    for (scalars, word), a in form.terms.items():
        for rule in known:
            powers, part = rule.word
            rest = dict(scalars)
            if any(rest.get(name, 0) < power for name, power in powers):
                continue
            rest |= {name: rest[name] - power for name, power in powers}
            left_over = tuple((name, power) for name, power in rest.items() if power)
            n = len(part)
            for i in range(len(word) - n + 1):
                if word[i : i + n] == part:
                    left = Form({(left_over, word[:i]): a / rule.coefficient}, form.symmetric)
                    right = Form({((), word[i + n :]): Fraction(1)}, form.symmetric)
                    return Term(left, rule.relation, right, rule.transposed)
    return None


def derive(
    name: str,
    goal: Form,
    relations: Sequence[Form],
    words: Mapping[int, str],
    squares: Sequence[Square] = (),
) -> Identity:
    """Prove an identity by replacing words.

    Parameters
    ----------
    name : str
    goal : Form
    relations : sequence of Form
    words : mapping of int to str
        As in `rules`.
    squares : sequence of Square, optional
        What shall be left of the goal, as squares.

    Returns
    -------
    Identity

    Raises
    ------
    ValueError
        The replacements leave something else.
    """
    target = goal
    for square in squares:
        target = target - square.form
    taken, _ = reduce(target, relations, rules(relations, words))
    return identity(name, goal, relations, taken, squares)
