"""Intervals hold what they say they hold, as often as they say it."""

import math

import numpy as np
import pytest

from sensortrack.errors import InputError
from verification.statistics import (
    PILOT,
    Interval,
    batch_interval,
    mean_interval,
    monte_carlo,
    runs_for,
)


def normal(seed, mean=3.0, deviation=2.0):
    """Runs with random numbers of their own."""

    def draw(first, count):
        return [
            mean + deviation * np.random.default_rng([seed, k]).standard_normal()
            for k in range(first, first + count)
        ]

    return draw


def test_an_interval_of_two_runs_is_the_cauchy_one():
    """One degree of freedom: the quantile is tan(pi level/2)."""
    found = mean_interval([1.0, 3.0], 0.9)
    assert found.mean == 2
    assert found.half == pytest.approx(math.tan(math.pi * 0.9 / 2))
    assert found.holds(2 + found.half)
    assert not found.holds(2 + 1.001 * found.half)


def test_intervals_hold_the_mean_as_often_as_they_say():
    rng = np.random.default_rng(5)
    held = sum(mean_interval(rng.normal(7, 2, 9), 0.8).holds(7) for _ in range(2000))
    assert held / 2000 == pytest.approx(0.8, abs=4 * math.sqrt(0.16 / 2000))


def test_two_stages_hold_the_mean_as_often_as_they_say_at_the_width_that_was_wanted():
    rng = np.random.default_rng(8)
    width, held, wide = 0.02, 0, []
    for _ in range(1000):
        found = monte_carlo(lambda _, count: rng.normal(30, 2, count), width, 8, 0.8, pilot=20)
        held += found.holds(30)
        wide.append(found.relative_width)
    assert held / 1000 == pytest.approx(0.8, abs=4 * math.sqrt(0.16 / 1000))
    assert max(wide) < 1.1 * width
    assert np.median(wide) == pytest.approx(width, rel=0.02)


def test_the_wanted_width_decides_the_number_of_runs():
    pilot = normal(3)(0, 200)
    wide, narrow = runs_for(pilot, 0.1), runs_for(pilot, 0.05)
    assert narrow == pytest.approx(4 * wide, rel=1e-3)
    assert runs_for(pilot, 100.0) == len(pilot)
    assert runs_for([2.0, 2.0, 2.0], 1e-9) == 3


def test_the_same_seed_gives_the_same_interval_and_every_run_is_its_own():
    first, again = (monte_carlo(normal(1), 0.5, 1) for _ in range(2))
    assert first == again
    assert first.runs > PILOT
    assert first.seed == 1
    assert first.mean == np.mean(normal(1)(0, first.runs))


def test_batches_see_what_a_series_remembers():
    """Neighbours that are alike tell less: the interval of batches is wider, and holds the mean."""
    rng = np.random.default_rng(2)
    noise, series = rng.standard_normal(40_000), np.zeros(40_000)
    for k in range(1, len(series)):
        series[k] = 0.9 * series[k - 1] + noise[k]
    naive, fair = mean_interval(series), batch_interval(series, 20)
    assert fair.holds(0)
    exact = math.sqrt((1 + 0.9) / (1 - 0.9))
    assert fair.half / naive.half == pytest.approx(exact, rel=0.6)


def test_a_series_that_does_not_divide_loses_its_start():
    assert batch_interval([99.0, 1.0, 1.0, 3.0, 3.0], 2) == mean_interval([1.0, 3.0])


def test_the_width_of_a_mean_of_zero_is_infinite():
    assert Interval(0.0, 1.0, 2, 0.9).relative_width == math.inf


@pytest.mark.parametrize(
    "call,name",
    [
        (lambda: mean_interval([1.0]), "runs"),
        (lambda: mean_interval([[1.0, 2.0]]), "runs"),
        (lambda: mean_interval([1.0, math.inf]), "runs"),
        (lambda: mean_interval([1.0, 2.0], 1.0), "level"),
        (lambda: mean_interval([1.0, 2.0], 0.0), "level"),
        (lambda: batch_interval([1.0, 2.0], 3), "batches"),
        (lambda: batch_interval([1.0, 2.0], 0), "batches"),
        (lambda: runs_for([1.0, 2.0], 0.0), "width"),
        (lambda: runs_for([1.0, -1.0], 0.1), "width"),
        (lambda: runs_for([1.0, 2.0], 1e-9), "width"),
        (lambda: runs_for([1.0, 2.0], math.nan), "width"),
        (lambda: runs_for([1.0, 2.0], "narrow"), "width"),
        (lambda: mean_interval(["a", "b"]), "runs"),
        (lambda: mean_interval([1.0, 2.0], "high"), "level"),
        (lambda: batch_interval([1.0, 2.0], 1.5), "batches"),
        (lambda: batch_interval([1.0, 2.0], 1), "batches"),
        (lambda: monte_carlo(normal(1), 0.1, 1, pilot=1), "pilot"),
        (lambda: monte_carlo(normal(1), 0.1, 1, pilot=-1), "pilot"),
        (lambda: monte_carlo(normal(1), 0.1, 1, pilot=2.5), "pilot"),
        (lambda: monte_carlo(lambda _, count: np.ones(count - 1), 0.1, 1), "draw"),
        (lambda: monte_carlo(lambda _, count: np.ones((count, 2)), 0.1, 1), "draw"),
    ],
)
def test_what_cannot_be_an_interval_is_refused_by_name(call, name):
    with pytest.raises(InputError) as error:
        call()
    assert error.value.name == name
