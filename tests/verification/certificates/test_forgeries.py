"""Forged certificates are refused, or prove something true about the data that is then printed."""

import copy
import json
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verification.certificates import check
from verification.certificates.make import statements

from .documents import document, judged_in_memory, run_checker
from .forging import altered, numbers, refused_or_restated, share
from .samples import SCALARS, samples
from .truths import is_true

KEYS = sorted(samples())


CHANGES = {
    "one more": lambda v: v + 1 if isinstance(v, int) else str(Fraction(v) + 1),
    "one less": lambda v: v - 1 if isinstance(v, int) else str(Fraction(v) - 1),
    "negated": lambda v: -v if isinstance(v, int) else str(-Fraction(v)),
    "zero": lambda v: 0 if isinstance(v, int) else "0",
    "a hair more": lambda v: str(Fraction(v) + Fraction(1, 10**12)),
    "huge": lambda v: 10**30 if isinstance(v, int) else "1" + "0" * 30,
}


MOST_PLACES = 25
"""Numbers of one file that are changed, each in two ways; a longer one has a seeded share."""


MOST_WITNESSES = 15
"""Witnesses of another system that are tried on one file: a seeded share of them."""


@pytest.mark.parametrize("key", KEYS)
def test_every_number_changed_in_turn(key, samples, known):
    made, refused, total = samples[key], 0, 0
    places = [path for path, _ in numbers(made)]
    for path in share(places, MOST_PLACES, key):
        for change in share([*CHANGES.values()], 2, f"{key} {path}"):
            forged = altered(made, path, change)
            if forged != made:
                total += 1
                refused += refused_or_restated(forged, known)
    print(f"{key}: {refused} of {total} forgeries refused, the others restated and true")
    assert refused <= total


NOT_NUMBERS = [
    "1/0", "0/0", "1/-2", "-1/-2", "--1", "1/2/3", "/2", "2/", "1e9999999", "1e2", "0x10", "1_000",
    " 1", "1 ", "+1", "1.0", "1\n", "½", "١", "1\u0661", "", "-", "NaN", "nan", "inf", "Infinity",
    "9" * 4001, "1/" + "9" * 4001, "1/02", True, False, None, 1.5, [], {}, ["1"], {"1": 1}, "_0",
]  # fmt: skip


@pytest.mark.parametrize("bad", NOT_NUMBERS, ids=range(len(NOT_NUMBERS)))
def test_what_is_no_number_is_refused_wherever_a_number_is_due(bad, samples, known):
    tried = set()
    for key in KEYS:
        made = samples[key]
        for path, _ in numbers(made):
            place = (made["name"], *(step for step in path if isinstance(step, str)))
            if "squares" in path or ("relations" in path and path[-1] != 1) or place in tried:
                continue  # where an expression is due, or the like was tried
            tried.add(place)
            forged = altered(made, path, lambda _: bad)
            assert not believed(forged, known), (key, path)
    assert len(tried) > 60


@pytest.mark.parametrize("key", KEYS)
def test_items_dropped_doubled_or_moved(key, samples, known):
    made = samples[key]
    items = made["witness"]
    for k in range(len(items)):
        for forged in (items[:k] + items[k + 1 :], items[:k] + items[k : k + 1] + items[k:]):
            entry, _ = judged_in_memory(made | {"witness": forged}, known)
            assert not entry["valid"]
        rotated = items[k:] + items[:k]
        if k and rotated != items:
            refused_or_restated(made | {"witness": rotated}, known)
    for forged in (None, {}, "", [[]], [None], [{}], [{"kind": "congruence"}], [items]):
        entry, _ = judged_in_memory(made | {"witness": forged}, known)
        assert not entry["valid"]


@pytest.mark.parametrize("key", KEYS)
def test_the_witness_of_another_system_is_refused(key, samples, known):
    made = samples[key]
    others = [other for other in samples.values() if other["system"] != made["system"]]
    assert others
    if not made["witness"]:  # any item is one too many: one witness of each composition is enough
        others = [*{str([item["kind"] for item in d["witness"]]): d for d in others}.values()]
    for other in share(others, MOST_WITNESSES, key):
        if made["witness"] != other["witness"]:
            forged = made | {"witness": other["witness"]}
            assert refused_or_restated(forged, known)


def predicates(made, known):
    case = known[f"{made['system']}.{made['name']}"]["cases"].get(made["case"], {})
    return case.get("show")


def believed(document, known):
    """As `judged` says, without the way through a file: there are many pairs."""
    try:
        return bool(check.check_document(document, known))
    except Exception:  # as the checker has it, whatever is raised proves nothing
        return False


@pytest.mark.parametrize("key", KEYS)
def test_the_heading_of_another_statement_is_refused(key, samples, known):
    """Name alone, name with digest, and everything but the witness.

    Two statements without data may have one derivation, like "the first hypothesis less the second
    one"; under the heading of the other it is then a proof of that one, which is true.
    """
    made = samples[key]
    heading = ("system", "name", "digest", "case", "verdict", "relies_on")
    for other in samples.values():
        if other["digest"] == made["digest"]:
            continue
        names = {k: other[k] for k in heading[:2]}
        for fields in (names, {k: other[k] for k in heading[:3]}, {k: other[k] for k in heading}):
            forged = made | fields
            universal = not (
                made["inputs"] or known[f"{other['system']}.{other['name']}"]["inputs"]
            )
            alike = universal or predicates(forged, known) == predicates(made, known)
            same = "digest" in fields and alike
            assert same or not believed(forged, known), other["name"]


@pytest.mark.parametrize("key", KEYS)
def test_keys_missing_unknown_or_of_another_kind_are_refused(key, samples, known):
    made = samples[key]
    for name in made:
        without = {k: v for k, v in made.items() if k != name}
        assert not judged_in_memory(without, known)[0]["valid"]
        if name != "about":
            for value in (None, 1, [], {}, "other", [made[name]], {"": made[name]}):
                if value != made[name]:
                    forged = made | {name: value}
                    refused = refused_or_restated(forged, known)
                    assert refused or name in ("lower", "upper")
    assert not judged_in_memory(made | {"note": ""}, known)[0]["valid"]
    inputs = made["inputs"] | {"extra": "1"}
    assert not judged_in_memory(made | {"inputs": inputs}, known)[0]["valid"]
    for name in made["inputs"]:
        inputs = {k: v for k, v in made["inputs"].items() if k != name}
        assert not judged_in_memory(made | {"inputs": inputs}, known)[0]["valid"]
    for k, item in enumerate(made["witness"]):
        items = [*made["witness"]]
        items[k] = item | {"note": 1}
        assert not judged_in_memory(made | {"witness": items}, known)[0]["valid"]


def test_ends_fixed_by_the_statement_cannot_be_others(samples, known):
    for made in samples.values():
        for end in ("lower", "upper"):
            fixed = known[f"{made['system']}.{made['name']}"]["cases"][made["case"]]["ends"]
            if fixed.get(end) is not None:
                for value in ("1", "-1", "Inf", "00", None, 0, ""):
                    forged = made | {end: value}
                    assert not judged_in_memory(forged, known)[0]["valid"]
            elif end not in fixed:
                assert not judged_in_memory(made | {end: "0"}, known)[0]["valid"]


def test_every_statement_weakened_is_another_statement(samples, known):
    """One predicate less, or a hypothesis more, is printed and refused under the old digest."""
    for made in samples.values():
        name = f"{made['system']}.{made['name']}"
        weaker = copy.deepcopy(known[name])
        weaker["cases"][made["case"]]["show"].pop()
        entry, status = judged_in_memory(made, known | {name: weaker})
        assert (entry["valid"], status) == (False, 1)
        assert "digest" in entry["reason"]
        forged = made | {"digest": check.digest_of(weaker)}
        assert not judged_in_memory(forged, known)[0]["valid"]


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
    except Exception:  # whatever it is, check_file makes INVALID of it
        return
    assert entry["inputs"] == forged["inputs"]
    assert is_true(entry)
