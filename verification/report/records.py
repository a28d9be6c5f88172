"""What `verify` left in a folder, and the words that every report shares."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Record = dict[str, Any]

VERDICTS = ("PROVED", "CORRECTED", "REFUTED", "SUPPORTED", "UNDECIDED")
MEANINGS = {
    "PROVED": "the printed statement holds; an exact certificate was re-validated",
    "CORRECTED": "a counterexample replays, and a repaired statement is proved",
    "REFUTED": "a counterexample replays; no repair is proved",
    "SUPPORTED": "statistics or a residual-checked computation only",
    "UNDECIDED": "neither proof nor counterexample; the stage that stopped is named",
}
WORDS = (
    *("no", "one", "two", "three", "four", "five", "six"),
    *("seven", "eight", "nine", "ten", "eleven", "twelve"),
)


@dataclass(frozen=True)
class Findings:
    """Everything that a report shows.

    Parameters
    ----------
    claims, networks : sequence of dict
        Entries of ``claims.json`` and ``networks.json``.
    facts : dict
        Content of ``facts.json``.
    folder : Path
        Where they and the certificates lie.
    """

    claims: Sequence[Record]
    networks: Sequence[Record]
    facts: Record
    folder: Path

    @property
    def counts(self) -> dict[str, int]:
        """Number of claims of each verdict, in the order of `VERDICTS`."""
        said = [claim["verdict"] for claim in self.claims]
        return {verdict: said.count(verdict) for verdict in VERDICTS}

    def size(self, certificate: str) -> int | None:
        """Bytes of a certificate, None if it is not there."""
        path = self.folder / certificate
        return path.stat().st_size if path.is_file() else None


def read_findings(folder: Path) -> Findings:
    """Read ``claims.json``, ``networks.json`` (may be absent) and ``facts.json`` of a folder.

    Raises
    ------
    OSError, ValueError
        A file is missing or no JSON.
    """
    networks = folder / "networks.json"
    return Findings(
        claims=_read(folder / "claims.json"),
        networks=_read(networks) if networks.exists() else [],
        facts=_read(folder / "facts.json"),
        folder=folder,
    )


def _read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def count(number: int, noun: str) -> str:
    """``three claims``; digits above twelve."""
    word = WORDS[number] if number < len(WORDS) else str(number)
    return f"{word} {noun}" + ("" if number == 1 else "s")


def headline(findings: Findings) -> str:
    """The result in one sentence."""
    counts, total = findings.counts, len(findings.claims)
    wrong = counts["CORRECTED"] + counts["REFUTED"]
    if not total:
        return "No claim was asked for"
    if not wrong:
        held = counts["PROVED"]
        if held == total:
            return f"All {count(total, 'printed claim')} hold".replace("All one", "The one")
        return f"{count(held, 'printed claim').capitalize()} of {total} proved, none refuted"
    parts = [f"{counts['PROVED']} proved"] if counts["PROVED"] else []
    parts += (
        [f"{counts['CORRECTED']} false as printed and corrected"] if counts["CORRECTED"] else []
    )
    parts += [f"{counts['REFUTED']} refuted"] if counts["REFUTED"] else []
    return f"{count(total, 'printed claim').capitalize()}: {', '.join(parts)}"


def lede(findings: Findings) -> str:
    """What else a reader must know in the first minute."""
    counts, facts = findings.counts, findings.facts
    text = f"{count(int(facts.get('checked', 0)), 'certificate').capitalize()} re-validated by the "
    text += "standard-library checker."
    if counts["UNDECIDED"]:
        text += f" {count(counts['UNDECIDED'], 'claim').capitalize()} left undecided."
    if facts.get("skipped"):
        text += f" {count(len(facts['skipped']), 'check').capitalize()} skipped."
    return text


def digits(value: float | None) -> str:
    """Five significant digits."""
    return "–" if value is None else f"{value:.5g}"


def size_text(size: int | None) -> str:
    """``1.2 kB``."""
    if size is None:
        return "–"
    return f"{size} B" if size < 1000 else f"{size / 1000:.1f} kB"


def side_text(names: Sequence[str], most: int = 4) -> str:
    """Node names of a cut, shortened."""
    shown = ", ".join(names[:most])
    return shown + (f" and {len(names) - most} more" if len(names) > most else "")
