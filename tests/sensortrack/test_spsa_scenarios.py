"""Scenarios of cyclic SPSA that contradict themselves or cannot be meant, refused by their keys."""

import pytest

from sensortrack.errors import InputError
from sensortrack.simulation import simulate
from sensortrack.simulation.scenario import scenario_of
from tests.sensortrack.test_spsa_simulation import BASE, changed


@pytest.mark.parametrize(
    "path,value,name",
    [
        (("target",), [], "target"),
        (("target", 0, "name"), "east", "target.name"),
        (("target", 0, "name"), "", "target.name"),
        (("target", 0, "kind"), "spiral", "target.kind"),
        (("target", 0, "speed"), 1.0, "target.speed"),
        (
            ("target", 0),
            {"kind": "line", "start_m": [-100.0, 0.0, 0.0], "velocity_mps": [0.0, 0.0, 0.0]},
            "target",
        ),
        (("target", 0), {"kind": "weaving", "start_m": [0, 0, 0]}, "target.velocity_mps"),
        (
            ("target", 0),
            {
                "kind": "weaving",
                "start_m": [0, 0, 0],
                "velocity_mps": [0, 0, 0],
                "swing_mps": [0, 0, 0],
                "period_s": 0.0,
            },
            "target.period_s",
        ),
        (("sensor", 0, "velocity_mps"), [1.0, 0.0, 0.0], "sensor.velocity_mps"),
        (("noise", "kind"), "uniform", "noise.kind"),
        (("noise", "kind"), "none", "noise.kind"),
        (("noise", "bearing_deg"), -1.0, "noise.bearing_deg"),
        (("noise", "bearing_deg"), 90.0, "noise.bearing_deg"),
        (("noise", "range_relative"), 5.0, "noise.range_relative"),
        (("noise", "range_relative"), 0.3, "noise.range_relative"),
        (("sensor", 0, "bias_position_m"), [1.0, 0.0, 0.0], "sensor.bias_position_m"),
        (("sensor", 0, "name"), "", "sensor.name"),
        (("sensor", 0, "position_m"), [1e300, 0.0, 0.0], "sensor.position_m"),
        (("target", 0, "start_m"), [1e300, 0.0, 0.0], "target"),
        (("summary_from_s",), 25.0, "scenario.summary_from_s"),
        (("summary_from_s",), -1.0, "scenario.summary_from_s"),
        (("kalman_acceleration",), 0.0, "scenario.kalman_acceleration"),
        (("kalman_acceleration",), 1e300, "scenario.kalman_acceleration"),
        (("estimator", "alpha"), 1e300, "estimator.alpha"),
        (("estimator", "beta_m"), 1e300, "estimator.beta_m"),
        (("estimator", "beta_m"), 1e-15, "estimator.beta_m"),
        (("start", "low_m"), [-1e308, 0.0, 0.0], "start.low_m"),
        (("estimator", "alpha"), 0.0, "estimator.alpha"),
        (("estimator", "beta_m"), -1.0, "estimator.beta_m"),
        (("estimator", "reading"), "three", "estimator.reading"),
        (("estimator", "n_max"), -1, "estimator.n_max"),
        (("estimator", "m_max"), 0, "estimator.m_max"),
        (("estimator", "scale"), "median", "estimator.scale"),
        (("estimator", "reach_m"), 1.0, "estimator.reach_m"),
        (("estimator", "reach_m"), -1.0, "estimator.reach_m"),
        (("estimator", "diverged_m"), 0.0, "estimator.diverged_m"),
        (("start", "high_m"), [0.0, 0.0, 0.0], "start.high_m"),
        (("variant",), [{"name": "x"}, {"name": "x"}], "variant.name"),
        (("variant",), [{"name": "kalman"}], "variant.name"),
        (("variant",), [{"name": ""}], "variant.name"),
        (("variant",), [{"name": "x", "alpha": -1.0}], "variant.alpha"),
        (("variant",), [{"name": "x", "alpha": 0.0}], "variant.alpha"),
        (("variant",), [{"name": "x", "beta_m": 0.0}], "variant.beta_m"),
        (("variant",), [{"name": "x", "n_max": -1}], "variant.n_max"),
        (("variant",), [{"name": "x", "m_max": 0}], "variant.m_max"),
        (("variant",), [{"name": "x", "alpha": "0.1"}], "variant.alpha"),
        (("variant",), [{"name": "x", "reading": "none"}], "variant.reading"),
        (("variant",), [{"name": "x", "m_max": -2}], "variant.m_max"),
        (("variant",), [{"name": "x", "step": 1.0}], "variant.step"),
        (("placement",), {"kind": "random", "count": 3}, "placement"),
        (("seed",), -1, "scenario.seed"),
        (("baselines",), ["raw"], "scenario.baselines"),
    ],
)
def test_what_contradicts_itself_is_refused_by_its_key(path, value, name):
    with pytest.raises(InputError) as error:
        scenario_of("toy", changed((path, value)))
    assert error.value.name == name


def test_a_network_has_no_place_here_and_placed_sensors_have():
    data = changed((("placement",), {"kind": "network"}))
    del data["sensor"]
    with pytest.raises(InputError, match=r"placement\.kind"):
        scenario_of("toy", data)
    data["placement"] = {"kind": "ring", "count": 5, "size_m": 200.0}
    assert [*simulate(scenario_of("toy", data)).sensors] == ["1", "2", "3", "4", "5"]


def test_a_start_without_box_needs_a_measurement():
    data = changed((("fault",), [{"kind": "nan", "sensor": "a", "from_s": 0.0, "until_s": 1.0}]))
    del data["start"]
    with pytest.raises(InputError) as error:
        simulate(scenario_of("toy", data))
    assert error.value.name == "start"


def test_one_table_is_one_target_here_and_a_list_is_refused_elsewhere():
    alone = changed((("target",), {"kind": "line"}), (("estimator", "m_max"), 1))
    assert simulate(scenario_of("toy", alone)).to_data()["targets"][0]["name"] == "1"
    other = {key: value for key, value in BASE.items() if key not in ("start", "noise")}
    other["estimator"] = {"system": "variational", "M": 1.0, "K": 1.0, "C": 1.0, "h_s": 0.1}
    with pytest.raises(InputError) as error:
        scenario_of("toy", other)
    assert error.value.name == "target"
