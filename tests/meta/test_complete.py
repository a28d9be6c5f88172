"""Forgetting is a failing test: every system has claims, a page, a notebook, a scenario."""

import tomllib

import pytest

from tests.laws.cases import ESTIMATORS
from tests.meta.repository import ROOT
from theory.codegen.emit import STEPPERS
from theory.systems import SYSTEMS
from verification.systems import SYSTEMS as ROOMS

NAMES = [system.name for system in SYSTEMS]
WAITING: dict[str, set[str]] = {}
"""What a system does not have yet; an entry that is no longer true fails too."""


def scenarios():
    for path in (ROOT / "sensortrack" / "scenarios").glob("*.toml"):
        yield tomllib.loads(path.read_text())["estimator"]["system"]


def has(system):
    """What there is of a system."""
    room = ROOMS.get(system.name)
    return {
        "claims": bool(system.claims),
        "decisions": room is not None and bool(room.claims.DECISIONS),
        "questions": room is not None and bool(room.quantities.QUANTITIES),
        "page": (ROOT / "docs" / "systems" / f"{system.name}.md").is_file(),
        "notebook": (ROOT / "notebooks" / f"{system.name}.ipynb").is_file(),
        "scenario": system.name in {*scenarios()},
        "benchmark": (ROOT / "benchmarks" / f"bench_{system.name}.py").is_file(),
        "stepper": system.name in STEPPERS,
        "laws": system.name in ESTIMATORS,
    }


@pytest.mark.parametrize("system", SYSTEMS, ids=NAMES)
def test_nothing_of_a_system_is_forgotten(system):
    missing = {part for part, found in has(system).items() if not found}
    assert missing == WAITING.get(system.name, set())


def test_only_systems_wait():
    assert {*WAITING} <= {*NAMES}


@pytest.mark.parametrize("system", SYSTEMS, ids=NAMES)
def test_every_claim_has_a_decision_and_every_decision_a_claim(system):
    assert {claim.id for claim in system.claims} == {*ROOMS[system.name].claims.DECISIONS}
