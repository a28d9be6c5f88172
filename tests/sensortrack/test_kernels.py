"""Compiling C sources: once, into the user's cache, and never a failure."""

import stat
from pathlib import Path

import pytest

from sensortrack.kernels import build, kernel

compiles = pytest.mark.skipif(kernel("cuts").library is None, reason="no C compiler")


@compiles
def test_a_library_is_built_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert kernel("cuts").library is not None
    (library,) = build.cache_folder().iterdir()
    before = library.stat().st_mtime_ns
    build._kernel.cache_clear()
    assert kernel("cuts").library is not None
    assert [path.stat().st_mtime_ns for path in build.cache_folder().iterdir()] == [before]
    assert stat.S_IMODE(build.cache_folder().stat().st_mode) & 0o077 == 0


def test_no_compiler_is_a_reason_and_no_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("CC", "no-such-compiler")
    found = kernel("cuts")
    assert found.library is None
    assert "no-such-compiler" in found.reason


def test_an_unreadable_source_is_a_reason_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(build, "FLAGS", (*build.FLAGS, "--no-such-flag"))
    build._kernel.cache_clear()
    found = kernel("cuts")
    build._kernel.cache_clear()
    assert found.library is None
    assert found.reason
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_a_cache_that_cannot_be_written_is_a_reason(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "sensortrack").write_text("a file where a folder is due")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    found = kernel("cuts")
    assert found.library is None
    assert found.reason


def test_a_relative_cache_folder_is_ignored(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", "somewhere")
    assert build.cache_folder().is_absolute()
    assert build.cache_folder().parts[-3:] == (".cache", "sensortrack", "kernels")


@compiles
def test_libraries_for_one_processor_are_told_apart(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for processor, count in [("flags: this one", 1), ("flags: another", 2), ("", 3), ("", 3)]:
        monkeypatch.setattr(build, "_processor", lambda found=processor: found)
        build._kernel.cache_clear()
        assert kernel("cuts", native=True).library is not None
        assert len(list(build.cache_folder().iterdir())) == count
    build._kernel.cache_clear()
    assert kernel("cuts").library is not None
    assert len(list(build.cache_folder().iterdir())) == count
    build._kernel.cache_clear()


@compiles
def test_a_compiler_that_cannot_build_for_this_processor_builds_for_any(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(build, "NATIVE", ("--no-such-flag",))
    monkeypatch.setattr(build, "_processor", lambda: "flags: this one")
    build._kernel.cache_clear()
    assert kernel("cuts", native=True).library is not None
    build._kernel.cache_clear()
