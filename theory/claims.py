"""Printed statements as data: what a paper claims, under which assumptions, in our words."""

from __future__ import annotations

import re
from dataclasses import dataclass

SENSES = frozenset({"threshold", "upper", "lower", "equality", "property"})
"""A limit that decides, a bound from above or below, an equality, a property."""

CLAIM_ID = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*\.[a-z][a-z0-9]*(_[a-z0-9]+)+")
ASSUMPTION_ID = re.compile(r"[A-Z][A-Z0-9]{0,3}")


def _need(condition: bool, message: str) -> None:
    if not condition:
        raise ValueError(message)


def _sentence(text: str, what: str, whose: str) -> None:
    """Words for a reader: one line, no blanks at its ends, more than one word."""
    good = text == text.strip() and " " in text and "\n" not in text
    _need(good, f"{whose}: {what} is {text!r}; one line of words is needed")


@dataclass(frozen=True)
class Assumption:
    """One hypothesis of a claim.

    Parameters
    ----------
    id : str
        Short label like ``A1``; the paper's own number where it has one.
    text : str
        The hypothesis in our words.

    Raises
    ------
    ValueError
        The label is no capital letter with digits, or the text is empty.
    """

    id: str
    text: str

    def __post_init__(self) -> None:
        good = ASSUMPTION_ID.fullmatch(self.id)
        _need(bool(good), f"assumption: id is {self.id!r}; a label like 'A1' is needed")
        _sentence(self.text, "text", f"assumption {self.id}")

    def __str__(self) -> str:
        """Return label and text."""
        return f"{self.id}: {self.text}"


@dataclass(frozen=True)
class Claim:
    """A printed statement, restated so that it can be decided.

    Parameters
    ----------
    id : str
        ``SYSTEM.kind_number[_part][_reading]``, like ``bearing_dac.theorem_1_gain``.
    system : str
        Short name of the system.
    source : str
        Author and number of the equation, lemma or theorem.
    title : str
        A sentence in our words that could be false.
    statement : str
        The claim in our words.
    formula : str
        The claim's formula in LaTeX, or empty.
    sense : str
        ``threshold``, ``upper``, ``lower``, ``equality`` or ``property``.
    assumes : tuple of Assumption
        The hypotheses, none twice.
    printed : str, optional
        The printed value as text, where the claim has one.

    Raises
    ------
    ValueError
        A field is malformed; the message names the claim, the field and what is needed.
    """

    id: str
    system: str
    source: str
    title: str
    statement: str
    formula: str
    sense: str
    assumes: tuple[Assumption, ...]
    printed: str = ""

    def __post_init__(self) -> None:
        good = CLAIM_ID.fullmatch(self.id) and self.id.startswith(f"{self.system}.")
        pattern = f"{self.system}.kind_number[_part][_reading]"
        _need(bool(good), f"claim: id is {self.id!r}; {pattern} in small letters is needed")
        found = f"{self.id}: sense is {self.sense!r}"
        _need(self.sense in SENSES, f"{found}; one of {', '.join(sorted(SENSES))} is needed")
        numbered = any(letter.isdigit() for letter in self.source)
        _need(numbered, f"{self.id}: source is {self.source!r}; it must name a number")
        for what in ("source", "title", "statement"):
            _sentence(getattr(self, what), what, self.id)
        balanced = self.formula.count("{") == self.formula.count("}")
        plain = balanced and "$" not in self.formula and self.formula == self.formula.strip()
        _need(plain, f"{self.id}: formula is {self.formula!r}; LaTeX without dollars is needed")
        _need(self.printed == self.printed.strip(), f"{self.id}: printed has blanks at its ends")
        labels = [assumption.id for assumption in self.assumes]
        twice = sorted({label for label in labels if labels.count(label) > 1})
        _need(bool(labels), f"{self.id}: no assumption; at least one is needed")
        _need(not twice, f"{self.id}: assumption {', '.join(twice)} stands twice; once is needed")

    @property
    def assumptions(self) -> tuple[str, ...]:
        """The hypotheses as text, each with its label."""
        return tuple(str(assumption) for assumption in self.assumes)


@dataclass(frozen=True)
class Gap:
    """A printed statement that the text leaves too open to be true or false.

    Parameters
    ----------
    source : str
        Author and number of the section, figure or equation.
    statement : str
        What is said, in our words.
    missing : str
        What the text would have to say so that the statement could be decided.

    Raises
    ------
    ValueError
        A field is malformed.
    """

    source: str
    statement: str
    missing: str

    def __post_init__(self) -> None:
        for what in ("source", "statement", "missing"):
            _sentence(getattr(self, what), what, f"gap, {self.source}")
