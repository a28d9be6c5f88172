"""The files that the repository holds, for tests that look at all of them."""

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]

# What the targets of the Makefile produce; met only where git is absent (an unpacked archive).
PRODUCED = {
    ".venv", "build", "dist", "_build", "__pycache__", ".git", ".pytest_cache", ".mypy_cache",
    ".ruff_cache", ".hypothesis", ".benchmarks", ".import_linter_cache", ".ipynb_checkpoints",
}  # fmt: skip


def _walk() -> Iterator[str]:
    for folder, names, files in os.walk(ROOT):
        names[:] = [n for n in names if n not in PRODUCED and not n.endswith(".egg-info")]
        for name in files:
            path = Path(folder, name)
            if not name.endswith((".so", ".pyc")):
                yield path.relative_to(ROOT).as_posix()


def tracked_files() -> list[str]:
    """Paths relative to the root, with slashes, sorted."""
    try:
        run = subprocess.run(
            ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError):
        return sorted(_walk())
    names = [name for name in run.stdout.split("\0") if name]
    return sorted(name for name in names if (ROOT / name).is_file())


def text_of(name: str) -> str | None:
    """Text of a tracked file, or None where it holds something else."""
    data = (ROOT / name).read_bytes()
    if b"\0" in data:
        return None
    return data.decode("utf-8")
