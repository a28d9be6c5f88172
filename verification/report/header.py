"""The first screen: the result in one sentence, five counts, the facts of the run."""

from __future__ import annotations

from .dom import Element, el
from .records import MEANINGS, Findings, Record, headline, lede
from .symbols import icon, mark

MOST_ICONS = 40


def header(findings: Findings) -> Element:
    """Product name, headline, lede, strip, run facts, and how to check everything again."""
    brand = el("span", el("b", "SensorTrack"), " verification report")
    theme = el("button", "Theme: Auto", type="button", id="theme", class_="jsonly")
    return el(
        "header",
        el("div", brand, theme, class_="brand"),
        el("h1", headline(findings)),
        el("p", lede(findings), class_="lede"),
        el(
            "ul",
            [_count(findings, verdict) for verdict in MEANINGS],
            class_="strip",
            aria_label="Verdicts",
        ),
        facts(run_facts(findings.facts)),
        el(
            "div",
            el("p", "Check every certificate again, with the standard library alone:"),
            command("python -I -S verification/certificates/check.py certificates/*.json"),
            class_="again",
        ),
        class_="top",
        id="top",
    )


def _count(findings: Findings, verdict: str) -> Element:
    claims = [claim for claim in findings.claims if claim["verdict"] == verdict]
    cells = el("div", [_cell(claim) for claim in claims], class_="cells")
    return el(
        "li",
        el("span", str(len(claims)), class_="n"),
        mark(verdict),
        el("p", MEANINGS[verdict]),
        cells if 0 < len(claims) <= MOST_ICONS else None,
        class_=verdict,
    )


def _cell(claim: Record) -> Element:
    spoken = el("span", f"{claim['title']}, {claim['verdict']}", class_="vh")
    return el("a", spoken, icon(claim["verdict"]), href=f"#{claim['id']}", title=claim["title"])


def run_facts(given: Record) -> dict[str, str]:
    """What a reader needs in order to run it again."""
    return {
        "Date": given["date"],
        "Command": given["command"],
        "Time": f"{given['seconds']:.1f} s",
        "Certificates": f"{given['checked']} re-validated",
        "Versions": f"SensorTrack {given['version']}, Python {given['python']}",
    }


def facts(pairs: dict[str, str]) -> Element:
    """Names and values of a run, as a list."""
    return el("dl", [el("div", el("dt", k), el("dd", v)) for k, v in pairs.items()], class_="facts")


def command(text: str) -> Element:
    """A command that a reader selects with one click; the script adds a button."""
    return el("div", el("code", text), class_="ask")
