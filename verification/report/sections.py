"""A section a system: what was read, what was assumed, and its cards."""

from __future__ import annotations

from .cards import card
from .dom import Element, el
from .formulas import formula
from .records import GAP_HEAD, Findings, Record


def section(name: str, findings: Findings) -> Element:
    """Return the section of one system."""
    system = findings.facts["systems"][name]
    claims = [claim for claim in findings.claims if claim["system"] == name]
    return el(
        "section",
        el(
            "header",
            el("h2", system["title"]),
            el("p", system["citation"], class_="cite"),
        ),
        el("div", _laws(name, system), _assumptions(name, claims), class_="model"),
        [card(claim, findings) for claim in claims],
        _gaps(name, system),
        id=name,
        class_="sys",
    )


def _laws(name: str, system: Record) -> Element:
    """The laws as they were read, for a reader to compare with the paper."""
    rows = [
        el("tr", el("td", formula(latex)), el("td", equation, class_="no"))
        for equation, latex in system.get("laws", [])
    ]
    return el(
        "div",
        el("h3", "The system as read"),
        el("table", el("tbody", rows), class_="laws") if rows else None,
        el("p", f"{name}, digest ", el("code", system["digest"][:16]), class_="uses"),
    )


def _assumptions(name: str, claims: list[Record]) -> Element | None:
    """All assumptions of the claims, once each, with the labels that cards link to."""
    found: dict[str, str] = {}
    for claim in claims:
        for text in claim["assumptions"]:
            label, _, words = text.partition(": ")
            found.setdefault(label, words)
    if not found:
        return None
    items = [
        el("li", el("b", label), words, id=f"{name}-{label}")
        for label, words in sorted(found.items(), key=lambda entry: _order(entry[0]))
    ]
    return el("div", el("h3", "Assumptions"), el("ul", items, class_="as"))


def _gaps(name: str, system: Record) -> Element | None:
    """What is printed and cannot be decided, with what is missing."""
    rows = [
        el("tr", el("th", source, scope="row"), el("td", statement), el("td", missing))
        for source, statement, missing in system.get("gaps", [])
    ]
    if not rows:
        return None
    head = el("tr", [el("th", text, scope="col") for text in GAP_HEAD])
    table = el("table", el("thead", head), el("tbody", rows))
    return el(
        "div",
        el("h3", "What the text leaves open"),
        el("div", table, class_="scroll"),
        class_="card",
        id=f"{name}-gaps",
    )


def _order(label: str) -> tuple[str, int]:
    digits = "".join(letter for letter in label if letter.isdigit())
    return label.rstrip("0123456789"), int(digits or 0)
