"""Re-validate written certificates by the checker alone, and draw the consequences."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from verification.certificates import check
from verification.verdict import Verdict

from .records import Record, undecide

NEEDS: Mapping[str, tuple[str, ...]] = {
    Verdict.PROVED: ("PROVED",),
    Verdict.REFUTED: ("REFUTED",),
    Verdict.CORRECTED: ("REFUTED", "PROVED"),
}
"""What a claim's certificates must say for its verdict to stand."""


def checked(folder: Path, files: Sequence[str]) -> dict[str, dict[str, Any]]:
    """Entries of ``check --json`` by file, from one run of the checker without site packages.

    Parameters
    ----------
    folder : Path
        The output folder.
    files : sequence of str
        Paths relative to it.

    Returns
    -------
    dict
        One entry a file; not valid, with the reason, if the checker did not answer.
    """
    if not files:
        return {}
    command = [sys.executable, "-I", "-S", str(Path(check.__file__).resolve()), "--json"]
    run = subprocess.run(
        [*command, *files],
        cwd=folder,
        capture_output=True,
        text=True,
        encoding="utf-8",
        errors="replace",
        stdin=subprocess.DEVNULL,
        check=False,
    )
    try:
        entries = {entry["file"]: entry for entry in json.loads(run.stdout)}
    except (ValueError, TypeError, KeyError):
        entries = {}
    reason = f"the checker did not answer (status {run.returncode}): {run.stderr.strip()[-200:]}"
    missing = {"valid": False, "reason": reason, "verdict": None, "system": None}
    return {file: entries.get(file, missing) for file in files}


def confirm(record: Record, entries: Mapping[str, Mapping[str, Any]]) -> None:
    """Take a claim's verdict back unless valid certificates of its system bear it out."""
    own = [(file, entries[file]) for file in record["certificates"]]
    for file, entry in own:
        if not entry["valid"]:
            undecide(record, f"stage check: {file} does not validate: {entry['reason']}")
            return
        if entry["system"] != record["system"]:
            undecide(record, f"stage check: {file} is about {entry['system']}")
            return
    said = {entry["verdict"] for _, entry in own}
    for need in NEEDS.get(record["verdict"], ()):
        if need not in said:
            undecide(record, f"stage check: {record['verdict']} without a certificate for {need}")
            return
