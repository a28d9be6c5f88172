"""Simulations that know nothing of the closed forms bracket them, in every scenario shipped too."""

from fractions import Fraction

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.simulation import read_scenario, shipped_scenarios
from sensortrack.simulation.ranging import moments
from sensortrack.simulation.spsa_settings import variants
from sensortrack.simulation.spsa_teams import team_of
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.errors.stationary import (
    MEAN_SQUARE,
    stationary_mean,
    stationary_mse,
)
from verification.systems.cyclic_spsa.running.confirmed import confirm_mean, confirm_mean_square
from verification.systems.cyclic_spsa.running.expected_squares import Setting, expected_squares
from verification.systems.cyclic_spsa.running.frozen import frozen_blocks, frozen_error
from verification.systems.cyclic_spsa.stability.steps import step_limit

NOISE = [["0.3", "0.1"], ["0.1", "0.2"]]
DRIFT = ["0.1", "-0.2"]
BLOCK = {"h": ["1", "0.5"], "Xi": NOISE, "eta": DRIFT, "beta": "0.8", "alpha": "0.15"}
FULL = {key: value for key, value in BLOCK.items() if key != "h"} | {
    "H": [["1", ".6"], [".6", "1"]]
}
SCENARIOS = [
    name for name in shipped_scenarios() if read_scenario(name).estimator.system == "cyclic_spsa"
]


def question(**given):
    return read_inputs(MEAN_SQUARE, given, None, "cyclic_spsa.stationary_mse").values


CASES = [
    {**block, "reading": reading, "law": law, "k": k}
    for block in (BLOCK, FULL)
    for reading in ("one", "two")
    for law, k in (("gaussian", "1"), ("two_point", "3"))
] + [
    {**BLOCK, "eta": "0", "Xi": "0.5", "law": "two_point"},
    {"h": ["1", "2", "0.7", "1"], "Xi": "0.2", "eta": "0.05", "beta": "2", "alpha": "0.1"},
]


@pytest.mark.parametrize("given", CASES, ids=lambda given: f"{len(given)}-{given.get('law')}")
def test_simulated_intervals_bracket_the_closed_forms(given):
    values = question(**given)
    found = confirm_mean_square(values, width=0.06, seed=3)
    assert found.holds, found
    assert found.interval.relative_width < 0.08
    assert found.interval.seed == 3
    assert all(entry.holds for entry in confirm_mean(values, seed=3))


def test_an_interval_excludes_what_another_reading_would_give():
    """The readings differ by a tenth here: a simulation of one is evidence against the other."""
    given = {"h": ["1", "1"], "Xi": "1", "beta": "1", "alpha": "0.2"}
    one, two = (
        confirm_mean_square(question(**given, reading=reading), 0.03, 5)
        for reading in ("one", "two")
    )
    assert one.holds
    assert two.holds
    assert not one.interval.holds(two.exact)
    assert not two.interval.holds(one.exact)


def setting_of(scenario, variant):
    """A setting without a run: paths and shares are known before anything is drawn."""
    count = round(scenario.header.duration_s / scenario.estimator.h_s) + 1
    paths = scenario.target.at(scenario.estimator.h_s * np.arange(count))[0][..., :2]
    along, across = moments(scenario.noise)
    return Setting(
        alpha=variant.alpha,
        beta=variant.beta_m,
        instants=2 if variant.reading == "two" else 1,
        paths=paths,
        sensors=np.array([sensor.position_m[:2] for sensor in scenario.sensors]),
        along=along,
        across=across,
        shares=team_of(scenario, variant, paths, 0).record(),
        start=np.zeros((len(scenario.sensors), paths.shape[1], 2)),
    )


@pytest.mark.parametrize("name", SCENARIOS)
def test_simulated_intervals_bracket_the_closed_forms_in_shipped_scenarios(name):
    """A block of every sensor in each setting at the last geometry; what grows has no value."""
    scenario = read_scenario(name)
    settings = [setting_of(scenario, variant) for variant in variants(scenario)]
    level = 1 - 0.001 / (len(settings) * len(scenario.sensors))
    grown = 0
    for setting in settings:
        last = len(setting.paths) - 1
        blocks = dict(reversed([*frozen_blocks(setting, "gaussian", last)]))
        assert [*sorted(blocks)] == [*range(len(scenario.sensors))]
        if frozen_error(setting, "gaussian", last) is None:
            grown += 1
            assert {stationary_mse(values).value for values in blocks.values()} == {"inf"}
            with pytest.raises(InputError, match="less than"):
                confirm_mean_square(blocks[0])
            continue
        for values in blocks.values():
            found = confirm_mean_square(values, 0.05, 1, level)
            assert found.holds, found
        assert all(entry.holds for entry in confirm_mean(blocks[0], seed=1))
    assert grown == {"erofeeva_section_5": 3, "spsa_solent": 1}[name]


def resting(instants, speed):
    """Two targets seen by one sensor, in one block, without noise if they move."""
    time = np.arange(4000)[:, None, None]
    start, rate = np.array([[30.0, 40.0], [-20.0, 50.0]]), np.array([[1.0, 0.5], [-0.3, 0.2]])
    noise = 0.0 if speed else 0.001
    share = {"sources": [0, 0], "blocks": [[0, 1]], "weights": [1.0, 0.6]}
    return Setting(
        alpha=0.2,
        beta=4.0,
        instants=instants,
        paths=start + speed * rate * time,
        sensors=np.zeros((1, 2)),
        along=noise,
        across=2 * noise,
        shares=[share],
        start=np.full((1, 2, 2), 60.0),
    )


@pytest.mark.parametrize("instants", [1, 2])
@pytest.mark.parametrize("speed", [0.0, 0.3])
def test_expectations_settle_at_the_closed_forms(instants, speed):
    setting = resting(instants, speed)
    squares, limit = expected_squares(setting)
    ((_, values),) = frozen_blocks(setting, "gaussian", 3990)
    assert squares[3990].sum() == pytest.approx(stationary_mse(values).value, rel=1e-6)
    assert limit == pytest.approx(step_limit(values).value, rel=1e-8)
    both = np.sqrt(squares[3990:3992].mean())
    assert both == pytest.approx(frozen_error(setting, "gaussian", 3990), rel=1e-6)


def test_a_frozen_block_has_the_numbers_of_its_sensor():
    setting = resting(2, 0.3)
    ((sensor, values),) = frozen_blocks(setting, "gaussian", 7)
    assert sensor == 0
    assert values["h"] == (1, 1, Fraction("0.6"), Fraction("0.6"))
    assert [float(x) for x in values["eta"]] == pytest.approx([0.3, 0.15, -0.09, 0.06])
    lag = np.array(stationary_mean(values).value) / np.array([float(x) for x in values["eta"]])
    assert lag[:2] == pytest.approx(-2 / 0.2 + 1.5)


@pytest.mark.parametrize(
    "change,name",
    [
        ({"alpha": "1.2"}, "alpha"),
        ({"alpha": "0.00001"}, "alpha"),
        ({"alpha": "0"}, "alpha"),
        ({"law": "uniform"}, "law"),
        ({"beta": "0"}, "beta"),
    ],
)
def test_what_cannot_be_simulated_is_refused_by_name(change, name):
    with pytest.raises(InputError) as error:
        confirm_mean_square(question(**{**BLOCK, **change}))
    assert error.value.name == name


def test_intervals_hold_the_closed_form_as_often_as_they_say():
    """Near the largest step that is simulated, where squares have their heaviest tail."""
    values = question(h=["1"] * 6, Xi="1", beta="0.5", alpha="0.078", law="two_point")
    assert 0.7 < float(values["alpha"]) / step_limit(values).value < 0.75
    held = [confirm_mean_square(values, 0.2, seed, 0.9).holds for seed in range(60)]
    assert sum(held) >= 60 * 0.9 - 4 * np.sqrt(60 * 0.9 * 0.1)


def test_a_level_is_a_probability_for_the_mean_too():
    with pytest.raises(InputError, match="level"):
        confirm_mean(question(**BLOCK), level=0.0)
