"""``sensortrack verify``: what is printed, what is written, when ``--strict`` fails."""

import json
from types import SimpleNamespace

import pytest

from theory.systems import SYSTEMS as THEORY
from verification.systems import SYSTEMS
from verification.verdict import Decision, Verdict

IDS = [claim.id for system in THEORY if system.name == "variational" for claim in system.claims]


@pytest.fixture
def supported(monkeypatch):
    """Let all claims of one system be supported, but for those that are left out."""

    def call(*without):
        decisions = {
            name: lambda: Decision(Verdict.SUPPORTED, "by statistics")
            for name in IDS
            if name not in without
        }
        room = SimpleNamespace(claims=SimpleNamespace(DECISIONS=decisions))
        monkeypatch.setitem(SYSTEMS, "variational", room)

    return call


def test_the_table_the_report_and_the_check_line_are_shown(run, tmp_path):
    out = tmp_path / "found"
    status, text, err = run("verify", "variational", "--out", out)
    assert (status, err) == (0, [])
    assert all(name in text for name in IDS)
    assert f"report  {out}/report.html" in text
    assert f"check   sensortrack check {out}/certificates/*.json" in text
    files = {path.name for path in out.iterdir()}
    assert files >= {"claims.json", "networks.json", "facts.json", "report.html", "report.md"}
    assert run("check", *sorted((out / "certificates").iterdir()))[0] == 0


def test_json_prints_the_claims_and_nothing_else(run, tmp_path):
    status, text, err = run("verify", "variational", "--json", "--quick", "--out", tmp_path)
    assert (status, err) == (0, [])
    assert json.loads(text) == json.loads((tmp_path / "claims.json").read_text())


def test_one_claim_may_be_chosen(run, tmp_path):
    _, text, _ = run("verify", IDS[1], "--json", "--out", tmp_path)
    assert [claim["id"] for claim in json.loads(text)] == [IDS[1]]


def test_plain_is_ascii_without_colour(run, tmp_path):
    _, text, _ = run("verify", "variational", "--plain", "--out", tmp_path)
    assert text.isascii()
    assert "\x1b" not in text


def test_strict_fails_for_an_undecided_claim_only(run, supported, tmp_path):
    supported()
    assert run("verify", "variational", "--strict", "--out", tmp_path)[0] == 0
    supported(IDS[0])
    assert run("verify", "variational", "--out", tmp_path)[0] == 0
    assert run("verify", "variational", "--strict", "--out", tmp_path)[0] == 1


def test_strict_fails_for_a_skipped_check(run, supported, monkeypatch, tmp_path):
    supported()
    monkeypatch.setattr("verification.verify.SWEPT", "variational")
    monkeypatch.setattr("verification.verify.sweeping.load_network", lambda _name: 1 / 0)
    status, _, err = run("verify", "variational", "--out", tmp_path)
    assert (status, len(err) > 0) == (0, True)
    assert err[0].startswith("sensortrack: skipped: network ")
    assert run("verify", "variational", "--strict", "--out", tmp_path)[0] == 1
    assert run("verify", "variational", "--strict", "--quick", "--out", tmp_path)[0] == 0


def test_the_command_is_recorded_for_the_report(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run("verify", "variational", "--quick", "--jobs", "1")
    facts = json.loads((tmp_path / "build" / "verify" / "facts.json").read_text())
    assert facts["command"] == "sensortrack verify variational --quick"
    run("verify", IDS[0], "--out", "a b")
    facts = json.loads((tmp_path / "a b" / "facts.json").read_text())
    assert facts["command"] == f"sensortrack verify {IDS[0]} --out 'a b'"


def test_misuse_is_told_before_any_work(run, tmp_path):
    status, _, err = run("verify", "variational.prop_4_2")
    assert status == 2
    assert err[0].endswith("did you mean variational.prop_4_1?")
    (tmp_path / "mine").write_text("")
    status, _, err = run("verify", "--out", tmp_path)
    assert status == 2
    assert err[0].startswith(f"sensortrack: --out: {tmp_path} holds files ")
    assert [path.name for path in tmp_path.iterdir()] == ["mine"]


def test_report_builds_the_same_pages_again(run, tmp_path):
    run("verify", "variational", "--quick", "--out", tmp_path)
    pages = [tmp_path / "report.html", tmp_path / "report.md"]
    before = [page.read_text() for page in pages]
    for page in pages:
        page.unlink()
    status, text, _ = run("report", tmp_path)
    assert (status, text.split()) == (0, list(map(str, pages)))
    assert [page.read_text() for page in pages] == before


@pytest.mark.parametrize("claims", [None, "", "{}", "[1]", "[{}]"])
def test_report_of_something_else_is_an_input_error(run, tmp_path, claims):
    if claims is not None:
        (tmp_path / "claims.json").write_text(claims)
        (tmp_path / "facts.json").write_text("[]")
    status, out, err = run("report", tmp_path)
    assert (status, out) == (2, "")
    assert err[0].startswith(f"sensortrack: DIR: no report can be made of {tmp_path}: ")
