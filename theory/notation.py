"""One glossary for all systems: symbol, name, unit, frame and meaning, rendered as Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from .system import Parameter, Signal, System

GREEK = frozenset(
    {
        "alpha",
        "beta",
        "gamma",
        "delta",
        "epsilon",
        "zeta",
        "eta",
        "theta",
        "kappa",
        "lambda",
        "mu",
        "nu",
        "xi",
        "pi",
        "rho",
        "sigma",
        "tau",
        "phi",
        "chi",
        "psi",
        "omega",
    }
)
CAPITALS = frozenset(
    {"Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi", "Psi", "Omega"}
)
HATS = {"hat": r"\hat{%s}", "star": "%s^*", "minus": "%s^-", "plus": "%s^+"}


@dataclass(frozen=True)
class Entry:
    """One line of the glossary.

    Parameters
    ----------
    symbol : str
        LaTeX.
    name : str
        Identifier in the laws.
    unit, frame, meaning : str
        As declared; the frame of a parameter is its domain.
    """

    symbol: str
    name: str
    unit: str
    frame: str
    meaning: str


def latex(name: str) -> str:
    """LaTeX of an identifier: Greek names, a mark of `HATS` behind ``_``, else an index."""
    head, _, index = name.partition("_")
    symbol = f"\\{head}" if head in GREEK | CAPITALS else head
    if index in HATS:
        return HATS[index] % symbol
    return f"{symbol}_{{{index}}}" if index else symbol


def entries(system: System) -> tuple[Entry, ...]:
    """The glossary of one system, by name.

    Parameters
    ----------
    system : System

    Returns
    -------
    tuple of Entry
    """
    found = [_entry(symbol) for symbol in system.symbols]
    return tuple(sorted(found, key=lambda entry: (entry.name.lower(), entry.name)))


def _entry(symbol: Signal | Parameter) -> Entry:
    frame = symbol.frame if isinstance(symbol, Signal) else symbol.domain
    return Entry(latex(symbol.name), symbol.name, symbol.unit, frame or "none", symbol.meaning)


def render(systems: Iterable[System]) -> str:
    """Markdown of the glossary: one section a system, with its open sizes and units.

    Parameters
    ----------
    systems : iterable of System

    Returns
    -------
    str
        Ends in one newline.
    """
    return "\n".join(_section(system) for system in systems)


def _section(system: System) -> str:
    lines = [f"## {system.title}", "", system.citation, ""]
    lines += [
        "| symbol | name | unit | frame or domain | meaning |",
        "| --- | --- | --- | --- | --- |",
    ]
    for entry in entries(system):
        symbol = f"${entry.symbol}$ | `{entry.name}`"
        lines.append(f"| {symbol} | {entry.unit} | {entry.frame} | {entry.meaning} |")
    lines += _open("Sizes", system.dimensions) + _open("Units", system.units)
    return "\n".join(lines) + "\n"


def _open(what: str, names: Mapping[str, str]) -> list[str]:
    if not names:
        return []
    return ["", f"{what}: " + "; ".join(f"`{name}`, {text}" for name, text in names.items()) + "."]
