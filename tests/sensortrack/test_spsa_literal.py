"""Whole simulated runs beside Algorithm 1 written out once more from the tables of a scenario."""

import copy

import numpy as np
import pytest

from sensortrack.simulation import simulate
from sensortrack.simulation.ranging import measured
from sensortrack.simulation.scenario import scenario_of
from tests.sensortrack.literal_spsa import literal_run
from tests.sensortrack.test_spsa_simulation import BASE

VARIANTS = [
    {"name": "one", "reading": "one"},
    {"name": "single", "m_max": 1, "n_max": 0},
    {"name": "all", "m_max": 7, "n_max": 9, "alpha": 0.1},
    {"name": "odd", "m_max": 2, "beta_m": 11.0, "n_max": 2},
]
ALONE = {"sensor": BASE["sensor"][:1], "target": BASE["target"][1:2]}
NEAR = {"estimator": BASE["estimator"] | {"reach_m": 190.0, "n_max": 1}}
BLIND = {
    "fault": [
        {"kind": "lost", "sensor": "b", "from_s": 3.05, "until_s": 5.0},
        {"kind": "nan", "sensor": "c", "from_s": 4.0},
    ]
}


@pytest.mark.parametrize(
    "changes", [{}, ALONE, NEAR, BLIND], ids=["all", "one sensor, one target", "reach", "blind"]
)
def test_runs_are_those_of_the_algorithm_written_out(changes):
    data = copy.deepcopy({k: v for k, v in BASE.items() if k != "start"}) | copy.deepcopy(changes)
    data |= {"duration_s": 10.1, "summary_from_s": 0.0, "baselines": [], "variant": VARIANTS}
    if changes is NEAR:
        data["variant"] = [{"name": "near"}, {"name": "near, one", "reading": "one", "m_max": 1}]
    scenario = scenario_of("toy", data)
    run = simulate(scenario, seed=11)
    truth = run.target[0][..., :2]
    seen = measured(scenario, 11, run.time, truth)
    for entry in data["variant"]:
        variant = data["estimator"] | {"reading": "two"} | entry
        wanted = literal_run(data, scenario.targets, truth, seen.angle, seen.distance, 11, variant)
        found = run.estimates[entry["name"]][0][..., :2]
        assert np.array_equal(np.isnan(found), np.isnan(wanted))
        assert np.allclose(found, wanted, rtol=1e-9, atol=1e-7, equal_nan=True)
        moved = np.nanmax(np.abs(found[-1] - found[0]), axis=(1, 2))
        assert (moved > 1).all()


def in_units(part, size):
    """The same tables with all lengths and speeds in units so many times smaller."""
    if isinstance(part, list):
        return [in_units(entry, size) for entry in part]
    if not isinstance(part, dict):
        return part
    lengths = {key for key in part if key.endswith(("_m", "_mps"))}
    scaled = {key: (size * np.array(part[key])).tolist() for key in lengths}
    return {key: scaled.get(key, in_units(value, size)) for key, value in part.items()}


@pytest.mark.parametrize("size", [1024.0, 2.0**-20])
def test_a_run_in_other_units_of_length_is_the_same_run(size):
    data = copy.deepcopy(BASE) | {"duration_s": 8.0, "summary_from_s": 0.0, "baselines": []}
    for target in data["target"]:
        if target["kind"] == "line":
            target.setdefault("velocity_mps", [1.0, 0.0, 0.0])
    data["estimator"] |= {"diverged_m": 1e7}
    run, other = (simulate(scenario_of("toy", in_units(data, by))) for by in (1.0, size))
    found = other.estimates["cyclic_spsa"][0]
    assert np.array_equal(found, size * run.estimates["cyclic_spsa"][0])
