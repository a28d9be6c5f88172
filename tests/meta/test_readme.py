"""The pages a newcomer reads first are run: what they show is what happens.

Blocks marked ``console`` are commands after ``$`` with their output; blocks marked ``python`` are
executed. All blocks of a page share one folder and one namespace, in the order of the page. Numbers
are compared as numbers, times are not compared. A line that ends with an ellipsis is compared up
to it; a line that is an ellipsis stands for any lines.
"""

import math
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.meta.repository import ROOT, tracked_files

PAGES = [
    name
    for name in tracked_files()
    if name == "README.md" or (name.startswith("docs/") and name.endswith(".md"))
]
FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
DURATION = re.compile(r"\d+(?:\.\d+)? ?m?s\b")
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
ANY_LINES = ("…", "...")


def blocks(page: str, *languages: str) -> list[tuple[str, str]]:
    found = FENCE.findall((ROOT / page).read_text())
    return [(language, text) for language, text in found if language in languages]


def same_line(shown: str, printed: str) -> bool:
    """Same words, numbers equal to nine digits, times ignored."""
    shown, printed = (DURATION.sub("TIME", " ".join(s.split())) for s in (shown, printed))
    if shown.endswith(ANY_LINES):
        shown = shown.rstrip("….").rstrip()
        printed = printed[: len(shown)]
    numbers = [tuple(map(float, NUMBER.findall(line))) for line in (shown, printed)]
    return NUMBER.sub("#", shown) == NUMBER.sub("#", printed) and all(
        math.isclose(a, b, rel_tol=1e-9) for a, b in zip(*numbers, strict=True)
    )


def same_output(shown: list[str], printed: list[str]) -> bool:
    if not shown:
        return not printed
    if shown[0].strip() in ANY_LINES:
        return any(same_output(shown[1:], printed[k:]) for k in range(len(printed) + 1))
    return bool(printed) and same_line(shown[0], printed[0]) and same_output(shown[1:], printed[1:])


def run_console(text: str, folder: Path) -> None:
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("COV", "PYTEST"))}
    path = f"{Path(sys.executable).parent}{os.pathsep}{environment.get('PATH', '')}"
    environment |= {"PATH": path, "NO_COLOR": "1", "COLUMNS": "100", "PYTHONIOENCODING": "utf-8"}
    for step in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
        command, _, shown = step.partition("\n")
        while command.endswith("\\"):
            more, _, shown = shown.partition("\n")
            command = command[:-1] + more
        run = subprocess.run(
            command,
            shell=True,
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        lines = [[row.rstrip() for row in out.strip().splitlines()] for out in (shown, run.stdout)]
        assert same_output(*lines), f"$ {command}\n{run.stdout}"


@pytest.mark.parametrize("page", PAGES)
def test_the_page_shows_what_happens(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    namespace: dict[str, Any] = {"__name__": page}
    for language, text in blocks(page, "console", "python"):
        if language == "console":
            run_console(text, tmp_path)
        else:
            exec(compile(text, page, "exec"), namespace)


@pytest.mark.parametrize("page", PAGES)
def test_the_page_names_targets_that_exist(page: str) -> None:
    targets = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    named = re.findall(r"(?<![\w-])make ([a-z][\w-]*)`", (ROOT / page).read_text())
    named += [
        target
        for _, text in blocks(page, "sh")
        for target in re.findall(r"^make ([\w-]+)", text, re.MULTILINE)
    ]
    assert set(named) <= targets


@pytest.mark.parametrize("page", PAGES)
def test_links_of_the_page_lead_to_files(page: str) -> None:
    links = re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", (ROOT / page).read_text())
    broken = [link for link in links if not (ROOT / page).parent.joinpath(link).exists()]
    assert not broken


@pytest.mark.parametrize(
    "shown, printed, same",
    [
        ("value 3.0 in 0.04 s", "value  3 in 12.1 s", True),
        ("value 3.0", "value 3.1", False),
        ("threshold 16/9", "threshold 16/9", True),
        ("threshold 16/9", "threshold 16/7", False),
        ("PROVED path:6 …", "PROVED path:6 whatever", True),
        ("one\n…\nlast", "one\n2\n3\nlast", True),
        ("one\n…\nlast", "one\n2\n3", False),
        ("", "unexpected", False),
    ],
)
def test_comparison_is_loose_where_it_should_be(shown: str, printed: str, same: bool) -> None:
    assert same_output(shown.splitlines(), printed.splitlines()) == same
