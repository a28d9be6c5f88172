"""Forged certificates are refused, or prove something true about the data that is then printed."""

import copy
import json
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verification.certificates import check

from .documents import document, judged, run_checker
from .samples import ONE, PAIR, RING, SCALARS, TREE, cuts, samples
from .truths import is_true

KEYS = sorted(samples())


def refused_or_restated(forged, known, path):
    """True if refused; else the forged data are printed, and the statement is true of them."""
    entry, status = judged(forged, path, known)
    assert status in (0, 1, 2)
    if not entry["valid"]:
        assert status != 0
        assert entry["reason"]
        return True
    assert status == 0
    assert entry["inputs"] == forged["inputs"]
    assert (entry["lower"], entry["upper"]) == (forged.get("lower"), forged.get("upper"))
    assert is_true(entry), entry
    return False


def leaves(value, path=()):
    """Where numbers stand in a document: (path, number)."""
    if isinstance(value, dict):
        for key in value:
            yield from leaves(value[key], (*path, key))
    elif isinstance(value, list):
        for index, entry in enumerate(value):
            yield from leaves(entry, (*path, index))
    elif isinstance(value, int) or check.NUMBER.fullmatch(str(value)):
        yield path, value


def altered(made, path, change):
    forged = copy.deepcopy(made)
    place = forged
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = change(place[path[-1]])
    return forged


def numbers(made):
    parts = {key: made[key] for key in ("inputs", "witness", "lower", "upper") if key in made}
    return list(leaves(parts))


CHANGES = {
    "one more": lambda v: v + 1 if isinstance(v, int) else str(Fraction(v) + 1),
    "one less": lambda v: v - 1 if isinstance(v, int) else str(Fraction(v) - 1),
    "negated": lambda v: -v if isinstance(v, int) else str(-Fraction(v)),
    "zero": lambda v: 0 if isinstance(v, int) else "0",
    "a hair more": lambda v: str(Fraction(v) + Fraction(1, 10**12)),
    "huge": lambda v: 10**30 if isinstance(v, int) else "1" + "0" * 30,
}


@pytest.mark.parametrize("key", KEYS)
def test_every_number_changed_in_turn(key, samples, known, tmp_path):
    made, refused, total = samples[key], 0, 0
    for path, value in numbers(made):
        for change in CHANGES.values():
            forged = altered(made, path, change)
            if forged != made:
                total += 1
                refused += refused_or_restated(forged, known, tmp_path / "it.json")
    print(f"{key}: {refused} of {total} forgeries refused, the others restated and true")
    assert refused <= total


NOT_NUMBERS = [
    "1/0", "0/0", "1/-2", "-1/-2", "--1", "1/2/3", "/2", "2/", "1e9999999", "1e2", "0x10", "1_000",
    " 1", "1 ", "+1", "1.0", "1\n", "½", "١", "1\u0661", "", "-", "NaN", "nan", "inf", "Infinity",
    "9" * 4001, "1/" + "9" * 4001, "1/02", True, False, None, 1.5, [], {}, ["1"], {"1": 1}, "_0",
]  # fmt: skip


@pytest.mark.parametrize("bad", NOT_NUMBERS, ids=range(len(NOT_NUMBERS)))
def test_what_is_no_number_is_refused_wherever_a_number_is_due(bad, samples, known, tmp_path):
    tried = set()
    for key in KEYS:
        made = samples[key]
        for path, _ in numbers(made):
            place = (made["name"], *(step for step in path if isinstance(step, str)))
            if "squares" in path or ("relations" in path and path[-1] != 1) or place in tried:
                continue  # where an expression is due, or the like was tried
            tried.add(place)
            forged = altered(made, path, lambda _: bad)
            entry, _ = judged(forged, tmp_path / "it.json", known)
            assert not entry["valid"], (key, path)
    assert len(tried) > 60


@pytest.mark.parametrize("key", KEYS)
def test_items_dropped_doubled_or_moved(key, samples, known, tmp_path):
    made = samples[key]
    items = made["witness"]
    for k in range(len(items)):
        for forged in (items[:k] + items[k + 1 :], items[:k] + items[k : k + 1] + items[k:]):
            entry, _ = judged(made | {"witness": forged}, tmp_path / "it.json", known)
            assert not entry["valid"]
        rotated = items[k:] + items[:k]
        if k and rotated != items:
            refused_or_restated(made | {"witness": rotated}, known, tmp_path / "it.json")
    for forged in (None, {}, "", [[]], [None], [{}], [{"kind": "congruence"}], [items]):
        entry, _ = judged(made | {"witness": forged}, tmp_path / "it.json", known)
        assert not entry["valid"]


@pytest.mark.parametrize("key", KEYS)
def test_the_witness_of_another_system_is_refused(key, samples, known, tmp_path):
    made = samples[key]
    others = [other for other in samples.values() if other["system"] != made["system"]]
    assert others
    for other in others:
        if made["witness"] != other["witness"]:
            forged = made | {"witness": other["witness"]}
            assert refused_or_restated(forged, known, tmp_path / "it.json")


@pytest.mark.parametrize("key", KEYS)
def test_the_heading_of_another_statement_is_refused(key, samples, known, tmp_path):
    """Name alone, name with digest, and everything but the witness."""
    made = samples[key]
    heading = ("system", "name", "digest", "case", "verdict", "relies_on")
    for other in samples.values():
        if other["digest"] == made["digest"]:
            continue
        names = {k: other[k] for k in heading[:2]}
        for fields in (names, {k: other[k] for k in heading[:3]}, {k: other[k] for k in heading}):
            entry, _ = judged(made | fields, tmp_path / "it.json", known)
            shown = [known[f"{d['system']}.{d['name']}"]["cases"][d["case"]] for d in (made, other)]
            same = shown[0]["show"] == shown[1]["show"] and "digest" in fields
            assert not entry["valid"] or same, other["name"]


@pytest.mark.parametrize("key", KEYS)
def test_keys_missing_unknown_or_of_another_kind_are_refused(key, samples, known, tmp_path):
    made = samples[key]
    for name in made:
        without = {k: v for k, v in made.items() if k != name}
        assert not judged(without, tmp_path / "it.json", known)[0]["valid"]
        if name != "about":
            for value in (None, 1, [], {}, "other", [made[name]], {"": made[name]}):
                if value != made[name]:
                    forged = made | {name: value}
                    refused = refused_or_restated(forged, known, tmp_path / "it.json")
                    assert refused or name in ("lower", "upper")
    assert not judged(made | {"note": ""}, tmp_path / "it.json", known)[0]["valid"]
    inputs = made["inputs"] | {"extra": "1"}
    assert not judged(made | {"inputs": inputs}, tmp_path / "it.json", known)[0]["valid"]
    for name in made["inputs"]:
        inputs = {k: v for k, v in made["inputs"].items() if k != name}
        assert not judged(made | {"inputs": inputs}, tmp_path / "it.json", known)[0]["valid"]
    for k, item in enumerate(made["witness"]):
        items = [*made["witness"]]
        items[k] = item | {"note": 1}
        assert not judged(made | {"witness": items}, tmp_path / "it.json", known)[0]["valid"]


def test_ends_fixed_by_the_statement_cannot_be_others(samples, known, tmp_path):
    for made in samples.values():
        for end in ("lower", "upper"):
            fixed = known[f"{made['system']}.{made['name']}"]["cases"][made["case"]]["ends"]
            if fixed.get(end) is not None:
                for value in ("1", "-1", "Inf", "00", None, 0, ""):
                    forged = made | {end: value}
                    assert not judged(forged, tmp_path / "it.json", known)[0]["valid"]
            elif end not in fixed:
                assert not judged(made | {end: "0"}, tmp_path / "it.json", known)[0]["valid"]


def test_every_statement_weakened_is_another_statement(samples, known, tmp_path):
    """One predicate less, or a hypothesis more, is printed and refused under the old digest."""
    for made in samples.values():
        name = f"{made['system']}.{made['name']}"
        weaker = copy.deepcopy(known[name])
        weaker["cases"][made["case"]]["show"].pop()
        entry, status = judged(made, tmp_path / "it.json", known | {name: weaker})
        assert (entry["valid"], status) == (False, 1)
        assert "digest" in entry["reason"]
        forged = made | {"digest": check.digest_of(weaker)}
        assert not judged(forged, tmp_path / "it.json", known)[0]["valid"]


def test_a_weaker_statement_is_believed_only_where_it_is_asked_for_and_printed(known, tmp_path):
    name = "variational.step"
    weaker = copy.deepcopy(known[name])
    weaker["cases"]["PROVED"]["show"] = ["h > 0"]
    made = document(weaker, {**SCALARS, "h": "9"}, [], name=name)
    (tmp_path / "made.json").write_text(json.dumps(made))
    (tmp_path / "other.json").write_text(json.dumps(known | {name: weaker}))
    assert run_checker(tmp_path / "made.json").returncode == 1
    ran = run_checker("--statements", tmp_path / "other.json", tmp_path / "made.json")
    assert ran.returncode == 0
    assert "[h > 0]" in ran.stdout


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
def test_other_graphs(what, known, tmp_path):
    honest = threshold_of(RING, [1, 2], "3", "3", known)
    assert not refused_or_restated(honest, known, tmp_path / "it.json")
    forged = honest | {"inputs": {"graph": GRAPHS[what], "gamma": "3"}}
    refused = refused_or_restated(forged, known, tmp_path / "it.json")
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


SIDES = [[], [0, 1, 2, 3], [0, 0], [1, 4], [-1], [4], [10**30], ["0"], [True], [0.0], "0", None, [[0]]]


@pytest.mark.parametrize("nodes", SIDES)
def test_sides_of_a_cut_that_are_empty_whole_or_elsewhere(nodes, known, tmp_path):
    forged = threshold_of(RING, nodes, "0", "3", known)
    refused = refused_or_restated(forged, known, tmp_path / "it.json")
    assert refused or nodes == ["0"]


def test_a_threshold_between_two_values_is_refused_on_either_side(known, tmp_path):
    for lower, upper in (("3", "299/100"), ("301/100", "4"), ("4", "3"), ("3", "0"), ("-1", "3")):
        forged = threshold_of(RING, [1, 2], lower, upper, known)
        assert refused_or_restated(forged, known, tmp_path / "it.json")


def test_five_loads_for_four_nodes_and_three_too(known, tmp_path):
    for gamma in (["3"] * 5, ["3"] * 3, ["3"], [], [["3"] * 4], {"a": "3"}, "3,3,3,3"):
        forged = threshold_of(RING, [1, 2], "3", "3", known, gamma)
        assert refused_or_restated(forged, known, tmp_path / "it.json")


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
def test_matrices_of_unlike_sizes_or_lopsided_are_refused(gains, samples, known, tmp_path):
    for made in samples.values():
        if {*made["inputs"]} >= {"M", "K", "C"}:
            forged = made | {"inputs": made["inputs"] | gains}
            assert refused_or_restated(forged, known, tmp_path / "it.json")


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
def test_a_selection_or_a_disturbance_beyond_its_bound(place, value, samples, known, tmp_path):
    forged = copy.deepcopy(refuting_run(samples))
    run = next(item for item in forged["witness"] if item["kind"] == "trajectory")
    run["pieces"][0][place] = value
    assert refused_or_restated(forged, known, tmp_path / "it.json")


def test_an_error_with_a_mean_refutes_nothing(samples, known, tmp_path):
    """Its mean never goes away, at whatever gain and without any disturbance."""
    made = copy.deepcopy(next(m for m in samples.values() if m["name"] == "theorem_1_time"))
    same = {"x0": ["1", "1"], "x1": ["1", "1"], "t": "10", "beta": "100"}
    run = {"duration": "10", "disturbance": ["0", "0"], "signs": ["0"]}
    made["inputs"] |= same
    made["witness"][1]["pieces"] = [run]
    assert refused_or_restated(made, known, tmp_path / "it.json")


def test_one_number_for_the_error_is_no_error_at_all(known, tmp_path):
    """The same number at every node has no spread, so that no time is needed."""
    forged = document(
        known["bearing_dac.settling_time"],
        {"graph": PAIR, "gamma": "0", "beta": "1", "x0": "4"},
        [cuts(TREE), {"kind": "cut", "nodes": [0]}],
        name="bearing_dac.settling_time",
        lower="1",
        upper="4",
    )
    assert refused_or_restated(forged, known, tmp_path / "it.json")
    assert not refused_or_restated(forged | {"lower": "0"}, known, tmp_path / "it.json")


SCRAPS = st.sampled_from(
    [None, True, 0, -1, 2**70, "", "0", "1/3", "M", "lower", "__class__", [], {}, [[]], "forall"]
)


def branches(value, path=()):
    yield path
    children = value.items() if isinstance(value, dict) else enumerate(value)
    for key, entry in children:
        if isinstance(entry, dict | list):
            yield from branches(entry, (*path, key))
        else:
            yield (*path, key)


@given(st.data())
def test_any_part_replaced_by_anything(data):
    """No exception escapes, and what is believed is printed as forged."""
    from verification.certificates.make import statements

    made = samples()[data.draw(st.sampled_from(KEYS))]
    places = [path for path in branches(made) if path and path[0] != "about"]
    scraps = st.one_of(SCRAPS, st.integers(), st.text(max_size=5))
    forged = made
    for _ in range(data.draw(st.integers(1, 2))):
        where, scrap = data.draw(st.sampled_from(places)), data.draw(scraps)
        try:
            forged = altered(forged, where, lambda _, scrap=scrap: scrap)
        except (IndexError, KeyError, TypeError):
            continue  # the second place went away with the first
    try:
        entry = check.check_document(forged, statements())
    except Exception as error:  # noqa: BLE001 - whatever it is, check_file makes INVALID of it
        assert isinstance(error, Exception)
        return
    assert entry["inputs"] == forged["inputs"]
    assert is_true(entry)
