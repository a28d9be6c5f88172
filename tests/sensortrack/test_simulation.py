"""Scenarios are checked before they run, and a run is the same for the same seed."""

import copy
import json
import tomllib
from importlib.resources import files

import numpy as np
import pytest

from sensortrack.data import TRACKS, load_track
from sensortrack.errors import InputError
from sensortrack.simulation import read_scenario, shipped_scenarios, simulate
from sensortrack.simulation.scenario import scenario_of
from sensortrack.targets import Helix, Line, Track, Weaving

BASE = {
    "title": "A toy",
    "about": "A line.",
    "duration_s": 2.0,
    "target": {"kind": "line", "velocity_mps": [1.0, 0.5, 0.0]},
    "sensor": [
        {"name": "a", "position_m": [0.0, 5.0, 0.0]},
        {"name": "b", "position_m": [5.0, 0.0, 0.0]},
    ],
    "noise": {"kind": "gaussian", "position_m": 0.1, "velocity_mps": 0.2},
    "estimator": {"system": "variational", "M": 1.0, "K": 2.0, "C": 2.0, "h_s": 0.05},
}


def changed(path, value):
    data = copy.deepcopy(BASE)
    place = data
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = copy.deepcopy(value)
    return data


@pytest.mark.parametrize("name", shipped_scenarios())
def test_every_shipped_scenario_is_read_and_says_what_it_assumes(name):
    scenario = read_scenario(name)
    assert scenario.header.assumptions
    assert sum(scenario.weights.values()) == pytest.approx(1)


def test_the_same_seed_gives_the_same_run_and_another_one_another():
    scenario = scenario_of("toy", BASE)
    first, again, other = (simulate(scenario, seed).to_data() for seed in (1, 1, 2))
    assert json.dumps(first) == json.dumps(again)
    assert first["estimates"] != other["estimates"]


def test_another_sensor_leaves_the_draws_of_the_others_as_they_are():
    more = changed(("sensor",), [*BASE["sensor"], {"name": "c", "position_m": [1.0, 1.0, 1.0]}])
    weights = {"a": 1e-9, "b": 1 - 1e-9}
    alone = copy.deepcopy(BASE)
    for data in (alone, more):
        for sensor in data["sensor"]:
            sensor["weight"] = weights.get(sensor["name"], 0.0) or 1e-12
    more["sensor"][1]["weight"] = 1 - 1e-9 - 1e-12
    one, two = (simulate(scenario_of("toy", d), 3).estimates["raw"][0] for d in (alone, more))
    assert one == pytest.approx(two, abs=1e-9)


def test_a_lost_sensor_and_a_broken_one_are_events():
    data = copy.deepcopy(BASE)
    data["fault"] = [
        {"kind": "lost", "sensor": "a", "from_s": 0.5, "until_s": 1.0},
        {"kind": "nan", "sensor": "b", "from_s": 0.8, "until_s": 0.9},
    ]
    run = simulate(scenario_of("toy", data))
    assert [event["time"] for event in run.events] == [0.5, 0.8, 0.9, 1.0]
    assert any("no sensor sees the target" in note for note in run.notes)
    raw = run.estimates["raw"][0]
    assert np.isnan(raw[[16, 17]]).all()
    assert np.isfinite(np.delete(raw, [16, 17], axis=0)).all()
    assert np.isfinite(run.estimates["variational"][0]).all()
    assert json.loads(json.dumps(run.to_data()))["estimates"][2]["position"][16] == [None] * 3


def test_differenced_velocities_are_differences_of_positions():
    run = simulate(scenario_of("toy", changed(("estimator", "velocity"), "differenced")))
    place, rate = run.estimates["raw"]
    assert rate[1:] == pytest.approx(np.diff(place, axis=0) / 0.05, abs=1e-9)


def test_noise_has_the_size_and_kind_that_was_asked_for():
    data = changed(("duration_s",), 200.0)
    data["sensor"] = data["sensor"][:1]
    for kind, spread in (("gaussian", 0.1), ("uniform", 0.1 / 3**0.5)):
        data["noise"]["kind"] = kind
        place, _ = simulate(scenario_of("toy", data)).errors("raw")
        assert np.sqrt(np.mean(place**2) / 3) == pytest.approx(spread, rel=0.03)
        if kind == "uniform":
            assert place.max() <= 0.1 * 3**0.5


@pytest.mark.parametrize(
    "path,value,name",
    [
        (("duration_s",), -1.0, "scenario.duration_s"),
        (("duration",), 1.0, "scenario.duration"),
        (("duration_s",), True, "scenario.duration_s"),
        (("title",), 3, "scenario.title"),
        (("seed",), 1.5, "scenario.seed"),
        (("target", "kind"), "spiral", "target.kind"),
        (("target", "velocity_mps"), [1.0, 2.0], "target.velocity_mps"),
        (("target", "speed"), 1.0, "target.speed"),
        (("sensor",), [], "sensor"),
        (("sensor",), BASE["sensor"][:1] * 2, "sensor.name"),
        (("sensor", 0, "positon_m"), [0, 0, 0], "sensor.positon_m"),
        (("sensor", 0, "weight"), 0.7, "weights"),
        (("noise", "kind"), "pink", "noise.kind"),
        (("noise", "kind"), "none", "noise.kind"),
        (("noise", "position_m"), -1.0, "noise"),
        (("noise", "position_m"), float("nan"), "noise.position_m"),
        (("fault",), [{"kind": "lost", "sensor": "z", "from_s": 1.0}], "fault.sensor"),
        (("fault",), [{"kind": "melt", "sensor": "a", "from_s": 1.0}], "fault.kind"),
        (
            ("fault",),
            [{"kind": "lost", "sensor": "a", "from_s": 1.0, "until_s": 0.5}],
            "fault.until_s",
        ),
        (("estimator", "h_s"), 0.0, "estimator.h_s"),
        (("estimator", "h_s"), 1e-9, "estimator.h_s"),
        (("estimator", "system"), "bearing", "estimator.system"),
        (("estimator", "velocity"), "guessed", "estimator.velocity"),
        (("baselines",), ["median"], "scenario.baselines"),
        (("estimator",), 3, "estimator"),
    ],
)
def test_what_contradicts_itself_is_refused_by_its_key(path, value, name):
    with pytest.raises(InputError) as error:
        scenario_of("toy", changed(path, value))
    assert error.value.name == name


def test_the_nearest_key_is_suggested():
    with pytest.raises(InputError, match="did you mean position_m"):
        scenario_of("toy", changed(("sensor", 0, "positon_m"), [0, 0, 0]))


@pytest.mark.parametrize("gain", [-1.0, [[1, 2], [2, 1]]])
def test_gains_that_are_not_definite_are_refused(gain):
    with pytest.raises(InputError) as error:
        simulate(scenario_of("toy", changed(("estimator", "K"), gain)))
    assert error.value.name == "K"


def test_files_that_cannot_be_read_are_refused(tmp_path):
    (tmp_path / "bad.toml").write_text("a = = 1")
    for text in (str(tmp_path / "none.toml"), str(tmp_path / "bad.toml"), "nonsense"):
        with pytest.raises(InputError) as error:
            read_scenario(text)
        assert error.value.name == "scenario"


@pytest.mark.parametrize(
    "target",
    [
        Line(),
        Helix(2.0, 0.7, 0.1),
        Weaving((1.0, 2.0, 0.0), (3.0, 1.0, 0.0), (0.5, -0.2, 0.1), 7.0),
        Track("solent_six_vessels", "2", 300),
    ],
)
def test_a_velocity_is_the_derivative_of_its_path(target):
    time = np.linspace(1, 5, 20)
    step = 1e-5
    ahead, behind = target.at(time + step)[0], target.at(time - step)[0]
    assert target.at(time)[1] == pytest.approx((ahead - behind) / (2 * step), abs=1e-4)


def test_recorded_tracks_are_in_order_and_have_their_notice():
    notice = files("sensortrack.data").joinpath("tracks", "NOTICE.md").read_text()
    for name in TRACKS:
        time, place = load_track(name, "2" if name == "solent_six_vessels" else "")
        assert (np.diff(time) > 0).all()
        assert np.isfinite(place).all()
        assert place.shape == (len(time), 3)
        assert f"{name}.csv" in notice
    assert "MIT" in notice


@pytest.mark.parametrize("track", [("nowhere", ""), ("solent_six_vessels", ""), ("uav_gps", "3")])
def test_a_track_that_is_not_there_is_refused(track):
    with pytest.raises(InputError) as error:
        load_track(*track)
    assert error.value.name == "track"


def test_a_track_that_ends_too_early_is_refused():
    with pytest.raises(InputError) as error:
        Track("uav_gps", "", 900.0).at(np.linspace(0, 100, 5))
    assert error.value.name == "target.from_s"


def test_scenarios_are_toml_that_says_units():
    for name in shipped_scenarios():
        text = files("sensortrack").joinpath("scenarios", f"{name}.toml").read_text()
        assert "duration_s" in tomllib.loads(text)
