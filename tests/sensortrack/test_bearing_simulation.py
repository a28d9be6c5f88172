"""Scenarios of bearing sensors: what they place, lose, report and refuse."""

import copy
import json
from dataclasses import replace

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.simulation import read_scenario, simulate
from sensortrack.simulation.bearings import seen_by
from sensortrack.simulation.scenario import scenario_of

BASE = {
    "title": "A toy",
    "about": "A line.",
    "duration_s": 1.0,
    "target": {"kind": "line", "start_m": [0.0, 5.0, 0.0], "velocity_mps": [4.0, 1.0, 0.0]},
    "sensor": [
        {"name": "a", "position_m": [-40.0, 0.0, 0.0]},
        {"name": "b", "position_m": [0.0, 50.0, 0.0]},
        {"name": "c", "position_m": [45.0, -5.0, 0.0]},
        {"name": "d", "position_m": [5.0, -40.0, 0.0]},
    ],
    "network": {"family": "cycle:4"},
    "estimator": {"system": "bearing_dac", "beta_P": 20.0, "beta_q": 1000.0, "h_s": 0.02},
}


def changed(*changes):
    data = copy.deepcopy(BASE)
    for path, value in changes:
        place = data
        for key in path[:-1]:
            place = place[key]
        if value is None:
            del place[path[-1]]
        else:
            place[path[-1]] = copy.deepcopy(value)
    return data


def run(*changes, seed=None):
    return simulate(scenario_of("toy", changed(*changes)), seed)


def test_without_noise_the_implicit_run_is_exact_and_explicit_steps_are_not():
    found = run()
    place, _ = found.errors("bearing_dac")
    assert place[found.time >= 0.2].max() < 1e-11
    explicit = found.estimates["explicit"][0]
    off = found.errors("explicit")[0][found.time >= 0.2]
    assert np.isnan(explicit).any() or np.nanmax(off) > 1.0
    assert found.errors("least_squares")[0].max() < 1e-11
    assert found.errors("linear")[0][-1] > 1e-6
    assert set(found.estimates) == {"bearing_dac", "explicit", "linear", "least_squares", "ekf"}


def test_before_there_is_information_the_run_has_a_status_and_no_number():
    data = run().to_data()
    assert data["estimates"][0]["position"][0] == [None, None, None]
    assert data["agents"]["known"][0] == 0
    assert data["agents"]["worst"][0] is None
    assert any("P_x is singular" in note for note in data["notes"])
    assert data["summary"][0]["velocity_rms"] is None
    assert "NaN" not in json.dumps(data)


def test_a_run_in_which_nobody_ever_has_a_position_says_so():
    """Sensors and target on one line: every bearing is parallel to every other."""
    line = [{"name": n, "position_m": [x, 0.0, 0.0]} for n, x in zip("abcd", range(4), strict=True)]
    target = {"kind": "line", "start_m": [90.0, 0.0, 0.0], "velocity_mps": [1.0, 0.0, 0.0]}
    found = run((("sensor",), line), (("target",), target), (("baselines",), ["least_squares"]))
    assert np.isnan(found.estimates["bearing_dac"][0]).all()
    assert np.isnan(found.estimates["least_squares"][0]).all()
    assert found.events[-1]["kind"] == "no_position"
    assert found.summary[0]["position_rms"] is None


def test_a_target_on_a_sensor_is_a_missing_bearing():
    target = {"kind": "line", "start_m": [-40.0, 0.0, 0.0], "velocity_mps": [0.0, 0.0, 0.0]}
    late = {"kind": "line", "start_m": [-60.0, 0.0, 0.0], "velocity_mps": [40.0, 0.0, 0.0]}
    first = run((("target",), target), (("baselines",), []))
    assert any("no bearing from a" in note for note in first.notes)
    passing = run((("target",), late), (("baselines",), []))
    (note,) = [note for note in passing.notes if "no bearing from a" in note]
    assert "(1 sample, first at 0.5 s)" in note


def test_noisy_sensors_on_one_line_that_the_target_crosses_give_no_error_of_the_program():
    line = [{"name": n, "position_m": [20.0 * k, 0.0, 0.0]} for k, n in enumerate("abcd")]
    path = {"kind": "line", "start_m": [20.0, -10.0, 0.0], "velocity_mps": [0.0, 20.0, 0.0]}
    found = run(
        (("sensor",), line),
        (("target",), path),
        (("noise",), {"kind": "gaussian", "bearing_deg": 0.1}),
    )
    assert any("to first order" in note for note in found.notes)
    assert np.isfinite(found.estimates["ekf"][0][-1]).all()
    still = path | {"start_m": [90.0, 0.0, 0.0], "velocity_mps": [0.0, 0.0, 0.0]}
    found = run(
        (("sensor",), line),
        (("target",), still),
        (("noise",), {"kind": "gaussian", "bearing_deg": 1e-9}),
    )
    assert any("no position to first order" in note for note in found.notes)


@pytest.mark.parametrize("rate", [0.3, 0.9])
def test_dropouts_keep_the_average_and_come_from_the_seed(rate):
    options = ((("dropout",), {"rate": rate}), (("baselines",), []))
    one, again, other = (run(*options, seed=s).to_data() for s in (1, 1, 2))
    assert json.dumps(one) == json.dumps(again)
    assert one["consensus"]["graph"] != other["consensus"]["graph"]
    carried = np.mean([len(one["consensus"]["graphs"][g]) / 4 for g in one["consensus"]["graph"]])
    assert carried == pytest.approx(1 - rate, abs=0.12)


def test_another_sensor_leaves_the_draws_of_the_others_as_they_are():
    noise = (("noise",), {"kind": "gaussian", "bearing_deg": 1.0})
    more = [{"name": "e", "position_m": [60.0, 60.0, 0.0]}, *BASE["sensor"]]
    four = scenario_of("toy", changed(noise))
    five = scenario_of(
        "toy", changed(noise, (("sensor",), more), (("network",), {"family": "cycle:5"}))
    )
    time = np.linspace(0, 1, 20)
    one, two = (seen_by(s, 3, time, s.target.at(time)[0][:, :2]) for s in (four, five))
    assert one.tobytes() == np.ascontiguousarray(two[:, 1:]).tobytes()
    size = np.std(one - seen_by(scenario_of("toy", BASE), 3, time, four.target.at(time)[0][:, :2]))
    assert np.rad2deg(size) == pytest.approx(1.0, rel=0.25)


def test_uniform_noise_stays_within_its_size():
    found = run((("noise",), {"kind": "uniform", "bearing_deg": 0.5}), (("baselines",), ["ekf"]))
    assert 0 < found.errors("bearing_dac")[0][10:].max() < 60 * np.deg2rad(0.5) * 4


def test_outages_faults_and_leaving_are_events_and_the_rest_stay_exact():
    found = run(
        (("duration_s",), 2.0),
        (("baselines",), ["explicit", "linear"]),
        (("outage",), [{"link": ["b", "a"], "from_s": 0.3, "until_s": 0.6}]),
        (
            ("fault",),
            [
                {"kind": "nan", "sensor": "b", "from_s": 0.7, "until_s": 0.8},
                {"kind": "leaves", "sensor": "c", "from_s": 1.0, "until_s": 1.5},
            ],
        ),
    )
    kinds = [event["kind"] for event in found.events]
    assert kinds == [
        *("position", "link_lost", "link_back", "sensor_nan", "sensor_back"),
        *("sensor_leaves", "sensor_back"),
    ]
    place, _ = found.errors("bearing_dac")
    settled = (found.time > 0.9) & ((found.time < 1.0) | (found.time > 1.1))
    settled &= (found.time < 1.49) | (found.time > 1.6)
    assert place[settled].max() < 1e-10
    record = found.to_data()["consensus"]
    assert [who for _, who in record["present"]] == [[0, 1, 2, 3], [0, 1, 3], [0, 1, 2, 3]]


def test_who_fails_biases_the_others():
    fault = {"kind": "fails", "sensor": "c", "from_s": 0.5}
    found = run((("fault",), [fault]), (("baselines",), []))
    assert found.extra["consensus"]["biased"]
    assert found.errors("bearing_dac")[0][-1] > 1e-3


def test_who_leaves_without_neighbours_is_noted_and_the_last_one_stays():
    gone = [
        {"kind": "leaves", "sensor": "a", "from_s": 0.2},
        {"kind": "leaves", "sensor": "b", "from_s": 0.4},
    ]
    star = (("network", "family"), "star:4"), (("baselines",), [])
    found = run(*star, (("fault",), gone))
    assert any("b has nobody to hand over to" in note for note in found.notes)
    assert found.extra["consensus"]["biased"]
    everyone = [{"kind": "fails", "sensor": name, "from_s": 0.5} for name in "abcd"]
    with pytest.raises(InputError, match="is the last"):
        run(*star, (("fault",), everyone))


@pytest.mark.parametrize(
    "network,links",
    [
        ({"links": [["a", "b"], ["b", "c"], ["d", "c"]]}, [[0, 1], [1, 2], [2, 3]]),
        ({"family": "star:4"}, [[0, 1], [0, 2], [0, 3]]),
        ({"radius_m": 65.0}, [[0, 1], [0, 3], [2, 3]]),
    ],
)
def test_networks_are_named_by_the_sensors(network, links):
    data = run((("network",), network), (("baselines",), []), (("duration_s",), 0.02)).to_data()
    assert sorted(data["links"]) == links


@pytest.mark.parametrize(
    "placement,network,count",
    [
        ({"kind": "ring", "count": 6, "size_m": 80.0}, {"family": "cycle:6"}, 6),
        ({"kind": "random", "count": 30, "size_m": 200.0, "seed": 1}, {"radius_m": 70.0}, 30),
        ({"kind": "network", "size_m": 500.0}, {"data": "sndlib_polska"}, 12),
    ],
)
def test_sensors_are_placed_by_a_few_keys(placement, network, count):
    found = run(
        (("sensor",), None),
        (("placement",), placement),
        (("network",), network),
        (("baselines",), ["least_squares"]),
        (("duration_s",), 0.2),
        (("estimator", "beta_q"), 20000.0),
        (("estimator", "beta_P"), 300.0),
    )
    assert len(found.sensors) == count
    assert found.errors("bearing_dac")[0][-1] < 1e-9
    places = np.array([rows[0, :2] for rows in found.sensors.values()])
    size = placement["size_m"] * (2 if placement["kind"] == "ring" else 1)
    assert np.ptp(places, axis=0).max() <= size * (1 + 1e-12)


@pytest.mark.parametrize(
    "changes,name",
    [
        ([(("network",), None)], "network"),
        ([(("network",), {})], "network"),
        ([(("network",), {"family": "cycle:4", "radius_m": 9.0})], "network"),
        ([(("network",), {"family": "cycle:5"})], "network.family"),
        ([(("network",), {"family": "torso:4"})], "network.family"),
        ([(("network",), {"data": "nowhere"})], "network.data"),
        ([(("network",), {"radius_m": 5.0})], "network.radius_m"),
        ([(("network",), {"links": [["a", "z"]]})], "network.links"),
        ([(("network",), {"links": [["a"]]})], "network.links"),
        ([(("network",), {"links": "ab"})], "network.links"),
        ([(("network",), {"links": [["a", "a"]]})], "graph"),
        ([(("placement",), {"kind": "ring", "count": 4})], "placement"),
        ([(("sensor",), None), (("placement",), {"kind": "ring"})], "placement.count"),
        ([(("sensor",), None), (("placement",), {"kind": "heap"})], "placement.kind"),
        ([(("sensor",), None), (("placement",), {"kind": "network"})], "network.data"),
        ([(("sensor", 0, "velocity_mps"), [1.0, 0.0, 0.0])], "sensor.velocity_mps"),
        ([(("sensor", 0, "name"), "b")], "sensor.name"),
        ([(("noise",), {"kind": "pink"})], "noise.kind"),
        ([(("noise",), {"bearing_deg": 1.0})], "noise.kind"),
        ([(("noise",), {"kind": "gaussian", "bearing_deg": -1.0})], "noise.bearing_deg"),
        ([(("noise",), {"position_m": 1.0})], "noise.position_m"),
        ([(("dropout",), {"rate": 1.0})], "dropout.rate"),
        ([(("outage",), [{"link": ["a", "c"], "from_s": 0.0}])], "outage.link"),
        ([(("outage",), [{"link": ["a", "b"], "from_s": 1.0, "until_s": 0.5}])], "outage.until_s"),
        ([(("fault",), [{"kind": "melts", "sensor": "a", "from_s": 0.0}])], "fault.kind"),
        ([(("estimator", "beta_P"), 0.0)], "estimator.beta_P"),
        ([(("estimator", "sign"), "round")], "estimator.sign"),
        ([(("estimator", "origin"), "here")], "estimator.origin"),
        ([(("estimator", "shown"), "z")], "estimator.shown"),
        ([(("estimator", "missing"), "withdraw")], "estimator.missing"),
        ([(("estimator", "M"), 1.0)], "estimator.M"),
        ([(("estimator", "system"), 3)], "estimator.system"),
        ([(("baselines",), ["raw"])], "scenario.baselines"),
    ],
)
def test_what_contradicts_itself_is_refused_by_its_key(changes, name):
    with pytest.raises(InputError) as error:
        scenario_of("toy", changed(*changes))
    assert error.value.name == name


def test_the_poster_says_what_it_assumes_and_has_its_printed_gain():
    scenario = read_scenario("george_numerical")
    assert scenario.estimator.beta_P == pytest.approx(1 + 100 * 5**0.5 / 0.4, abs=0.005)
    assert any("lambda_2" in text for text in scenario.header.assumptions)


@pytest.mark.parametrize("name,length", [("george_numerical", 0.12), ("bearing_abilene", 12.0)])
def test_shipped_scenarios_do_what_their_words_say(name, length):
    """The first part of each: exact agreement, so that every sensor has what least squares has."""
    scenario = read_scenario(name)
    head = replace(scenario.header, duration_s=length, summary_from_s=length / 2)
    found = simulate(replace(scenario, header=head))
    rms = {row["estimate"]: row["position_rms"] for row in found.summary}
    assert rms["bearing_dac"] == pytest.approx(rms["least_squares"], rel=1e-6, abs=1e-11)
    explicit, off = found.estimates["explicit"][0], found.errors("explicit")[0]
    assert np.isnan(explicit).any() or np.nanmedian(off) > 10
    if name == "george_numerical":
        assert rms["bearing_dac"] < 1e-12


def test_steps_that_are_not_exact_are_noted():
    slow = (("estimator", "sign"), "isotropic"), (("estimator", "beta_q"), 50.0)
    found = run(*slow, (("network", "family"), "complete:4"), (("baselines",), []))
    assert any("steps within" in note for note in found.notes)
    assert found.errors("bearing_dac")[0][-1] < 1e-10


def test_a_network_comes_from_a_file_by_the_names_of_its_nodes(tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text("source,target\nd,a\na,c\nc,b\n")
    quick = (("baselines",), []), (("duration_s",), 0.02)
    data = run((("network",), {"file": str(path)}), *quick).to_data()
    assert sorted(data["links"]) == [[0, 2], [0, 3], [1, 2]]
    for text in ("source,target\na,z\n", "nothing"):
        path.write_text(text)
        with pytest.raises(InputError) as error:
            scenario_of("toy", changed((("network",), {"file": str(path)})))
        assert error.value.name == "network.file"
    path.write_text("source,target\na,b\n")
    with pytest.raises(InputError) as error:
        scenario_of("toy", changed((("network",), {"file": str(path)})))
    assert error.value.name == "network.file"
