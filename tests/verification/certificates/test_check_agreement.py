"""The exact time of agreement: runs that fall short, wait or leave something out are refused."""

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import networks, rationals
from verification.exact.runs.filippov import filippov_run
from verification.systems.bearing_dac.runs import trajectory

from .documents import accepts, text
from .samples import LADDER, PAIR, PATH, run

KINDS = {"graph": "graph", "beta": "number", "x0": "nodes", "t": "number"}
AGREES = ["agrees(graph, beta, x0, t)"]
STILL = ["0", "0", "0"]
SLOW_END = {"graph": PATH, "beta": "1", "x0": ["13", "10", "7"], "t": "6"}
FIRST, LAST = ("2", STILL, ["1", "1"]), ("4", STILL, ["1/4", "1"])
TWO_PAIRS = {"nodes": list("abcd"), "edges": [[0, 2], [1, 3]]}
FAR_AND_NEAR = {"graph": TWO_PAIRS, "beta": "1", "x0": ["5", "1", "1", "0"], "t": "2"}
BOTH = ("1/2", [*STILL, "0"], ["1", "1"])
ONE = ("3/2", [*STILL, "0"], ["1", "0"])


def test_a_path_agrees_after_two_pieces():
    """The first two meet after 2, then pull the third in with half the strength."""
    assert accepts(AGREES, [run(FIRST, LAST)], SLOW_END, KINDS)
    halves = [("2", STILL, ["1/4", "1"])] * 2
    assert accepts(AGREES, [run(FIRST, *halves)], SLOW_END, KINDS)


@pytest.mark.parametrize(
    "pieces, time",
    [
        ([FIRST], "2"),
        ([LAST], "4"),
        ([FIRST, LAST], "5"),
        ([FIRST, LAST], "7"),
        ([FIRST, ("3", STILL, ["1/4", "1"])], "5"),
        ([FIRST, ("5", STILL, ["1/4", "1"])], "7"),
        ([FIRST, LAST, ("1", STILL, STILL[:2])], "7"),  # it waits at zero
        ([FIRST, LAST, ("0", STILL, STILL[:2])], "6"),
        ([FIRST, ("0", STILL, ["1/4", "1"]), LAST], "6"),
        ([FIRST, ("4", STILL, ["1/2", "1"])], "6"),
        ([("2", STILL, ["1", "5000001/5000000"]), LAST], "6"),
        ([("2", STILL, ["5000001/5000000", "1"]), LAST], "6"),
        ([("2", ["-1/100", "0", "1/100"], ["1", "1"]), LAST], "6"),  # pushed
        ([FIRST, ("1", STILL, ["1/4", "1"]), ("-1", STILL, ["1/4", "1"]), LAST], "6"),
        ([], "0"),
        ([], "6"),
    ],
)
def test_runs_that_end_elsewhere_or_at_another_time(pieces, time):
    assert not accepts(AGREES, [run(*pieces)], SLOW_END | {"t": time}, KINDS)


@pytest.mark.parametrize(
    "change",
    [
        {"beta": "2"},
        {"beta": "0"},
        {"beta": "-1"},
        {"x0": ["13", "10", "8"]},
        {"x0": ["3", "0"]},
        {"x0": "0"},
        {"graph": PATH | {"weights": ["1", "1"]}},
        {"graph": PATH | {"edges": [[0, 1]], "weights": ["1"]}},
        {"graph": LADDER},
    ],
)
def test_other_data_are_not_run_through(change):
    assert not accepts(AGREES, [run(FIRST, LAST)], SLOW_END | change, KINDS)


def test_the_slowest_component_counts_and_none_is_left_out():
    assert accepts(AGREES, [run(BOTH, ONE)], FAR_AND_NEAR, KINDS)
    assert not accepts(AGREES, [run(BOTH)], FAR_AND_NEAR | {"t": "1/2"}, KINDS)
    alone = ("2", [*STILL, "0"], ["1", "0"])
    assert not accepts(AGREES, [run(alone)], FAR_AND_NEAR, KINDS)
    less = FAR_AND_NEAR | {"x0": ["0", "1", "0", "0"], "t": "1/2"}
    assert accepts(AGREES, [run(("1/2", [*STILL, "0"], ["0", "1"]))], less, KINDS)
    longer = run(("1/2", [*STILL, "0"], ["0", "1"]), ("1", [*STILL, "0"], ["0", "0"]))
    assert not accepts(AGREES, [longer], less | {"t": "3/2"}, KINDS)


def test_agreement_at_the_start_takes_no_time_and_no_piece():
    same = {"graph": PAIR, "beta": "1", "x0": ["4", "4"], "t": "0"}
    assert accepts(AGREES, [run()], same, KINDS)
    assert accepts(AGREES, [run()], same | {"x0": "4"}, KINDS)
    assert not accepts(AGREES, [run()], same | {"t": "1"}, KINDS)
    assert not accepts(AGREES, [run(("1", ["0", "0"], ["0"]))], same | {"t": "1"}, KINDS)
    assert not accepts(AGREES, [], same, KINDS)


@given(networks(1, 6, weighted=True), st.data())
@settings(max_examples=30)
def test_runs_that_are_found_are_believed_and_no_other_time(network, data):
    x0 = [data.draw(rationals(-3, 3, 3)) for _ in range(network.n)]
    beta = data.draw(rationals(Fraction(1, 5), 3, 5))
    found = filippov_run(network, beta, x0)
    item = trajectory(found)
    for piece in item["pieces"]:
        piece |= {key: text([piece[key]])[0] for key in ("disturbance", "signs")}
        piece["duration"] = str(piece["duration"])
    inputs = {"graph": network.to_data(), "beta": str(beta), "x0": [*map(str, x0)]}
    time = found.times[-1]
    assert accepts(AGREES, [item], inputs | {"t": str(time)}, KINDS)
    for other in (time + Fraction(1, 10**9), time - Fraction(1, 10**9), 0, 2 * time):
        if other != time:
            assert not accepts(AGREES, [item], inputs | {"t": str(other)}, KINDS)
    short = {"kind": "trajectory", "pieces": item["pieces"][:-1]}
    if item["pieces"]:
        assert not accepts(AGREES, [short], inputs | {"t": str(found.times[-2])}, KINDS)
