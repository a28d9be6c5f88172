"""The run behind ``sensortrack verify``: one failure stops nothing, nothing unproved passes."""

import json
import os
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import pytest

from sensortrack.errors import InputError
from theory.systems import SYSTEMS as THEORY
from verification.certificates import check
from verification.certificates.make import certificate
from verification.systems import SYSTEMS
from verification.verdict import Decision, Verdict
from verification.verify import select, tasks_of, verify
from verification.verify.parallel import run_all

CLAIMS = next(system.claims for system in THEORY if system.name == "variational")
IDS = [claim.id for claim in CLAIMS]
KEYS = {
    *("id", "system", "source", "title", "statement", "formula", "printed", "sharp"),
    *("printed_value", "sharp_value", "sense", "verdict", "margin", "margin_text", "reason"),
    *("repair", "repair_formula", "assumptions", "relies_on", "certificates", "replay"),
    *("figure", "seconds", "digest"),
}


def proof(h="1/10"):
    one = ((Fraction(1),),)
    inputs = {"M": one, "K": one, "C": one, "h": Fraction(h)}
    return certificate("variational", "step", inputs, [])


def refutation():
    one = ((Fraction(1),),)
    inputs = {"M": one, "K": one, "C": one, "h": Fraction(4)}
    return certificate("variational", "step", inputs, [{"kind": "vector", "x": [1]}], "REFUTED")


PROVED = Decision(
    Verdict.PROVED,
    "by hand",
    printed_value=3.0,
    sharp_value=2.0,
    certificates={"a": proof()},
)


@pytest.fixture
def decide(monkeypatch, tmp_path):
    """Run verify on the first claims of a system whose decisions are given, as a dict by id."""

    def call(*decisions, **options):
        functions = dict(zip(IDS, decisions, strict=False))
        room = SimpleNamespace(claims=SimpleNamespace(DECISIONS=functions))
        monkeypatch.setitem(SYSTEMS, "variational", room)
        outcome = verify(select(["variational"]), tmp_path / "out", **options)
        return {claim["id"]: claim for claim in outcome.claims}

    return call


def said(claims):
    return [claim["verdict"] for claim in claims.values()]


def test_a_run_leaves_claims_networks_facts_and_certificates(decide, tmp_path):
    found = decide(lambda: PROVED, command="sensortrack verify variational")
    out = tmp_path / "out"
    assert json.loads((out / "claims.json").read_text()) == list(found.values())
    assert json.loads((out / "networks.json").read_text()) == []
    facts = json.loads((out / "facts.json").read_text())
    assert (facts["command"], facts["checked"]) == ("sensortrack verify variational", 1)
    assert list(facts["systems"]) == ["variational"]
    assert [path.name for path in (out / "certificates").iterdir()] == ["a.json"]
    record = found[IDS[0]]
    assert set(record) == KEYS
    assert (record["certificates"], record["margin"]) == (["certificates/a.json"], 0.5)
    assert check.main([str(out / record["certificates"][0])]) == 0


def test_a_claim_that_nothing_decides_is_undecided(decide):
    found = decide(lambda: PROVED)
    assert said(found) == ["PROVED"] + ["UNDECIDED"] * (len(IDS) - 1)
    assert found[IDS[1]]["reason"].startswith("stage load: ")


def test_a_decision_that_fails_stops_no_other(decide):
    def fail():
        raise ZeroDivisionError("one\ntwo")

    found = decide(fail, lambda: PROVED)
    assert said(found)[:2] == ["UNDECIDED", "PROVED"]
    assert found[IDS[0]]["reason"] == "stage decide: ZeroDivisionError: one two"


def test_a_system_that_cannot_be_loaded_is_undecided(monkeypatch, tmp_path):
    class Broken:
        @property
        def claims(self):
            raise ModuleNotFoundError("No module named 'flint'")

    monkeypatch.setitem(SYSTEMS, "variational", Broken())
    outcome = verify(select(["variational"]), tmp_path / "out")
    assert {claim["verdict"] for claim in outcome.claims} == {"UNDECIDED"}
    assert "stage load: ModuleNotFoundError" in outcome.claims[0]["reason"]


def test_a_certificate_that_does_not_validate_takes_the_verdict_back(decide):
    forged = proof()
    forged["inputs"]["h"] = "5"
    found = decide(lambda: replace(PROVED, certificates={"a": forged}, repair="something"))
    record = found[IDS[0]]
    assert record["verdict"] == "UNDECIDED"
    assert record["reason"].startswith("stage check: certificates/a.json does not validate: ")
    assert (record["repair"], record["certificates"]) == ("", [])


@pytest.mark.parametrize(
    "verdict, documents, stands",
    [
        (Verdict.PROVED, [], False),
        (Verdict.PROVED, [refutation()], False),
        (Verdict.REFUTED, [proof()], False),
        (Verdict.REFUTED, [refutation()], True),
        (Verdict.CORRECTED, [refutation()], False),
        (Verdict.CORRECTED, [proof()], False),
        (Verdict.CORRECTED, [proof(), refutation()], True),
        (Verdict.SUPPORTED, [], True),
        (Verdict.UNDECIDED, [], True),
    ],
)
def test_a_verdict_stands_only_with_the_certificates_that_it_needs(
    decide, verdict, documents, stands
):
    files = {f"c{place}": document for place, document in enumerate(documents)}
    found = decide(lambda: Decision(verdict, "because", certificates=files))
    assert (found[IDS[0]]["reason"] == "because") == stands
    assert found[IDS[0]]["verdict"] == (verdict if stands else "UNDECIDED")


def test_a_certificate_of_another_system_is_no_support(decide):
    universal = certificate(
        "bearing_dac",
        "gain",
        {
            "graph": {"nodes": ["a", "b"], "edges": [[0, 1]]},
            "gamma": Fraction(1),
            "beta": Fraction(1),
        },
        [{"kind": "cuts", "parts": [{"kind": "tree"}]}],
    )
    found = decide(lambda: replace(PROVED, certificates={"a": universal}))
    assert found[IDS[0]]["reason"] == "stage check: certificates/a.json is about bearing_dac"


def test_one_file_name_holds_one_document(decide):
    other = replace(PROVED, certificates={"a": proof("1/5")})
    found = decide(lambda: PROVED, lambda: other, lambda: PROVED)
    assert said(found)[:3] == ["PROVED", "UNDECIDED", "PROVED"]
    assert "two files would be called a" in found[IDS[1]]["reason"]


@pytest.mark.parametrize("stem", ["../a", "/a", "", "a/b", ".a", "a\n"])
def test_a_certificate_cannot_leave_its_folder(decide, stem):
    found = decide(lambda: replace(PROVED, certificates={stem: proof()}))
    assert found[IDS[0]]["reason"].startswith("stage certificates: ValueError")


def test_infinite_numbers_leave_the_margin_open(decide):
    found = decide(lambda: replace(PROVED, printed_value=float("inf")))
    assert (found[IDS[0]]["printed_value"], found[IDS[0]]["margin"]) == (None, None)


def test_certificates_of_an_earlier_run_are_removed(decide, tmp_path):
    decide(lambda: PROVED, lambda: replace(PROVED, certificates={"b": proof("1/5")}))
    folder = tmp_path / "out" / "certificates"
    (folder / "note.txt").write_text("mine")
    decide(lambda: PROVED)
    assert sorted(path.name for path in folder.iterdir()) == ["a.json", "note.txt"]


@pytest.mark.parametrize("claims", [None, "[1]", "{}", '[{"id": "x"}]', "no JSON"])
def test_a_folder_that_is_not_ours_is_left_alone(decide, tmp_path, claims):
    out = tmp_path / "out"
    (out / "certificates").mkdir(parents=True)
    (out / "certificates" / "kept.json").write_text("precious")
    if claims is not None:
        (out / "claims.json").write_text(claims)
    with pytest.raises(InputError, match="holds files that no run of verify wrote"):
        decide(lambda: PROVED)
    assert (out / "certificates" / "kept.json").read_text() == "precious"


def test_a_first_run_that_was_interrupted_can_be_repeated(decide):
    def interrupt():
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        decide(interrupt)
    assert said(decide(lambda: PROVED))[0] == "PROVED"


def test_a_link_to_another_folder_is_not_followed(decide, tmp_path):
    decide(lambda: PROVED)
    elsewhere = tmp_path / "elsewhere"
    (tmp_path / "out" / "certificates").rename(elsewhere)
    (tmp_path / "out" / "certificates").symlink_to(elsewhere)
    with pytest.raises(InputError, match="certificates is a link"):
        decide(lambda: PROVED)
    assert (elsewhere / "a.json").exists()


def test_a_file_is_no_folder(tmp_path):
    (tmp_path / "out").write_text("")
    for path in (tmp_path / "out", tmp_path / "out" / "deeper"):
        with pytest.raises(InputError, match="--out: "):
            verify(select(["variational"]), path)


def test_an_empty_folder_may_be_used(tmp_path):
    verify(select([IDS[0]]), tmp_path)
    assert (tmp_path / "claims.json").exists()


def test_selection_keeps_the_order_of_theory_and_takes_nothing_twice():
    everything = [claim.id for system in THEORY for claim in system.claims]
    assert [claim.id for claim in select([]).claims] == everything
    assert [claim.id for claim in select([IDS[1], IDS[0], IDS[1]]).claims] == IDS[:2]
    assert [claim.id for claim in select([IDS[1], "variational"]).claims] == IDS


def test_unknown_systems_and_claims_suggest_the_nearest():
    for text, hint in [
        ("varational", "no such system; did you mean variational?"),
        ("variational.prop_4_2", "no such claim; did you mean variational.prop_4_1?"),
    ]:
        with pytest.raises(InputError) as caught:
            select([text])
        assert str(caught.value).startswith(f"{text}: {hint}")


def test_networks_are_swept_with_the_whole_system_only():
    def swept(texts, quick=False):
        return any(what == "network" for what, _ in tasks_of(select(texts), quick))

    assert swept([])
    assert swept(["bearing_dac"])
    assert not swept([], quick=True)
    assert not swept(["variational"])
    assert not swept(["bearing_dac.theorem_1_gain"])


def test_two_processes_decide_what_one_decides(tmp_path):
    def run(jobs):
        seen = []
        outcome = verify(select(["variational"]), tmp_path / str(jobs), jobs=jobs, tick=seen.append)
        assert sorted(seen) == sorted(tasks_of(select(["variational"]), False))
        return [{**claim, "seconds": 0} for claim in outcome.claims]

    assert run(1) == run(2)


def end_unless_good(task):
    if task == "bad":
        os._exit(1)
    return task.upper()


def test_a_process_that_ends_loses_its_own_task_only():
    tasks = ["a", "bad", "b", "c"]
    found = run_all(end_unless_good, tasks, 2, lambda task: f"lost {task}", lambda _task: None)
    assert found == ["A", "lost bad", "B", "C"]


def test_records_say_the_truth_about_where_files_are(decide, tmp_path):
    found = decide(lambda: PROVED, lambda: replace(PROVED, certificates={"b": proof("1/5")}))
    for record in found.values():
        assert all(Path(tmp_path, "out", file).is_file() for file in record["certificates"])
