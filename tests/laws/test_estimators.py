"""Laws of every estimator: purity, order and names of sensors, moved frames, blind sensors."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws.cases import ESTIMATORS

EACH = pytest.mark.parametrize("system", sorted(ESTIMATORS))
SEEDS = st.integers(0, 2**32 - 1)


def run(case, estimator, samples):
    """The states, one a sample."""
    states = [estimator.init(samples[0])]
    for k, views in enumerate(samples[1:], start=1):
        states.append(estimator.step(k * case.period(estimator), states[-1], views))
    return states


def bits(states):
    return [state.flat.tobytes() for state in states]


@EACH
@settings(max_examples=8)
@given(SEEDS)
def test_a_step_changes_neither_state_nor_measurements(system, seed):
    case = ESTIMATORS[system]
    estimator, samples = case.draw(np.random.default_rng(seed))
    state, soon = estimator.init(samples[0]), case.period(estimator)
    before = state.flat.tobytes(), [vars(view).copy() for view in samples[1]]
    after = estimator.step(soon, state, samples[1])
    assert state.flat.tobytes() == before[0]
    for view, old in zip(samples[1], before[1], strict=True):
        now = [getattr(view, name) for name in old]
        assert all(np.array_equal(a, b) for a, b in zip(now, old.values(), strict=True))
    assert bits([after]) == bits([estimator.step(soon, state, samples[1])])
    assert after.flat.dtype == np.float64


@EACH
@settings(max_examples=8)
@given(SEEDS)
def test_order_and_names_of_the_sensors_do_not_change_a_bit(system, seed):
    rng = np.random.default_rng(seed)
    case = ESTIMATORS[system]
    estimator, samples = case.draw(rng)
    wanted = bits(run(case, estimator, samples))
    shuffled = [[views[i] for i in rng.permutation(len(views))] for views in samples]
    assert bits(run(case, estimator, shuffled)) == wanted
    names = [view.sensor for view in samples[0]]
    other = dict(zip(names, (f"sensor {k}" for k in rng.permutation(len(names))), strict=True))
    assert bits(run(case, *case.renamed(estimator, samples, other))) == wanted


@EACH
@settings(max_examples=8)
@given(SEEDS)
def test_what_a_blind_sensor_says_does_not_change_a_bit(system, seed):
    rng = np.random.default_rng(seed)
    case = ESTIMATORS[system]
    estimator, samples = case.draw(rng)
    away = [samples[0], *([views[0], *views[2:]] for views in samples[1:])]
    blind = [
        samples[0],
        *([views[0], case.blinded(views[1], rng), *views[2:]] for views in samples[1:]),
    ]
    assert bits(run(case, estimator, away)) == bits(run(case, estimator, blind))


@EACH
@settings(max_examples=8)
@given(SEEDS)
def test_a_moved_frame_moves_the_estimates(system, seed):
    """By the motions that a system declares: turns, shifts, constant velocities."""
    rng = np.random.default_rng(seed)
    case = ESTIMATORS[system]
    estimator, samples = case.draw(rng)
    motion = case.motion(rng)
    period, other = case.period(estimator), case.placed(estimator, motion)
    moved = [case.moved(views, motion, k * period) for k, views in enumerate(samples)]
    both = zip(run(case, estimator, samples), run(case, other, moved), strict=True)
    for k, (one, two) in enumerate(both):
        for before, after in case.results(one, two, motion, k * period):
            near = pytest.approx(before, rel=case.rounding, abs=case.rounding, nan_ok=True)
            assert after == near
