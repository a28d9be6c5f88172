"""Statements about data that a certificate replays."""

from __future__ import annotations

from ....statements import Case, Statement


def case(
    verdict: str,
    name: str,
    words: str,
    show: tuple[str, ...],
    inputs: dict[str, str],
    relies_on: tuple[str, ...] = (),
) -> Statement:
    """Statement with one case about data.

    Parameters
    ----------
    verdict, name, words : str
    show : tuple of str
        Predicates.
    inputs : dict
        Name to kind.
    relies_on : tuple of str, optional

    Returns
    -------
    Statement
    """
    return Statement(
        "cyclic_spsa", name, {verdict: Case(verdict, words, show)}, inputs, relies_on=relies_on
    )


def numbers(*names: str) -> dict[str, str]:
    """Inputs that are numbers."""
    return dict.fromkeys(names, "number")
