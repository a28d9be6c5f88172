"""Networks that change, gains for each entry, outages: against all networks, cuts and signs."""

import itertools
import json
import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from verification.answers import Answer
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.exact.cuts import cut_families
from verification.exact.cuts.cut_families import disjoint, worst_threshold
from verification.exact.cuts.cut_reference import enumerate_all
from verification.inputs import read_inputs
from verification.systems.bearing_dac import entry_gains, outages, switching
from verification.systems.bearing_dac.quantities import QUANTITIES

QUESTIONS = {question.name: question for question in QUANTITIES}
ONE = Fraction(1)


def ask(name: str, network: Network | str, **given: Any) -> Answer:
    question = QUESTIONS[name]
    if isinstance(network, str):
        network = read_network(network)
    answer = question.answer(read_inputs(question.inputs, given, network, name).values)
    if answer.certificate is not None:
        entry = check.check_document(json.loads(json.dumps(answer.certificate)), statements())
        assert (entry["name"], entry["verdict"]) == (name, "PROVED")
    return answer


def exact(answer: Answer) -> Fraction:
    assert answer.exact
    assert answer.verdict == "PROVED"
    return Fraction(answer.exact["value"])


def worst(network: Network, gamma: list[Fraction]) -> Fraction | None:
    """The threshold by all cuts; None if the network is not connected."""
    if not network.is_connected():
        return None
    return max(cut.load / cut.k for cut in enumerate_all(network, gamma))


def without(network: Network, gone: tuple[int, ...]) -> Network:
    kept = [e for e in range(network.m) if e not in gone]
    weights = None if network.weights is None else tuple(network.weights[e] for e in kept)
    return Network(network.names, network.edges[kept], weights)


@given(connected_networks(3, 6, weighted=True), st.data())
@settings(max_examples=12)
def test_the_worst_network_decides_when_links_are_lost(
    network: Network, data: st.DataObject
) -> None:
    gamma = data.draw(st.lists(rationals(0, 3, 4), min_size=network.n, max_size=network.n))
    gamma[0] += 1
    drop = data.draw(st.integers(0, min(2, network.m)))
    ways = itertools.combinations(range(network.m), drop)
    values = [worst(without(network, gone), gamma) for gone in ways]
    answer = ask("switching_threshold", network, gamma=list(map(str, gamma)), drop=drop)
    if None in values:
        assert (answer.value, answer.verdict) == (math.inf, "PROVED")
    else:
        assert exact(answer) == max(value for value in values if value is not None)


@given(connected_networks(3, 6), st.data())
@settings(max_examples=12)
def test_the_worst_network_decides_when_an_agent_is_lost(
    network: Network, data: st.DataObject
) -> None:
    gamma = data.draw(st.lists(rationals(1, 3, 4), min_size=network.n, max_size=network.n))
    values = []
    for lost in range(network.n):
        kept = [i for i in range(network.n) if i != lost]
        values.append(worst(network.subnetwork(kept), [gamma[i] for i in kept]))
    answer = ask("node_loss_threshold", network, gamma=list(map(str, gamma)))
    assert answer.notes
    if None in values:
        assert (answer.value, answer.lower, answer.upper) == (math.inf,) * 3
    else:
        assert exact(answer) == max(value for value in values if value is not None)


def test_listed_networks_are_told_apart() -> None:
    links = [[["0", "1"], ["1", "2"], ["2", "3"]], [["0", "1"], ["0", "2"], [0, 3]]]
    answer = ask("switching_threshold", "complete:4", links=links)
    assert exact(answer) == 2  # of the path; the star needs 3/2
    details = {name: make() for name, make in answer.more.items()}
    assert details["worst"]
    assert details["worst"].data == {"list": 1, "lost": []}
    assert details["cut"]
    assert details["cut"].data["edges"] == [["1", "2"]]
    assert answer.certificate
    assert len(answer.certificate["inputs"]["graph"]["nodes"]) == 8


def test_joint_connectivity_is_not_enough() -> None:
    """Each link of a path of three holds in turn: connected together, never at one time."""
    answer = ask("switching_threshold", "path:3", links=[[["0", "1"]], [["1", "2"]]])
    assert (answer.value, answer.verdict) == (math.inf, "PROVED")
    assert "not connected" in answer.notes[0]


def test_agents_without_disturbance_need_no_gain() -> None:
    answer = ask("switching_threshold", "path:3", links=[[["0", "1"]], []], gamma=0)
    assert (answer.value, answer.certificate) == (0.0, None)


def test_too_many_networks_are_bounded_by_a_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(switching, "MOST", 5)
    answer = ask("switching_threshold", "complete:6", drop=2)
    sharp = max(
        value
        for gone in itertools.combinations(range(15), 2)
        if (value := worst(without(read_network("complete:6"), gone), [ONE] * 6)) is not None
    )
    assert answer.verdict == "UNDECIDED"
    assert 1 / 3 < answer.lower <= sharp
    assert any("too many" in note for note in answer.notes)
    apart = ask("switching_threshold", "cycle:6", drop=3)
    assert apart.value == math.inf
    lost = ask("switching_threshold", "cycle:8", drop=8)
    assert lost.value == math.inf
    monkeypatch.setattr(switching, "MOST_NODES", 10)
    assert ask("node_loss_threshold", "complete:6").verdict == "UNDECIDED"


def test_what_is_apart_in_a_large_network_is_said_without_proof(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(switching, "DENSE", 2)
    answer = ask("switching_threshold", "path:3", drop=1)
    assert (answer.value, answer.lower, answer.verdict) == (math.inf, None, "SUPPORTED")


def test_a_family_that_is_not_decided_has_no_upper_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    networks = [read_network("petersen"), read_network("karate")]
    graph = disjoint(networks)
    assert [len(part) for part in graph.components()] == [10, 34]
    full = worst_threshold(graph, [ONE] * 44)
    assert full.upper == full.value == Fraction(145, 68)
    solve = cut_families.solve
    monkeypatch.setattr(cut_families, "refute_or_show", lambda *_: None)
    monkeypatch.setattr(cut_families, "solve", lambda *asked: replace(solve(*asked), shown=None))
    found = worst_threshold(graph, [ONE] * 44)
    assert found.lower == Fraction(145, 68)
    assert (found.upper, found.clear, found.value) == (None, None, None)


def test_weights_stay_with_their_links() -> None:
    half = Network(["a", "b", "c"], [[0, 1], [1, 2]], (ONE / 2, ONE / 3))  # type: ignore[arg-type]
    both = disjoint([half, read_network("path:2")])
    assert both.weights == (ONE / 2, ONE / 3, ONE)
    assert both.names == ("1: a", "1: b", "1: c", "2: 0", "2: 1")


def test_a_family_with_a_better_cut_is_refused() -> None:
    answer = ask("switching_threshold", "cycle:6", drop=1)
    document = json.loads(json.dumps(answer.certificate))
    inputs, witness = document["inputs"], document["witness"]
    ask_for = ("bearing_dac", "switching_threshold", inputs, witness)
    certificate(*ask_for, lower=3, upper=3)
    for lower, upper in ((3, "29/10"), ("31/10", "4")):
        with pytest.raises(CertificateError):
            certificate(*ask_for, lower=lower, upper=upper)
    for gamma in (0, [0] * 36):
        with pytest.raises(CertificateError):
            certificate(
                "bearing_dac",
                "switching_threshold",
                {"graph": read_network("path:2").to_data(), "gamma": gamma},
                [{"kind": "vector", "x": [1, -1]}],
                "INFINITE",
                lower="inf",
                upper="inf",
            )


@pytest.mark.parametrize("n", range(1, 7))
def test_equal_bounds_drift_apart_by_halves(n: int) -> None:
    network = read_network(f"path:{n}") if n > 1 else Network(["a"], [])  # type: ignore[arg-type]
    answer = ask("outage_growth", network, gamma=2, tau="1/4")
    assert answer.value == pytest.approx(2 * 2 * 0.25 * math.sqrt(n * n // 4 / n))


@given(st.lists(rationals(0, 3, 6), min_size=2, max_size=7))
@settings(max_examples=20)
def test_the_longest_drift_is_that_of_the_best_signs(gamma: list[Fraction]) -> None:
    n = len(gamma)
    longest = Fraction(0)
    for signs in itertools.product((1, -1), repeat=n):
        u = [s * g for s, g in zip(signs, gamma, strict=True)]
        longest = max(longest, sum(x * x for x in u) - sum(u) ** 2 / n)
    answer = ask("outage_growth", read_network(f"path:{n}"), gamma=list(map(str, gamma)), tau=1)
    assert answer.value == pytest.approx(math.sqrt(longest))


def test_bounds_too_unlike_give_an_upper_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    gamma = ["1", "1/3", "5/7", "2/11"]
    sharp = ask("outage_growth", "path:4", gamma=gamma, tau=1).value
    monkeypatch.setattr(outages, "SUMS", 2)
    answer = ask("outage_growth", "path:4", gamma=gamma, tau=1)
    assert answer.value is None
    assert sharp <= answer.upper
    assert answer.verdict == "UNDECIDED"


def test_entries_have_gains_of_their_own() -> None:
    positions = [[3, 4], [0, 1], [0, 0], [6, 8]]
    answer = ask("entry_gains", "path:4", v_max=2, rho_min="1/2", positions=positions)
    far = [Fraction(4 * d) for d in (5, 1, 0, 10)]
    q = max(cut.load / cut.k for cut in enumerate_all(read_network("path:4"), far))
    assert answer.value == [8.0, float(q)]
    assert answer.verdict == "PROVED"
    assert all(
        low <= v <= top
        for low, v, top in zip(answer.lower, answer.value, answer.upper, strict=True)
    )


@given(rationals(0, 1000, 97).filter(bool))
def test_distances_are_rounded_up_a_little(square: Fraction) -> None:
    found = entry_gains.distance_above(square)
    assert 0 <= found**2 - square <= square / 2**60


def test_moving_the_origin_changes_the_second_gain_only() -> None:
    near = np.array([[0, 0], [1, 0], [0, 1], [-1, -1]])
    gains = [
        ask("entry_gains", "cycle:4", v_max=1, rho_min=1, positions=(near + by).tolist()).value
        for by in (0, 100)
    ]
    assert gains[0][0] == gains[1][0] == 1
    assert gains[0][1] < 2
    assert gains[1][1] > 100


def test_a_target_at_rest_needs_no_gain() -> None:
    network = read_network("path:2")
    answer = ask("entry_gains", network, v_max=0, rho_min=1, positions=[[0, 0], [1, 1]])
    assert answer.value == [0.0, 0.0]


LINK = [["0", "1"]]


@pytest.mark.parametrize(
    "name, given, wrong",
    [
        ("switching_threshold", {"drop": -1}, "drop"),
        ("switching_threshold", {"drop": "1/2"}, "drop"),
        ("switching_threshold", {"drop": 99}, "drop"),
        ("switching_threshold", {"drop": 2, "links": [LINK]}, "drop"),
        ("switching_threshold", {"links": []}, "links"),
        ("switching_threshold", {"links": 3}, "links"),
        ("switching_threshold", {"links": ["ab"]}, "links"),
        ("switching_threshold", {"links": [["ab"]]}, "links"),
        ("switching_threshold", {"links": [[["0", "1", "2"]]]}, "links"),
        ("switching_threshold", {"links": [[["0", None]]]}, "links"),
        ("switching_threshold", {"links": [[["0", "9"]]]}, "links"),
        ("switching_threshold", {"links": [[["0", "2"]]]}, "links"),
        ("switching_threshold", {"links": [[["0", "0"]]]}, "links"),
        ("switching_threshold", {"links": [[["0", "1"], ["1", "0"]]]}, "links"),
        ("switching_threshold", {"links": [LINK] * 2001}, "links"),
        ("switching_threshold", {"gamma": -1}, "gamma"),
        ("node_loss_threshold", {"gamma": -1}, "gamma"),
        ("outage_growth", {"tau": -1}, "tau"),
        ("outage_growth", {"tau": "nan"}, "tau"),
        ("outage_growth", {"tau": 1, "gamma": -1}, "gamma"),
        ("entry_gains", {"v_max": -1}, "v_max"),
        ("entry_gains", {"rho_min": 0}, "rho_min"),
        ("entry_gains", {"positions": [[0, 0]]}, "positions"),
    ],
)
def test_bad_inputs_are_named(name: str, given: dict[str, Any], wrong: str) -> None:
    if name == "entry_gains":
        given = {"v_max": 1, "rho_min": 1, "positions": [[0, 0]] * 4, **given}
    with pytest.raises(InputError) as found:
        ask(name, "path:4", **given)
    assert found.value.name == wrong


def test_two_agents_cannot_lose_one() -> None:
    with pytest.raises(InputError) as found:
        ask("node_loss_threshold", "path:2")
    assert found.value.name == "graph"


@pytest.mark.parametrize(
    "name, given, wrong",
    [
        ("disturbance_bound", {"v_max": "1e400"}, "v_max"),
        ("disturbance_bound", {"rho_min": "1e-400"}, "rho_min"),
        ("disturbance_bound", {"positions": [[0, "1e300"]]}, "positions"),
        ("noise_bias", {"sigma_bearing_rad": "1e300"}, "sigma_bearing_rad"),
        ("noise_covariance", {"target": ["1e300", 0]}, "target"),
    ],
)
def test_sizes_beyond_use_are_refused(name: str, given: dict[str, Any], wrong: str) -> None:
    question = QUESTIONS[name]
    usual = {
        "v_max": 1,
        "rho_min": 1,
        "positions": [[0, 0], [1, 0]],
        "target": [5, 5],
        "sigma_bearing_rad": "0.1",
    }
    taken = {entry.name: usual[entry.name] for entry in question.inputs} | given
    with pytest.raises(InputError) as found:
        question.answer(read_inputs(question.inputs, taken, None, name).values)
    assert found.value.name == wrong
