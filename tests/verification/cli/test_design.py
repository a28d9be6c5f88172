"""``sensortrack design``: what is printed can be given back to the other commands."""

import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from verification.certificates import check
from verification.cli.main import main
from verification.systems import SYSTEMS

WISH = ["design", "variational", "--set", "decay=0.5", "--set", "h=0.1"]


def test_gains_and_certificate_are_written_and_serve_as_params(tmp_path, capsys):
    out = tmp_path / "new" / "chosen"
    assert main([*WISH, "--out", str(out), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert {"system", "gains", "objective", "bound", "certificate"} <= {*said}
    assert json.loads((out / "gains.json").read_text()) == said["gains"]
    checked = [sys.executable, "-I", "-S", check.__file__, said["certificate"]]
    assert subprocess.run(checked, capture_output=True, check=False).returncode == 0
    assert main(["certify", "variational.step", "--params", str(out / "gains.json")]) == 0


def test_a_step_for_given_gains(capsys):
    given = ["--set", "M=[[2, 0.3], [0.3, 1]]", "--set", 'K="1/3"', "--set", "C=1", "--json"]
    assert main(["design", "variational", *given]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["gains"]["K"] == [["1/3", 0], [0, "1/3"]]
    assert 0 < said["gains"]["h"] < said["bound"]["step_limit"]
    assert said["certificate"] is None


def test_gains_beyond_the_largest_double_get_no_step(capsys):
    given = ["--set", "M=1e400", "--set", "K=1e400", "--set", "C=1"]
    assert main(["design", "variational", *given]) == 3
    assert "largest double" in capsys.readouterr().out


def test_a_gain_below_the_smallest_double_is_given_back_as_text(capsys):
    given = ["--set", "M=1", "--set", "K=1", "--set", "C=1e-400", "--json"]
    assert main(["design", "variational", *given]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["gains"]["C"] == [["1/1" + 400 * "0"]]


@pytest.mark.parametrize("name", ["decay", "h", "chi", "nu", "noise"])
@pytest.mark.parametrize("value", ["1e400", "1e-400"])
def test_a_wish_beyond_the_doubles_is_refused(capsys, name, value):
    wish = {"decay": "1", "h": "0.1", name: value}
    given = [text for key, given in wish.items() for text in ("--set", f"{key}={given}")]
    assert main(["design", "variational", *given]) == 2
    assert capsys.readouterr().err.startswith(f"sensortrack: {name}:")


def test_a_reader_sees_lines(capsys):
    assert main(WISH) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "variational: gains for a decay"
    assert any(line.split()[:2] == ["decay", "0.5"] for line in lines)


def test_nothing_found_is_no_answer_and_writes_nothing(tmp_path, capsys):
    out = tmp_path / "chosen"
    assert main([*WISH, "--set", "noise=1e-9", "--out", str(out)]) == 3
    assert "no gains" in capsys.readouterr().out
    assert not out.exists()


@pytest.mark.parametrize(
    "arguments, name, word",
    [
        (["variationel"], "variationel", "variational"),
        (["bearing_dac"], "input", "nothing given"),
        (["variational"], "input", "nothing given"),
        (["variational", "--set", "deca=1"], "deca", "decay"),
        (["variational", "--set", "decay=1"], "input", "decay given"),
        (["variational", "--set", "decay=1", "--set", "h=x"], "h", "number"),
        (["variational", "--set", "M=1", "--set", "K=-1", "--set", "C=1"], "K", "definite"),
    ],
)
def test_misuse_names_the_input(capsys, arguments, name, word):
    assert main(["design", *arguments]) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"sensortrack: {name}:")
    assert word in said


def test_a_system_without_choices_says_so(capsys, monkeypatch):
    monkeypatch.setitem(SYSTEMS, "toy", SimpleNamespace(design=None))
    assert main(["design", "toy"]) == 2
    assert capsys.readouterr().err.startswith("sensortrack: toy: nothing to choose;")


def test_a_folder_that_holds_something_is_refused(tmp_path, capsys):
    (tmp_path / "mine.txt").write_text("mine")
    assert main([*WISH, "--out", str(tmp_path)]) == 2
    assert "not empty" in capsys.readouterr().err
    assert [path.name for path in Path(tmp_path).iterdir()] == ["mine.txt"]
