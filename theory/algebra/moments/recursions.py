"""Second moments of a linear recursion with a random matrix, for vectors of every length.

The matrix is a form in letters: vectors x of independent symmetric entries, vectors y with known
second moments, independent of them, and constants. The mean of M P M' takes each word apart into
an outer product and at most one quadratic form inside it,

    x (x'Qx) x',   x (y'Qy) x',   y (x'Qx) y',   x x',   y y',

whose means are known; a word with an odd number of x has the mean zero, because -x has x's law.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from ..noncommuting import Form, Key
from .laws import SymmetricLaw
from .quadratic import sandwich

Word = tuple[str, ...]
IDENTITY = "I"


@dataclass(frozen=True)
class Randomness:
    """Which letters are random, and how.

    Parameters
    ----------
    entries : mapping of str to SymmetricLaw
        A vector with independent entries, each of this law.
    moments : mapping of str to str
        A vector y, independent of the others, to the letter that stands for E yy'.
    symmetric : frozenset of str
        Letters of symmetric matrices.
    names : mapping of tuple to str
        Words that stand inside quadratic forms, to a letter for each.
    """

    entries: Mapping[str, SymmetricLaw]
    moments: Mapping[str, str]
    symmetric: frozenset[str]
    names: Mapping[Word, str] = field(default_factory=dict)

    def mean(self, form: Form) -> Form:
        """E of a form, the random letters gone.

        The identity is the letter ``I``; ``trace(Q)`` is a scalar and ``diag(Q)`` a letter.

        Raises
        ------
        ValueError
            A word has another structure than those above.
        """
        total = Form({}, self.symmetric)
        for (scalars, word), a in form.terms.items():
            factor = Form({(scalars, ()): a}, self.symmetric)
            total = total + factor * self._mean(word)
        return total

    def second_moment(self, step: Form, moment: Form) -> Form:
        """E M P M' for the step e+ = M e, P being E ee'."""
        return self.mean(step * moment * step.T)

    def adjoint(self, step: Form, weight: Form) -> Form:
        """E M'YM: tr(Y E MPM') = tr(P E M'YM) for all symmetric P and Y."""
        return self.mean(step.T * weight * step)

    def _mean(self, word: Word) -> Form:
        places = [k for k, letter in enumerate(word) if self._random(letter)]
        if any(sum(_plain(word[k]) == x for k in places) % 2 for x in self.entries):
            return Form({}, self.symmetric)
        if not places:
            return self._word(word)
        first, last = places[0], places[-1]
        left, right, inner = word[:first], word[last + 1 :], word[first + 1 : last]
        if _plain(word[first]) != _plain(word[last]) or len(places) not in (2, 4):
            raise ValueError(f"word: {'*'.join(word)}; its mean is not known here")
        outer, between = _plain(word[first]), places[1:-1]
        if not between:
            if inner:
                raise ValueError(f"word: {'*'.join(word)}; an outer product is needed")
            return self._framed(left, self._outer(outer), right)
        if between != [first + 1, last - 1] or _plain(word[first + 1]) != _plain(word[last - 1]):
            raise ValueError(f"word: {'*'.join(word)}; one quadratic form is needed inside")
        return self._framed(left, self._kicked(outer, _plain(word[first + 1]), inner[1:-1]), right)

    def _random(self, letter: str) -> bool:
        return _plain(letter) in self.entries or _plain(letter) in self.moments

    def _word(self, word: Word) -> Form:
        """A word; the identity stands alone or not at all."""
        kept = tuple(letter for letter in word if letter != IDENTITY)
        return Form({((), kept or (IDENTITY,)): Fraction(1)}, self.symmetric | {IDENTITY})

    def _framed(self, left: Word, middle: Form, right: Word) -> Form:
        total = Form({}, self.symmetric)
        for (scalars, word), a in middle.terms.items():
            known = frozenset(x for x in word if x.startswith("diag("))
            whole = Form({(scalars, ()): a}, self.symmetric | known)
            total = total + whole * self._word(left + word + right)
        return total

    def _outer(self, outer: str) -> Form:
        if outer in self.entries:
            return self._word((IDENTITY,)) * self.entries[outer].variance
        return self._word((self.moments[outer],))

    def _kicked(self, outer: str, inner: str, word: Word) -> Form:
        """E z (w'Qw) z' for the outer vector z and the inner vector w."""
        if word != tuple(reversed(word)) or not self.symmetric.issuperset(word):
            raise ValueError(f"word: {'*'.join(word)}; a symmetric matrix is needed inside")
        letter = self.names.get(word)
        inside = (letter,) if letter else word
        text = "*".join(inside)
        if outer == inner:
            if outer not in self.entries:
                raise ValueError(f"word: fourth moments of {outer} are not known")
            c = sandwich(self.entries[outer])
            return (
                _scalar(f"trace({text})") * self._word((IDENTITY,)) * c.trace
                + self._word(inside) * c.whole
                + self._word((f"diag({text})",)) * c.diagonal
            )
        if inner in self.entries:
            size = self.entries[inner].variance
            return _scalar(f"trace({text})") * self._outer(outer) * size
        return _scalar(f"trace({text}*{self.moments[inner]})") * self._outer(outer)


def _plain(letter: str) -> str:
    return letter.rstrip("'")


def _scalar(name: str) -> Form:
    key: Key = (((name, 1),), ())
    return Form({key: Fraction(1)})
