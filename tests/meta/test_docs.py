"""The pages name everything that can be asked."""

import re
import tomllib
from dataclasses import fields
from pathlib import Path

import pytest

from sensortrack.simulation import simulate
from sensortrack.simulation.parts import FaultPart, Header, SensorPart
from sensortrack.simulation.scenario import scenario_of
from sensortrack.simulation.systems import SYSTEMS as SIMULATED
from sensortrack.simulation.systems import simulated
from verification.cli.main import COMMANDS
from verification.systems import SYSTEMS

ROOT = Path(__file__).parents[2]
SCENARIOS = (ROOT / "docs" / "scenarios.md").read_text(encoding="utf-8")
CHOOSE = (ROOT / "docs" / "choose.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("system", sorted(SYSTEMS))
def test_every_question_is_in_the_list_of_questions(system):
    module = SYSTEMS[system].quantities
    # in tables a quantity stands alone, a condition after its command
    missing = [entry.name for entry in module.QUANTITIES if f"`{entry.name}`" not in CHOOSE]
    missing += [
        entry.name
        for entry in module.CONDITIONS
        if f"`certify {system}.{entry.name}`" not in CHOOSE
    ]
    assert missing == []


@pytest.mark.parametrize("system", SIMULATED)
def test_every_key_of_a_scenario_is_on_its_page(system):
    room = simulated(system)
    tables = {"": Header, "sensor": SensorPart, "fault": FaultPart, **room.TABLES, **room.LISTS}
    names = {key for table in tables.values() for key in (entry.name for entry in fields(table))}
    names |= {table for table in tables if table} | {*room.BASELINES, *room.FAULTS}
    prose = re.sub(r"```.*?```", "", SCENARIOS, flags=re.DOTALL)
    written = {span.strip("[]") for span in re.findall(r"`([^`]+)`", prose)}
    assert sorted(names - written) == []


def test_the_scenario_on_the_page_runs():
    text = SCENARIOS.partition("```toml\n")[2].partition("```")[0]
    run = simulate(scenario_of("page", tomllib.loads(text)))
    assert [event["kind"] for event in run.events] == [
        *("position", "link_lost", "link_back", "sensor_leaves"),
    ]


def test_every_command_is_in_the_list_of_questions():
    assert [name for name in COMMANDS if f"`sensortrack {name}" not in CHOOSE] == []
