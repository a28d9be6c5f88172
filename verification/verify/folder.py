"""The output folder: only ever written to if it is new, empty or of an earlier run."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from sensortrack.errors import InputError
from verification.files import certificate_text, write_text

from .records import FOLDER, file_of

CLAIMS, NETWORKS, FACTS = "claims.json", "networks.json", "facts.json"


def prepare(folder: Path) -> None:
    """Make the folder ready, and mark a new one as ours.

    Raises
    ------
    InputError
        It holds something else, is a file, or cannot be made or written to.
    """
    try:
        if folder.exists() and not folder.is_dir():
            raise InputError("--out", f"{folder} is a file", "the name of a folder is needed")
        if folder.is_dir() and any(folder.iterdir()) and not _is_ours(folder):
            found = f"{folder} holds files that no run of verify wrote"
            cure = "A folder of an earlier run is known by its claims.json."
            raise InputError("--out", found, "a new or empty folder is needed", cure)
        if (folder / FOLDER).is_symlink():
            found = f"{folder / FOLDER} is a link"
            raise InputError("--out", found, "a folder of its own is needed")
        (folder / FOLDER).mkdir(parents=True, exist_ok=True)
        if not os.access(folder, os.W_OK):
            raise InputError("--out", f"{folder} cannot be written to", "another is needed")
        if not (folder / CLAIMS).exists():
            # so that a folder left by an interrupted first run is known as ours
            write_text(folder / CLAIMS, "[]\n")
    except OSError as error:
        found = f"{folder}: {error.strerror or error}"
        raise InputError("--out", found, "a folder that can be written to is needed") from None


def write_certificates(folder: Path, documents: Mapping[str, Mapping[str, Any]]) -> list[str]:
    """Write certificates by file stem and remove those of earlier runs.

    Returns
    -------
    list of str
        Their paths relative to the folder.
    """
    files = [file_of(stem) for stem in documents]
    for file, document in zip(files, documents.values(), strict=True):
        write_text(folder / file, certificate_text(document))
    kept = {folder / file for file in files}
    for path in sorted((folder / FOLDER).glob("*.json")):
        if path not in kept and not path.is_dir():
            path.unlink()
    return files


def write_records(folder: Path, records: Mapping[str, Any]) -> None:
    """Write JSON files by name, an entry a line where it is a list."""
    for name, content in records.items():
        text = _lines(content) if isinstance(content, list) else json.dumps(content, indent=1)
        write_text(folder / name, f"{text}\n")


def _lines(entries: Iterable[Any]) -> str:
    lines = ",\n ".join(map(json.dumps, entries))
    return f"[\n {lines}\n]" if lines else "[]"


def _is_ours(folder: Path) -> bool:
    """Whether ``claims.json`` is one that verify wrote."""
    try:
        claims = json.loads((folder / CLAIMS).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return False
    keys = {"id", "verdict", "certificates"}
    return isinstance(claims, list) and all(
        isinstance(claim, dict) and keys <= set(claim) for claim in claims
    )
