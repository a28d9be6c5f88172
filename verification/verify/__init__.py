"""The run behind ``sensortrack verify``: decide, write, re-validate, report."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from importlib.metadata import version
from pathlib import Path
from typing import Any

from .checking import checked, confirm
from .deciding import decide, lost
from .folder import CLAIMS, FACTS, NETWORKS, prepare, write_certificates, write_records
from .parallel import run_all
from .records import Finding, Record, undecide
from .selection import Selection, select
from .sweeping import SYSTEM as SWEPT
from .sweeping import sweep

__all__ = ["Outcome", "select", "verify"]

Task = tuple[str, str]
"""What to do, ``claim`` or ``network``, and its name."""


@dataclass(frozen=True)
class Outcome:
    """What a run found.

    Parameters
    ----------
    claims, networks : list of dict
        The contents of ``claims.json`` and ``networks.json``.
    facts : dict
        The contents of ``facts.json``.
    skipped : tuple of str
        Checks that were meant to be made and could not be.
    """

    claims: list[Record]
    networks: list[Record]
    facts: Record
    skipped: tuple[str, ...]


def verify(
    selection: Selection,
    folder: Path,
    *,
    quick: bool = False,
    jobs: int = 1,
    command: str = "sensortrack verify",
    tick: Callable[[Task], None] = lambda _task: None,
) -> Outcome:
    """Decide claims and leave everything that was found in a folder.

    Parameters
    ----------
    selection : Selection
        Which claims; see `select`.
    folder : Path
        New, empty, or of an earlier run, whose certificates are then removed.
    quick : bool, optional
        Leave out the sweep over the shipped networks.
    jobs : int, optional
        Processes to use.
    command : str, optional
        What the user typed, for the report.
    tick : callable, optional
        Called with each task that is done; `tasks_of` tells all of them.

    Returns
    -------
    Outcome

    Raises
    ------
    InputError
        The folder cannot be used.
    """
    started = time.perf_counter()
    prepare(folder)
    tasks = tasks_of(selection, quick)
    findings = run_all(work, tasks, jobs, _lost, tick)
    documents = _documents(findings)
    entries = checked(folder, write_certificates(folder, documents))
    claims, networks, skipped = [], [], []
    for (what, name), finding in zip(tasks, findings, strict=True):
        if finding.skipped:
            skipped.append(finding.skipped)
        elif what == "claim":
            confirm(finding.record, entries)
            claims.append(finding.record)
        else:
            entry = entries[finding.record["certificate"]]
            if entry["valid"]:
                size = (folder / finding.record["certificate"]).stat().st_size
                networks.append(finding.record | {"bytes": size})
            else:
                skipped.append(f"network {name}: {entry['reason']}")
    facts = _facts(selection, command, skipped)
    facts["checked"] = sum(bool(entry["valid"]) for entry in entries.values())
    facts["seconds"] = round(time.perf_counter() - started, 3)
    write_records(folder, {NETWORKS: networks, FACTS: facts, CLAIMS: claims})
    return Outcome(claims, networks, facts, tuple(skipped))


def tasks_of(selection: Selection, quick: bool) -> list[Task]:
    """What a run has to do, in order."""
    tasks = [("claim", claim.id) for claim in selection.claims]
    if quick or SWEPT not in selection.systems:
        return tasks
    from sensortrack.data import real_networks

    return [*tasks, *(("network", name) for name in real_networks())]


def work(task: Task) -> Finding:
    """Do one task; top level, because processes import it."""
    what, name = task
    return decide(name) if what == "claim" else sweep(name)


def _lost(task: Task) -> Finding:
    what, name = task
    reason = "the process ended without an answer"
    return (
        lost(name, reason) if what == "claim" else Finding({}, skipped=f"{what} {name}: {reason}")
    )


def _documents(findings: Sequence[Finding]) -> dict[str, Mapping[str, Any]]:
    """All certificates by file stem; a stem with two documents takes its second claim back."""
    documents: dict[str, Mapping[str, Any]] = {}
    for finding in findings:
        taken = [
            stem
            for stem, document in finding.certificates.items()
            if documents.setdefault(stem, document) != document
        ]
        if taken:
            undecide(finding.record, f"stage certificates: two files would be called {taken[0]}")
    return documents


def _facts(selection: Selection, command: str, skipped: Sequence[str]) -> Record:
    from theory.latex import law
    from theory.systems import SYSTEMS

    chosen = {claim.system for claim in selection.claims}
    return {
        "version": version("sensortrack"),
        "date": date.today().isoformat(),
        "python": platform.python_version(),
        "command": command,
        "systems": {
            system.name: {
                "title": system.title,
                "citation": system.citation,
                "digest": system.digest,
                "laws": [[given.equation, law(given)] for given in system.laws],
                "gaps": [[gap.source, gap.statement, gap.missing] for gap in system.gaps],
            }
            for system in SYSTEMS
            if system.name in chosen
        },
        "skipped": list(skipped),
    }
