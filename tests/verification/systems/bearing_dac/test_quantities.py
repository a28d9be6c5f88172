"""Answers about consensus on a user's network: values, certificates, notes and refusals."""

import json
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.networks import Network, read_network
from tests.strategies import networks, rationals
from verification.answers import Answer
from verification.certificates import check
from verification.certificates.make import statements
from verification.exact.cuts import cut_roads
from verification.exact.laplacians import slow_modes, spectral_gap
from verification.inputs import read_inputs
from verification.systems.bearing_dac import rates
from verification.systems.bearing_dac.quantities import CONDITIONS, QUANTITIES

QUESTIONS = {question.name: question for question in (*QUANTITIES, *CONDITIONS)}


def ask(name: str, network: Network | str, **given: Any) -> Answer:
    question = QUESTIONS[name]
    if isinstance(network, str):
        network = read_network(network)
    answer = question.answer(read_inputs(question.inputs, given, network, name).values)
    if answer.certificate is not None:
        entry = check.check_document(json.loads(json.dumps(answer.certificate)), statements())
        assert entry["name"] == name
        assert entry["verdict"] in ("PROVED", "REFUTED")
    return answer


def two_pieces() -> Network:
    """A triangle with unlike weights, a link, and a node by itself."""
    weights = (Fraction(1, 2), Fraction(2), Fraction(5, 4), Fraction(1, 10))
    return Network(list("abcdef"), [[0, 1], [1, 2], [0, 2], [3, 4]], weights)  # type: ignore[arg-type]


def test_the_names_are_those_that_users_were_promised() -> None:
    offered = {quantity.name: quantity.certified for quantity in QUANTITIES}
    promised = {
        "gain_threshold": True,
        "margin_rate_squared": True,
        "algebraic_connectivity": True,
        "printed_threshold": False,
        "printed_settling_time": False,
        "settling_time": True,
        "disagreement_time": True,
        "implicit_steps": True,
        "chattering_bound": False,
    }
    assert promised.items() <= offered.items()
    assert [condition.name for condition in CONDITIONS] == ["gain"]


def test_a_threshold_stands_beside_the_printed_gain() -> None:
    answer = ask("gain_threshold", "path:6", gamma=1)
    assert answer.value == answer.lower == answer.upper == 3.0
    assert answer.exact == {"kind": "rational", "value": "3"}
    assert answer.verdict == "PROVED"
    assert answer.printed == pytest.approx(1 + math.sqrt(6) / (4 * math.sin(math.pi / 12) ** 2))
    assert answer.printed == ask("printed_threshold", "path:6").value


def test_bounds_enclose_values_that_are_no_doubles() -> None:
    answer = ask("gain_threshold", "complete:3", gamma="0.1")
    assert answer.exact == {"kind": "rational", "value": "1/15"}
    assert Fraction(answer.lower) < Fraction(1, 15) < Fraction(answer.upper)
    assert answer.upper == math.nextafter(answer.lower, 1)


@given(st.data())
@settings(max_examples=40)
def test_scaling_gamma_scales_the_threshold(data: st.DataObject) -> None:
    network = data.draw(networks(2, 7, weighted=True).filter(lambda drawn: drawn.m > 0))
    factor = data.draw(rationals(Fraction(1, 7), 5, 7))
    one = ask("gain_threshold", network, gamma=1)
    other = ask("gain_threshold", network, gamma=factor)
    assert one.exact
    assert other.exact
    assert Fraction(other.exact["value"]) == factor * Fraction(one.exact["value"])


def test_gains_are_decided_at_and_below_the_threshold() -> None:
    at = ask("gain", "cycle:8", gamma=1, beta=2)
    assert (at.verdict, at.margin) == ("PROVED", 0.0)
    below = ask("gain", "cycle:8", gamma=1, beta="1.99")
    assert below.verdict == "REFUTED"
    assert below.margin == pytest.approx(-0.01)
    assert ask("gain", "hypercube:20", beta=1).verdict == "PROVED"
    assert ask("gain", "grid:1000,1000", beta="499.999").verdict == "REFUTED"


def test_settling_times_are_exact_or_algebraic() -> None:
    x0 = ["3/4", "-1/4", "-1/4", "-1/4"]
    quarter = ask("settling_time", "complete:4", gamma=1, beta="3/2", x0=x0)
    assert quarter.value == quarter.lower == quarter.upper == 0.25
    assert quarter.exact == {"kind": "rational", "value": "1/4"}
    assert quarter.printed == pytest.approx(math.sqrt(3) / 8)
    root = ask("settling_time", "complete:4", gamma=0, beta=1, x0=[1, 0, 0, -1])
    assert root.exact is not None
    assert root.exact["kind"] == "algebraic"
    low, high = (Fraction(end) for end in root.exact["interval"])
    assert low < Fraction(root.value) < high
    minus, zero, plus = root.exact["polynomial"]
    assert zero == 0
    assert math.sqrt(-minus / plus) == pytest.approx(root.value)
    assert root.lower < root.value <= root.upper <= math.nextafter(root.lower, 9)
    assert root.verdict == quarter.verdict == "PROVED"


def test_the_start_is_projected() -> None:
    x0, moved = [3, -1, -1, -1], [13, 9, 9, 9]
    times = [ask("settling_time", "complete:4", beta=2, x0=x) for x in (x0, moved)]
    assert times[0].value == times[1].value
    assert times[0].printed == times[1].printed


@pytest.mark.parametrize("beta", ["1/2", "2", "1"])
def test_gains_up_to_the_threshold_never_settle(beta: str) -> None:
    answer = ask("settling_time", "cycle:8", beta=beta, x0=[1, 0, 0, 0, 0, 0, 0, 0])
    assert answer.value == answer.lower == answer.upper == math.inf
    assert answer.verdict == "PROVED"
    assert answer.certificate is not None
    assert answer.certificate["lower"] == "inf"
    assert answer.printed is None


def test_agreement_at_the_start_takes_no_time() -> None:
    answer = ask("settling_time", "cycle:8", beta=3, x0=7)
    assert (answer.value, answer.lower, str(answer.upper)) == (0.0, 0.0, "0.0")
    assert answer.verdict == "PROVED"


def test_pieces_are_answered_one_by_one() -> None:
    network = two_pieces()
    gamma = {"a": 1, "b": "1/3", "c": 2, "d": 0, "e": "0.5", "f": 1}
    threshold = ask("gain_threshold", network, gamma=gamma)
    assert threshold.exact == {"kind": "rational", "value": "5/2"}  # the link: 1/4 over 1/10
    rate = ask("margin_rate_squared", network)
    assert rate.exact == {"kind": "rational", "value": "1/50"}
    time = ask("settling_time", network, gamma="0.01", beta=1, x0=[1, 2, 3, 4, 5, 6])
    assert time.exact == {"kind": "rational", "value": "50/9"}
    assert all("3 components" in answer.notes[0] for answer in (threshold, rate, time))
    connectivity = ask("algebraic_connectivity", network)
    assert connectivity.value == connectivity.lower == connectivity.upper == 0
    assert connectivity.verdict == "PROVED"


def test_printed_values_are_those_of_the_worst_piece() -> None:
    network = two_pieces()
    printed = ask("printed_threshold", network, gamma="0.1")
    assert printed.value == pytest.approx(1 + 0.1 * math.sqrt(2) / 0.2)
    time = ask("printed_settling_time", network, x0=[0, 0, 0, 3, -1, 100])
    assert time.value == pytest.approx(math.sqrt(10) / 0.2)
    assert any("mean zero" in note for note in time.notes)
    assert printed.verdict == time.verdict == "SUPPORTED"


def test_the_largest_bound_enters_the_printed_gain() -> None:
    answer = ask("printed_threshold", "complete:4", gamma=[1, 2, 3, 0])
    assert answer.value == pytest.approx(1 + 3 * 2 / 4)
    assert any("largest" in note for note in answer.notes)


def test_connectivity_is_exact_where_that_is_short() -> None:
    answer = ask("algebraic_connectivity", "cycle:8")
    assert answer.exact is not None
    assert answer.exact["polynomial"] == [2, -4, 1]
    assert answer.lower < answer.value <= answer.upper
    assert answer.value == pytest.approx(2 - math.sqrt(2), rel=1e-15)
    assert ask("algebraic_connectivity", "karate").exact is None


def test_connectivity_of_large_networks_is_proved() -> None:
    cube = ask("algebraic_connectivity", "hypercube:20")
    assert (cube.value, cube.upper, cube.verdict) == (2.0, 2.0, "PROVED")
    assert cube.lower == math.nextafter(2.0, 0.0)
    path = ask("algebraic_connectivity", "path:400")
    assert path.value == pytest.approx(4 * math.sin(math.pi / 800) ** 2, rel=1e-9)
    assert path.upper <= path.lower * (1 + 1e-9)
    torus = ask("algebraic_connectivity", "torus:100,100")
    assert torus.lower <= 4 * math.sin(math.pi / 100) ** 2 * (1 + 1e-14)
    assert path.certificate
    assert torus.certificate
    assert path.verdict == torus.verdict == "PROVED"


def test_connectivity_beyond_any_file_says_how_it_is_proved(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    closed = ask("algebraic_connectivity", "complete:1200")
    assert (closed.lower, closed.upper, closed.verdict) == (1200.0, 1200.0, "PROVED")
    assert closed.certificate is None
    assert "closed form" in closed.notes[0]
    monkeypatch.setattr(rates, "CHECKED", 10.0)
    long = ask("algebraic_connectivity", "path:300")
    assert long.verdict == "PROVED"
    assert long.certificate is None
    assert "exact integers" in long.notes[0]
    assert "no certificate" in long.notes[0]
    monkeypatch.undo()
    monkeypatch.setattr(rates, "EDGE_BYTES", 10**6)
    large = ask("algebraic_connectivity", "path:300")
    assert "too large to be read" in large.notes[0]
    apart = ask("algebraic_connectivity", "random_geometric:300,0.05,1")
    assert (apart.lower, str(apart.upper), apart.certificate) == (0.0, "0.0", None)
    assert any("constant on a component" in note for note in apart.notes)


def test_connectivity_that_cannot_be_proved_is_computed_or_a_bracket(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(spectral_gap, "WORK", 10.0)
    network = read_network("random_geometric:250,0.15,4")
    value = np.linalg.eigvalsh(network.laplacian().toarray())[1]
    computed = ask("algebraic_connectivity", network)
    assert computed.verdict == "SUPPORTED"
    assert computed.value == pytest.approx(value, rel=1e-9)
    assert (computed.lower, computed.upper) == (None, None)
    monkeypatch.setattr(slow_modes, "RESTARTS", 1)
    for name in ("algebraic_connectivity", "printed_threshold"):
        assert ask(name, network).verdict == "UNDECIDED"
    monkeypatch.undo()
    monkeypatch.setattr(spectral_gap, "DISTANCES", (1e-4,))
    wide = ask("algebraic_connectivity", "path:300")
    assert (wide.value, wide.verdict) == (None, "UNDECIDED")
    assert wide.lower < 4 * math.sin(math.pi / 600) ** 2 < wide.upper


@pytest.mark.parametrize(
    "name, given, wrong",
    [
        ("gain_threshold", {"gamma": -1}, "gamma"),
        ("gain_threshold", {"gamma": [1, 1, -2, 1]}, "gamma"),
        ("gain_threshold", {"gamma": [1, 1]}, "gamma"),
        ("gain", {"beta": 0}, "beta"),
        ("gain", {"beta": -1}, "beta"),
        ("gain", {}, "beta"),
        ("settling_time", {"beta": 3}, "x0"),
        ("settling_time", {"beta": 3, "x0": [1, 2, 3]}, "x0"),
        ("margin_rate_squared", {"gamma": 1}, "gamma"),
        ("gain_threshold", {"gamma": "1e101"}, "gamma"),
        ("gain_threshold", {"gamma": "nan"}, "gamma"),
        ("gain_threshold", {"gamma": [0, 0, 0, "1e-101"]}, "gamma"),
        ("settling_time", {"beta": "1e400", "x0": 1}, "beta"),
        ("settling_time", {"beta": 1, "x0": [0, 1, 2, "-1e400"]}, "x0"),
        ("printed_settling_time", {"x0": "1e400"}, "x0"),
        ("implicit_steps", {"beta": 1, "x0": 1, "h": "1e-400"}, "h"),
        ("chattering_bound", {"beta": "1e300", "h": 1}, "beta"),
        ("outage_growth", {"tau": "1e400"}, "tau"),
    ],
)
def test_bad_inputs_are_named(name: str, given: dict[str, Any], wrong: str) -> None:
    with pytest.raises(InputError) as found:
        ask(name, "complete:4", **given)
    assert found.value.name == wrong


def test_weights_too_unlike_are_refused() -> None:
    weights = (Fraction(10) ** 200, Fraction(1))
    network = Network(["a", "b", "c"], [[0, 1], [1, 2]], weights)  # type: ignore[arg-type]
    with pytest.raises(InputError) as found:
        ask("margin_rate_squared", network)
    assert found.value.name == "weight"
    far = Network(["a", "b"], [[0, 1]], (Fraction(10) ** 100,))  # type: ignore[arg-type]
    answer = ask("margin_rate_squared", far)
    assert answer.exact == {"kind": "rational", "value": str(2 * 10**200)}


def test_a_network_without_edges_is_refused() -> None:
    lonely = Network(["a", "b"], [])  # type: ignore[arg-type]
    for name in ("gain_threshold", "margin_rate_squared", "algebraic_connectivity"):
        with pytest.raises(InputError) as found:
            ask(name, lonely)
        assert found.value.name == "graph"


def test_what_is_not_shown_is_not_claimed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where searches and flows are cut short, values are not claimed or only as computed."""
    monkeypatch.setattr(cut_roads, "LIMITS", (10, 10))
    monkeypatch.setattr(cut_roads, "LOOSER", (Fraction(50),))
    torus = read_network("torus:4,4")
    network = Network(torus.names, torus.edges)
    computed = ask("margin_rate_squared", network)
    assert computed.verdict == "SUPPORTED"
    assert computed.value == 16.0
    assert (computed.lower, computed.upper) == (None, None)
    monkeypatch.setattr(cut_roads, "LONG_NODES", 0)
    bracket = ask("margin_rate_squared", network)
    assert bracket.verdict == "UNDECIDED"
    assert bracket.value is None
    assert bracket.lower is None or bracket.lower < bracket.upper == 16.0
