"""Runs of the error under an admissible disturbance, against an independent replay."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import connected_networks, rationals

from .documents import accepts
from .samples import APART, LADDER, PAIR, run

NODES, NUMBERS = ("gamma", "x0", "x1"), ("beta", "t")
KINDS = {"graph": "graph"} | dict.fromkeys(NODES, "nodes") | dict.fromkeys(NUMBERS, "number")
RUN = ["run(graph, beta, gamma, x0, x1, t)"]
APART_FROM_REST = {
    "graph": PAIR, "gamma": "4", "beta": "3", "x0": ["0", "0"], "x1": ["1", "-1"], "t": "1",
}  # fmt: skip
PUSH = ("1", ["4", "-4"], ["1"])


def test_a_pair_is_driven_apart():
    """Four against a gain of three: each moves by one in the unit of time."""
    assert accepts(RUN, [run(PUSH)], APART_FROM_REST, KINDS)
    half = ("1/2", ["4", "-4"], ["1"])
    assert accepts(RUN, [run(half, half)], APART_FROM_REST, KINDS)
    assert accepts(RUN, [run(("1", ["4", "-4"], ["1/1"]))], APART_FROM_REST, KINDS)


@pytest.mark.parametrize(
    "pieces",
    [
        [],
        [("1", ["4", "-4"], ["10000001/10000000"])],
        [("1", ["4", "-4"], ["99/100"])],
        [("1", ["4", "-4"], ["-1"])],
        [("1", ["4", "-4"], ["0"])],
        [("1", ["4", "-4"], [])],
        [("1", ["4", "-4"], ["1", "1"])],
        [("1", ["4"], ["1"])],
        [("1", ["5", "-3"], ["1"])],  # above its bound
        [("1", ["40000001/10000000", "-39999999/10000000"], ["1"])],
        [("99/100", ["4", "-4"], ["1"])],
        [("2", ["4", "-4"], ["1"]), ("-1", ["4", "-4"], ["1"])],  # back in time
        [("1", ["4", "-4"], ["1"]), ("0", ["4", "-4"], ["1"])],
        [("1", ["-4", "4"], ["-1"])],  # the other way
    ],
)
def test_pieces_that_are_no_run(pieces):
    assert not accepts(RUN, [run(*pieces)], APART_FROM_REST, KINDS)


@pytest.mark.parametrize(
    "change",
    [
        {"t": "2"},
        {"x1": ["1", "-2"]},
        {"x1": ["1"]},
        {"x1": "1"},
        {"x1": ["1", "-1", "0"]},
        {"x0": ["1", "-1"]},
        {"gamma": "3"},
        {"gamma": ["4", "3"]},
        {"gamma": ["4"]},
        {"beta": "4"},
        {"graph": {"nodes": ["a", "b"], "edges": [[0, 1]], "weights": ["2"]}},
        {"graph": {"nodes": ["a", "b"], "edges": []}},
        {"graph": {"nodes": ["a", "b", "c"], "edges": [[0, 1], [1, 2]]}},
        {"graph": LADDER},
        {"graph": APART},
        {"x0": ["1", "1"], "x1": ["2", "0"]},  # an error sums to zero
    ],
)
def test_other_data_are_not_run_through(change):
    assert not accepts(RUN, [run(PUSH)], APART_FROM_REST | change, KINDS)


@pytest.mark.parametrize(
    "piece",
    [
        {"duration": "1", "disturbance": ["4", "-4"]},
        {"duration": "1", "disturbance": ["4", "-4"], "signs": ["1"], "note": ""},
        ["duration", "disturbance", "signs"],
        None,
        "duration",
    ],
)
def test_pieces_have_three_keys(piece):
    item = {"kind": "trajectory", "pieces": [piece]}
    assert not accepts(RUN, [item], APART_FROM_REST, KINDS)


def test_an_error_that_is_the_same_everywhere_is_none():
    still = run(("10", ["0", "0"], ["0"]))
    data = APART_FROM_REST | {"x0": ["1", "1"], "x1": ["1", "1"], "t": "10"}
    assert not accepts(RUN, [still], data, KINDS)
    assert accepts(RUN, [still], data | {"x0": ["0", "0"], "x1": ["0", "0"]}, KINDS)
    assert not accepts(RUN, [still], data | {"x0": "1", "x1": "1"}, KINDS)


def test_a_link_may_rest_within_the_jump_of_the_sign_only_while_its_ends_agree():
    resting = {"x0": ["0", "0"], "x1": ["0", "0"], "t": "1"}
    held = run(("1", ["4", "-4"], ["1"]))
    assert accepts(RUN, [held], APART_FROM_REST | resting | {"beta": "4"}, KINDS)
    assert accepts(
        RUN, [run(("1", ["4", "-4"], ["4/5"]))], APART_FROM_REST | resting | {"beta": "5"}, KINDS
    )
    assert not accepts(RUN, [run(("1", ["4", "-4"], ["4/3"]))], APART_FROM_REST | resting, KINDS)


@st.composite
def replays(draw):
    """Constant disturbances and the pieces that follow, ended where the first sign changes."""
    network = draw(connected_networks(min_nodes=2, max_nodes=4, weighted=True))
    n = network.n
    beta, gamma = draw(rationals(0, 3, 4)), draw(rationals(0, 3, 4))
    x = [draw(rationals(-2, 2, 3)) for _ in range(n)]
    x = [v - sum(x) / Fraction(n) for v in x]
    pieces, start, clock = [], x, Fraction(0)
    links = list(zip(network.edges.tolist(), network.weights, strict=True))
    for _ in range(draw(st.integers(1, 3))):
        u = [draw(st.fractions(-gamma, gamma, max_denominator=5)) for _ in range(n)]
        signs = [(x[i] > x[j]) - (x[i] < x[j]) for (i, j), _ in links]
        rate = [v - sum(u) / n for v in u]
        for ((i, j), w), sign in zip(links, signs, strict=True):
            rate[i] -= beta * w * sign
            rate[j] += beta * w * sign
        times = [Fraction(1)]
        for ((i, j), _), sign in zip(links, signs, strict=True):
            gap, speed = x[i] - x[j], rate[i] - rate[j]
            if sign == 0 and speed != 0:
                return None  # the right selection is not simply 0
            if sign and gap * speed < 0:
                times.append(-gap / speed)
        x = [a + min(times) * v for a, v in zip(x, rate, strict=True)]
        clock += min(times)
        pieces.append((str(min(times)), [*map(str, u)], [*map(str, signs)]))
    data = {"graph": network.to_data(), "beta": str(beta), "gamma": str(gamma), "t": str(clock)}
    return data | {"x0": [*map(str, start)], "x1": [*map(str, x)]}, pieces


@given(replays().filter(bool), st.data())
def test_a_replay_is_accepted_and_any_other_end_is_not(replay, more):
    data, pieces = replay
    assert accepts(RUN, [run(*pieces)], data, KINDS)
    wrong = [Fraction(v) for v in data["x1"]]
    wrong[0] += Fraction(1, 1000)
    wrong[1] -= Fraction(1, 1000)
    assert not accepts(RUN, [run(*pieces)], data | {"x1": [*map(str, wrong)]}, KINDS)
    span, u, signs = more.draw(st.sampled_from(pieces))
    k = more.draw(st.integers(0, len(u) - 1))
    bound = Fraction(data["gamma"])
    more_than_allowed = [*u[:k], str(bound + Fraction(1, 10**9)), *u[k + 1 :]]
    changed = [(span, more_than_allowed, signs) if p == (span, u, signs) else p for p in pieces]
    assert not accepts(RUN, [run(*changed)], data, KINDS)
