"""One self-contained HTML page: nothing is loaded from anywhere."""

from __future__ import annotations

import base64
import hashlib
from pathlib import Path

from .cards import card
from .dom import Element, Raw, el
from .figures import drawing, margin, ratios
from .records import (
    MEANINGS,
    VERDICTS,
    Findings,
    Record,
    digits,
    headline,
    lede,
    side_text,
    size_text,
)
from .symbols import mark, sprite

HERE = Path(__file__).parent


def page(findings: Findings) -> str:
    """Return the page's text."""
    style = (HERE / "style.css").read_text(encoding="utf-8")
    script = (HERE / "page.js").read_text(encoding="utf-8")
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    policy = (
        f"default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{digest}'; "
        "img-src data:; base-uri 'none'; form-action 'none'"
    )
    head = el(
        "head",
        el("meta", charset="utf-8"),
        el("meta", http_equiv="Content-Security-Policy", content=policy),
        el("meta", name="viewport", content="width=device-width,initial-scale=1"),
        el("title", f"{headline(findings)} – SensorTrack"),
        el("style", Raw(style)),
    )
    body = el(
        "body",
        el("a", "Skip to the claims", href="#claims", class_="skip"),
        sprite(),
        el(
            "div",
            _rail(findings),
            el("div", _header(findings), _main(findings), _footer(findings)),
            class_="page",
        ),
        el("script", Raw(script)),
    )
    return f"<!doctype html>\n{el('html', head, body, lang='en')}\n"


def _rail(findings: Findings) -> Element:
    items = [
        el(
            "li",
            el("a", mark(claim["verdict"], word=False), " ", claim["id"], href=f"#{claim['id']}"),
        )
        for claim in findings.claims
    ]
    networks = el("li", el("a", "real networks", href="#networks")) if findings.networks else None
    return el(
        "nav", el("h2", "Claims"), el("ol", items, networks), class_="rail", aria_label="Claims"
    )


def _header(findings: Findings) -> Element:
    strip = [
        el(
            "li",
            el("span", str(number), class_="n"),
            mark(verdict),
            el("p", MEANINGS[verdict]),
            class_=verdict,
        )
        for verdict, number in findings.counts.items()
    ]
    facts = findings.facts
    pairs = {
        "version": facts["version"],
        "date": facts["date"],
        "Python": facts["python"],
        "command": facts["command"],
        "certificates re-validated": str(facts["checked"]),
        "time": f"{facts['seconds']:.1f} s",
    }
    return el(
        "header",
        el("p", el("b", "SensorTrack"), " · theorems decided", class_="brand"),
        el("h1", headline(findings)),
        el("p", lede(findings), class_="lede"),
        el("ul", strip, class_="strip"),
        el("dl", [el("div", el("dt", k), el("dd", v)) for k, v in pairs.items()], class_="facts"),
        el("p", "Check every certificate again, with the standard library alone:"),
        _command("python -I -S verification/certificates/check.py certificates/*.json"),
        class_="top",
    )


def _command(text: str) -> Element:
    return el(
        "div",
        el("code", text),
        el("button", "Copy", type="button", class_="copy jsonly"),
        class_="ask",
    )


def _main(findings: Findings) -> Element:
    sections = []
    for name, system in findings.facts["systems"].items():
        cards = [card(claim, findings) for claim in findings.claims if claim["system"] == name]
        citation = el("p", system["citation"], class_="citation")
        digest = el("p", f"{name} · digest {system['digest'][:16]}", class_="meta")
        sections.append(el("section", el("h2", system["title"]), citation, digest, cards, id=name))
    return el("main", _claims(findings), sections, _networks(findings))


def _claims(findings: Findings) -> Element:
    toggles = [
        el("button", mark(v), type="button", data_verdict=v, aria_pressed="false", class_=v)
        for v, number in findings.counts.items()
        if number
    ]
    tools = el(
        "div",
        el("input", type="search", placeholder="Search claims  /", aria_label="Search claims"),
        toggles,
        el("output", ""),
        class_="tools jsonly",
    )
    head = ["Verdict", "Claim", "Printed", "Sharp", "Margin", "Certificates", "Time"]
    rows = [_claim_row(claim, findings) for claim in findings.claims]
    table = el(
        "table",
        el("caption", "Every printed claim, in the order of the papers", class_="vh"),
        el("thead", el("tr", [el("th", text, scope="col") for text in head])),
        el("tbody", rows),
    )
    return el(
        "section", el("h2", "The claims"), tools, el("div", table, class_="scroll"), id="claims"
    )


def _claim_row(claim: Record, findings: Findings) -> Element:
    sizes = [findings.size(path) or 0 for path in claim["certificates"]]
    words = f"{claim['id']} {claim['title']} {claim['source']} {claim['verdict']}".lower()
    margin_cell = margin(claim) or el("span", claim["margin_text"] or "–", class_="words")
    return el(
        "tr",
        el("td", mark(claim["verdict"])),
        el(
            "td",
            el("a", claim["title"], href=f"#{claim['id']}"),
            el("small", f"{claim['id']} · {claim['source']}"),
        ),
        el("td", claim["printed"] or "–", data_label="printed"),
        el("td", claim["sharp"] or "–", data_label="sharp"),
        el("td", margin_cell, data_label="margin"),
        el("td", size_text(sum(sizes) if sizes else None), class_="num", data_label="certificates"),
        el("td", f"{claim['seconds']:.2f} s", class_="num", data_label="time"),
        class_=claim["verdict"],
        data_words=words,
    )


def _networks(findings: Findings) -> Element | None:
    if not findings.networks:
        return None
    head = ["Network", "Nodes", "Edges", "λ₂", "Threshold", "Printed", "Ratio", "Critical cut"]
    rows = [
        el(
            "tr",
            el("th", row["graph"], scope="row"),
            [el("td", str(row[key]), class_="num") for key in ("nodes", "edges")],
            el("td", digits(row["lambda_2"]), class_="num"),
            el("td", f"{row['threshold']} = {digits(row['threshold_value'])}", class_="num"),
            el("td", digits(row["printed_value"]), class_="num"),
            el("td", f"{digits(row['ratio'])} ×", class_="num"),
            el("td", f"{row['cut_edges']} edges around {side_text(row['cut'], 6)}"),
        )
        for row in findings.networks
    ]
    pictures = [
        el("figure", picture, el("figcaption", f"{row['graph']}: {row['threshold']}"))
        for row in findings.networks
        if (picture := drawing(row))
    ]
    return el(
        "section",
        el("h2", "Real networks"),
        el(
            "p",
            "The sharp gain of each network for a disturbance bound of 1, with its certificate, "
            "beside the printed one. The critical cut is the pair of sides that is hardest to hold "
            "together; it is drawn thick, and its smaller side is filled.",
        ),
        el(
            "div",
            el(
                "table",
                el("thead", el("tr", [el("th", text, scope="col") for text in head])),
                el("tbody", rows),
            ),
            class_="scroll",
        ),
        el(
            "figure",
            ratios(findings.networks),
            el("figcaption", "Printed gain over sharp threshold"),
        ),
        el("div", pictures, class_="gallery"),
        id="networks",
    )


def _footer(findings: Findings) -> Element:
    rows = [el("div", el("dt", mark(v)), el("dd", MEANINGS[v])) for v in VERDICTS]
    return el(
        "footer",
        el("dl", rows, class_="verdicts"),
        el("p", f"SensorTrack {findings.facts['version']}. This page loads nothing from anywhere."),
    )
