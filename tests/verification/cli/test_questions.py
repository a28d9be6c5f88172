"""``bound`` and ``certify``: the JSON document, exit statuses, what a reader sees, ``--out``."""

import json

import pytest

from verification.certificates import check
from verification.certificates.make import statements

KEYS = {
    "system",
    "value",
    "exact",
    "lower",
    "upper",
    "printed",
    "verdict",
    "certificate",
    "inputs",
    "digest",
    "seconds",
    "notes",
}
ONE = ["--set", "M=1", "--set", "K=2"]


def test_bound_prints_one_document_with_the_promised_keys(run):
    status, out, err = run("bound", "toy.trace", *ONE, "--json")
    document = json.loads(out)
    assert (status, err) == (0, [])
    assert set(document) == KEYS | {"quantity"}
    assert document["inputs"] == {"M": "1", "K": "2"}
    assert (document["value"], document["printed"], document["certificate"]) == (3.0, 6.0, None)
    assert document["digest"] == check.digest_of(statements()["variational.step"])


def test_certify_has_condition_and_margin_and_no_value(run):
    status, out, _ = run("certify", "toy.small", "--set", "h=1/4", "--json")
    document = json.loads(out)
    assert status == 0
    assert set(document) == KEYS | {"condition", "margin"}
    assert (document["value"], document["margin"], document["verdict"]) == (None, 0.75, "PROVED")


@pytest.mark.parametrize("h, status", [("0.5", 0), ("2", 1), ("1", 3)])
def test_certify_exit_status_is_the_verdict(run, h, status):
    assert run("certify", "toy.small", "--set", f"h={h}")[0] == status


@pytest.mark.parametrize("name, status", [("trace", 0), ("open", 3)])
def test_bound_without_value_exits_3(run, name, status):
    assert run("bound", f"toy.{name}", *(ONE if name == "trace" else []))[0] == status


def test_infinite_numbers_are_text_in_json(run):
    status, out, _ = run("bound", "toy.endless", "--json")
    document = json.loads(out, parse_constant=pytest.fail)
    assert (status, document["value"], document["lower"]) == (0, "inf", [1.0, -2.5])


def test_a_reader_sees_value_bracket_printed_verdict_notes(run):
    _, out, _ = run("bound", "toy.trace", *ONE)
    lines = [" ".join(line.split()) for line in out.splitlines()]
    assert lines == [
        "toy.trace",
        "M 1",
        "K 2",
        "",
        "value 3",
        "exactly 3",
        "bracket 3 … 3 (certified)",
        "printed 6 (2 times the value)",
        "verdict PROVED",
        "note sizes [1, 1]",
    ]


def test_a_reader_sees_the_polynomial_of_an_algebraic_number(run):
    _, out, _ = run("bound", "toy.root")
    assert "the root of x^2 - 2 between 1.4 and 1.5" in out


def test_a_reader_sees_that_there_is_no_value(run):
    _, out, _ = run("bound", "toy.open")
    assert "value        none" in out


def test_out_writes_a_certificate_that_checks(run, tmp_path):
    path = tmp_path / "found.json"
    _, out, _ = run("bound", "toy.trace", *ONE, "--out", path)
    assert f"sensortrack check {path}" in out
    assert run("check", path)[0] == 0
    assert [entry.name for entry in tmp_path.iterdir()] == ["found.json"]


def test_out_replaces_an_older_file(run, tmp_path):
    path = tmp_path / "found.json"
    path.write_text("old")
    run("bound", "toy.trace", *ONE, "--out", path, "--json")
    assert json.loads(path.read_text())["verdict"] == "PROVED"


def test_out_of_a_quantity_without_certificate_is_misuse(run, tmp_path):
    status, out, err = run("bound", "toy.total", "--graph", "path:3", "--out", tmp_path / "x.json")
    assert (status, out) == (2, "")
    assert err[0].startswith("sensortrack: --out: toy.total writes no certificate;")


def test_out_without_a_certificate_found_exits_3_and_keeps_the_verdict(run, tmp_path):
    path = tmp_path / "x.json"
    status, out, err = run("bound", "toy.root", "--out", path, "--json")
    assert (status, json.loads(out)["verdict"], path.exists()) == (3, "PROVED", False)
    assert err == ["sensortrack: toy.root: no certificate was written: no witness was found"]


def test_out_to_a_folder_or_into_none_is_an_error_before_any_work(run, tmp_path):
    for path, words in [(tmp_path, "is a folder"), (tmp_path / "no" / "x.json", "no folder")]:
        status, out, err = run("bound", "toy.trace", *ONE, "--out", path)
        assert (status, out) == (2, "")
        assert err[0].startswith("sensortrack: --out: ")
        assert words in err[0]


def test_unknown_names_suggest_the_nearest(run):
    for text, nearest in [
        ("variational.step_limti", "variational.step_limit"),
        ("toy.trance", "toy.trace"),
        ("tyo.trace", "toy"),
    ]:
        status, _, err = run("bound", text)
        assert status == 2
        assert err[0].startswith(f"sensortrack: {text}: no such ")
        assert err[0].endswith(f"did you mean {nearest}?")


def test_a_condition_asked_with_bound_is_told_so_and_the_reverse(run):
    _, _, err = run("bound", "toy.small", "--set", "h=1")
    assert err == ["sensortrack: toy.small: a condition; ask 'sensortrack certify toy.small'"]
    _, _, err = run("certify", "toy.trace")
    assert err == ["sensortrack: toy.trace: a quantity; ask 'sensortrack bound toy.trace'"]


def test_a_name_without_resemblance_gets_the_list(run):
    status, _, err = run("bound", "toy.zzzzzz")
    assert status == 2
    assert "toy.trace, toy.total" in err[0]
