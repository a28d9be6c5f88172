"""Write files whole or not at all."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from sensortrack.errors import InputError


def certificate_text(document: Mapping[str, Any]) -> str:
    """JSON of a certificate, one line a key, so that a reader sees its parts."""
    lines = (f"{json.dumps(key)}: {json.dumps(value)}" for key, value in document.items())
    return "{\n " + ",\n ".join(lines) + "\n}\n"


def require_target(path: Path, name: str) -> None:
    """Refuse a path to which no file can be written.

    Raises
    ------
    InputError
        It is a folder, or its folder does not exist or cannot be written to.
    """
    if path.is_dir():
        raise InputError(name, f"{path} is a folder", "the name of a file is needed")
    if not path.parent.is_dir():
        cure = f"mkdir -p {path.parent} makes it"
        raise InputError(name, f"there is no folder {path.parent}", "an existing one", cure)
    if not os.access(path.parent, os.W_OK):
        found = f"the folder {path.parent} cannot be written to"
        raise InputError(name, found, "another is needed")


def require_folder(folder: Path) -> None:
    """Refuse a folder that holds something or cannot be made.

    Raises
    ------
    InputError
        It is a file, is not empty, or the folder above cannot be written to.
    """
    needed = "a new or empty folder is needed"
    if folder.exists() and not folder.is_dir():
        raise InputError("--out", f"{folder} is a file", needed)
    if folder.is_dir() and any(folder.iterdir()):
        raise InputError("--out", f"{folder} is not empty", needed)
    parent = folder
    while not parent.exists():
        parent = parent.parent
    if not parent.is_dir() or not os.access(parent, os.W_OK):
        raise InputError("--out", f"{parent} cannot be written to", "another folder is needed")


def write_text(path: Path, text: str) -> None:
    """Write a text file; a reader sees the old file or the new one, never half of one.

    Parameters
    ----------
    path : Path
        Target; its folder exists.
    text : str
        Content, written as UTF-8.
    """
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        # mkstemp lets only the owner read; what is written here is as public as any other file
        umask = os.umask(0)
        os.umask(umask)
        Path(temporary).chmod(0o666 & ~umask)
        Path(temporary).replace(path)
    except BaseException:
        with suppress(OSError):
            Path(temporary).unlink()
        raise
