"""Words that no file of the repository may contain.

The patterns hold a one-letter class each, so that this file does not match itself.
"""

import re

import pytest

from tests.meta.repository import text_of, tracked_files

FORBIDDEN = {
    "unfinished work": r"\bTO[D]O\b|\bFIX[M]E\b|\bX[X]X\b|\bNotImplemented[E]rror\b",
    "a package registry (pip's configuration decides)": (
        r"py[p]i\.org|python[h]osted|anaconda\.[o]rg|npm[j]s\.|crates\.[i]o|--index-[u]rl|find-[l]inks"
    ),
    "a file to download": r"https?://\S+\.(?:[w]hl|[t]ar\.gz|[z]ip|[d]eb)\b",
    "a path of one machine": (
        r"(?<![\w.~])/(?:[t]mp|[w]ork|[h]ome|[r]oot|[U]sers|[o]pt)/\w|\.\./[s]hared\b"
    ),
    # pytest's own scope and class are meant where they are written as such
    "how the work was organised": r"(?<!scope=\")(?<!pytest\.)\b[s]essions?\b|\b[i]ssues? ?#?\d+\b",
}


@pytest.mark.parametrize("what", FORBIDDEN)
def test_no_file_contains(what: str) -> None:
    pattern = re.compile(FORBIDDEN[what], 0 if what == "unfinished work" else re.IGNORECASE)
    found = [
        f"{name}:{number}: {line.strip()[:120]}"
        for name in tracked_files()
        for number, line in enumerate((text_of(name) or "").splitlines(), start=1)
        if pattern.search(line)
    ]
    assert not found, f"{what}:\n" + "\n".join(found)


@pytest.mark.parametrize(
    "what, line",
    [
        ("unfinished work", "# TO" + "DO later"),
        ("unfinished work", "raise NotImplemented" + "Error"),
        ("a package registry (pip's configuration decides)", "py" + "pi.org"),
        ("a file to download", "https://host/a-1.0." + "whl"),
        ("a path of one machine", "open('/" + "tmp/x')"),
        ("how the work was organised", "in this ses" + "sion"),
        ("how the work was organised", "see iss" + "ue 3"),
    ],
)
def test_the_patterns_find_what_they_are_for(what: str, line: str) -> None:
    assert re.search(FORBIDDEN[what], line)


@pytest.mark.parametrize(
    "line", ['@pytest.fixture(scope="session")', "#!/usr/bin/env bash", "return NotImplemented"]
)
def test_the_patterns_leave_alone_what_is_meant(line: str) -> None:
    assert not any(re.search(pattern, line) for pattern in FORBIDDEN.values())
