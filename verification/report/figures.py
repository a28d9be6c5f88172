"""Pictures of networks as inline SVG: ratios, and each network with its critical cut."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .dom import Element, el
from .records import Record, digits


def ratios(rows: Sequence[Record]) -> Element:
    """A bar a network: how many times the printed gain is larger than needed."""
    ordered = sorted(rows, key=lambda row: row["ratio"] or 0)
    top = max((row["ratio"] or 1 for row in ordered), default=1.0)
    height, left = 26, 150
    bars: list[Element] = []
    for k, row in enumerate(ordered):
        y, width = 8 + k * height, 270 * (row["ratio"] or 0) / top
        bars += [
            el("text", row["graph"], x=left - 8, y=y + 13, text_anchor="end"),
            el("rect", x=left, y=y, width=f"{width:.1f}", height=16, class_="bar"),
            el("text", f"{digits(row['ratio'])} ×", x=f"{left + width + 6:.1f}", y=y + 13),
        ]
    one = left + 270 / top
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
    places = _layout(len(names), np.array(links))
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
        "svg", el("title", title), lines, dots, viewBox="0 0 240 170", role="img", class_="network"
    )


def _layout(n: int, links: NDArray[np.int64]) -> NDArray[np.float64]:
    """Stress majorisation of hop distances from a fixed start: the same picture every time."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import shortest_path

    graph = coo_array((np.ones(len(links)), (links[:, 0], links[:, 1])), shape=(n, n))
    hops = shortest_path(graph, directed=False, unweighted=True)
    hops[~np.isfinite(hops)] = n
    angle = 2 * np.pi * np.arange(n) / n
    x = np.stack([np.cos(angle), 0.7 * np.sin(angle)], axis=1) * n / 4
    weight = np.where(hops > 0, 1 / np.maximum(hops, 1) ** 2, 0.0)
    total = weight.sum(axis=1, keepdims=True)
    for _ in range(300):
        apart = x[:, None] - x[None]
        length = np.sqrt((apart**2).sum(axis=2)) + 1e-9
        pull = (weight * hops / length)[:, :, None] * apart
        x = (weight @ x + pull.sum(axis=1)) / np.maximum(total, 1e-9)
    x -= x.min(axis=0)
    span = np.maximum(x.max(axis=0), 1e-9)
    return np.asarray(10 + x / span * np.array([220.0, 150.0]))
