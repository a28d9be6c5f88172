"""Certificates with other graphs, sides, sizes and runs than those that were proved."""

import copy
import json

import pytest

from verification.certificates import check

from .documents import document, run_checker
from .forging import refused_or_restated
from .samples import ONE, PAIR, RING, TREE, cuts


def threshold_of(graph, nodes, lower, upper, known, gamma="3"):
    parts = [cuts({"kind": "enumeration", "order": list(range(len(graph["nodes"])))})]
    return document(
        known["bearing_dac.gain_threshold"],
        {"graph": graph, "gamma": gamma},
        [*parts, {"kind": "cut", "nodes": nodes}],
        name="bearing_dac.gain_threshold",
        lower=lower,
        upper=upper,
    )


GRAPHS = {
    "an edge more": RING | {"edges": [*RING["edges"], [0, 2]]},
    "an edge less": RING | {"edges": RING["edges"][:3]},
    "an edge elsewhere": RING | {"edges": [*RING["edges"][:3], [1, 3]]},
    "a node less": RING | {"nodes": RING["nodes"][:3]},
    "a node more": RING | {"nodes": [*RING["nodes"], "e"]},
    "renumbered": RING | {"edges": [[0, 2], [1, 2], [1, 3], [0, 3]]},
    "a weight doubled": RING | {"weights": ["2", "1", "1", "1"]},
    "a weight of zero": RING | {"weights": ["0", "1", "1", "1"]},
    "a negative weight": RING | {"weights": ["-1", "1", "1", "1"]},
    "a weight too few": RING | {"weights": ["1", "1", "1"]},
    "an edge twice": RING | {"edges": [*RING["edges"], [0, 1]]},
    "an edge there and back": RING | {"edges": [*RING["edges"], [1, 0]]},
    "a loop": RING | {"edges": [*RING["edges"], [1, 1]]},
    "an edge to nowhere": RING | {"edges": [*RING["edges"], [3, 4]]},
    "an edge of three": RING | {"edges": [*RING["edges"], [1, 2, 3]]},
    "a name twice": RING | {"nodes": ["a", "b", "c", "a"]},
    "a name that is a number": RING | {"nodes": ["a", "b", "c", 4]},
    "no nodes": {"nodes": [], "edges": []},
    "no edges": {"nodes": ["a", "b", "c", "d"], "edges": []},
    "one node": {"nodes": ["a"], "edges": []},
    "another key": RING | {"directed": False},
    "no graph": "ring:4",
    "an empty product": {"product": []},
    "a product of one": {"product": [RING]},
    "a product beside a graph": RING | {"product": [PAIR, PAIR]},
    "an empty product beside a graph": RING | {"product": []},
    "a product of products": {"product": [{"product": [PAIR, PAIR]}, PAIR]},
    "a factor in pieces": {"product": [PAIR, {"nodes": ["a", "b"], "edges": []}]},
}


@pytest.mark.parametrize("what", GRAPHS)
def test_other_graphs(what, known):
    honest = threshold_of(RING, [1, 2], "3", "3", known)
    assert not refused_or_restated(honest, known)
    forged = honest | {"inputs": {"graph": GRAPHS[what], "gamma": "3"}}
    refused = refused_or_restated(forged, known)
    assert refused or what == "renumbered"


def test_names_of_nodes_are_only_printed(known, tmp_path):
    names = ["constructor", "__class__", "S\u00e3o Paulo", "\ud800"]
    honest = threshold_of(RING | {"nodes": names}, [1, 2], "3", "3", known)
    path = tmp_path / "it.json"
    path.write_text(json.dumps(honest))
    entry, status = check.check_file(str(path), known)
    assert status == 0
    assert entry["inputs"]["graph"]["nodes"] == names
    ran = run_checker(path)
    assert ran.returncode == 0, ran.stderr


SIDES = [
    [],
    [0, 1, 2, 3],
    [0, 0],
    [1, 4],
    [-1],
    [4],
    [10**30],
    ["0"],
    [True],
    [0.0],
    "0",
    None,
    [[0]],
]


@pytest.mark.parametrize("nodes", SIDES)
def test_sides_of_a_cut_that_are_empty_whole_or_elsewhere(nodes, known):
    forged = threshold_of(RING, nodes, "0", "3", known)
    refused = refused_or_restated(forged, known)
    assert refused or nodes == ["0"]


def test_a_threshold_between_two_values_is_refused_on_either_side(known):
    for lower, upper in (("3", "299/100"), ("301/100", "4"), ("4", "3"), ("3", "0"), ("-1", "3")):
        forged = threshold_of(RING, [1, 2], lower, upper, known)
        assert refused_or_restated(forged, known)


def test_five_loads_for_four_nodes_and_three_too(known):
    for gamma in (["3"] * 5, ["3"] * 3, ["3"], [], [["3"] * 4], {"a": "3"}, "3,3,3,3"):
        forged = threshold_of(RING, [1, 2], "3", "3", known, gamma)
        assert refused_or_restated(forged, known)


WRONG_SIZES = [
    {"M": ONE, "K": ONE, "C": [["1", "0"], ["0", "1"]]},
    {"M": [["1", "0"], ["0", "1"]], "K": ONE, "C": ONE},
    {"M": [["1", "0"]], "K": ONE, "C": ONE},
    {"M": [["1", "1"], ["0", "1"]], "K": [["1", "0"], ["0", "1"]], "C": [["1", "0"], ["0", "1"]]},
    {"M": [[]], "K": [[]], "C": [[]]},
    {"M": [], "K": [], "C": []},
    {"M": "1", "K": "1", "C": "1"},
]


@pytest.mark.parametrize("gains", WRONG_SIZES)
def test_matrices_of_unlike_sizes_or_lopsided_are_refused(gains, samples, known):
    for made in samples.values():
        if {*made["inputs"]} >= {"M", "K", "C"}:
            forged = made | {"inputs": made["inputs"] | gains}
            assert refused_or_restated(forged, known)


def refuting_run(samples):
    return next(made for made in samples.values() if made["name"] == "theorem_1_gain")


@pytest.mark.parametrize(
    "place, value",
    [
        ("signs", ["10000001/10000000"]),
        ("signs", ["9999999/10000000"]),
        ("disturbance", ["40000001/10000000", "-4"]),
        ("disturbance", ["4", "-40000001/10000000"]),
        ("duration", "49999999/10000000"),
    ],
)
def test_a_selection_or_a_disturbance_beyond_its_bound(place, value, samples, known):
    forged = copy.deepcopy(refuting_run(samples))
    run = next(item for item in forged["witness"] if item["kind"] == "trajectory")
    run["pieces"][0][place] = value
    assert refused_or_restated(forged, known)


def test_an_error_with_a_mean_refutes_nothing(samples, known):
    """Its mean never goes away, at whatever gain and without any disturbance."""
    made = copy.deepcopy(next(m for m in samples.values() if m["name"] == "theorem_1_time"))
    same = {"x0": ["1", "1"], "x1": ["1", "1"], "t": "10", "beta": "100"}
    run = {"duration": "10", "disturbance": ["0", "0"], "signs": ["0"]}
    made["inputs"] |= same
    made["witness"][1]["pieces"] = [run]
    assert refused_or_restated(made, known)


def test_one_number_for_the_error_is_no_error_at_all(known):
    """The same number at every node has no spread, so that no time is needed."""
    forged = document(
        known["bearing_dac.settling_time"],
        {"graph": PAIR, "gamma": "0", "beta": "1", "x0": "4"},
        [cuts(TREE), {"kind": "cut", "nodes": [0]}],
        name="bearing_dac.settling_time",
        lower="1",
        upper="4",
    )
    assert refused_or_restated(forged, known)
    assert not refused_or_restated(forged | {"lower": "0"}, known)
