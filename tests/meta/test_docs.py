"""The pages name everything that can be asked."""

from pathlib import Path

import pytest

from verification.cli.main import COMMANDS
from verification.systems import SYSTEMS

ROOT = Path(__file__).parents[2]
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


def test_every_command_is_in_the_list_of_questions():
    assert [name for name in COMMANDS if f"`sensortrack {name}" not in CHOOSE] == []
