"""What is declared, what is pinned and what is installed are the same."""

import tomllib
from importlib.metadata import distributions

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from tests.meta.repository import ROOT

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
EXTRAS: dict[str, list[str]] = PROJECT["optional-dependencies"]

GATE = ("verify", "plots", "interop", "test")
# Declared for people, and left out of the locks: the reason of each.
NOT_PINNED = {"jupyterlab": "for reading; the tests execute notebooks through nbmake"}


def pins(name: str) -> dict[str, str]:
    rows = (ROOT / name).read_text().splitlines()
    assert all(row.count("==") == 1 for row in rows), f"{name}: NAME==VERSION in each line"
    return {canonicalize_name(row.partition("==")[0]): row.partition("==")[2] for row in rows}


SMALL = pins("requirements.lock")
STRICT = pins("requirements-strict.lock")


def declared(*extras: str) -> list[Requirement]:
    rows = [row for extra in extras for row in EXTRAS[extra]]
    return [Requirement(row) for row in rows if not row.startswith("sensortrack[")]


def test_the_strict_lock_contains_the_small_one() -> None:
    assert {name: STRICT.get(name) for name in SMALL} == SMALL


@pytest.mark.parametrize("lock", ["small", "strict"])
def test_what_is_declared_is_pinned_within_its_bounds(lock: str) -> None:
    core = [Requirement(row) for row in PROJECT["dependencies"]]
    if lock == "small":
        pinned, needed, exempt = SMALL, core + declared(*GATE), {}
    else:
        pinned, needed, exempt = STRICT, core + declared(*EXTRAS), NOT_PINNED
    for requirement in needed:
        if requirement.name in exempt:
            continue
        assert requirement.name in pinned, f"{requirement}: no pin"
        assert requirement.specifier.contains(pinned[requirement.name]), str(requirement)


def test_the_environment_is_the_locked_one() -> None:
    installed = {
        canonicalize_name(found.metadata["Name"]): found.version for found in distributions()
    }
    differing = {n: installed.get(n) for n in SMALL if installed.get(n) != SMALL[n]}
    assert not differing, "run make test, which installs requirements.lock"


def test_every_dependency_has_its_reason() -> None:
    page = (ROOT / "docs" / "decisions" / "0001-dependencies.md").read_text()
    core = [Requirement(row) for row in PROJECT["dependencies"]]
    missing = [r.name for r in core + declared(*EXTRAS) if r.name not in page]
    assert not missing
