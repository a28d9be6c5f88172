"""Claims about angles, distances, weights and cost, on a second road: plain numbers."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from theory.algebra.moments import COSINE, SINE
from verification.systems.cyclic_spsa.claims import DECISIONS
from verification.systems.cyclic_spsa.claims.moments import gaussian_errors

angles = st.floats(-math.pi, math.pi)
places = st.tuples(st.floats(-300, 300), st.floats(-300, 300))
HERMITE, WEIGHTS = np.polynomial.hermite_e.hermegauss(40)
WEIGHTS = WEIGHTS / WEIGHTS.sum()


def polar(sensor, psi, rho):
    """(13)."""
    return np.array(sensor) + rho * np.array([np.sin(psi), np.cos(psi)])


def printed_rotation(psi):
    """R of (14)."""
    return np.array([[math.sin(psi), -math.cos(psi)], [math.cos(psi), math.sin(psi)]])


@given(places, angles, st.floats(1, 300))
def test_the_angle_in_its_quadrant_gives_the_place_and_the_quotient_its_mirror_image(s, psi, rho):
    r = polar(s, psi, rho)
    east, north = r - np.array(s)
    back = polar(s, math.atan2(east, north), math.hypot(east, north))
    assert back == pytest.approx(r, abs=1e-9)
    if abs(north) > 1e-3:
        printed = polar(s, math.atan(east / north), math.hypot(east, north))
        wanted = r if north > 0 else 2 * np.array(s) - r
        assert printed == pytest.approx(wanted, abs=1e-9)


@pytest.mark.parametrize("degrees", [0.5, 10.0])
def test_the_mean_position_is_short_by_the_mean_cosine(degrees):
    """Gauss-Hermite quadrature of a Gaussian angle error."""
    sigma = math.radians(degrees)
    mean = sum(
        w * polar((0, 0), 0.7 + sigma * x, 300) for x, w in zip(HERMITE, WEIGHTS, strict=True)
    )
    cosine = 1 + gaussian_errors(sigma, 0)[0]
    assert cosine == pytest.approx(math.exp(-(sigma**2) / 2), rel=1e-15)
    assert mean == pytest.approx(cosine * polar((0, 0), 0.7, 300), rel=1e-12)


def test_the_mean_cosine_and_sine_of_a_gaussian_angle_are_known():
    assert COSINE.mean == {1: 1}
    assert SINE.mean == {}


def test_the_bias_at_half_a_degree_is_eleven_metres_in_three_hundred_kilometres():
    assert "11.42 m" in DECISIONS["cyclic_spsa.eq_2_zero_mean"]().reason


def test_the_rows_of_the_replay_are_four_positions_and_their_mean():
    table = DECISIONS["cyclic_spsa.eq_2_zero_mean"]().replay
    rows = [[Fraction(x) for x in row] for row in table[1:-1]]
    for cosine, sine, distance, east, north, probability in rows:
        assert cosine**2 + sine**2 == 1
        assert (east, north) == (distance * sine, distance * cosine)
        assert probability == Fraction(1, 4)
    for place in (3, 4):
        assert sum(row[place] for row in rows) / 4 == Fraction(table[-1][place])


@settings(max_examples=40)
@given(angles, st.floats(10, 300))
def test_the_covariance_is_that_of_small_errors(psi, rho):
    """The derivative of (13) by differences; (14) has its two variances swapped."""
    f, k, step = 0.0087, 0.05, 1e-6
    by_angle = (polar((0, 0), psi + step, rho) - polar((0, 0), psi - step, rho)) / (2 * step)
    by_range = (polar((0, 0), psi, rho + step) - polar((0, 0), psi, rho - step)) / (2 * step)
    jacobian = np.column_stack([by_angle, by_range])
    true = jacobian @ np.diag([f**2, (rho * k) ** 2]) @ jacobian.T
    turn = printed_rotation(psi)
    along, across = (rho * k) ** 2, (rho * f) ** 2
    assert true == pytest.approx(turn @ np.diag([along, across]) @ turn.T, rel=1e-6, abs=1e-6)
    printed = turn @ np.diag([across, along]) @ turn.T
    assert np.linalg.norm(printed - true) / np.linalg.norm(true) > 1
    assert np.trace(printed) == pytest.approx(np.trace(true))


@given(angles)
def test_the_printed_matrix_turns_by_a_right_angle_less_psi(psi):
    turn = math.pi / 2 - psi
    true = [[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]]
    assert printed_rotation(psi) == pytest.approx(np.array(true), abs=1e-12)


def test_errors_over_distance_have_one_law_at_all_distances():
    """The same draws at two distances: equal after division, unequal before."""
    rng = np.random.default_rng(1)
    turns, stretch = rng.normal(0, 0.1, 50), 1 + rng.normal(0, 0.05, 50)
    near, far = (
        np.array(
            [
                polar((0, 0), t, rho * q) - polar((0, 0), 0, rho)
                for t, q in zip(turns, stretch, strict=True)
            ]
        )
        for rho in (3.0, 12.0)
    )
    assert near / 3 == pytest.approx(far / 12)
    assert np.mean(far**2) == pytest.approx(16 * np.mean(near**2))


@given(st.floats(-math.pi, math.pi), st.floats(-2, 3), st.floats(0.1, 300))
def test_the_error_is_at_most_the_sum_of_both_distances(turn, ratio, rho):
    """The measured distance is `ratio` times the true one, negative by a gross error."""
    miss = polar((0, 0), turn, ratio * rho) - polar((0, 0), 0, rho)
    assert np.linalg.norm(miss) <= rho * (1 + abs(ratio)) * (1 + 1e-12)


def test_the_fourth_moment_grows_as_the_fourth_power_of_the_distance():
    sigma = math.radians(0.5)
    moments = [
        sum(
            w * np.linalg.norm(polar((0, 0), sigma * x, rho) - polar((0, 0), 0, rho)) ** 4
            for x, w in zip(HERMITE, WEIGHTS, strict=True)
        )
        for rho in (1.0, 10.0)
    ]
    assert moments[1] == pytest.approx(1e4 * moments[0])
