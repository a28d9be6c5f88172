"""The table on a terminal: the words, digits and order of the page."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TextIO

from verification.plain_text import harmless

from .records import (
    NETWORK_HEAD,
    Findings,
    Record,
    headline,
    network_cells,
    read_findings,
    size_text,
)

MARKS = {"PROVED": "✓", "CORRECTED": "‸", "REFUTED": "✗", "SUPPORTED": "≈", "UNDECIDED": "?"}
PLAIN_MARKS = {"PROVED": "+", "CORRECTED": "^", "REFUTED": "x", "SUPPORTED": "~", "UNDECIDED": "?"}
COLOURS = {"PROVED": 36, "CORRECTED": 33, "REFUTED": 31, "SUPPORTED": 35, "UNDECIDED": 90}
ASCII = str.maketrans({"–": "-", "…": "..", "≥": ">=", "≤": "<=", "×": "x", "β": "beta", "λ": "l"})
NARROW = 60
FILE_WIDTH = 140


def show(folder: Path, *, plain: bool = False, stream: TextIO | None = None) -> None:
    """Print what `verify` left in a folder.

    Parameters
    ----------
    folder : Path
        The output folder of `verify`.
    plain : bool, optional
        ASCII only, no colour. Also chosen when the stream cannot write the signs.
    stream : text stream, optional
        Standard output by default.
    """
    out = stream or sys.stdout
    plain = plain or not _writes("✓", out)
    colour = not plain and out.isatty() and "NO_COLOR" not in os.environ
    width = shutil.get_terminal_size((FILE_WIDTH, 24)).columns if out.isatty() else FILE_WIDTH
    findings = read_findings(folder)
    lines = [*claim_lines(findings, plain, colour, width), *network_lines(findings, width)]
    for line in [*lines, "", headline(findings)]:
        print(
            line.translate(ASCII).encode("ascii", "replace").decode() if plain else line, file=out
        )


def claim_lines(findings: Findings, plain: bool, colour: bool, width: int) -> list[str]:
    """One row a claim; margin, certificate size and time go first where it is narrow."""
    rows = [_claim_row(claim, findings, plain) for claim in findings.claims]
    rows = _fitted(rows, width, keep=4)
    texts = _aligned(rows)
    if colour:
        texts = [
            text.replace(
                claim["verdict"], f"\x1b[{COLOURS[claim['verdict']]}m{claim['verdict']}\x1b[0m", 1
            )
            for text, claim in zip(texts, findings.claims, strict=True)
        ]
    return texts


def network_lines(findings: Findings, width: int) -> list[str]:
    """The table of networks, with a head."""
    if not findings.networks:
        return []
    rows = [[harmless(cell) for cell in network_cells(row)] for row in findings.networks]
    table = [[*row[:3], *row[4:]] for row in ([*NETWORK_HEAD], *rows)]
    return [
        "",
        "gain threshold of real networks, gamma = 1",
        *_aligned(_fitted(table, width, 8)),
    ]


def _claim_row(claim: Record, findings: Findings, plain: bool) -> list[str]:
    marks = PLAIN_MARKS if plain else MARKS
    sizes = [findings.size(path) for path in claim["certificates"]]
    total = sum(size or 0 for size in sizes) if sizes else None
    return [
        f"{marks[claim['verdict']]} {claim['verdict']}",
        claim["id"],
        f"printed {claim['printed'] or '–'}",
        f"sharp {claim['sharp'] or '–'}",
        size_text(total),
        f"{claim['seconds']:.2f} s",
    ]


def _fitted(rows: list[list[str]], width: int, keep: int) -> list[list[str]]:
    """Drop last columns, then shorten the widest, until the table fits."""
    rows = [list(row) for row in rows]
    while rows and len(rows[0]) > keep and _width(rows) > width:
        rows = [row[:-1] for row in rows]
    for _ in range(200):
        if not rows or _width(rows) <= max(width, NARROW):
            break
        wide = max(range(2, len(rows[0])), key=lambda k: max(len(row[k]) for row in rows))
        limit = max(len(row[wide]) for row in rows) - 1
        for row in rows:
            if len(row[wide]) > limit:
                row[wide] = row[wide][: limit - 1].rstrip(" …") + "…"
    return rows


def _width(rows: Sequence[Sequence[str]]) -> int:
    return sum(max(map(len, column)) + 2 for column in zip(*rows, strict=True)) - 2


def _aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(text.ljust(width) for text, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]


def _writes(text: str, stream: TextIO) -> bool:
    try:
        text.encode(stream.encoding or "ascii")
    except UnicodeEncodeError:
        return False
    return True
