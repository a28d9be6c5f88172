"""Pictures of networks as inline SVG: ratios, and each network with its critical cut."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sensortrack.network_layout import framed, spread_places

from .dom import Element, el
from .records import Record, digits

WIDTH, HEIGHT, MARGIN = 240, 170, 10
"""Frame of one network."""

NAMES, LONGEST = 168, 236
"""Room for the names beside bars, and the length of the longest bar."""


def ratios(rows: Sequence[Record]) -> Element:
    """A bar a network: how many times the printed gain is larger than needed."""
    ordered = sorted(rows, key=lambda row: row["ratio"] or 0)
    top = max((row["ratio"] or 1 for row in ordered), default=1.0)
    height = 26
    bars: list[Element] = []
    for k, row in enumerate(ordered):
        y, width = 8 + k * height, LONGEST * (row["ratio"] or 0) / top
        bars += [
            el("text", row["graph"], x=NAMES - 8, y=y + 13, text_anchor="end"),
            el("rect", x=NAMES, y=y, width=f"{width:.1f}", height=16, class_="bar"),
            el("text", f"{digits(row['ratio'])} ×", x=f"{NAMES + width + 6:.1f}", y=y + 13),
        ]
    one = NAMES + LONGEST / top
    total = 16 + height * len(ordered)
    guide = el("line", x1=f"{one:.1f}", y1=2, x2=f"{one:.1f}", y2=total - 6, class_="truth")
    says = "Printed gain over the sharp threshold; the line is 1, what is needed."
    return el(
        "svg",
        el("title", "Printed gain over the sharp threshold"),
        el("desc", says),
        bars,
        guide,
        viewBox=f"0 0 480 {total}",
        role="img",
        class_="ratios",
    )


def drawing(row: Record) -> Element | None:
    """The network with its critical cut: cut edges thick, the smaller side filled."""
    names, links = row.get("names"), row.get("edge_list")
    if not names or not links or len(names) > 60:
        return None
    on_map = row.get("places")
    found = np.array(on_map) if on_map else spread_places(len(names), links)
    places = framed(found, WIDTH, HEIGHT, MARGIN, equal=bool(on_map))
    inside = {i for i, name in enumerate(names) if name in set(row["cut"])}
    lines = [
        el(
            "line",
            x1=f"{places[i, 0]:.1f}",
            y1=f"{places[i, 1]:.1f}",
            x2=f"{places[j, 0]:.1f}",
            y2=f"{places[j, 1]:.1f}",
            class_="cut" if (i in inside) != (j in inside) else "link",
        )
        for i, j in links
    ]
    dots = [
        el(
            "circle",
            el("title", name),
            cx=f"{places[i, 0]:.1f}",
            cy=f"{places[i, 1]:.1f}",
            r=4.5,
            class_="inside" if i in inside else "node",
        )
        for i, name in enumerate(names)
    ]
    title = f"{row['graph']}: critical cut of {row['cut_edges']} edges"
    return el(
        "svg",
        el("title", title),
        lines,
        dots,
        viewBox=f"0 0 {WIDTH} {HEIGHT}",
        role="img",
        class_="network",
    )
