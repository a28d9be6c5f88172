"""Every statement has samples, in every case, and the checker believes each of them."""

import json

from verification.certificates import check

from .documents import run_checker


def test_every_case_of_every_statement_has_a_sample(samples, known):
    cases = {(name, case) for name, entry in known.items() for case in entry["cases"]}
    sampled = {(f"{d['system']}.{d['name']}", d["case"]) for d in samples.values()}
    assert cases <= sampled, "add one to EXPLICIT in samples.py"


def test_samples_are_valid_when_read_from_files(samples, known, tmp_path):
    for number, made in enumerate(samples.values()):
        path = tmp_path / f"{number}.json"
        path.write_text(json.dumps(made))
        entry, status = check.check_file(str(path), known)
        assert status == 0, entry["reason"]
        assert entry["valid"]
        assert entry["inputs"] == made["inputs"]
        assert (entry["lower"], entry["upper"]) == (made.get("lower"), made.get("upper"))
        assert entry["verdict"] == made["verdict"]


def test_the_program_says_the_same_of_all_samples_at_once(samples, tmp_path):
    paths = []
    for number, made in enumerate(samples.values()):
        paths.append(tmp_path / f"{number}.json")
        paths[-1].write_text(json.dumps(made))
    ran = run_checker("--json", *paths)
    assert ran.returncode == 0, ran.stderr
    entries = json.loads(ran.stdout)
    assert [entry["file"] for entry in entries] == [str(path) for path in paths]
    assert all(entry["valid"] for entry in entries)
    keys = {"file", "valid", "system", "name", "statement", "inputs", "lower", "upper", "verdict"}
    assert all({*entry} == keys | {"reason"} for entry in entries)


def test_every_kind_of_witness_and_every_predicate_is_in_a_sample_or_known_to_be_spare(
    samples, known
):
    kinds = {item["kind"] for made in samples.values() for item in made["witness"]}
    parts = {
        part["kind"]
        for made in samples.values()
        for item in made["witness"]
        for part in item.get("parts", [])
    }
    assert kinds == {
        "congruence", "combination", "vector", "cuts", "cut", "trajectory", "derivation",
        "sparse_ldl", "product",
    } | (kinds & {"matrix"})  # fmt: skip
    assert parts == {"tree", "enumeration", "routing", "cells", "gap", "product", "sparse_ldl"}
    shown = " ".join(p for e in known.values() for c in e["cases"].values() for p in c["show"])
    assert all(f"{name}(" in shown for name in check.PREDICATES)
