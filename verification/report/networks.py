"""The section on real networks: a row, a bar and a drawing each."""

from __future__ import annotations

from .dom import Element, el
from .figures import drawing, ratios
from .records import NETWORK_HEAD, Findings, network_cells


def networks(findings: Findings) -> Element | None:
    """Return the section, None without networks."""
    if not findings.networks:
        return None
    rows = [
        el("tr", el("th", name, scope="row"), [el("td", cell) for cell in cells])
        for name, *cells in map(network_cells, findings.networks)
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
            class_="sub",
        ),
        el(
            "div",
            el(
                "table",
                el("thead", el("tr", [el("th", text, scope="col") for text in NETWORK_HEAD])),
                el("tbody", rows),
                class_="plain",
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
