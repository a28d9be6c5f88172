"""Ticks are few, round and show the deciding value; simplified lines stay where they were."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from verification.figure import Axis, Plot
from verification.report.axes import TOLERANCE, Scale, number, path, simplified, ticks
from verification.report.plots import DIGIT, LEFT, plot

ends = st.floats(-1e6, 1e6)


@given(ends, st.floats(1e-3, 1e6))
def test_ticks_are_few_and_within_the_axis(low, span):
    axis = Axis("x", "", low, low + span)
    found = ticks(axis)
    assert 1 <= len(found) <= 8
    assert all(low - 1e-6 * span <= value <= low + span * (1 + 1e-6) for value in found)
    assert found == sorted(found)


@given(st.floats(-12, 6), st.floats(0.4, 1.99))
def test_a_short_logarithmic_axis_has_ticks_to_read_it_by(low, decades):
    axis = Axis("x", "", 10**low, 10 ** (low + decades), log=True)
    found = ticks(axis)
    assert 1 <= len(found) <= 7
    assert found == sorted(found)
    assert all(axis.low * 0.999 <= value <= axis.high * 1.001 for value in found)
    assert all(f"{value:.0e}"[0] in "125" for value in found)


@given(st.floats(-12, 6), st.floats(2, 12))
def test_ticks_of_a_logarithmic_axis_are_powers_of_ten(low, decades):
    axis = Axis("x", "", 10**low, 10 ** (low + decades), log=True)
    assert len(ticks(axis)) <= 7
    assert all(abs(np.log10(value) - round(np.log10(value))) < 1e-9 for value in ticks(axis))


def test_the_deciding_value_is_marked_and_its_neighbours_give_way():
    found = ticks(Axis("h", "s", 0.0, 4.0, ticks=(3.236,)))
    assert 3.236 in found
    assert 3.0 not in found


@pytest.mark.parametrize(
    "value,text",
    [(0, "0"), (-1.5, "−1.5"), (1e-6, "10⁻⁶"), (100, "100"), (1e6, "10⁶"), (0.1, "0.1")],
)
def test_ticks_are_written_shortly(value, text):
    assert number(value) == text


def test_a_scale_maps_its_ends_and_holds_what_is_far_outside():
    scale = Scale(Axis("x", "", 1.0, 100.0, log=True), 0.0, 10.0)
    assert scale((1.0, 10.0, 100.0)) == pytest.approx([0, 5, 10])
    assert np.isfinite(scale((1e-300, 1e300))).all()


def distance(point, x, y):
    """From a point to the nearest place of a line through points."""
    px, py, dx, dy = point[0] - x[:-1], point[1] - y[:-1], np.diff(x), np.diff(y)
    along = np.clip((px * dx + py * dy) / np.maximum(dx * dx + dy * dy, 1e-300), 0, 1)
    return np.hypot(px - along * dx, py - along * dy).min()


@given(st.integers(0, 10**6))
def test_a_simplified_line_leaves_no_point_farther_than_the_tolerance(seed):
    rng = np.random.default_rng(seed)
    x, y = np.linspace(0, 400, 600), np.cumsum(rng.normal(size=600))
    keep = simplified(x, y)
    assert keep[0]
    assert keep[-1]
    away = [distance(p, x[keep], y[keep]) for p in zip(x, y, strict=True)]
    assert max(away) <= TOLERANCE + 1e-9


def test_a_straight_line_of_many_points_becomes_two():
    x = np.linspace(0, 400, 1000)
    assert path(x, 2 * x).count("L") == 1


@pytest.mark.parametrize("top", [1.0, 4e-14, 123456.0])
def test_no_label_of_the_vertical_axis_is_cut_off(top):
    figure = Plot("t", "finding", "caption", Axis("x", "", 0, 1), Axis("y", "", -top, top))
    left = float(dict(plot(figure, "p").attributes)["viewBox"].split()[0])
    labels = [number(value) for value in ticks(figure.y)]
    assert left <= LEFT - 8 - max(map(len, labels)) * DIGIT
    assert left <= 0
