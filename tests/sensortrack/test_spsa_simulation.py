"""Several targets followed by several sensors: replay, roads to the same numbers, divergence."""

import copy
import json

import numpy as np
import pytest

from sensortrack.errors import InputError
from sensortrack.estimators.kalman import Kalman
from sensortrack.estimators.position_kalman import PositionKalman
from sensortrack.sensors import Average
from sensortrack.simulation import simulate
from sensortrack.simulation.ranging import NoisePart, measured, moments
from sensortrack.simulation.scenario import scenario_of
from sensortrack.simulation.several_baselines import received
from sensortrack.simulation.spsa_settings import variants
from sensortrack.simulation.spsa_teams import team_of

BASE = {
    "title": "A toy",
    "about": "Three targets.",
    "duration_s": 24.0,
    "seed": 5,
    "summary_from_s": 12.0,
    "target": [
        {"kind": "line", "start_m": [0.0, 90.0, 0.0], "velocity_mps": [1.0, 0.5, 0.0]},
        {"kind": "line", "name": "east", "start_m": [80.0, 10.0, 0.0]},
        {"kind": "helix", "radius_m": 30.0, "rate_radps": 0.1},
    ],
    "sensor": [
        {"name": "a", "position_m": [-100.0, 0.0, 0.0]},
        {"name": "b", "position_m": [150.0, -20.0, 0.0]},
        {"name": "c", "position_m": [20.0, -130.0, 0.0]},
        {"name": "d", "position_m": [10.0, 160.0, 0.0]},
    ],
    "noise": {"kind": "gaussian", "bearing_deg": 2.0, "range_relative": 0.02},
    "start": {"low_m": [100.0, 100.0, 0.0], "high_m": [120.0, 110.0, 0.0]},
    "estimator": {
        "system": "cyclic_spsa",
        "h_s": 0.1,
        "alpha": 0.3,
        "beta_m": 5.0,
        "n_max": 1,
        "m_max": 2,
    },
}


def changed(*changes):
    data = copy.deepcopy(BASE)
    for path, value in changes:
        place = data
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = value
    return data


def ran(*changes, seed=None):
    return simulate(scenario_of("toy", changed(*changes)), seed)


def parts(scenario, seed=5):
    time = scenario.estimator.h_s * np.arange(241)
    truth = scenario.target.at(time)[0][..., :2]
    return time, truth, measured(scenario, seed, time, truth)


def test_the_same_seed_gives_the_same_run_and_another_one_another():
    first, again, other = (ran(seed=seed).to_data() for seed in (1, 1, 2))
    assert json.dumps(first) == json.dumps(again)
    assert first["estimates"] != other["estimates"]


@pytest.mark.parametrize("reading", ["one", "two"])
def test_agents_do_what_the_algorithm_says(reading):
    """All sensors and targets as arrays, costs as whole sums: another road to the same numbers."""
    scenario = scenario_of("toy", changed((("estimator", "reading"), reading)))
    run = simulate(scenario)
    _, truth, seen = parts(scenario)
    team = team_of(scenario, variants(scenario)[0], truth, 5)
    places, _ = received(team, seen)
    for j, agent in enumerate(team.agents.values()):
        columns = [team.targets.index(name) for name in agent.targets]
        h = np.array([agent.weights[name] for name in agent.targets])[:, None]
        theta = run.estimates["cyclic_spsa"][0][0, j, columns, :2].copy()
        k, first = len(agent.schedule.blocks), 0
        for t in range(2, 241, 2):
            cycle, u = (t - 2) // (2 * k) + 1, (t - 2) % (2 * k) // 2
            first = 0 if u == 0 else first
            rows = slice(first, first + len(agent.schedule.blocks[u]))
            first = rows.stop
            delta = agent.perturbation(cycle)[rows]
            late = places[t, j][columns][rows]
            early = late if reading == "one" else places[t - 1, j][columns][rows]
            plus = (h[rows] * (theta[rows] + 5.0 * delta - late) ** 2).sum() / 2
            minus = (h[rows] * (theta[rows] - 5.0 * delta - early) ** 2).sum() / 2
            theta[rows] -= 0.3 * delta * (plus - minus) / 10.0
            found = run.estimates["cyclic_spsa"][0][t, j, columns, :2]
            assert found == pytest.approx(theta, rel=1e-9, abs=1e-7)


def test_weights_add_up_to_one_over_the_sensors_or_scale_by_the_mean_of_the_variances():
    made = {}
    for scale in ("harmonic", "sum", "mean"):
        scenario = scenario_of("toy", changed((("estimator", "scale"), scale)))
        made[scale] = team_of(scenario, variants(scenario)[0], parts(scenario)[1], 0).weights
    assert made["harmonic"].sum(axis=0) == pytest.approx(np.ones(3))
    inverse = 1 / made["harmonic"]
    assert made["sum"] == pytest.approx(inverse.sum(axis=0) / 4 * made["harmonic"])
    assert made["mean"] == pytest.approx(made["sum"] / 4)


def test_another_sensor_or_target_leaves_the_draws_of_the_others_as_they_are():
    one = parts(scenario_of("toy", BASE))[2]
    more = changed()
    more["sensor"].insert(0, {"name": "e", "position_m": [500.0, 0.0, 0.0]})
    more["target"].append({"kind": "line"})
    two = parts(scenario_of("toy", more))[2]
    assert np.array_equal(one.angle, two.angle[:, 1:, :3])
    assert np.array_equal(one.distance, two.distance[:, 1:, :3])


def test_moments_of_a_measured_position_are_those_of_quadrature():
    """Gauss and Hermite's nodes for both errors: no bias, and the variances along and across."""
    nodes, shares = np.polynomial.hermite_e.hermegauss(40)
    shares = shares / shares.sum()
    noise = NoisePart("gaussian", 12.0, 0.2)
    angle, size = noise.bearing * nodes, 1 + 0.2 * nodes
    grow = np.exp(noise.bearing**2 / 2)
    weight = shares[:, None] * shares
    along = grow * size[:, None] * np.cos(angle)
    across = grow * size[:, None] * np.sin(angle)
    assert (weight * along).sum() == pytest.approx(1, rel=1e-12)
    exact = (weight * (along - 1) ** 2).sum(), (weight * across**2).sum()
    assert moments(noise) == pytest.approx(exact, rel=1e-10)


def test_positions_computed_from_measurements_have_the_covariance_that_filters_are_told():
    scenario = scenario_of("toy", changed((("noise", "bearing_deg"), 8.0)))
    time = np.zeros(20_000)
    truth = scenario.target.at(time)[0][..., :2]
    seen = measured(scenario, 3, time, truth)
    off = seen.position - truth[:, None]
    size = np.sqrt(np.trace(seen.covariance[0], axis1=-2, axis2=-1))
    assert np.abs(off.mean(axis=0) / size[..., None]).max() < 5 / np.sqrt(20_000)
    found = np.einsum("tqic,tqid->qicd", off, off) / len(time)
    assert np.abs(found - seen.covariance[0]).max() < 0.06 * size.max() ** 2


def test_a_setting_that_diverges_is_an_event_and_leaves_no_number():
    changes = [(("estimator", "beta_m"), 0.01), (("estimator", "diverged_m"), 1e5)]
    variant = [{"name": "calm", "beta_m": 5.0}, {"name": "wild"}]
    run = ran(*changes, (("variant",), variant), (("baselines",), []))
    (event,) = run.events
    assert event["kind"] == "diverged"
    assert event["of"] == "wild"
    level = run.errors("wild")[0]
    known = np.isfinite(level)
    assert known[: int(event["time"] / 0.1)].all()
    assert not known[round(event["time"] / 0.1) :].any()
    assert level[known].max() <= 1e5
    calm, wild = run.summary
    assert calm["diverged"] is None
    assert wild["diverged"] == pytest.approx(event["time"])
    assert wild["position_rms"] is None
    assert "NaN" not in json.dumps(run.to_data())


def test_a_blind_sensor_keeps_its_estimates_and_those_who_listen_to_it_too():
    lost = [{"kind": "lost", "sensor": name, "from_s": 2.0, "until_s": 4.0} for name in "abcd"]
    run = ran((("fault",), lost), (("baselines",), ["kalman", "gradient"]))
    place = run.estimates["cyclic_spsa"][0]
    assert np.array_equal(place[20], place[39], equal_nan=True)
    assert not np.array_equal(place[20], place[60], equal_nan=True)
    assert any("no measurement" in note for note in run.notes)
    assert np.isfinite(run.errors("kalman")[0]).all()
    assert np.isfinite(run.errors("gradient")[0]).all()
    gradient = run.estimates["gradient"][0]
    assert gradient[39].mean(axis=0) == pytest.approx(gradient[20].mean(axis=0), rel=0.3)


def test_errors_are_root_mean_squares_over_sensors_and_targets():
    run = ran()
    place = run.estimates["cyclic_spsa"][0]
    square = ((place - run.target[0][:, None]) ** 2).sum(axis=-1)
    assert run.errors("cyclic_spsa")[0] == pytest.approx(np.sqrt(square.mean(axis=(1, 2))))
    entry = run.to_data()["estimates"][0]
    assert np.array(entry["by_sensor"]) == pytest.approx(np.sqrt(square.mean(axis=2)).T, rel=1e-5)
    assert np.array(entry["by_target"]) == pytest.approx(np.sqrt(square.mean(axis=1)).T, rel=1e-5)
    row = next(row for row in run.summary if row["estimate"] == "gradient")
    level, first = run.errors("gradient")[0], run.errors("cyclic_spsa")[0][0]
    settled = round(row["settled"] / 0.1)
    assert level[settled] < 0.1 * first
    assert (level[:settled] >= 0.1 * first).all()
    assert row["start"] == level[0]
    assert row["position_rms"] == pytest.approx(np.sqrt(np.mean(level[120:] ** 2)))


def test_without_a_box_sensors_start_at_what_they_measure_first():
    data = changed()
    del data["start"]
    scenario = scenario_of("toy", data)
    run = simulate(scenario)
    _, truth, seen = parts(scenario)
    places, _ = received(team_of(scenario, variants(scenario)[0], truth, 5), seen)
    assert run.estimates["cyclic_spsa"][0][0, ..., :2] == pytest.approx(places[0])


def test_all_at_once_is_cyclic_with_room_for_all():
    run = ran((("baselines",), ["plain"]), (("estimator", "m_max"), 3))
    both = (run.estimates[name][0] for name in ("cyclic_spsa", "plain"))
    assert np.array_equal(*both)


def test_consensus_of_a_sensor_alone_is_gradient_descent():
    run = ran((("estimator", "n_max"), 0), (("baselines",), ["gradient"]))
    scenario = scenario_of("toy", changed((("estimator", "n_max"), 0)))
    _, truth, seen = parts(scenario)
    team = team_of(scenario, variants(scenario)[0], truth, 5)
    now = run.estimates["gradient"][0][0, ..., :2]
    for k in range(1, 50):
        now = now - 0.3 * team.weights[..., None] * (now - seen.position[k])
        assert run.estimates["gradient"][0][k, ..., :2] == pytest.approx(now)


def test_targets_out_of_reach_are_followed_by_those_who_hear_of_them():
    run = ran((("estimator", "reach_m"), 190.0), (("estimator", "n_max"), 0))
    known = np.isfinite(run.estimates["cyclic_spsa"][0][-1, ..., 0])
    apart = run.target[0][:, None] - np.array([s[0] for s in run.sensors.values()])[:, None]
    far = np.linalg.norm(apart[..., :2], axis=-1).max(axis=0)
    assert np.array_equal(known, far <= 190)
    assert not known.all()


def test_filters_of_positions_are_those_of_positions_and_worthless_velocities():
    """Equal variances in both coordinates: the filter for means of views is another road."""
    rng = np.random.default_rng(3)
    seen = np.cumsum(rng.normal(size=(40, 2)), axis=0)
    fine = PositionKalman(0.5, 2.0, 30.0)
    known = Kalman(0.5, 2.0, 1.5, 1e9)
    state = fine.init(seen[0], 2.25 * np.eye(2))
    start = known.init(Average(np.r_[seen[0], 0.0], np.zeros(3), ("a",), ()))
    other = type(start)(start.mean, np.diag([2.25, 900.0]))
    for place in seen[1:]:
        state = fine.step(state, place, 2.25 * np.eye(2))
        other = known.step(other, Average(np.r_[place, 0.0], np.zeros(3), ("a",), ()))
        assert state.mean == pytest.approx(other.mean[:, :2].ravel(), rel=1e-6, abs=1e-6)
        assert state.covariance[0, 0] == pytest.approx(other.covariance[0, 0], rel=1e-6)


def test_filters_side_by_side_start_when_they_first_see_and_coast_when_they_do_not():
    fine, noise = PositionKalman(1.0, 0.1, 10.0), np.broadcast_to(np.eye(2), (2, 2, 2))
    nothing = np.full((2, 2), np.nan)
    state = fine.init(nothing, noise)
    half = np.array([[1.0, 2.0], [np.nan, np.nan]])
    state = fine.step(state, half, noise)
    assert state.mean[0] == pytest.approx([1, 2, 0, 0])
    assert np.isnan(state.mean[1]).all()
    moved = fine.step(state, nothing, noise)
    assert moved.mean[0] == pytest.approx(state.mean[0])
    assert moved.covariance[0, 0, 0] > state.covariance[0, 0, 0]


@pytest.mark.parametrize("name", ["h", "acceleration", "speed"])
def test_a_filter_needs_positive_numbers(name):
    with pytest.raises(InputError) as error:
        PositionKalman(**{"h": 1.0, "acceleration": 1.0, "speed": 1.0, name: 0.0})
    assert error.value.name == name


@pytest.mark.parametrize(
    "position,noise,name",
    [
        (np.zeros(3), np.eye(2), "position"),
        ("xy", np.eye(2), "position"),
        (np.zeros(2), np.eye(3), "noise"),
        (np.zeros((4, 2)), np.eye(2), "noise"),
    ],
)
def test_a_filter_needs_shapes_that_fit(position, noise, name):
    kalman = PositionKalman(1.0, 1.0, 1.0)
    state = kalman.init((0.0, 0.0), np.eye(2))
    for refused in (
        lambda: kalman.init(position, noise),
        lambda: kalman.step(state, position, noise),
    ):
        with pytest.raises(InputError) as error:
            refused()
        assert error.value.name == name


def test_a_baseline_that_diverges_is_an_event_and_leaves_no_number():
    changes = (("estimator", "alpha"), 5.0), (("estimator", "diverged_m"), 1e9)
    run = ran(*changes, (("baselines",), ["gradient", "kalman"]))
    rows = {row["estimate"]: row for row in run.summary}
    assert rows["gradient"]["position_rms"] is None
    assert rows["kalman"]["diverged"] is None
    (event,) = [event for event in run.events if event.get("of") == "gradient"]
    assert event["time"] == rows["gradient"]["diverged"]
    before = run.errors("gradient")[0]
    assert np.nanmax(before) <= 1e9
    json.dumps(run.to_data(), allow_nan=False)
