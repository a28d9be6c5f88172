"""Statements that identities prove for matrices of every size."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar

from .algebra.identities import Identity
from .algebra.noncommuting import Form
from .statements import Case, Statement


def needed(identities: tuple[Identity, ...]) -> tuple[Identity, ...]:
    """Identities without the hypotheses that none of their proofs uses.

    Parameters
    ----------
    identities : tuple of Identity
        They share their hypotheses.

    Returns
    -------
    tuple of Identity
    """
    used = sorted({term.relation for entry in identities for term in entry.combination})
    return tuple(
        replace(
            entry,
            relations=tuple(entry.relations[k] for k in used),
            combination=tuple(
                term._replace(relation=used.index(term.relation)) for term in entry.combination
            ),
        )
        for entry in identities
    )


@dataclass(frozen=True)
class Universal:
    """What is proved for all matrices and scalars of the declared kinds, and the proof.

    Hypotheses that no proof uses are left out of the statement, and so are symbols that then do not
    occur. Each system derives a class of its own, which says whose statements these are.

    Parameters
    ----------
    name : str
        Name of the claim, or of what is attached to it.
    words : str
        What is proved.
    identities : tuple of Identity
        They share their hypotheses.
    symbols : mapping of str to str
        Kinds of the letters and scalars, at least of those that occur.
    relies_on : tuple of str, optional
        Theorems between the identities and the words.
    verdict : str, optional
    """

    system: ClassVar[str]

    name: str
    words: str
    identities: tuple[Identity, ...]
    symbols: Mapping[str, str]
    relies_on: tuple[str, ...] = field(default=())
    verdict: str = "PROVED"

    @property
    def proof(self) -> tuple[Identity, ...]:
        """The identities with the hypotheses that some of them use."""
        return needed(self.identities)

    @property
    def statement(self) -> Statement:
        """The statement whose hypotheses and goals are those of the proof."""
        (given,) = {tuple(str(form) for form in entry.relations) for entry in self.proof}
        show = tuple(entry.predicate for entry in self.proof)
        occurring = {name for entry in self.proof for name in _names(entry)}
        return Statement(
            self.system,
            self.name,
            {self.verdict: Case(self.verdict, self.words, show)},
            symbols={name: kind for name, kind in self.symbols.items() if name in occurring},
            given=given,
            relies_on=self.relies_on,
        )


def _names(entry: Identity) -> Iterator[str]:
    """Letters and scalars of an identity and its proof."""
    forms: list[Form] = [entry.goal, *entry.relations]
    forms += [part for square in entry.squares for part in square]
    forms += [part for term in entry.combination for part in (term.left, term.right)]
    for form in forms:
        for scalars, word in form.terms:
            yield from (name for name, _ in scalars)
            yield from (letter.rstrip("'") for letter in word)
