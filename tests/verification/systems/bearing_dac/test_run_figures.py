"""Figures of runs and steps say what the exact numbers say."""

import math
from fractions import Fraction
from itertools import pairwise

import pytest

from sensortrack.networks import read_network
from verification.exact.runs.filippov import filippov_run
from verification.exact.runs.prox import explicit_step, implicit_step
from verification.systems.bearing_dac.run_figures import (
    agreement_plot,
    chattering_plot,
    entries_over_time,
    norm_over_time,
    stepped,
)

CYCLE = read_network("cycle:6")
START = [Fraction(v) for v in (5, -2, 0, 3, 1, -4)]
ZERO = [Fraction(0)] * 6


def heights(curve):
    return dict(zip(curve.x, curve.y, strict=True))


def test_norms_are_those_of_the_run_and_fall():
    run = filippov_run(CYCLE, Fraction(2), START)
    times, norms = norm_over_time(run, 5)
    assert len(times) == 5 * len(run.pieces) + 1
    assert times[0] == 0
    assert norms[-1] == 0
    for time, norm in zip(times, norms, strict=True):
        point = run.at(min(Fraction(time), run.times[-1]))
        assert norm == pytest.approx(math.hypot(*map(float, point)), abs=1e-12)
    assert list(norms) == sorted(norms, reverse=True)
    lines = entries_over_time(run)
    assert [line[1][0] for line in lines] == [float(v) for v in run.points[0]]
    assert all(line[0] == tuple(map(float, run.times)) for line in lines)


def test_a_run_stays_below_its_proved_bound():
    plot = agreement_plot(CYCLE, ZERO, Fraction(2), START)
    bound, run, printed = plot.curves
    slope = bound.y[0] / bound.x[1]
    assert all(y <= bound.y[0] - slope * x + 1e-12 for x, y in heights(run).items() if y)
    assert run.x[-1] <= bound.x[1]
    assert printed.x[0] == pytest.approx(bound.y[0])  # lambda_2 is 1
    assert f"{run.x[-1]:.5g}" in plot.finding


def test_a_driven_run_on_the_slowest_ray_is_the_bound_itself():
    path = read_network("path:4")
    gamma = [Fraction(1)] * 4
    push = [(Fraction(9), [Fraction(v) for v in (1, 1, -1, -1)])]
    x0 = [Fraction(v) for v in (1, 1, 0, 0)]
    bound, run, _ = agreement_plot(path, gamma, Fraction(3), x0, push).curves
    slope = bound.y[0] / bound.x[1]
    for time, norm in heights(run).items():
        assert norm == pytest.approx(max(0.0, bound.y[0] - slope * time), abs=1e-12)
    short = [(Fraction(1, 9), push[0][1])]
    assert "does not agree" in agreement_plot(path, gamma, Fraction(3), x0, short).finding
    with pytest.raises(ValueError, match="above the threshold"):
        agreement_plot(path, gamma, Fraction(2), x0)


def test_explicit_steps_chatter_and_implicit_ones_agree():
    plot = chattering_plot(CYCLE, Fraction(1, 3), START, 30)
    explicit, implicit = plot.curves
    assert min(explicit.y) > 0
    assert implicit.y[-1] == 0
    assert f"by {min(explicit.y[15:]):.3g} to {max(explicit.y[15:]):.3g}" in plot.finding
    assert f"agree exactly after {implicit.y.index(0.0)}" in plot.finding
    short = chattering_plot(CYCLE, Fraction(1, 3), START, 2)
    assert "do not agree yet" in short.finding
    still = chattering_plot(CYCLE, Fraction(1, 3), ZERO, 3)
    assert still.y.high == 1.0


@pytest.mark.parametrize("step", [explicit_step, implicit_step])
def test_steps_follow_one_another(step):
    points = stepped(CYCLE, START, Fraction(1, 3), 4, step)
    assert len(points) == 5
    assert all(step(CYCLE, a, Fraction(1, 3)) == b for a, b in pairwise(points))
