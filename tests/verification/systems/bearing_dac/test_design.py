"""Gains and edges that are chosen, against all cuts and all edges."""

import json
import math
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from verification.answers import Designed
from verification.certificates import check
from verification.certificates.make import statements
from verification.cli.main import main
from verification.exact.cuts.cut_components import spread
from verification.exact.cuts.cut_reference import enumerate_all
from verification.exact.cuts.edge_choice import with_edge
from verification.inputs import read_inputs
from verification.systems.bearing_dac import design
from verification.systems.bearing_dac.design import DESIGNS

BY_NAME = {entry.name: entry for entry in DESIGNS}
ONE = Fraction(1)


def choose(name: str, network: Network | str, **given: Any) -> Designed:
    entry = BY_NAME[name]
    if isinstance(network, str):
        network = read_network(network)
    found = entry.answer(read_inputs(entry.inputs, given, network, name).values)
    if found.certificate is not None:
        shown = check.check_document(json.loads(json.dumps(found.certificate)), statements())
        assert shown["verdict"] == found.verdict == "PROVED"
    return found


def worst(network: Network) -> Fraction:
    return max(cut.load / cut.k for cut in enumerate_all(network, [ONE] * network.n))


def test_the_smallest_gain_is_the_threshold() -> None:
    found = choose("gain", "karate")
    assert found.gains == {"beta": Fraction(145, 68)}
    assert found.certificate
    assert found.certificate["name"] == "gain"
    assert found.bound["threshold"] >= 145 / 68
    gamma = [Fraction(1, 1000003), Fraction(1, 3), Fraction(1, 999983)]
    sharp = max(c.load / c.k for c in enumerate_all(read_network("path:3"), gamma))
    beta = choose("gain", "path:3", gamma=list(map(str, gamma))).gains["beta"]
    assert 0 < beta - sharp < sharp / 10**11


@given(connected_networks(2, 6), st.data())
@settings(max_examples=20)
def test_no_gain_much_smaller_is_in_time(network: Network, data: st.DataObject) -> None:
    gamma = data.draw(st.lists(rationals(0, 3, 4), min_size=network.n, max_size=network.n))
    x0 = data.draw(st.lists(rationals(-3, 3, 4), min_size=network.n, max_size=network.n))
    x0[0] += 7 + sum(map(abs, x0))
    time = data.draw(rationals(Fraction(1, 5), 5, 5))
    found = choose(
        "gain for a time", network, gamma=list(map(str, gamma)), x0=list(map(str, x0)), time=time
    )
    length = math.sqrt(spread(x0)) / time
    need = max((c.load + length * math.sqrt(c.p)) / c.k for c in enumerate_all(network, gamma))
    assert found.verdict == "PROVED"
    assert float(found.gains["beta"]) == pytest.approx(need, rel=1e-9)
    assert found.bound["settling_time"] <= math.nextafter(float(time), math.inf)


def test_a_gain_that_is_a_fraction_stays_one() -> None:
    x0 = ["3/4", "-1/4", "-1/4", "-1/4"]
    found = choose("gain for a time", "complete:4", x0=x0, time="1/4")
    assert found.gains == {"beta": Fraction(3, 2)}
    assert found.bound == {"settling_time": 0.25}


def test_what_cannot_be_shown_is_not_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(design, "ROUNDS", 0)
    found = choose("gain for a time", "path:4", x0=[1, 0, 0, 0], time=1)
    assert (found.verdict, found.gains) == ("UNDECIDED", {})


def test_edges_are_added_one_after_the_other() -> None:
    found = choose("edges to add", "path:6", edges=2)
    network = read_network("path:6")
    for a, b in found.edges:
        options = [
            (i, j) for j in range(6) for i in range(j) if [i, j] not in network.edges.tolist()
        ]
        best = min(worst(with_edge(network, pair)) for pair in options)
        network = with_edge(network, (int(a), int(b)))
        assert worst(network) == best
    assert found.gains == {"beta": best}
    assert found.network
    assert found.network.edges.tolist() == network.edges.tolist()
    assert found.certificate
    assert found.certificate["inputs"]["graph"] == network.to_data()


def test_edges_are_added_until_a_gain_is_enough() -> None:
    found = choose("edges for a gain", "path:6", beta="3/2")
    assert len(found.edges) == 1
    assert found.gains == {"beta": Fraction(3, 2)}
    none = choose("edges for a gain", "path:6", beta=3)
    assert (none.edges, none.network) == ((), None)
    assert none.verdict == "PROVED"
    never = choose("edges for a gain", "complete:4", beta="1/10")
    assert (never.gains, never.verdict) == ({}, "UNDECIDED")


def test_a_complete_network_takes_no_edge() -> None:
    found = choose("edges to add", "complete:4", edges=1)
    assert found.edges == ()
    assert "no single edge" in found.notes[0]


def test_each_entry_gets_its_gain() -> None:
    given = {"v_max": 1, "rho_min": 2, "positions": [[3, 4], [0, 0]]}
    found = choose("gains for the entries", "path:2", **given)
    assert found.gains == {"beta_P": Fraction(1, 2), "beta_q": Fraction(5, 4)}


@pytest.mark.parametrize(
    "name, given, wrong",
    [
        ("gain", {"gamma": 0}, "gamma"),
        ("gain", {"gamma": -1}, "gamma"),
        ("gain for a time", {"x0": 1, "time": 1}, "x0"),
        ("gain for a time", {"x0": [1, 2, 3, 4], "time": 0}, "time"),
        ("gain for a time", {"x0": [1, 2], "time": 1}, "x0"),
        ("edges to add", {"edges": 0}, "edges"),
        ("edges to add", {"edges": "1/2"}, "edges"),
        ("edges to add", {"edges": 1000}, "edges"),
        ("edges for a gain", {"beta": -1}, "beta"),
    ],
)
def test_bad_wishes_are_named(name: str, given: dict[str, Any], wrong: str) -> None:
    with pytest.raises(InputError) as found:
        choose(name, "path:4", **given)
    assert found.value.name == wrong


def test_the_command_writes_gains_network_and_certificate(
    tmp_path: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "chosen"
    asked = ["design", "bearing_dac", "--graph", "path:6", "--set", "edges=1"]
    assert main([*asked, "--out", str(out), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["edges"] == [["0", "5"]]
    assert said["gains"] == {"beta": 1.5}
    assert main(["check", said["certificate"]]) == 0
    question = ["certify", "bearing_dac.gain", "--graph", str(out / "graph.graphml")]
    assert main([*question, "--params", str(out / "gains.json")]) == 0
    capsys.readouterr()
    assert main(asked) == 0
    assert "  edge to add  0 – 5\n  beta         1.5\n" in capsys.readouterr().out
