"""The report as Markdown: the same order, words and digits as the page."""

from __future__ import annotations

import re
from collections.abc import Sequence

from .records import (
    GAP_HEAD,
    NETWORK_HEAD,
    Findings,
    Record,
    headline,
    lede,
    network_cells,
    size_text,
)

SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|~$!])")


def markdown(findings: Findings) -> str:
    """Return the whole text."""
    parts = [f"# {escape(headline(findings))}", escape(lede(findings)), _table(findings)]
    for claim in findings.claims:
        parts += _claim(claim)
    gaps = [row for system in findings.facts["systems"].values() for row in system.get("gaps", [])]
    if gaps:
        parts += ["## What the text leaves open", table_of(GAP_HEAD, gaps)]
    if findings.networks:
        parts += ["## Gain threshold of real networks", _networks(findings)]
    parts.append(_facts(findings))
    return "\n\n".join(parts) + "\n"


def escape(text: str) -> str:
    """Text from papers, files and errors, with nothing that Markdown or HTML would act on."""
    return SPECIAL.sub(r"\\\1", " ".join(text.split()))


def _display(latex: str) -> str:
    """A formula; its order signs are spelled, because Markdown passes tags through."""
    return "$$" + latex.replace("<", r"\lt ").replace(">", r"\gt ") + "$$"


def _row(cells: list[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def table_of(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of texts from anywhere."""
    lines = [[escape(cell) for cell in row] for row in (head, *rows)]
    return "\n".join(map(_row, [lines[0], ["---"] * len(head), *lines[1:]]))


def _table(findings: Findings) -> str:
    rows = [_row(["verdict", "claim", "printed", "sharp", "certificates"]), _row(["---"] * 5)]
    for claim in findings.claims:
        sizes = [findings.size(path) for path in claim["certificates"]]
        rows.append(
            _row(
                [
                    claim["verdict"],
                    f"[{escape(claim['id'])}](#{anchor(claim['id'])})",
                    escape(claim["printed"] or "–"),
                    escape(claim["sharp"] or "–"),
                    size_text(sum(size or 0 for size in sizes) if sizes else None),
                ]
            )
        )
    return "\n".join(rows)


def anchor(identifier: str) -> str:
    """The link that renderers make of a heading."""
    return re.sub(r"[^a-z0-9_-]", "", identifier.lower())


def _claim(claim: Record) -> list[str]:
    parts = [f"### {claim['id']}", f"**{claim['verdict']}** · {escape(claim['source'])}"]
    parts.append(escape(claim["title"]) + ".")
    if claim["formula"]:
        parts.append(_display(claim["formula"]))
    parts.append(
        f"Printed: {escape(claim['printed'] or '–')}. Sharp: {escape(claim['sharp'] or '–')}."
        + (f" {escape(claim['margin_text'])}." if claim["margin_text"] else "")
    )
    if claim["repair"]:
        parts.append(f"What is true: {escape(claim['repair'])}")
    if claim["repair_formula"]:
        parts.append(_display(claim["repair_formula"]))
    parts.append(f"How it was decided: {escape(claim['reason'])}")
    if claim["replay"]:
        head, *rows = claim["replay"]
        cells = [[escape(cell) for cell in row] for row in rows]
        parts.append("\n".join(map(_row, [[escape(c) for c in head], ["---"] * len(head), *cells])))
    if claim["relies_on"]:
        parts.append("Relies on: " + "; ".join(map(escape, claim["relies_on"])) + ".")
    if claim["certificates"]:
        parts.append("```sh\nsensortrack check " + " ".join(claim["certificates"]) + "\n```")
    return parts


def _networks(findings: Findings) -> str:
    return table_of(NETWORK_HEAD, list(map(network_cells, findings.networks)))


def _facts(findings: Findings) -> str:
    facts = findings.facts
    lines = [
        f"SensorTrack {facts['version']}, {facts['date']}, Python {facts['python']}, "
        f"`{facts['command'].replace('`', '')}`."
    ]
    lines += [
        f"- {name}: {escape(entry['citation'])}; digest `{entry['digest'][:16]}`"
        for name, entry in facts["systems"].items()
    ]
    return "\n".join(lines)
