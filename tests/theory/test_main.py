"""python -m theory writes the statements, compares them, and shows the systems."""

import json
from pathlib import Path

import pytest

from theory.__main__ import TARGET, main, statements_text
from theory.systems import STATEMENTS, SYSTEMS


def test_committed_statements_are_those_of_theory(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["generate", "--check"]) == 0
    assert "up to date" in capsys.readouterr().out


def test_statements_are_sorted_ascii_with_one_newline_at_the_end() -> None:
    text = statements_text()
    assert text.isascii()
    assert text.endswith("}\n")
    entries = json.loads(text)
    assert [*entries] == sorted(entries)
    assert entries == {f"{s.system}.{s.name}": s.to_data() for s in STATEMENTS}


def test_a_difference_is_found_and_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / TARGET
    path.parent.mkdir(parents=True)
    root = ["--root", str(tmp_path)]
    assert main(["generate", "--check", *root]) == 1
    assert not path.exists()
    assert main(["generate", *root]) == 0
    assert path.read_text() == statements_text()
    assert main(["generate", "--check", *root]) == 0
    path.write_text(statements_text().replace(">", "<", 1))
    assert main(["generate", "--check", *root]) == 1
    assert "make generate" in capsys.readouterr().out


def test_systems_are_listed_and_shown(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list"]) == 0
    listed = capsys.readouterr().out.splitlines()
    assert listed == [f"{system.name}: {system.title}" for system in SYSTEMS]
    for system in SYSTEMS:
        assert main(["show", system.name]) == 0
        shown = capsys.readouterr().out
        assert system.digest in shown
        assert all(claim.title in shown for claim in system.claims)


def test_an_unknown_system_is_misuse() -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["show", "nothing"])
    assert stopped.value.code == 2
