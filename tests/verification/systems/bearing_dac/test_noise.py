"""Bias and covariance under bearing noise: two roads, seeded draws, and runs."""

from fractions import Fraction

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.estimators.bearing_filters import intersect
from sensortrack.estimators.bearing_noise import covariance, cramer_rao, limit_bias
from sensortrack.sensors import bearings_to
from sensortrack.simulation import simulate
from sensortrack.simulation.scenario import scenario_of
from tests.sensortrack.test_bearing_simulation import changed
from verification.inputs import read_inputs
from verification.systems.bearing_dac.noise import noise_bias, noise_covariance, noise_cramer_rao
from verification.systems.bearing_dac.quantities import SENSORS, SIGMA, TARGET

PLACES = [[60, 10], [-20, 70], [-70, -30], [10, -80]]
POINT = [15, 25]


def answer(quantity, sigma, positions=PLACES, target=POINT):
    given = {"positions": positions, "target": target, "sigma_bearing_rad": sigma}
    return quantity(read_inputs((SENSORS, TARGET, SIGMA), given).values)


@pytest.mark.parametrize("sigma", ["0", "1/1000", "1/20", "3/2"])
def test_rationals_and_matrices_agree(sigma):
    size = float(Fraction(sigma))
    for quantity, road in ((noise_covariance, covariance), (noise_cramer_rao, cramer_rao)):
        wanted = road(PLACES, POINT, size)
        upper = [wanted[0, 0], wanted[0, 1], wanted[1, 1]]
        assert answer(quantity, sigma).value == pytest.approx(upper, rel=1e-12, abs=1e-18)
    bias = limit_bias(PLACES, POINT, size)
    assert answer(noise_bias, sigma).value == pytest.approx(bias, rel=1e-12, abs=1e-18)


def test_the_averages_of_many_samples_lead_to_the_biased_limit():
    """Half a million draws a sensor; the interval is six standard errors of twenty batches."""
    sigma, rng = 0.25, np.random.default_rng(1)
    places, point = np.array(PLACES, float), np.array(POINT, float)
    found = []
    for _ in range(20):
        angle = bearings_to(point, places) + sigma * rng.standard_normal((25_000, 4))
        rows = np.stack([-np.sin(angle), np.cos(angle)], axis=-1)
        offsets = (rows * places).sum(axis=-1)
        matrix = np.einsum("nki,nkj->ij", rows, rows)
        found.append(np.linalg.solve(matrix, np.einsum("nki,nk->i", rows, offsets)) - point)
    error = np.std(found, axis=0, ddof=1) / np.sqrt(20)
    bias = limit_bias(PLACES, POINT, sigma)
    assert np.abs(bias).max() > 20 * error.max()
    assert (np.abs(np.mean(found, axis=0) - bias) <= 6 * error).all()


def test_the_spread_of_single_shots_is_the_first_order_covariance():
    """Twenty thousand shots: the relative error of a variance is about 0.01."""
    sigma, rng = 0.002, np.random.default_rng(2)
    angle = bearings_to(POINT, PLACES) + sigma * rng.standard_normal((20_000, 4))
    shots = np.array([intersect(row, PLACES) for row in angle[:4000]])
    wanted = covariance(PLACES, POINT, sigma)
    assert np.cov(shots.T) == pytest.approx(wanted, rel=0.15)
    scale = np.sqrt(np.trace(wanted) / 4000)
    assert np.linalg.norm(shots.mean(axis=0) - POINT) < 6 * scale


def test_no_unbiased_position_is_better_than_the_bound_and_weights_attain_it():
    sigma, rng = 0.003, np.random.default_rng(3)
    for _ in range(20):
        places, point = rng.normal(scale=50, size=(5, 2)), rng.normal(scale=20, size=2)
        gap = covariance(places, point, sigma) - cramer_rao(places, point, sigma)
        assert np.linalg.eigvalsh(gap).min() >= -1e-12 * np.trace(gap)
    places = np.array(PLACES, float)
    weights = 1 / ((np.array(POINT) - places) ** 2).sum(axis=1)
    angle = bearings_to(POINT, places) + sigma * rng.standard_normal((4000, 4))
    shots = np.array([intersect(row, places, weights) for row in angle])
    assert np.cov(shots.T) == pytest.approx(cramer_rao(places, POINT, sigma), rel=0.15)


def test_a_run_has_the_errors_that_the_note_says():
    still = {"kind": "line", "start_m": [15.0, 20.0, 0.0], "velocity_mps": [0.0, 0.0, 0.0]}
    run = simulate(
        scenario_of(
            "toy",
            changed(
                (("noise",), {"kind": "gaussian", "bearing_deg": 0.5}),
                (("target",), still),
                (("duration_s",), 8.0),
                (("summary_from_s",), 0.2),
                (("baselines",), ["least_squares"]),
                (("estimator", "beta_q"), 1e5),
                (("estimator", "beta_P"), 2e3),
            ),
        )
    )
    places = [rows[0, :2] for rows in run.sensors.values()]
    wanted = np.sqrt(np.trace(covariance(places, (15.0, 20.0), np.deg2rad(0.5))))
    rms = {row["estimate"]: row["position_rms"] for row in run.summary}
    assert rms["bearing_dac"] == pytest.approx(wanted, rel=0.12)
    assert rms["least_squares"] == pytest.approx(rms["bearing_dac"], rel=1e-9)
    assert any(f"{wanted:.4g} m rms to first order" in note for note in run.notes)


@pytest.mark.parametrize("quantity", [noise_bias, noise_covariance, noise_cramer_rao])
@pytest.mark.parametrize(
    "change,name",
    [
        ({"sigma": "-1"}, "sigma_bearing_rad"),
        ({"target": [60, 10]}, "target"),
        ({"positions": [[0, 0], [30, 50]], "target": [15, 25]}, "target"),
        ({"positions": [[0, 0]]}, "target"),
        ({"positions": []}, "positions"),
        ({"positions": [[0, 0, 1]]}, "positions"),
        ({"target": 3}, "target"),
    ],
)
def test_bad_data_are_refused_by_name(quantity, change, name):
    with pytest.raises(InputError) as error:
        answer(quantity, **({"sigma": "1/10"} | change))
    assert error.value.name == name


@pytest.mark.parametrize("road", [covariance, limit_bias, cramer_rao])
@pytest.mark.parametrize(
    "given,name",
    [
        (([[0, 0], [30, 50]], (15, 25), 0.1), "target"),
        ((PLACES, (60, 10), 0.1), "target"),
        ((PLACES, POINT, -0.1), "sigma"),
        ((PLACES, POINT, float("nan")), "sigma"),
        (([[0, float("nan")]], POINT, 0.1), "positions"),
    ],
)
def test_the_runtime_refuses_the_same(road, given, name):
    with pytest.raises(InputError) as error:
        road(*given)
    assert error.value.name == name
