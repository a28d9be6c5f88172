"""The critical cut and the edge to add as a user sees them."""

import json
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from sensortrack.data import load_network
from sensortrack.networks import Network, read_network
from verification.answers import Answer, Detail
from verification.cli.main import main
from verification.inputs import read_inputs
from verification.systems.bearing_dac import critical
from verification.systems.bearing_dac.quantities import CONDITIONS, QUANTITIES

QUESTIONS = {question.name: question for question in (*QUANTITIES, *CONDITIONS)}


def ask(name: str, network: Network, **given: Any) -> Answer:
    question = QUESTIONS[name]
    return question.answer(read_inputs(question.inputs, given, network, name).values)


def detail(answer: Answer, name: str) -> Detail:
    found = answer.more[name]()
    assert found is not None
    return found


def test_the_cut_is_told_by_the_names_of_its_smaller_side() -> None:
    network = load_network("topozoo_abilene")
    found = detail(ask("gain_threshold", network), "cut")
    assert found.data["size"] == len(found.data["nodes"]) == 5
    assert (found.data["of"], found.data["edge_count"], found.data["weight"]) == (11, 2, "2")
    inside = set(found.data["nodes"])
    assert all(len(inside & set(edge)) == 1 for edge in found.data["edges"])
    assert Fraction(2 * 5 * 6, 11 * 2) == Fraction("30/11")
    assert [label for label, _ in found.lines] == ["cut", "across it"]
    assert all(name in found.lines[0][1] for name in inside)


def test_weights_are_summed_and_components_counted_apart() -> None:
    weights = (Fraction(1, 2), Fraction(2), Fraction(5, 4), Fraction(1, 10))
    network = Network(list("abcdef"), [[0, 1], [1, 2], [0, 2], [3, 4]], weights)  # type: ignore[arg-type]
    answer = ask("gain_threshold", network)
    found = detail(answer, "cut")
    assert (found.data["of"], found.data["weight"]) == (2, "1/10")
    assert found.data["edges"] == [["d", "e"]]
    assert answer.more["edge_to_add"]() is None  # d and e are joined, and f is not theirs


def test_another_component_limits_what_an_edge_can_do() -> None:
    paths = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [6, 7], [7, 8], [8, 9], [9, 10]]
    network = Network([str(i) for i in range(11)], np.array(paths))
    edge = detail(ask("gain_threshold", network), "edge_to_add")
    assert edge.data["value"] == edge.data["lower"] == 2.4  # of the path of five nodes
    assert edge.data["best"]
    assert {int(end) for end in edge.data["edge"]} <= set(range(6))


def test_a_product_is_told_by_its_own_nodes(monkeypatch: pytest.MonkeyPatch) -> None:
    answer = ask("gain_threshold", read_network("grid:3,4"))
    found = detail(answer, "cut")
    assert (found.data["size"], found.data["edge_count"]) == (6, 3)
    assert {int(name) % 4 // 2 for name in found.data["nodes"]} in ({0}, {1})
    monkeypatch.setattr(critical, "LARGEST", 10)
    monkeypatch.setattr(critical, "HELPED", 10)
    assert answer.more["cut"]() is None
    assert answer.more["edge_to_add"]() is None


def test_long_cuts_are_shortened_but_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    found = detail(ask("gain_threshold", read_network("path:40")), "cut")
    assert found.lines[0][1].startswith("20 of 40 nodes: ")
    assert found.lines[0][1].endswith(" and 8 more")
    assert len(found.data["nodes"]) == 20
    monkeypatch.setattr(critical, "LISTED", 3)
    short = detail(ask("gain_threshold", read_network("path:40")), "cut")
    assert (len(short.data["nodes"]), short.data["size"]) == (3, 20)
    assert short.lines[0][1].endswith(" and 17 more")


def test_other_constants_have_their_cuts_too() -> None:
    path = read_network("path:4")
    for name, given in (
        ("margin_rate_squared", {}),
        ("settling_time", {"beta": 5, "x0": [1, 0, 0, 0]}),
        ("settling_time", {"beta": 1, "x0": [1, 0, 0, 0]}),
        ("gain", {"beta": 5}),
        ("gain", {"beta": 1}),
    ):
        answer = ask(name, path, **given)
        assert list(answer.more) == ["cut"]
        assert detail(answer, "cut").data["edge_count"] == 1


def test_an_edge_that_cannot_help_is_not_named() -> None:
    edge = detail(ask("gain_threshold", read_network("petersen")), "edge_to_add")
    assert edge.data["edge"] is None
    assert edge.data["value"] == 1.0
    assert "no single one" in edge.lines[0][1]
    assert ask("gain_threshold", read_network("complete:4")).more["edge_to_add"]() is None
    zero = ask("gain_threshold", read_network("path:4"), gamma=0)
    assert zero.more["edge_to_add"]() is None


def test_the_command_prints_cut_and_edge(capsys: pytest.CaptureFixture[str]) -> None:
    ask_for = ["bound", "bearing_dac.gain_threshold", "--graph", "path:6"]
    assert main(ask_for) == 0
    out = capsys.readouterr().out
    assert "  cut          3 of 6 nodes: 3, 4, 5\n  across it    1 edge: 2 – 3\n" in out
    assert "  edge to add  0 – 5: 1.5, 50 % lower, the best of " in out
    assert main([*ask_for, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["cut"]["nodes"] == ["3", "4", "5"]
    assert document["cut"]["edges"] == [["2", "3"]]
    assert document["edge_to_add"]["edge"] == ["0", "5"]
    assert document["edge_to_add"]["exact"] == "3/2"


def test_names_play_no_tricks_with_a_terminal(
    tmp_path: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "hostile.csv"
    rows = ["source,target", '"a\x1b[2J","b\u202e"', '"b\u202e",c\x07']
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    asked = ["bound", "bearing_dac.gain_threshold", "--graph", str(path)]
    status = main(asked)
    shown = capsys.readouterr()
    assert not set("\x1b\u202e\x07") & set(shown.out + shown.err)
    assert status in (0, 2)
    status = main([*asked, "--set", 'gamma={"a\\u001b[2J": -1, "b\\u202e": 1, "c\\u0007": 1}'])
    shown = capsys.readouterr()
    assert status == 2
    assert not set("\x1b\u202e\x07") & set(shown.out + shown.err)
