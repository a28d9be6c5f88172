"""A card a claim: what is printed, what is true, how it was decided, how to check it."""

from __future__ import annotations

from verification.figure import Plot

from .dom import Element, el
from .evidence import evidence
from .formulas import formula
from .plots import plot
from .records import Findings, Record, value_text
from .symbols import mark


def card(claim: Record, findings: Findings) -> Element:
    """Return the article of one claim."""
    figure = _figure(claim)
    proof = [_decided(claim), _replay(claim), evidence(claim, findings)]
    left = [_printed(claim), _panel(claim), _truth(claim)]
    return el(
        "article",
        el(
            "div",
            mark(claim["verdict"]),
            el("p", claim["source"], class_="src"),
            el("a", el("code", claim["id"]), href=f"#{claim['id']}", class_="id"),
            el("h3", claim["title"]),
            class_="hd",
        ),
        el(
            "div",
            el("div", left, proof if figure else None, class_="l"),
            el("div", figure if figure else proof, class_="r"),
            class_="bd",
        ),
        id=claim["id"],
        class_=f"card {claim['verdict']}",
    )


def _printed(claim: Record) -> list[Element | None]:
    if not claim["statement"] and not claim["formula"]:
        return []
    words = el("p", claim["statement"]) if claim["statement"] else None
    return [
        el("h4", "As printed"),
        el("blockquote", words, formula(claim["formula"]), class_="st"),
    ]


def _panel(claim: Record) -> Element | None:
    """Printed beside sharp, and the margin in words."""
    if not claim["printed"] and not claim["sharp"]:
        return None
    margin = el(
        "div", el("dt", "Margin", class_="vh"), el("dd", claim["margin_text"]), class_="mgn"
    )
    return el(
        "dl",
        _value("Printed", value_text(claim, "printed")),
        _value("Sharp", value_text(claim, "sharp")),
        margin if claim["margin_text"] else None,
        class_=f"kv {claim['verdict']}",
    )


def _value(name: str, text: str) -> Element:
    """A number in large type; words in a size that they fit in."""
    size = "big" if len(text) <= 14 else "eq"
    return el("div", el("dt", name), el("dd", el("span", text, class_=size)))


def _truth(claim: Record) -> list[Element | None]:
    if not claim["repair"]:
        return []
    return [
        el("h4", "What is true"),
        el("div", el("p", claim["repair"]), formula(claim["repair_formula"]), class_="st ok"),
    ]


def _decided(claim: Record) -> list[Element | None]:
    return [
        el("h4", "How it was decided"),
        el("p", claim["reason"], class_="how"),
        el("p", _uses(claim), f"Decided in {claim['seconds']:.2f} s.", class_="uses"),
        _reliance(claim),
    ]


def _uses(claim: Record) -> list[Element | str]:
    """Links to the assumptions, by label."""
    labels = [text.partition(":")[0] for text in claim["assumptions"]]
    if not labels:
        return []
    links: list[Element | str] = ["Assumes "]
    for place, label in enumerate(labels):
        links += [", "] if place else []
        links.append(el("a", label, href=f"#{claim['system']}-{label}"))
    return [*links, ". "]


def _reliance(claim: Record) -> Element | None:
    if not claim["relies_on"]:
        return None
    return el("p", f"Relies on {'; '.join(claim['relies_on'])}.", class_="uses")


def _replay(claim: Record) -> Element | None:
    if not claim["replay"]:
        return None
    head, *rows = claim["replay"]
    table = el(
        "table",
        el("thead", el("tr", [el("th", text, scope="col") for text in head])),
        el("tbody", [el("tr", [el("td", text) for text in row]) for row in rows]),
        class_="replay",
    )
    return el("details", el("summary", "Follow it by hand"), el("div", table, class_="scroll"))


def _figure(claim: Record) -> Element | None:
    data = claim.get("figure")
    if not data:
        return None
    figure = Plot.from_data(data)
    name = f"{claim['id']}-figure"
    return el("figure", plot(figure, name), el("figcaption", figure.caption), id=name)
