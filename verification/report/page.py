"""One self-contained HTML page: nothing is loaded from anywhere."""

from __future__ import annotations

import base64
import hashlib
from pathlib import Path

from .dom import Child, Element, Raw, el
from .header import header
from .networks import networks
from .records import MEANINGS, Findings, Record, headline
from .sections import section
from .symbols import icon, mark, sprite
from .table import table

HERE = Path(__file__).parent


def page(findings: Findings) -> str:
    """Return the text of the page on claims."""
    names = [name for name in findings.facts["systems"] if _claims_of(name, findings)]
    return document(
        f"{headline(findings)} – SensorTrack",
        _rail(names, findings),
        header(findings),
        el(
            "main",
            table(findings),
            [section(name, findings) for name in names],
            networks(findings),
        ),
        _footer(findings),
    )


def document(title: str, rail: Element, *column: Child) -> str:
    """A page with our style and script, and a policy that allows nothing else."""
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
        el("title", title),
        el("style", Raw(style)),
    )
    body = el(
        "body",
        el("a", "Skip to the content", href="#top", class_="skip"),
        sprite(),
        el("div", rail, el("div", *column, class_="col"), class_="page"),
        el("script", Raw(script)),
    )
    return f"<!doctype html>\n{el('html', head, body, lang='en')}\n"


def _claims_of(name: str, findings: Findings) -> list[Record]:
    return [claim for claim in findings.claims if claim["system"] == name]


def _rail(names: list[str], findings: Findings) -> Element:
    """All claims by system, always in sight where the window is wide."""
    groups: list[Element] = []
    for name in names:
        items = [el("li", _entry(claim)) for claim in _claims_of(name, findings)]
        title = findings.facts["systems"][name]["title"]
        groups += [el("h2", el("a", title, href=f"#{name}")), el("ol", items)]
    more = el("a", el("b", "Real networks"), href="#networks") if findings.networks else None
    return el(
        "nav",
        el("a", el("b", "Summary"), href="#top"),
        el("a", el("b", "All claims"), href="#claims"),
        groups,
        more,
        class_="rail",
        aria_label="Claims by system",
    )


def _entry(claim: Record) -> Element:
    verdict, (_, _, name) = claim["verdict"], claim["id"].partition(".")
    spoken = el("span", verdict, class_="vh")
    words = name.replace("_", " ")
    return el("a", icon(verdict), words, spoken, href=f"#{claim['id']}", class_=verdict)


def _footer(findings: Findings) -> Element:
    rows = [el("div", el("dt", mark(v)), el("dd", text)) for v, text in MEANINGS.items()]
    digests = [
        el("li", f"{name}: ", el("code", system["digest"]))
        for name, system in findings.facts["systems"].items()
    ]
    return el(
        "footer",
        el("dl", rows, class_="verdicts"),
        el("ul", digests),
        el("p", f"SensorTrack {findings.facts['version']}. This page loads nothing from anywhere."),
    )
