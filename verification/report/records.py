"""What `verify` left in a folder, and the words that every report shares."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

Record = dict[str, Any]

VERDICTS = ("PROVED", "CORRECTED", "REFUTED", "SUPPORTED", "UNDECIDED")
MEANINGS = {
    "PROVED": "holds as printed; an exact certificate was re-validated",
    "CORRECTED": "false as printed; a counterexample replays, and a repair is proved",
    "REFUTED": "false; a counterexample replays, and no repair is proved",
    "SUPPORTED": "rests on statistics or a checked computation, not on proof",
    "UNDECIDED": "not decided; the stage that stopped is named",
}
OUTCOMES = {
    "PROVED": ("holds as printed", "hold as printed"),
    "CORRECTED": ("holds once corrected", "hold once corrected"),
    "REFUTED": ("is false", "are false"),
}
WORDS = (
    *("no", "one", "two", "three", "four", "five", "six"),
    *("seven", "eight", "nine", "ten", "eleven", "twelve"),
)
PAGE_BYTES, CLAIM_BYTES, INLINE_EACH = 550_000, 3300, 4000
"""Bytes of a page, of a claim's row and card in it, and of a certificate that it may hold."""
GAP_HEAD = ("source", "what is said", "what is missing to decide it")
NETWORK_HEAD = (
    *("network", "n", "m", "lambda_2", "threshold", ""),
    *("printed", "printed/sharp", "critical cut"),
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

    def document(self, certificate: str) -> Record:
        """A certificate's content, empty if it cannot be read: the checker says so, not a page."""
        try:
            found = json.loads((self.folder / certificate).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        return found if isinstance(found, dict) else {}

    @cached_property
    def inline(self) -> frozenset[str]:
        """Certificates that go into the page: the smallest, while it stays light."""
        sizes = {path: self.size(path) for claim in self.claims for path in claim["certificates"]}
        small = sorted((size, path) for path, size in sizes.items() if size and size <= INLINE_EACH)
        room, chosen = PAGE_BYTES - CLAIM_BYTES * len(self.claims), []
        for size, path in small:
            room -= 4 * size // 3
            chosen += [path] if room > 0 else []
        return frozenset(chosen)

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


RUN_FORMAT = "sensortrack-run/1"


def read_run(folder: Path) -> Record:
    """Read ``run.json`` of a folder.

    Raises
    ------
    OSError, ValueError
        The file is missing or no run.
    """
    run = _read(folder / "run.json")
    if not isinstance(run, dict) or run.get("format") != RUN_FORMAT:
        raise ValueError(f"run.json: the format is not {RUN_FORMAT}")
    return run


def _read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def count(number: int, noun: str) -> str:
    """``three claims``; digits above twelve."""
    return f"{number_word(number)} {noun}" + ("" if number == 1 else "s")


def number_word(number: int) -> str:
    """``three``; digits above twelve."""
    return WORDS[number] if number < len(WORDS) else str(number)


def headline(findings: Findings) -> str:
    """The result in one sentence."""
    counts, total = findings.counts, len(findings.claims)
    if not total:
        return "No claim was asked for"
    if counts["PROVED"] == total:
        return f"All {count(total, 'printed claim')} hold".replace("All one", "The one")
    parts = [
        f"{number_word(counts[verdict])} {one if counts[verdict] == 1 else many}"
        for verdict, (one, many) in OUTCOMES.items()
        if counts[verdict]
    ]
    *most, last = parts or ["none is decided by proof"]
    said = f"{', '.join(most)} and {last}" if most else last
    return f"Of {count(total, 'printed claim')}, {said}"


def lede(findings: Findings) -> str:
    """What else a reader must know in the first minute."""
    counts, facts = findings.counts, findings.facts
    text = f"{count(int(facts.get('checked', 0)), 'certificate').capitalize()} re-validated by the "
    text += "standard-library checker."
    if counts["UNDECIDED"]:
        text += f" {count(counts['UNDECIDED'], 'claim').capitalize()} left undecided."
    if counts["SUPPORTED"]:
        verb = "rests" if counts["SUPPORTED"] == 1 else "rest"
        said = count(counts["SUPPORTED"], "claim").capitalize()
        text += f" {said} {verb} on statistics or a checked computation, not on proof."
    gaps = sum(len(system.get("gaps", [])) for system in facts["systems"].values())
    if gaps:
        text += f" {count(gaps, 'printed statement').capitalize()} left open by the text."
    if facts.get("skipped"):
        text += f" {count(len(facts['skipped']), 'check').capitalize()} skipped."
    return text


def value_text(claim: Record, side: str) -> str:
    """The printed or the sharp value in words, a dash where there is none."""
    return str(claim[side] or "–")


def network_cells(row: Record) -> list[str]:
    """One row of the table of networks, the same in every report; see `NETWORK_HEAD`."""
    return [
        row["graph"],
        str(row["nodes"]),
        str(row["edges"]),
        digits(row["lambda_2"]),
        row["threshold"],
        digits(row["threshold_value"]),
        digits(row["printed_value"]),
        digits(row["ratio"]),
        f"{row['cut_edges']} edges around {side_text(row['cut'])}",
    ]


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
