"""``systems``, ``claims``, ``quantities``, ``data`` and ``check``."""

import json
import subprocess
import sys

import pytest

from tests.meta.repository import ROOT
from theory.systems import SYSTEMS
from verification.cli.main import main
from verification.systems import SYSTEMS as ROOMS

CHECKER = ROOT / "verification" / "certificates" / "check.py"


def output(capsys, *argv):
    assert main(list(argv)) == 0
    return capsys.readouterr().out


def listed(capsys, *argv):
    """Lines for people and entries for programs; as many of one as of the other."""
    lines = output(capsys, *argv).splitlines()
    entries = json.loads(output(capsys, *argv, "--json"))
    assert len(lines) == len(entries) > 0
    return lines, entries


def test_systems_are_those_of_theory(capsys):
    lines, entries = listed(capsys, "systems")
    assert [entry["system"] for entry in entries] == [system.name for system in SYSTEMS]
    assert all(entry["title"] in line for line, entry in zip(lines, entries, strict=True))


def test_every_system_of_theory_has_a_room_for_proofs():
    assert list(ROOMS) == sorted(system.name for system in SYSTEMS)


@pytest.mark.parametrize("system", [system.name for system in SYSTEMS])
def test_claims_and_quantities_of_one_system(capsys, system):
    lines, entries = listed(capsys, "claims", system)
    assert all(line.startswith(f"{system}.") for line in lines)
    assert {entry["system"] for entry in entries} == {system}
    _, entries = listed(capsys, "quantities", system)
    asked = [entry for entry in entries if entry["command"] != "design"]
    assert all(entry["name"].startswith(f"{system}.") for entry in asked)
    assert {entry["command"] for entry in asked} == {"bound", "certify"}
    assert {entry["name"] for entry in entries if entry not in asked} <= {system}


def test_lists_of_everything_join_the_lists_of_the_systems(capsys):
    for command in ("claims", "quantities"):
        parts = [entry for system in SYSTEMS for entry in listed(capsys, command, system.name)[1]]
        assert listed(capsys, command)[1] == parts


def test_columns_are_aligned(capsys):
    lines, entries = listed(capsys, "claims")
    for entry, line in zip(entries, lines, strict=True):
        assert line.index(entry["title"]) == lines[0].index(entries[0]["title"])


def test_an_unknown_system_suggests_the_nearest(capsys):
    assert main(["claims", "varational"]) == 2
    assert "did you mean variational?" in capsys.readouterr().err


def test_data_lists_the_shipped_networks(capsys):
    _, entries = listed(capsys, "data")
    assert {"graph": "sndlib_polska", "nodes": 12, "edges": 18} in entries


@pytest.fixture
def certificate(tmp_path, run):
    path = tmp_path / "a.json"
    assert run("certify", "toy.small", "--set", "h=0.5", "--out", path)[0] == 0
    return path


@pytest.mark.parametrize("options", [[], ["--json"]])
def test_check_says_what_the_checker_by_itself_says(run, certificate, options):
    status, out, err = run("check", certificate, *options)
    command = [sys.executable, "-I", "-S", str(CHECKER), str(certificate), *options]
    alone = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (status, out, err) == (alone.returncode, alone.stdout, alone.stderr.splitlines())
    assert status == 0


def test_check_exits_1_for_a_false_and_2_for_an_unreadable_certificate(run, certificate, tmp_path):
    text = certificate.read_text()
    forged = tmp_path / "forged.json"
    forged.write_text(text.replace('"1/10"', '"5"'))
    half = tmp_path / "half.json"
    half.write_text(text[: len(text) // 2])
    assert run("check", forged)[0] == 1
    assert run("check", half)[0] == 2
    assert run("check", certificate, forged)[0] == 1
    assert run("check", tmp_path / "none.json")[0] == 2
    assert run("check", "--", certificate)[0] == 0


def test_check_takes_other_statements_and_refuses_unreadable_ones(run, certificate, tmp_path):
    empty = tmp_path / "statements.json"
    empty.write_text("{}")
    assert run("check", certificate, "--statements", empty)[0] == 1
    status, _, err = run("check", certificate, "--statements", tmp_path / "none.json")
    assert status == 2
    assert err[0].startswith("sensortrack: --statements: ")
