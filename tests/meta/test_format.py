"""Format, lint and types: the same programs and settings for everybody."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.meta.repository import ROOT

PROGRAMS = {
    "lint": ["ruff", "check", "--quiet", "--no-cache", "--output-format=concise", "."],
    "format": [
        "ruff",
        "format",
        "--quiet",
        "--no-cache",
        "--check",
        "--output-format=concise",
        ".",
    ],
    "types": ["mypy"],
}


@pytest.mark.parametrize("what", PROGRAMS)
def test_is_clean(what: str) -> None:
    program, *arguments = PROGRAMS[what]
    run = subprocess.run(
        [Path(sys.executable).parent / program, *arguments],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
