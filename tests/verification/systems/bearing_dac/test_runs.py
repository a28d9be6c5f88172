"""Times of single runs and numbers of steps: values, certificates, and the steps themselves."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.consensus import chatter_bound
from sensortrack.errors import InputError
from sensortrack.kernels.links import links_of
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from verification.exact.cuts import cut_roads
from verification.exact.cuts.extreme import slowest, threshold
from verification.exact.runs import filippov
from verification.exact.runs.prox import centred, explicit_step, implicit_step
from verification.systems.bearing_dac import runs
from verification.systems.bearing_dac.rates import settling_time

from .test_quantities import ask, two_pieces

FEW = settings(max_examples=25)


def exactly(answer):
    assert answer.exact["kind"] == "rational"
    return Fraction(answer.exact["value"])


def square(x):
    return sum(v * v for v in x)


def test_the_time_of_agreement_is_rational_and_certified():
    answer = ask("disagreement_time", "path:4", beta=1, x0=[1, 0, 0, 0])
    assert answer.value == answer.lower == answer.upper == 0.75
    assert exactly(answer) == Fraction(3, 4)
    assert (answer.verdict, answer.notes) == ("PROVED", ())
    moved = ask("disagreement_time", "path:4", beta="1/3", x0=[8, 7, 7, 7])
    assert exactly(moved) == Fraction(9, 4)


def test_the_printed_time_stands_beside_it_from_the_printed_gain_on():
    four = ask("disagreement_time", "complete:4", beta=1, x0=[3, -1, -1, -1])
    assert four.value == 1.0
    assert four.printed == pytest.approx(math.sqrt(12) / 4)
    assert four.printed < four.value
    assert ask("disagreement_time", "complete:4", beta="99/100", x0=[1, 0, 0, 0]).printed is None


def test_the_slowest_component_counts():
    answer = ask("disagreement_time", two_pieces(), beta=2, x0=[5, 5, 5, 1, 0, 99])
    assert exactly(answer) == Fraction(5, 2)  # the link of weight 1/10
    assert answer.verdict == "PROVED"
    assert "3 components" in answer.notes[0]
    assert "largest time" in answer.notes[0]


def test_agreement_at_the_start_takes_no_time():
    answer = ask("disagreement_time", "cycle:8", beta=3, x0=7)
    assert (answer.value, answer.lower, str(answer.upper)) == (0.0, 0.0, "0.0")
    assert answer.verdict == "PROVED"
    apart = ask("disagreement_time", two_pieces(), beta=2, x0=[1, 1, 1, 3, 3, 5])
    assert exactly(apart) == 0


@given(connected_networks(2, 6, weighted=True), st.data())
@FEW
def test_the_true_time_is_at_most_the_proved_one(network, data):
    x0 = tuple(data.draw(rationals(-3, 3, 3)) for _ in range(network.n))
    beta, zero = data.draw(rationals(Fraction(1, 5), 3, 5)), (Fraction(0),) * network.n
    time = runs.disagreement_time({"graph": network, "beta": beta, "x0": x0})
    bound = settling_time({"graph": network, "gamma": zero, "beta": beta, "x0": x0})
    assert time.verdict == bound.verdict == "PROVED"
    assert exactly(time) <= Fraction(bound.certificate["upper"])


def test_runs_that_cannot_be_followed_are_left_open(monkeypatch):
    large = ask("disagreement_time", "hypercube:20", beta=1, x0=0)
    assert (large.value, large.verdict) == (None, "UNDECIDED")
    monkeypatch.setattr(filippov, "BITS", 3)
    fine = ask("disagreement_time", "path:4", beta=1, x0=["1/17", 0, "-1/19", 0])
    assert (fine.value, fine.verdict) == (None, "UNDECIDED")
    assert "binary digits" in fine.notes[0]


def test_a_run_too_long_for_the_checker_is_computed_only(monkeypatch):
    monkeypatch.setattr("verification.certificates.check.DENOMINATORS", 0)
    answer = ask("disagreement_time", "path:4", beta="1/3", x0=[1, 0, 0, 0])
    assert (answer.value, answer.lower, answer.verdict) == (2.25, None, "SUPPORTED")
    assert "no certificate" in answer.notes[0]


def steps_taken(network, x0, length, push):
    x = centred(network, x0)
    count = 0
    while any(x):
        x = implicit_step(network, x, length, push)
        count += 1
    return count


@pytest.mark.parametrize(
    "family, gamma, beta, h, cut",
    [
        ("path:5", 1, 3, "1/10", {0, 1}),
        ("cycle:4", 0, "1/2", "1/3", {0, 1}),
        ("complete:4", 1, "3/2", "1/100", {0}),
        ("star:6", "1/2", 2, "2/7", {3}),
    ],
)
def test_implicit_steps_are_counted_and_the_count_is_attained(family, gamma, beta, h, cut):
    network = read_network(family)
    x0 = [3 if i in cut else 0 for i in range(network.n)]
    answer = ask("implicit_steps", family, gamma=gamma, beta=beta, h=h, x0=x0)
    assert answer.value == answer.lower == answer.upper == exactly(answer)
    assert answer.verdict == "PROVED"
    h, gamma = Fraction(h), Fraction(gamma)
    push = [h * gamma * (1 if i in cut else -1) for i in range(network.n)]
    x0 = [Fraction(v) for v in x0]
    assert steps_taken(network, x0, h * Fraction(beta), push) == answer.value


def test_counts_are_right_at_whole_numbers_and_a_hair_beside():
    given = {"gamma": 0, "beta": 1, "h": "1/2"}
    assert ask("implicit_steps", "complete:2", x0=[2, 0], **given).value == 2
    assert (
        ask("implicit_steps", "complete:2", x0=["2.000000000000000000001", 0], **given).value == 3
    )
    assert (
        ask("implicit_steps", "complete:2", x0=["1.999999999999999999999", 0], **given).value == 2
    )
    assert ask("implicit_steps", "complete:2", x0=1, **given).value == 0


def test_counts_that_are_not_shown_are_not_claimed(monkeypatch):
    """Where searches and flows are cut short, as in the tests of settling times."""
    monkeypatch.setattr(cut_roads, "LIMITS", (10, 10))
    monkeypatch.setattr(cut_roads, "LOOSER", (Fraction(50),))
    for road in ("_rated", "_expanding"):
        monkeypatch.setattr(cut_roads, road, lambda _task, _start, solved, _rest: solved)
    torus = read_network("torus:4,4")
    network = Network(torus.names, torus.edges)
    given = {"gamma": 0, "beta": 1, "h": "1/10", "x0": [1, *[0] * 15]}
    computed = ask("implicit_steps", network, **given)
    assert (computed.value, computed.verdict) == (
        math.ceil(10 * math.sqrt(15 / 16) / 4),
        "SUPPORTED",
    )
    chattering = ask("chattering_bound", network, gamma=0, beta=1, h=1)
    assert chattering.value == pytest.approx(16**2 / (2 * 4))
    monkeypatch.setattr(cut_roads, "LONG_NODES", 0)
    open_end = ask("implicit_steps", network, **given)
    assert (open_end.value, open_end.verdict) == (None, "UNDECIDED")
    loose = ask("chattering_bound", network, gamma=0, beta=1, h=1)
    assert loose.verdict == "SUPPORTED"
    assert loose.value > chattering.value


def test_gains_up_to_the_threshold_never_agree():
    given = {"gamma": 1, "beta": 2, "h": "1/2"}
    steps = ask("implicit_steps", "cycle:8", x0=[1, 0, 0, 0, 0, 0, 0, 0], **given)
    assert steps.value == steps.lower == steps.upper == math.inf
    assert steps.verdict == "PROVED"
    chattering = ask("chattering_bound", "cycle:8", **given)
    assert chattering.value == math.inf


@given(connected_networks(2, 6, weighted=True), st.data())
@FEW
def test_explicit_steps_stay_within_the_chattering_bound(network, data):
    """From agreement never beyond it, from elsewhere a step beyond it goes down."""
    zero = (Fraction(0),) * network.n
    beta, h = data.draw(rationals(Fraction(1, 5), 3, 5)), Fraction(1, 4)
    given = {"graph": network, "gamma": zero, "beta": beta, "h": h}
    bound = runs.chattering_bound(given).value
    x = centred(network, [data.draw(rationals(-3, 3, 3)) for _ in zero])
    for _ in range(20):
        after = explicit_step(network, x, h * beta)
        limit = max(math.sqrt(square(x)), bound)
        assert math.sqrt(square(after)) <= limit * (1 + 1e-12)
        x = after


def test_the_chattering_bound_under_disturbances():
    """For the pair s = beta sqrt 2 + gamma sqrt 2 and r = sqrt 2 (beta - gamma)."""
    answer = ask("chattering_bound", "complete:2", gamma=1, beta=2, h="1/10")
    s, r = 3 * math.sqrt(2), math.sqrt(2) * (2 - 1)
    assert answer.value == pytest.approx(max(s, s * s / (2 * r)) / 10)
    assert answer.verdict == "SUPPORTED"
    larger = ask("chattering_bound", two_pieces(), gamma=0, beta=2, h="1/10")
    assert "largest bound" in larger.notes[0]


@given(connected_networks(2, 6, weighted=True), st.data())
@FEW
def test_the_estimator_knows_the_same_chattering_bound(network, data):
    gamma, h = data.draw(rationals(0, 2, 3)), Fraction(1, 7)
    bounds = (gamma,) * network.n
    beta = threshold(network, bounds).value + data.draw(rationals(Fraction(1, 5), 3, 5))
    given = {"graph": network, "gamma": bounds, "beta": beta, "h": h}
    start = [Fraction(1), *[Fraction(0)] * (network.n - 1)]
    rate = math.sqrt(square(centred(network, start)) / slowest(network, bounds, beta, start).value)
    numbers = np.array([float(beta)]), float(h), float(gamma), rate
    own = runs.chattering_bound(given).value
    assert own == pytest.approx(chatter_bound(links_of(network), *numbers)[0], rel=1e-12)


@pytest.mark.parametrize(
    "name, given, wrong",
    [
        ("disagreement_time", {"beta": 0, "x0": 0}, "beta"),
        ("disagreement_time", {"beta": -1, "x0": 0}, "beta"),
        ("disagreement_time", {"beta": 1}, "x0"),
        ("disagreement_time", {"x0": 1}, "beta"),
        ("disagreement_time", {"beta": 1, "x0": [1, 2, 3]}, "x0"),
        ("disagreement_time", {"beta": 1, "x0": 1, "gamma": 1}, "gamma"),
        ("implicit_steps", {"beta": 1, "x0": 1, "h": 0}, "h"),
        ("implicit_steps", {"beta": 0, "x0": 1, "h": 1}, "beta"),
        ("implicit_steps", {"beta": 1, "x0": 1, "h": 1, "gamma": -1}, "gamma"),
        ("chattering_bound", {"beta": 1, "h": -1}, "h"),
        ("chattering_bound", {"beta": -1, "h": 1}, "beta"),
        ("chattering_bound", {"beta": 1, "h": 1, "gamma": -1}, "gamma"),
    ],
)
def test_bad_inputs_are_named(name, given, wrong):
    with pytest.raises(InputError) as found:
        ask(name, "complete:4", **given)
    assert found.value.name == wrong


def test_a_network_without_edges_is_refused():
    lonely = Network(["a", "b"], np.empty((0, 2), dtype=np.int64))
    for name, data in (
        ("disagreement_time", {"beta": 1, "x0": 0}),
        ("implicit_steps", {"beta": 1, "x0": 0, "h": 1}),
        ("chattering_bound", {"beta": 1, "h": 1}),
    ):
        with pytest.raises(InputError) as found:
            ask(name, lonely, **data)
        assert found.value.name == "graph"


def test_links_of_two_components_may_stand_in_any_order():
    """The checker reads signs component by component, whatever the order of the links."""
    for edges in ([[1, 2], [0, 3]], [[0, 3], [1, 2]]):
        network = Network(tuple("abcd"), np.array(edges), (Fraction(1, 10),) * 2, label="pairs")
        values = {"graph": network, "beta": Fraction(1, 5), "x0": tuple(map(Fraction, "0001"))}
        answer = runs.disagreement_time(values)
        assert (answer.verdict, exactly(answer)) == ("PROVED", 25)
