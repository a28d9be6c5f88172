"""The table of all claims, with search, toggles and sorting for those who run the script."""

from __future__ import annotations

import math

from .dom import Element, el
from .margins import margin, ratio
from .records import MEANINGS, Findings, Record, size_text, value_text
from .symbols import icon, mark

COLUMNS = {
    "Verdict": "v",
    "Claim": "c",
    "Printed": "p",
    "Sharp": "s",
    "Margin": "m",
    "Certificate": "z",
    "Time": "t",
}


def table(findings: Findings) -> Element:
    """Return the section with the table."""
    rows = [_row(claim, findings) for claim in findings.claims]
    none = el("tr", el("td", "No claim has all these words.", colspan=7), id="none", hidden="")
    return el(
        "section",
        el("h2", "Every claim, printed beside sharp"),
        el(
            "p",
            "The dot is what the paper printed, the tick is the truth. Left of the tick the paper "
            "promises too much; right of it, it asks for more than is needed.",
            class_="sub",
        ),
        _tools(findings),
        el(
            "table",
            el("caption", "Every printed claim, in the order of the papers", class_="vh"),
            el("thead", el("tr", [_head(*column) for column in COLUMNS.items()], role="row")),
            el("tbody", rows, none),
            class_="claims",
            role="table",
        ),
        el(
            "p",
            "The margin is drawn on one logarithmic axis from ½ to 4 times the sharp value. "
            "Claims without a number have words only.",
            class_="key",
        ),
        id="claims",
    )


def _tools(findings: Findings) -> Element:
    """Search field and toggles; without the script they are not shown."""
    toggles = [
        el(
            "button",
            icon(verdict),
            verdict.capitalize(),
            type="button",
            data_f=verdict,
            aria_pressed="false",
            class_=verdict,
        )
        for verdict in MEANINGS
        if findings.counts[verdict]
    ]
    search = el(
        "input", type="search", id="q", placeholder="Search claims (press /)", aria_label="Search"
    )
    return el("div", search, toggles, el("output", id="count"), class_="tools jsonly")


def _head(title: str, key: str) -> Element:
    scale = el("span", el("span", "◂ too bold"), el("span", "cautious ▸"), class_="scale")
    button = el("button", title, type="button", data_k=key)
    number = "num" if key in "pst" else None
    return el("th", button, scale if key == "m" else None, scope="col", class_=number)


def _row(claim: Record, findings: Findings) -> Element:
    sizes = [findings.size(path) or 0 for path in claim["certificates"]]
    total = sum(sizes) if sizes else None
    sort = {
        "data-sp": _key(claim["printed_value"]),
        "data-ss": _key(claim["sharp_value"]),
        "data-sm": _key(_distance(claim)),
        "data-sz": _key(total),
        "data-st": _key(claim["seconds"]),
    }
    link = el("a", claim["title"], href=f"#{claim['id']}")
    size = el("a", size_text(total), href=f"#{claim['id']}-evidence") if total else "–"
    return el(
        "tr",
        el("td", mark(claim["verdict"]), class_="c-v", role="cell"),
        el(
            "th",
            link,
            el("small", f"{claim['source']}, {claim['system']}"),
            scope="row",
            role="rowheader",
        ),
        el("td", value_text(claim, "printed"), class_="num", data_l="Printed", role="cell"),
        el("td", value_text(claim, "sharp"), class_="num", data_l="Sharp", role="cell"),
        el(
            "td",
            margin(claim),
            el("small", claim["margin_text"] or "no number"),
            class_="mg",
            role="cell",
        ),
        el("td", size, class_="c-z", role="cell"),
        el("td", f"{claim['seconds']:.2f} s", class_="num c-t", role="cell"),
        class_=claim["verdict"],
        role="row",
        data_v=claim["verdict"],
        **sort,
    )


def _key(value: float | None) -> str | None:
    return None if value is None else f"{value:.6g}"


def _distance(claim: Record) -> float | None:
    """How far the printed value is from the truth, whichever way: what sorting goes by."""
    found = ratio(claim)
    return None if found is None else -abs(math.log(found))
