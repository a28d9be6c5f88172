"""Exponents of one coordinate beside quadrature, closed forms and published numbers."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from sensortrack.errors import InputError
from tests.strategies import rationals
from verification.exact.log_means import LONG, gaussian_log_mean
from verification.systems.cyclic_spsa.stability.almost_sure import (
    almost_sure_limit,
    lyapunov_exponent,
)
from verification.systems.cyclic_spsa.stability.steps import step_limit


def scalar(noise=0, drift=0, **changes):
    """Values as the command line makes them."""
    plain = {"h": (Fraction(1),), "H": None, "Xi": ((Fraction(noise),),), "beta": Fraction(1)}
    plain |= {"eta": (Fraction(drift),), "reading": "two", "k": Fraction(1)}
    return plain | changes


def log_mean(mean, deviation):
    """E ln|mean + deviation z| by quadrature, split where the logarithm is infinite."""
    pole = -mean / deviation
    ends = [pole] if abs(pole) < 12 else None

    def weighted(z):
        return np.log(abs(mean + deviation * z)) * np.exp(-z * z / 2) / np.sqrt(2 * np.pi)

    return quad(weighted, -12, 12, points=ends, limit=400, epsabs=1e-12)[0]


@settings(max_examples=20)
@given(rationals(-3, 3), rationals(Fraction(1, 10), 4))
def test_mean_logarithms_agree_with_quadrature(mean, deviation):
    ball = gaussian_log_mean(mean, deviation**2)
    assert float(ball.rad()) < 1e-30
    assert float(ball) == pytest.approx(log_mean(float(mean), float(deviation)), abs=1e-8)


def test_the_two_ways_to_a_mean_logarithm_meet():
    """On either side of the number of terms at which the expansion takes over."""
    variances = [Fraction(1, 2 * LONG - 1), Fraction(1, 2 * LONG + 1)]
    summed, expanded = (gaussian_log_mean(Fraction(1), v) for v in variances)
    t = [float(v) for v in variances]
    change = -(t[0] - t[1]) / 2 - 3 * (t[0] ** 2 - t[1] ** 2) / 4
    assert float(summed - expanded) == pytest.approx(change, abs=1e-16)
    assert float(expanded.rad()) < 1e-16


def test_a_centred_gaussian_has_the_known_mean_logarithm():
    known = -(np.euler_gamma + np.log(2)) / 2
    assert float(gaussian_log_mean(Fraction(0), Fraction(1))) == pytest.approx(known, rel=1e-15)
    assert float(gaussian_log_mean(Fraction(-3), Fraction(0))) == pytest.approx(np.log(3))
    with pytest.raises(ValueError, match="variance"):
        gaussian_log_mean(Fraction(0), Fraction(0))


@settings(max_examples=10)
@given(rationals(0, 3), rationals(-2, 2), rationals(Fraction(1, 20), 3))
def test_the_exponent_is_the_mean_over_draws(noise, drift, alpha):
    answer = lyapunov_exponent(scalar(noise + Fraction(1, 50), drift) | {"alpha": alpha})
    x, deviation = float(alpha), float(noise + Fraction(1, 50)) ** 0.5 / np.sqrt(2)
    centres = (1 - x + x * float(drift) / 2, 1 - x - x * float(drift) / 2)
    mean = sum(log_mean(centre, x * deviation) for centre in centres) / 2
    assert answer.value == pytest.approx(mean, abs=1e-8)
    assert answer.lower <= answer.value <= answer.upper
    assert answer.upper - answer.lower < 1e-14


@pytest.mark.parametrize(
    "noise,limit", [(1, 2.083477), (10, 0.841049), (100, 0.242961), (1000, 0.072175)]
)
def test_limits_for_growing_noise(noise, limit):
    answer = almost_sure_limit(scalar(noise))
    assert answer.value == pytest.approx(limit, abs=5e-7)
    assert answer.upper - answer.lower <= 4e-16 * answer.value
    square = step_limit(scalar(noise)).value
    assert square < answer.lower
    assert answer.more["mean_square_limit"]().data == square
    ends = (Fraction(answer.lower), Fraction(answer.upper))
    values = [lyapunov_exponent(scalar(noise) | {"alpha": end}) for end in ends]
    assert values[0].upper < 0 < values[1].lower


@settings(max_examples=6)
@given(st.integers(1, 50), rationals(Fraction(1, 9), 9), rationals(Fraction(1, 9), 9))
def test_units_do_not_matter(noise, factor, length):
    other = scalar(length**2 * noise, h=(factor,), beta=length)
    limit = almost_sure_limit(scalar(noise)).value / float(factor)
    assert almost_sure_limit(other).value == pytest.approx(limit, rel=1e-14)


def test_without_noise_both_limits_are_two():
    answer = almost_sure_limit(scalar(h=(Fraction(3),)))
    assert answer.exact == {"kind": "rational", "value": "2/3"}
    assert almost_sure_limit(scalar(7, reading="one")).value == 2
    assert lyapunov_exponent(scalar(alpha=Fraction(1))).value == "-inf"
    half = lyapunov_exponent(scalar(7, reading="one", alpha=Fraction(1, 2)))
    assert half.lower <= -np.log(2) <= half.upper


def test_with_drift_stable_steps_may_be_two_intervals():
    """m^2 = 3/4: |(1 - x)^2 - 3/4 x^2| is below 1, above, and below again."""
    values = scalar(drift=2, beta=Fraction(10**9, 866025404))
    signs = [
        lyapunov_exponent(values | {"alpha": alpha}).value < 0
        for alpha in (Fraction(1), Fraction(4), Fraction(15, 2), Fraction(9))
    ]
    assert signs == [True, False, True, False]
    with pytest.raises(InputError, match=r"^eta: "):
        almost_sure_limit(values)


@pytest.mark.parametrize("question", [almost_sure_limit, lyapunov_exponent])
def test_several_coordinates_are_refused(question):
    with pytest.raises(InputError, match=r"^h: 2 coordinates"):
        question(scalar(h=(Fraction(1),) * 2, alpha=Fraction(1)))
