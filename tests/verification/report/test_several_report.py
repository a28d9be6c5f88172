"""Pages and figures of runs of several targets, at the ends of what can happen."""

import json

import numpy as np
import pytest

from sensortrack.plots import save_run
from sensortrack.simulation import simulate
from sensortrack.simulation.scenario import scenario_of
from tests.sensortrack.test_spsa_simulation import changed
from tests.verification.report.test_report import HOSTILE, Page, built
from verification.cli.main import main
from verification.cli.simulate import lines_of
from verification.report.several_figures import several_figures
from verification.report.several_tables import metres
from verification.systems.cyclic_spsa.envelopes import expectations

SHORT = (("duration_s",), 3.0)
ALONE = (("baselines",), [])


def record(*changes):
    run = simulate(scenario_of("toy", changed(SHORT, (("summary_from_s",), 1.0), *changes)))
    data = run.to_data() | {"bounds": []}
    return data | {"expected": expectations(data)}


def pages(folder, data):
    text = json.dumps(data, allow_nan=False)
    (folder / "run.json").write_text(text)
    html, markdown = built(folder)
    assert "nan" not in html.replace("nance", "")
    assert html.count('role="img"') == html.count("<figure")
    assert save_run(data, folder)
    return html, markdown, "\n".join(lines_of(data))


@pytest.mark.parametrize(
    "changes,said",
    [
        ([(("estimator", "beta_m"), 0.001), ALONE], "it diverged"),
        ([(("duration_s",), 0.1), (("summary_from_s",), 0.0), ALONE], "nothing diverged"),
        ([(("noise",), {"kind": "none"}), ALONE], "nothing diverged"),
        ([(("estimator", "reach_m"), 190.0), (("estimator", "n_max"), 0)], "nothing diverged"),
        ([(("target",), [{"kind": "line"}]), ALONE], "nothing diverged"),
    ],
    ids=["diverged", "before an update", "no noise", "short reach", "one target"],
)
def test_every_run_has_pages_without_a_number_that_is_none(tmp_path, changes, said):
    html, markdown, text = pages(tmp_path, record(*changes))
    assert said in html
    assert said in markdown
    assert "nan" not in text


def test_a_run_with_failing_sensors_has_no_expectation(tmp_path):
    fault = [{"kind": "lost", "sensor": "a", "from_s": 1.0}]
    data = record((("fault",), fault), ALONE)
    assert data["expected"] == []
    html, _, _ = pages(tmp_path, data)
    assert "sensor a measures nothing" in html


def test_names_are_only_shown(tmp_path):
    data = record((("target", 0, "name"), HOSTILE), ALONE, (("variant",), [{"name": HOSTILE}]))
    html, markdown, _ = pages(tmp_path, data)
    assert "img" not in Page(html).tags
    assert "<img" not in markdown.replace("\\<", "")


@pytest.mark.parametrize(
    "value,text",
    [
        (None, "–"),
        (0.0, "0"),
        (182.0, "182"),
        (0.694, "0.694"),
        (99.9996, "100"),
        (9999.4, "9999"),
        (9999.6, "10\u202f000"),
        (117949.0, "117\u202f900"),
        (-53.12, "-53.12"),
        (1e-5, "1e-05"),
        (2e20, "2e+20"),
    ],
)
def test_lengths_have_four_digits_and_no_exponent_where_there_is_room(value, text):
    assert metres(value) == text


def test_curves_of_one_sensor_keep_the_mean_square_of_the_run():
    """Windows, as single errors hide each other: start, then the same squares in fewer points."""
    data = record((("duration_s",), 24.0), ALONE)
    figure = dict(several_figures(data))["error-by-sensor"]
    level = np.array(data["estimates"][0]["by_sensor"][0], dtype=float)
    curve = figure.curves[0]
    assert curve.y[0] == level[0]
    assert 50 < len(curve.y) < 70
    width = len(level) // 60
    squares = np.array(curve.y[1:]) ** 2
    assert squares.mean() == pytest.approx((level[1 : 1 + width * len(squares)] ** 2).mean())


def test_every_setting_is_on_the_page(tmp_path):
    names = [{"name": "calm"}, {"name": "bold", "beta_m": 7.5, "m_max": 1, "reading": "one"}]
    html, markdown, _ = pages(tmp_path, record(ALONE, (("variant",), names)))
    said = "alpha 0.3, beta 7.5 m, reading one, n_max 1, m_max 1"
    assert said in html
    assert said.replace("_", "\\_") in markdown or said in markdown


@pytest.mark.parametrize("where", ["spsa", "summary", "estimates"])
def test_a_run_whose_parts_do_not_fit_is_refused(tmp_path, capsys, where):
    data = record(ALONE, (("variant",), [{"name": "calm"}, {"name": "bold"}]))
    part = data[where]["variants"] if where == "spsa" else data[where]
    part[0]["estimate" if where == "summary" else "name"] = "gone"
    (tmp_path / "run.json").write_text(json.dumps(data))
    assert main(["report", str(tmp_path)]) == 2
    assert "internal" not in capsys.readouterr().err
