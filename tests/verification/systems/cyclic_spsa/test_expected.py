"""What is expected of a run is what runs do on average, and at rest what the closed form says."""

import copy
from dataclasses import replace

import numpy as np
import pytest

from sensortrack.simulation import read_scenario, simulate
from sensortrack.simulation.scenario import scenario_of
from tests.sensortrack.test_spsa_simulation import BASE, changed
from verification.statistics import mean_interval
from verification.systems.cyclic_spsa.envelopes import envelopes, expectations
from verification.systems.cyclic_spsa.running.expected import setting_of

SEEDS = range(40)
TIMES = (12, 25, 60)
SHORT = ((("duration_s",), 6.0), (("baselines",), []), (("summary_from_s",), 3.0))


def test_runs_do_on_average_what_is_expected_of_them():
    """Both readings, one start: intervals at all times and of both settings hold what is said."""
    variant = [{"name": "two"}, {"name": "one", "reading": "one"}]
    corner = {"low_m": [100.0, 90.0, 0.0], "high_m": [100.0, 90.0, 0.0]}
    data = changed(*SHORT, (("variant",), variant), (("start",), corner))
    scenario = scenario_of("toy", data)
    runs = [simulate(scenario, seed) for seed in SEEDS]
    expected = expectations(runs[0].to_data())
    level = 1 - 0.001 / (len(variant) * len(TIMES))
    for entry in expected:
        for k in TIMES:
            squares = [run.errors(entry["of"])[0][k] ** 2 for run in runs]
            found = mean_interval(squares, level)
            assert found.holds(entry["value"][k] ** 2), (entry["of"], k)
            assert found.relative_width < 0.8


def test_the_limit_is_the_step_at_which_the_expectation_stops_to_shrink():
    """Resting targets, no noise: just below the limit the mean square dies, above it grows."""
    data = changed(*SHORT, (("duration_s",), 24.0), (("estimator", "m_max"), 3))
    data["target"] = [{"kind": "line", "velocity_mps": [0, 0, 0], "start_m": [0, 9, 0]}] * 3
    data["target"] = [
        dict(entry, start_m=[0, 9.0 * k, 0]) for k, entry in enumerate(data["target"])
    ]
    data["noise"] = {"kind": "none"}
    (found,) = expectations(simulate(scenario_of("toy", data)).to_data())
    ends = []
    for share in (0.9, 1.1):
        other = copy.deepcopy(data)
        other["estimator"]["alpha"] = share * found["limit"]
        other["estimator"]["diverged_m"] = 1e30
        (entry,) = expectations(simulate(scenario_of("toy", other)).to_data())
        assert entry["alpha"] / entry["limit"] == pytest.approx(share)
        ends.append(np.array(entry["value"], dtype=float))
    assert ends[0][-1] < 0.05 * ends[0][0]
    assert ends[1][-1] > ends[1][-100]


def test_what_diverges_is_expected_to_and_has_no_number():
    run = simulate(scenario_of("toy", changed(*SHORT, (("estimator", "beta_m"), 0.01)))).to_data()
    (found,) = expectations(run)
    assert found["rms"] is None
    assert found["settled"] is None
    assert found["value"][-1] is None
    assert found["alpha"] > found["limit"]
    assert envelopes(run) == []


def test_before_the_first_update_the_start_is_all_there_is():
    run = simulate(scenario_of("toy", changed(*SHORT))).to_data()
    (found,) = expectations(run)
    assert found["value"][:2] == pytest.approx(run["estimates"][0]["error"][:2], rel=1e-5)
    assert BASE["estimator"]["alpha"] == found["alpha"]


def shortened(name, length, slow):
    """A shipped scenario without baselines and some settings, its last sixth counted."""
    scenario = read_scenario(name)
    header = replace(scenario.header, duration_s=length, summary_from_s=length * 5 / 6)
    kept = tuple(entry for entry in scenario.parts["variant"] if entry.name not in slow)
    parts = {**scenario.parts, "variant": kept}
    return replace(scenario, header=replace(header, baselines=()), parts=parts)


@pytest.mark.parametrize(
    "name,length,slow,settles,lost",
    [
        (
            *("erofeeva_section_5", 240.0, ("one instant, m_max 3", "one instant, m_max 1")),
            *({"one instant, m_max 6"}, 3),
        ),
        (
            *("spsa_solent", 300.0, ("two instants, one target at a time",)),
            *({"two instants", "one instant"}, 1),
        ),
    ],
    ids=["erofeeva_section_5", "spsa_solent"],
)
def test_shipped_scenarios_do_what_their_words_say(name, length, slow, settles, lost):
    """What settles does so near the expected time and error; the published step sizes diverge."""
    run = simulate(shortened(name, length, slow)).to_data()
    beside = {entry["of"]: entry for entry in expectations(run)}
    rows = {row["estimate"]: row for row in run["summary"]}
    assert {key for key, row in rows.items() if row["settled"] is not None} == settles
    for key in settles:
        assert rows[key]["settled"] == pytest.approx(beside[key]["settled"], rel=0.4)
        assert rows[key]["position_rms"] == pytest.approx(beside[key]["rms"], rel=0.3)
    diverged = {key for key, row in rows.items() if row["diverged"] is not None}
    assert len(diverged) == lost
    assert all(beside[key]["alpha"] > 1000 * beside[key]["limit"] for key in diverged)
    assert all(rows[key]["diverged"] < 13 for key in diverged)
    assert {event["of"] for event in run["events"]} == diverged


def test_paths_between_kept_samples_are_those_that_were_run():
    """More samples than are kept: what lies between, and after the last, is the path again."""
    scenario = scenario_of("toy", changed((("duration_s",), 70.7), (("estimator", "h_s"), 0.1)))
    run = simulate(replace(scenario, header=replace(scenario.header, baselines=()))).to_data()
    assert len(run["time"]) < run["samples"]
    assert run["time"][-1] < 70.65
    paths = setting_of(run, run["spsa"]["variants"][0]).paths
    truth = scenario.target.at(0.1 * np.arange(708))[0][..., :2]
    assert np.abs(paths - truth).max() < 1e-4
