"""Algorithm 1 at one sensor: its step is the closed recursion, exactly; its inbox; bad input."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.estimators import CyclicSpsa
from sensortrack.polar import PolarView, polar_to
from sensortrack.schedules import Schedule

SOURCES = {"p": "a", "q": "b", "r": "a"}
SCHEDULE = Schedule([["p", "q"], ["r"]], SOURCES)
WEIGHTS = {"p": 0.5, "q": 1.25, "r": 0.75}
START = {"p": (1.0, 2.0), "q": (-3.0, 0.5), "r": (0.0, 4.0)}
EIGHTHS = st.integers(-64, 64).map(lambda k: k / 8)
PLACES = {"a": np.array([5.0, -2.0]), "b": np.array([-4.0, 7.0])}


def make(**changes):
    settings = {"schedule": SCHEDULE, "weights": WEIGHTS, "alpha": 0.125, "beta": 0.25}
    return CyclicSpsa(**settings | changes)


def at(target, place, sensor=None):
    """A measurement that puts the target at this place without rounding: angle 0, distance 1."""
    return PolarView(sensor or SOURCES[target], target, 0.0, 1.0, (place[0], place[1] - 1.0))


def noisy(rng, targets=tuple(SOURCES)):
    """Measurements of targets about the origin."""
    views = []
    for target in targets:
        sensor = SOURCES[target]
        angle, distance = polar_to(rng.normal(size=2), PLACES[sensor])
        views.append(PolarView(sensor, target, float(angle), float(distance), PLACES[sensor]))
    return views


def run(estimator, state, inboxes):
    for t, views in enumerate(inboxes, start=state.time + 1):
        state = estimator.step(t, state, views)
    return state


def drawn(estimator, seed, count):
    rng = np.random.default_rng(seed)
    return [noisy(rng, estimator.targets) for _ in range(count)]


@settings(max_examples=30)
@given(
    reading=st.sampled_from(["two", "one"]),
    seed=st.integers(0, 2**64 - 1),
    numbers=st.lists(EIGHTHS, min_size=24, max_size=24),
)
def test_a_step_is_the_closed_recursion_exactly(reading, seed, numbers):
    """a+ = a - c - alpha Delta (Delta - nu)' H (a - chi) with c = 2k eta, in rational numbers.

    All data are dyadic, so that the estimator rounds nothing.
    """
    exact = [Fraction(x) for x in numbers]
    theta_early, eta, noise_early, noise_late, estimate = (
        exact[4 * k : 4 * k + 4] for k in range(5)
    )
    estimator = make(reading=reading, seed=seed)
    theta = [x + e for x, e in zip(theta_early, eta, strict=True)]
    early = [x + n for x, n in zip(theta_early, noise_early, strict=True)]
    late = [x + n for x, n in zip(theta, noise_late, strict=True)]
    first, second = (
        [at("p", list(map(float, p[:2]))), at("q", list(map(float, p[2:])))] for p in (early, late)
    )
    begin = START | {"p": numbers[16:18], "q": numbers[18:20]}
    found = run(estimator, estimator.init(positions=begin), [first, second])

    alpha, beta = Fraction(estimator.alpha), Fraction(estimator.beta)
    weights = [Fraction(WEIGHTS[target]) for target in "ppqq"]
    delta = [Fraction(x) for x in estimator.perturbation(1).ravel()[:4]]
    coordinates, k = range(4), len(SCHEDULE.blocks)
    if reading == "two":
        middle = [(x + y) / 2 for x, y in zip(theta, theta_early, strict=True)]
        difference = zip(noise_late, noise_early, eta, strict=True)
        nu = [(x - y + e) / (2 * beta) for x, y, e in difference]
        chi = [(x + y) / 2 for x, y in zip(noise_late, noise_early, strict=True)]
    else:
        middle, nu, chi = theta, [Fraction(0)] * 4, noise_late
    a = [x - m for x, m in zip(estimate, middle, strict=True)]
    slope = sum((delta[i] - nu[i]) * weights[i] * (a[i] - chi[i]) for i in coordinates)
    wanted = [a[i] - 2 * k * eta[i] - alpha * delta[i] * slope for i in coordinates]
    later = [m + 2 * k * e for m, e in zip(middle, eta, strict=True)]
    reached = [Fraction(x) for x in found.positions.ravel()[:4]]
    assert [x - m for x, m in zip(reached, later, strict=True)] == wanted


@pytest.mark.parametrize("reading", ["two", "one"])
def test_only_the_block_of_the_turn_moves_and_only_at_its_second_sample(reading):
    estimator = make(reading=reading)
    state = estimator.init(positions=START)
    for t, views in enumerate(drawn(estimator, 1, 12), start=1):
        before, state = state, estimator.step(t, state, views)
        moved = [
            target
            for target, one, other in zip(
                estimator.targets, before.positions, state.positions, strict=True
            )
            if one.tobytes() != other.tobytes()
        ]
        turn = SCHEDULE.turn(t)
        assert moved == (list(SCHEDULE.blocks[turn.block - 1]) if turn.second else [])
        assert state.status.updated == tuple(moved)
        assert (state.status.turn, state.status.left_out, state.notes) == (turn, (), ())


def test_a_run_is_taken_up_anywhere_and_gives_the_same_bits():
    estimator = make(seed=2**63 + 5, number=3)
    inboxes = drawn(estimator, 2, 14)
    whole = run(estimator, estimator.init(positions=START), inboxes)
    half = run(estimator, estimator.init(positions=START), inboxes[:7])
    rest = run(make(seed=2**63 + 5, number=3), half, inboxes[7:])
    assert rest.flat.tobytes() == whole.flat.tobytes()


def test_perturbations_depend_on_seed_number_cycle_and_place_alone():
    base = make(seed=7, number=2)
    assert set(base.perturbation(1).ravel()) <= {-1.0, 1.0}
    larger = make(
        schedule=Schedule([["p"], ["q"], ["r"], ["s"]], SOURCES | {"s": "b"}),
        weights=WEIGHTS | {"s": 1.0},
        seed=7,
        number=2,
        reading="one",
    )
    for cycle in range(1, 20):
        assert np.array_equal(larger.perturbation(cycle)[:3], base.perturbation(cycle))
    many = [
        np.concatenate([make(**changes).perturbation(cycle).ravel() for cycle in range(1, 200)])
        for changes in ({}, {"seed": 1}, {"number": 1}, {"seed": 1, "number": 1})
    ]
    signs = np.array(many)
    bound = 5 * np.sqrt(signs.shape[1])
    assert (np.abs(signs @ signs.T - signs.shape[1] * np.eye(4)) < bound).all()
    assert (np.abs(signs.sum(axis=1)) < bound).all()


def test_measurements_of_other_sensors_and_other_blocks_do_not_count():
    estimator = make()
    inboxes = drawn(estimator, 3, 8)
    wanted = run(estimator, estimator.init(positions=START), inboxes)
    lean = []
    for t, views in enumerate(inboxes, start=1):
        block = SCHEDULE.blocks[SCHEDULE.turn(t).block - 1]
        lean.append([view for view in views if view.target in block])
        views += [replace(view, sensor="c", angle=3.0) for view in views]
    assert run(estimator, estimator.init(positions=START), inboxes).flat.tobytes() == (
        run(estimator, estimator.init(positions=START), lean).flat.tobytes()
    )
    assert (
        wanted.flat.tobytes()
        == run(estimator, estimator.init(positions=START), lean).flat.tobytes()
    )


@pytest.mark.parametrize("reading", ["two", "one"])
@pytest.mark.parametrize("sample", [1, 2])
@pytest.mark.parametrize("blind", [False, True])
def test_a_target_missed_once_is_left_out_of_both_costs(reading, sample, blind):
    """As if the sensor did not know it: the others move as without it."""
    estimator = make(reading=reading)
    inboxes = drawn(estimator, 4, 2)
    alone = make(
        reading=reading,
        schedule=Schedule([["p"]], {"p": "a"}),
        weights={"p": WEIGHTS["p"]},
    )
    wanted = run(
        alone,
        alone.init(positions={"p": START["p"]}),
        [[view for view in views if view.target == "p"] for views in inboxes],
    )
    missed = inboxes[sample - 1]
    inboxes[sample - 1] = [
        replace(view, angle=np.nan) if view.target == "q" else view
        for view in missed
        if blind or view.target != "q"
    ]
    state = estimator.init(positions=START)
    states = []
    for t, views in enumerate(inboxes, start=1):
        state = estimator.step(t, state, views)
        states.append(state)
    if reading == "one" and sample == 1:  # the first sample is not looked at
        assert (states[0].notes, state.status.updated) == ((), ("p", "q"))
        return
    note = "no measurement of q from b: left out of this step"
    assert states[sample - 1].notes == (note,)
    assert (state.status.updated, state.status.left_out) == (("p",), ("q",))
    assert state.positions[0].tobytes() == wanted.positions[0].tobytes()
    assert state.positions[1].tolist() == list(START["q"])


def test_names_of_targets_do_not_change_a_bit():
    estimator, names = make(), {"p": "x", "q": "p", "r": "q"}
    other = make(
        schedule=Schedule(
            [[names[target] for target in block] for block in SCHEDULE.blocks],
            {names[target]: sensor for target, sensor in SOURCES.items()},
        ),
        weights={names[target]: weight for target, weight in WEIGHTS.items()},
    )
    inboxes = drawn(estimator, 5, 9)
    turned = [[replace(view, target=names[view.target]) for view in views] for views in inboxes]
    begin = {names[target]: place for target, place in START.items()}
    assert run(estimator, estimator.init(positions=START), inboxes).flat.tobytes() == (
        run(other, other.init(positions=begin), turned).flat.tobytes()
    )


def test_other_units_of_length_give_the_same_numbers_in_those_units():
    estimator, other = make(), make(beta=0.25 * 1024)
    inboxes = drawn(estimator, 6, 9)
    scaled = [
        [
            replace(view, distance=1024 * view.distance, position=1024 * np.asarray(view.position))
            for view in views
        ]
        for views in inboxes
    ]
    begin = {target: 1024 * np.array(place) for target, place in START.items()}
    found = run(other, other.init(positions=begin), scaled).positions
    wanted = run(estimator, estimator.init(positions=START), inboxes).positions
    assert found.tobytes() == (1024 * wanted).tobytes()


def test_targets_at_rest_without_noise_are_found():
    estimator = make(alpha=0.2, beta=1.0)
    exact = noisy(np.random.default_rng(8))
    state = run(estimator, estimator.init(positions=START), [exact] * 800)
    wanted = [estimator.measured(view) for view in exact]
    assert state.positions == pytest.approx(np.array(wanted), abs=1e-9)


@pytest.mark.parametrize("sigma", [0.01, 0.3])
def test_the_bias_of_the_printed_position_is_undone_in_the_mean(sigma):
    """Gaussian angle errors, by Gauss-Hermite quadrature."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(40)
    weights = weights / weights.sum()
    target, place = np.array([3.0, -4.0]), PLACES["b"]
    angle, distance = map(float, polar_to(target, place))
    views = [PolarView("b", "q", angle + sigma * x, distance, place) for x in nodes]
    for sigma_bearing, lost in ((sigma, 0.0), (0.0, 1 - np.exp(-(sigma**2) / 2))):
        estimator = make(sigma_bearing=sigma_bearing)
        mean = sum(
            weight * np.array(estimator.measured(view))
            for weight, view in zip(weights, views, strict=True)
        )
        assert mean == pytest.approx(target - lost * (target - place), abs=1e-12)


def test_an_estimate_that_runs_away_is_remarked_on():
    """It comes to rest in floating point, where it has no perturbation any more."""
    estimator = make(alpha=1e4)
    state = estimator.init(positions=START)
    for t, views in enumerate(drawn(estimator, 9, 400), start=1):
        state = estimator.step(t, state, views)
        if state.notes:
            break
    assert "run away" in state.notes[-1]
    assert np.abs(state.positions).max() > 2**52 * estimator.beta


def test_a_target_starts_where_its_source_measured_it():
    estimator = make()
    state = estimator.init([at("q", (6.0, 8.0))], {"p": (1, 2), "r": (3, 4)})
    assert state.positions.tolist() == [[1.0, 2.0], [6.0, 8.0], [3.0, 4.0]]
    assert str(state.status) == "start"
    state = estimator.step(1, state, [])
    assert str(state.status) == "cycle 1, block 1, first sample"
    assert str(estimator.step(2, state, []).status) == "cycle 1, block 1, 0 updated"


@pytest.mark.parametrize(
    "changes,name",
    [
        ({"alpha": 0.0}, "alpha"),
        ({"alpha": np.nan}, "alpha"),
        ({"alpha": "0.1"}, "alpha"),
        ({"alpha": 10**400}, "alpha"),
        ({"beta": None}, "beta"),
        ({"beta": 1j}, "beta"),
        ({"schedule": [["p"]]}, "schedule"),
        ({"sigma_bearing": "small"}, "sigma_bearing"),
        ({"weights": None}, "weights"),
        ({"weights": WEIGHTS | {"p": "heavy"}}, "weights"),
        ({"beta": 0.0}, "beta"),
        ({"beta": -1.0}, "beta"),
        ({"beta": np.inf}, "beta"),
        ({"reading": "three"}, "reading"),
        ({"seed": -1}, "seed"),
        ({"seed": 0.5}, "seed"),
        ({"number": 2**64}, "number"),
        ({"sigma_bearing": -0.1}, "sigma_bearing"),
        ({"sigma_bearing": 30.0}, "sigma_bearing"),
        ({"weights": {"p": 1.0, "q": 1.0}}, "weights"),
        ({"weights": WEIGHTS | {"s": 1.0}}, "weights"),
        ({"weights": WEIGHTS | {"p": 0.0}}, "weights"),
        ({"weights": WEIGHTS | {"p": np.nan}}, "weights"),
    ],
)
def test_bad_parameters_are_refused_by_name(changes, name):
    with pytest.raises(InputError) as error:
        make(**changes)
    assert error.value.name == name


GOOD = at("p", (0.0, 0.0))


@pytest.mark.parametrize(
    "t,views,name",
    [
        (1, [replace(GOOD, angle=45.0)], "angle"),
        (1, [replace(GOOD, angle=-7.0)], "angle"),
        (1, [replace(GOOD, distance=-1.0)], "distance"),
        (1, [replace(GOOD, position=(1.0, 2.0, 3.0))], "position"),
        (1, [GOOD, GOOD], "measurement"),
        (1, [GOOD, replace(GOOD, distance=2.0)], "measurement"),
        (1, [replace(GOOD, time=0)], "measurement"),
        (1, [replace(GOOD, time=2)], "measurement"),
        (1, [replace(GOOD, target="x")], "measurement"),
        (0, [GOOD], "t"),
        (2, [GOOD], "t"),
        (1.5, [GOOD], "t"),
        (1.0, [GOOD], "t"),
        (np.nan, [GOOD], "t"),
        (1, [replace(GOOD, angle=None)], "angle"),
        (1, [replace(GOOD, angle=np.array([0.1, 0.2]))], "angle"),
        (1, [replace(GOOD, distance="far")], "distance"),
        (1, [replace(GOOD, position=("x", "y"))], "position"),
        (1, [replace(GOOD, position=None)], "position"),
    ],
)
def test_bad_measurements_are_refused_by_name(t, views, name):
    estimator = make()
    with pytest.raises(InputError) as error:
        estimator.step(t, estimator.init(positions=START), views)
    assert error.value.name == name


def test_degrees_are_named_as_the_cause():
    estimator = make()
    with pytest.raises(InputError, match="degrees"):
        estimator.step(1, estimator.init(positions=START), [replace(GOOD, angle=90.0)])


@pytest.mark.parametrize(
    "views,positions",
    [
        ([], None),
        ([at("p", (0, 0)), at("q", (0, 0))], None),
        ([at("p", (0, 0)), at("q", (0, 0)), replace(at("r", (0, 0)), distance=np.nan)], None),
        ([], {"p": (0, 0), "q": (0, 0), "r": (0, np.nan)}),
        ([], START | {"x": (0, 0)}),
        ([], START | {"p": ("a", "b")}),
        ([], START | {"p": (1j, 0)}),
    ],
)
def test_a_start_needs_a_place_of_each_target(views, positions):
    with pytest.raises(InputError) as error:
        make().init(views, positions)
    assert error.value.name == "positions"


def test_samples_may_be_counted_by_numpy():
    estimator, views = make(), [GOOD]
    start = estimator.init(positions=START)
    one = estimator.step(np.int64(1), start, views)
    assert type(one.time) is int
    two = estimator.step(np.int64(2), one, views)
    plain = estimator.step(2, estimator.step(1, start, views), views)
    assert np.array_equal(two.flat, plain.flat, equal_nan=True)


def test_a_state_of_other_targets_is_refused():
    estimator, other = make(), CyclicSpsa(Schedule([["p"]], {"p": "a"}), {"p": 1.0}, 0.1, 1.0)
    with pytest.raises(InputError, match="state: one of 1 targets; one of 3"):
        estimator.step(1, other.init(positions={"p": (0.0, 0.0)}), [GOOD])


@pytest.mark.parametrize("cycle", [0, -1, 1.0, 2**64])
def test_cycles_count_from_one(cycle):
    with pytest.raises(InputError, match="cycle"):
        make().perturbation(cycle)
