"""The glossary names every symbol once, and is a table that Markdown readers accept."""

import pytest

from theory.notation import entries, latex, render
from theory.system import System
from theory.systems import SYSTEMS


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_every_symbol_has_one_line(system: System) -> None:
    found = [entry.name for entry in entries(system)]
    assert sorted(found) == sorted(symbol.name for symbol in system.symbols)
    symbols = [entry.symbol for entry in entries(system)]
    assert len({*symbols}) == len(symbols), "two names are printed alike"


def test_glossary_is_a_table_for_each_system() -> None:
    text = render(SYSTEMS)
    lines = text.splitlines()
    assert [line[3:] for line in lines if line.startswith("## ")] == [s.title for s in SYSTEMS]
    assert {line.count("|") for line in lines if line.startswith("|")} == {6}
    assert text.endswith("\n")
    for system in SYSTEMS:
        for name, meaning in [*system.dimensions.items(), *system.units.items()]:
            assert f"`{name}`, {meaning}" in text


@pytest.mark.parametrize(
    "name, expected",
    [
        ("x", "x"),
        ("beta", r"\beta"),
        ("lambda_i", r"\lambda_{i}"),
        ("b_hat", r"\hat{b}"),
        ("p_star", "p^*"),
        ("b_0i", "b_{0i}"),
        ("Delta", r"\Delta"),
        ("x_minus", "x^-"),
        ("Mode", "Mode"),
    ],
)
def test_names_become_latex(name: str, expected: str) -> None:
    assert latex(name) == expected
