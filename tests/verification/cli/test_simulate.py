"""``sensortrack simulate``: what it writes, what it says, what it refuses."""

import json

import pytest

from sensortrack.simulation import shipped_scenarios
from verification.cli.main import main

TOY = """
title = "A toy"
about = "A circle."
duration_s = 3.0
[target]
kind = "helix"
radius_m = 5.0
rate_radps = 0.8
[[sensor]]
name = "a"
position_m = [9.0, 0.0, 0.0]
[[sensor]]
name = "b"
position_m = [0.0, 9.0, 0.0]
[[fault]]
kind = "lost"
sensor = "b"
from_s = 1.5
[noise]
kind = "uniform"
position_m = 0.2
velocity_mps = 0.1
[estimator]
system = "variational"
M = 1.0
K = 4.0
C = 3.0
h_s = 0.05
start_offset_m = [1.0, 0.0, 0.0]
"""


@pytest.fixture
def toy(tmp_path):
    path = tmp_path / "toy.toml"
    path.write_text(TOY)
    return path


def test_a_run_leaves_its_data_figures_and_pages(toy, tmp_path, capsys):
    out = tmp_path / "out"
    assert main(["simulate", str(toy), "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert "sensor b no longer sees the target" in said
    assert said.count("held, reached") == 2
    names = {path.name for path in out.iterdir()}
    assert names == {
        *("run.json", "tracks.csv", "errors.csv", "figures", "report.html", "report.md")
    }
    run = json.loads((out / "run.json").read_text())
    assert all(bound["holds"] and bound["smallest_slack"] >= 0 for bound in run["bounds"])
    assert len((out / "errors.csv").read_text().splitlines()) == 1 + 61 * 3
    assert len(list((out / "figures").glob("*.svg"))) == 8
    assert "every proved bound held" in (out / "report.html").read_text()


def test_the_same_seed_writes_the_same_bytes(toy, tmp_path):
    for folder in ("x", "y"):
        main(["simulate", str(toy), "--out", str(tmp_path / folder), "--seed", "4"])
    for path in sorted((tmp_path / "x").rglob("*.*")):
        other = tmp_path / "y" / path.relative_to(tmp_path / "x")
        assert path.read_bytes() == other.read_bytes(), path.name


def test_json_is_one_document_and_report_builds_the_page_again(toy, tmp_path, capsys):
    out = tmp_path / "out"
    assert main(["simulate", str(toy), "--out", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["name"] == "toy"
    page = (out / "report.html").read_bytes()
    (out / "report.html").unlink()
    assert main(["report", str(out)]) == 0
    assert (out / "report.html").read_bytes() == page


def test_a_run_is_written_over_an_earlier_one_and_over_nothing_else(toy, tmp_path, capsys):
    out = tmp_path / "out"
    assert main(["simulate", str(toy), "--out", str(out)]) == 0
    assert main(["simulate", str(toy), "--out", str(out)]) == 0
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").write_text("mine")
    for target in (tmp_path / "mine", toy, toy / "below"):
        assert main(["simulate", str(toy), "--out", str(target)]) == 2
        assert capsys.readouterr().err.startswith("sensortrack: --out: ")


@pytest.mark.parametrize(
    "arguments,name",
    [
        (("nowhere.toml",), "scenario"),
        (("sanyal_section_5",), "scenario"),
        (("sanyal_section_4", "--seed", "-1"), "--seed"),
    ],
)
def test_bad_input_is_refused_by_name(tmp_path, capsys, arguments, name):
    assert main(["simulate", *arguments, "--out", str(tmp_path / "o")]) == 2
    assert capsys.readouterr().err.startswith(f"sensortrack: {name}: ")
    assert not (tmp_path / "o").exists()


BEARINGS = """
title = "Bearings"
about = "A line."
duration_s = 0.6
[target]
kind = "line"
start_m = [0.0, 5.0, 0.0]
velocity_mps = [4.0, 1.0, 0.0]
[placement]
kind = "ring"
count = 5
size_m = 50.0
[network]
family = "cycle:5"
[[outage]]
link = ["1", "2"]
from_s = 0.3
[estimator]
system = "bearing_dac"
beta_P = 20.0
beta_q = 1000.0
h_s = 0.02
"""


def test_bearings_have_their_own_figures_and_no_number_where_there_is_none(tmp_path, capsys):
    path, out = tmp_path / "bearings.toml", tmp_path / "out"
    path.write_text(BEARINGS)
    assert main(["simulate", str(path), "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert said.count("held, reached") == 3
    assert "link between 1 and 2 carries nothing" in said
    assert "nan" not in said
    names = {figure.stem for figure in (out / "figures").glob("*.svg")}
    assert {"tracks", "disagreement_on_P", "disagreement_on_q", "position_bound"} <= names
    assert "velocity_error" not in names
    page = (out / "report.html").read_text()
    assert "figure-disagreement-on-q" in page
    assert "figure-velocity-error" not in page
    assert "nan" not in page.replace("nance", "")
    assert "NaN" not in (out / "run.json").read_text()


def test_a_run_in_which_nobody_ever_knows_has_a_page_that_says_so(tmp_path, capsys):
    """Target and sensors on one line: a status at every sample, and no number anywhere."""
    sensors = "".join(
        f'[[sensor]]\nname = "{name}"\nposition_m = [{x}.0, 0.0, 0.0]\n'
        for name, x in zip("abc", (0, 10, 20), strict=True)
    )
    text = BEARINGS.replace('kind = "ring"\ncount = 5\nsize_m = 50.0\n', "")
    text = text.replace("[placement]\n", sensors).replace("cycle:5", "path:3")
    text = text.replace('[[outage]]\nlink = ["1", "2"]\nfrom_s = 0.3\n', "")
    text = text.replace("start_m = [0.0, 5.0, 0.0]", "start_m = [90.0, 0.0, 0.0]")
    text = text.replace("[4.0, 1.0, 0.0]", "[1.0, 0.0, 0.0]")
    path, out = tmp_path / "line.toml", tmp_path / "out"
    path.write_text(text)
    assert main(["simulate", str(path), "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert "no sample at which every sensor has a position" in said
    assert "nan" not in said
    assert "position error unknown" in (out / "report.html").read_text()
    assert "position error unknown" in (out / "report.md").read_text()


TARGETS = """
title = "Two targets"
about = "Lines."
duration_s = 4.0
summary_from_s = 2.0
[[target]]
kind = "line"
start_m = [0.0, 90.0, 0.0]
[[target]]
name = "<b>east</b>"
kind = "line"
start_m = [80.0, 10.0, 0.0]
[placement]
kind = "ring"
count = 3
size_m = 150.0
[noise]
kind = "gaussian"
bearing_deg = 1.0
range_relative = 0.01
[start]
low_m = [100.0, 100.0, 0.0]
high_m = [110.0, 110.0, 0.0]
[[variant]]
name = "calm"
[[variant]]
name = "wild"
beta_m = 0.001
[estimator]
system = "cyclic_spsa"
h_s = 0.05
alpha = 0.4
beta_m = 5.0
n_max = 1
m_max = 1
"""


def test_several_targets_have_a_table_of_settings_beside_what_was_expected(tmp_path, capsys):
    path, out = tmp_path / "targets.toml", tmp_path / "out"
    path.write_text(TARGETS)
    assert main(["simulate", str(path), "--out", str(out)]) == 0
    said = capsys.readouterr().out
    assert "wild has diverged: its error passes 10000 km" in said
    assert "alpha/limit" in said
    assert "nan" not in said
    run = json.loads((out / "run.json").read_text())
    beside = {entry["of"]: entry for entry in run["expected"]}
    assert beside["calm"]["alpha"] < beside["calm"]["limit"]
    assert beside["wild"]["alpha"] > 1000 * beside["wild"]["limit"]
    html, text = ((out / f"report.{end}").read_text() for end in ("html", "md"))
    for words in (
        "rms with calm; one of two settings diverged",
        "Kalman filters",
        "alpha over its",
    ):
        assert words in html
        assert words in text
    assert html.count('role="img"') == 6
    assert "<b>east</b>" not in html
    assert "NaN" not in (out / "run.json").read_text() + html.replace("nance", "")
    assert len(list((out / "figures").glob("*.svg"))) == 5
    head, *rows = (out / "errors.csv").read_text().splitlines()
    assert head == "time_s,estimate,sensor,target,position_error_m"
    assert len([row for row in rows if ",calm," in row]) == 81 * 6
    assert main(["report", str(out)]) == 0
    assert (out / "report.html").read_text() == html
    capsys.readouterr()
    assert main(["simulate", str(path), "--out", str(out), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["expected"][1]["rms"] is None


@pytest.mark.parametrize("name", [n for n in shipped_scenarios() if n.startswith("solent")])
def test_every_bound_is_on_the_right_side_of_a_recorded_track(tmp_path, name):
    out = tmp_path / "out"
    assert main(["simulate", name, "--out", str(out)]) == 0
    run = json.loads((out / "run.json").read_text())
    assert {bound["quantity"] for bound in run["bounds"]} == {"position error", "velocity error"}
    assert all(bound["holds"] for bound in run["bounds"])
    rms = {row["estimate"]: row["position_rms"] for row in run["summary"]}
    assert rms["variational"] < rms["raw"]
    assert rms["kalman"] < rms["raw"]
