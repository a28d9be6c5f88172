"""Verdict marks: an icon, a word and a colour, always all three to the reader."""

from __future__ import annotations

from .dom import Element, el
from .margins import scale

SHAPES = {
    "PROVED": (el("circle", cx=10, cy=10, r=9, class_="fill"), "M5.5 10.5 9 14l6-8"),
    "CORRECTED": (el("rect", x=1, y=1, width=18, height=18, rx=2, class_="fill"), "M5 14l5-8 5 8"),
    "REFUTED": (el("path", d="M10 0 20 10 10 20 0 10Z", class_="fill"), "M7 7l6 6M13 7l-6 6"),
    "SUPPORTED": (
        el("circle", cx=10, cy=10, r=8.5, class_="ring"),
        "M5.9 12.3h.1M8.7 9h.1M11.5 10.6h.1M14.2 7.3h.1",
    ),
    "UNDECIDED": (
        el("circle", cx=10, cy=10, r=8.5, class_="ring dashed"),
        "M7.5 7.5a2.5 2.5 0 1 1 3.3 2.4c-.6.3-.8.8-.8 1.6M10 14.5v.1",
    ),
}


def sprite() -> Element:
    """All icons, once."""
    icons = [
        el(
            "symbol",
            outline,
            el("path", d=path, class_=_stroke(verdict)),
            id=f"i-{verdict}",
            viewBox="0 0 20 20",
        )
        for verdict, (outline, path) in SHAPES.items()
    ]
    return el("svg", icons, scale(), _hatch(), width=0, height=0, aria_hidden="true", class_="vh")


def _hatch() -> Element:
    """The ground of what is promised and false: it survives grey print."""
    turned = "rotate(45)"
    lines = el("path", d="M0 0V7", class_="hatch")
    options = {"patternUnits": "userSpaceOnUse", "patternTransform": turned}
    return el("pattern", lines, id="hatch", width=7, height=7, **options)


def _stroke(verdict: str) -> str:
    return "on" if verdict in ("PROVED", "CORRECTED", "REFUTED") else "own"


def icon(verdict: str) -> Element:
    """The icon alone, in the colour of what is around it; a word must stand beside it."""
    return el("svg", el("use", href=f"#i-{verdict}"), class_="i")


def mark(verdict: str, word: bool = True) -> Element:
    """Icon and word of a verdict; without the word it is spoken only."""
    text = verdict if word else el("span", verdict, class_="vh")
    return el("span", icon(verdict), text, class_=f"mark {verdict}")
