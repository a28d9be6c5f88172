"""What a reader can check: files, their kind and size, and the command."""

from __future__ import annotations

import base64
from typing import Any

from .dom import Element, el
from .header import command
from .records import Findings, Record, size_text

KINDS = {
    "congruence": "congruences",
    "combination": "combinations",
    "derivation": "identities",
    "vector": "vectors",
    "matrix": "matrices",
    "trajectory": "replayed runs",
    "cuts": "enumerated or routed cuts",
    "cut": "critical cuts",
}
WORDS = {"PROVED": "Proof", "REFUTED": "Counterexample"}


def evidence(claim: Record, findings: Findings) -> Element | None:
    """Files of one claim, small ones inside the page, and the command that checks them."""
    files = claim["certificates"]
    if not files:
        return None
    rows = [el("li", _file(path, findings)) for path in files]
    return el(
        "div",
        el("ul", rows),
        command("sensortrack check " + " ".join(files)),
        id=f"{claim['id']}-evidence",
        class_="ev",
    )


def _file(path: str, findings: Findings) -> list[Element | str]:
    name = path.rsplit("/", maxsplit=1)[-1]
    document = findings.document(path)
    link = el("a", name, href=path)
    if path in findings.inline:
        text = base64.b64encode((findings.folder / path).read_bytes()).decode()
        link = el("a", name, href=f"data:application/json;base64,{text}", download=name)
    size = size_text(findings.size(path)).replace(" ", "\N{NO-BREAK SPACE}")
    return [f"{_described(document)}: ", link, f", {size}"]


def _described(document: dict[str, Any]) -> str:
    """``Proof by 3 congruences (3 by 3, 4 digits)``: what a checker goes through."""
    word = WORDS.get(str(document.get("verdict")), "Certificate")
    counts: dict[str, int] = {}
    matrices = []
    for item in document.get("witness", []):
        kind = str(item.get("kind"))
        counts[kind] = counts.get(kind, 0) + 1
        matrices += [item["rows"]] if kind == "congruence" else []
    parts = []
    for kind, count in counts.items():
        plural = KINDS.get(kind, kind)
        parts.append(f"{count} {plural if count > 1 else _singular(plural)}")
    detail = ""
    if matrices:
        digits = max(
            len(str(entry).lstrip("-")) for rows in matrices for row in rows for entry in row
        )
        detail = f" (up to {max(map(len, matrices))} rows, {digits} digits)"
    return f"{word} by {', '.join(parts)}{detail}" if parts else f"{word} by replayed arithmetic"


def _singular(word: str) -> str:
    """The singular of a kind's name."""
    irregular = {"matrices": "matrix", "identities": "identity"}
    if word in irregular:
        return irregular[word]
    head, _, tail = word.rpartition(" ")
    return f"{head} {tail.removesuffix('s')}".strip()
