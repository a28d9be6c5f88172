"""A card a claim: what is printed, what is true, how it was decided, how to check it."""

from __future__ import annotations

from .dom import Element, el
from .formulas import formula
from .records import Findings, Record, size_text
from .symbols import mark


def card(claim: Record, findings: Findings) -> Element:
    """Return the article of one claim."""
    verdict = claim["verdict"]
    return el(
        "article",
        el("p", mark(verdict), el("span", claim["source"]), el("code", claim["id"]), class_="meta"),
        el("h3", claim["title"]),
        el("p", el("b", "As printed. "), claim["statement"]) if claim["statement"] else None,
        formula(claim["formula"]),
        _panel(claim),
        _truth(claim),
        el("p", el("b", "How it was decided. "), claim["reason"]),
        _assumptions(claim),
        _reliance(claim),
        _replay(claim),
        _evidence(claim, findings),
        id=claim["id"],
        class_=verdict,
    )


def _panel(claim: Record) -> Element | None:
    if not claim["printed"] and not claim["sharp"]:
        return None
    return el(
        "div",
        el("div", el("span", "printed"), el("strong", claim["printed"] or "–")),
        el("div", el("span", "sharp"), el("strong", claim["sharp"] or "–")),
        el("p", claim["margin_text"]) if claim["margin_text"] else None,
        class_="panel",
    )


def _truth(claim: Record) -> list[Element | None]:
    if not claim["repair"]:
        return []
    return [el("p", el("b", "What is true. "), claim["repair"]), formula(claim["repair_formula"])]


def _assumptions(claim: Record) -> Element | None:
    if not claim["assumptions"]:
        return None
    items = [el("li", text) for text in claim["assumptions"]]
    return el("div", el("h4", "Assumptions"), el("ul", items))


def _reliance(claim: Record) -> Element | None:
    if not claim["relies_on"]:
        return None
    items = [el("li", text) for text in claim["relies_on"]]
    return el("div", el("h4", "Theorems of the literature it leans on"), el("ul", items))


def _replay(claim: Record) -> Element | None:
    if not claim["replay"]:
        return None
    head, *rows = claim["replay"]
    table = el(
        "table",
        el("thead", el("tr", [el("th", text, scope="col") for text in head])),
        el("tbody", [el("tr", [el("td", text, class_="num") for text in row]) for row in rows]),
    )
    return el("details", el("summary", "Follow it by hand"), el("div", table, class_="scroll"))


def _evidence(claim: Record, findings: Findings) -> Element | None:
    files = claim["certificates"]
    if not files:
        return None
    links = [
        el("li", el("a", path.split("/")[-1], href=path), f" {size_text(findings.size(path))}")
        for path in files
    ]
    return el(
        "div",
        el("h4", "Certificates"),
        el("ul", links),
        el(
            "div",
            el("code", "sensortrack check " + " ".join(files)),
            el("button", "Copy", type="button", class_="copy jsonly"),
            class_="ask",
        ),
        id=f"{claim['id']}-evidence",
        class_="ev",
    )
