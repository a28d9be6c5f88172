"""Bias and covariance of (13): quadrature, small angles, the published numbers."""

from fractions import Fraction
from math import exp, expm1, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from verification.systems.cyclic_spsa.network.measurement_moments import measurement_moments

HALF_DEGREE = Fraction(pi / 360)


def moments(angle, distance):
    given_ = {"sigma_bearing_rad": Fraction(angle), "sigma_range_rel": Fraction(distance)}
    return measurement_moments(given_).value


def quadrature(angle, distance):
    """The same moments by Gauss-Hermite quadrature of (13) itself, target on the second axis."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(60)
    weights = np.outer(weights, weights) / weights.sum() ** 2
    psi, rho = np.meshgrid(angle * nodes, 1 + distance * nodes, indexing="ij")
    across, along = rho * np.sin(psi), rho * np.cos(psi) - 1
    mean = [(weights * x).sum() for x in (along, across)]
    assert abs(mean[1]) < 1e-14
    return [mean[0], (weights * along**2).sum() - mean[0] ** 2, (weights * across**2).sum()]


@settings(max_examples=40, deadline=None)
@given(
    st.fractions(Fraction(0), Fraction(1), max_denominator=50),
    st.fractions(Fraction(0), Fraction(1), max_denominator=50),
)
def test_moments_are_those_of_quadrature(angle, distance):
    wanted = quadrature(float(angle), float(distance))
    assert moments(angle, distance) == pytest.approx(wanted, rel=1e-10, abs=1e-14)


def test_moments_have_the_published_closed_forms():
    p, s = float(HALF_DEGREE), 0.05
    radial = (1 + s * s) * (1 + exp(-2 * p * p)) / 2 - exp(-p * p)
    across = -(1 + s * s) * expm1(-2 * p * p) / 2
    found = moments(HALF_DEGREE, "0.05")
    assert found == pytest.approx([expm1(-p * p / 2), radial, across], rel=1e-12)
    # -11.4 m at 300 km; the trace is E|xi|^2 less the squared bias
    assert found[0] == pytest.approx(-3.807645e-5, rel=1e-6)
    assert found[1:] == pytest.approx([0.002499812528, 7.633892714e-5], rel=1e-9)


def test_ten_degrees_of_noise_shorten_the_range_by_a_percent_and_a_half():
    assert moments(Fraction(pi / 18), 0)[0] == pytest.approx(-0.0151154, rel=1e-5)


@pytest.mark.parametrize("size", [1, 40, 150])
def test_small_angles_keep_their_digits(size):
    angle = Fraction(1, 10**size)
    bias, radial, across = moments(angle, 0)
    p = float(angle)
    assert bias == pytest.approx(-p * p / 2, rel=1e-15 + 1.1 * p * p, abs=0)
    assert across == pytest.approx(p * p, rel=1e-15 + 1.1 * p * p, abs=0)
    if size <= 40:
        assert radial == pytest.approx(p**4 / 2, rel=1e-15 + 2 * p * p, abs=0)


def test_no_noise_means_no_error():
    assert moments(0, 0) == [0, 0, 0]


@pytest.mark.parametrize(
    "name, bad", [("sigma_bearing_rad", "-1"), ("sigma_range_rel", "-1"), ("sigma_bearing_rad", 4)]
)
def test_moments_refuse_numbers_out_of_range(name, bad):
    given_ = {"sigma_bearing_rad": Fraction(1, 100), "sigma_range_rel": Fraction(1, 20)}
    with pytest.raises(InputError) as raised:
        measurement_moments({**given_, name: Fraction(bad)})
    assert raised.value.name == name
    assert ("degrees" in str(raised.value)) == (bad == 4)
