"""Statements for gains of any size, which derivations prove."""

from __future__ import annotations

from collections.abc import Mapping

from ....algebra.noncommuting import Form
from ....statements import Case, Statement


def universal(
    name: str,
    words: str,
    show: tuple[str, ...],
    symbols: Mapping[str, str],
    given: tuple[Form, ...] = (),
    relies_on: tuple[str, ...] = (),
    verdict: str = "PROVED",
) -> Statement:
    """Statement with one case about all matrices and scalars of the declared kinds.

    Parameters
    ----------
    name : str
        Name of the claim, or of what is attached to it.
    words : str
        What is proved.
    show : tuple of str
        Predicates.
    symbols : mapping of str to str
        Kinds of the letters and scalars.
    given : tuple of Form, optional
        Hypotheses, each of them zero.
    relies_on : tuple of str, optional
        Theorems between the predicates and the words.
    verdict : str, optional

    Returns
    -------
    Statement
    """
    return Statement(
        "variational",
        name,
        {verdict: Case(verdict, words, show)},
        symbols=symbols,
        given=tuple(map(str, given)),
        relies_on=relies_on,
    )
