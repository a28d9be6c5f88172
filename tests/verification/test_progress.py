"""Long work says what it does, to those who listen and on terminals only."""

import io
import sys

import pytest

from verification.progress import listening, shown_on_terminal, tell


class Screen(io.StringIO):
    """A terminal."""

    def isatty(self) -> bool:
        return True


def test_only_who_listens_hears() -> None:
    heard: list[str] = []
    tell("before")
    with listening(heard.append):
        tell("one")
        with listening(lambda text: heard.append(text.upper())):
            tell("two")
        tell("three")
    tell("after")
    assert heard == ["one", "TWO", "three"]


def test_a_terminal_shows_one_line_that_goes_away(monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Screen()
    monkeypatch.setattr(sys, "stderr", screen)

    def work() -> None:
        with shown_on_terminal():
            tell("working " * 50)
            raise ValueError("stop")

    with pytest.raises(ValueError, match="stop"):
        work()
    lines = screen.getvalue().split("\r\x1b[K")
    assert "\n" not in screen.getvalue()
    assert lines[1].startswith("working")
    assert max(map(len, lines)) < 80
    assert lines[-1] == ""


def test_a_file_is_told_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    file = io.StringIO()
    monkeypatch.setattr(sys, "stderr", file)
    with shown_on_terminal():
        tell("working")
    assert file.getvalue() == ""
