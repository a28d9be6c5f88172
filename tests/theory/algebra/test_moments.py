"""Means of polynomials in sines and cosines of a Gaussian angle."""

from fractions import Fraction

import numpy as np
import pytest

from theory.algebra.moments import COSINE, ONE, SINE, Wave
from theory.systems.bearing_dac.noise import SPREAD, mean_outer


def power(wave, exponent):
    total = ONE
    for _ in range(exponent):
        total = total * wave
    return total


def test_sine_and_cosine_are_those_of_one_angle():
    assert (SINE * SINE + COSINE * COSINE).terms == ONE.terms
    assert (SINE * COSINE).times(2).terms == Wave({2: SINE.terms[1], -2: SINE.terms[-1]}).terms


@pytest.mark.parametrize("sines", range(5))
@pytest.mark.parametrize("cosines", range(4))
@pytest.mark.parametrize("sigma", [0.1, 0.7, 2.0])
def test_means_are_the_integrals(sines, cosines, sigma):
    """The trapezoidal rule as the second road, which is as exact as doubles for a bell."""
    nodes = np.linspace(-12, 12, 4001)
    weights, angle = np.exp(-(nodes**2) / 2), sigma * nodes
    values = np.sin(angle) ** sines * np.cos(angle) ** cosines
    integral = (weights * values).sum() / weights.sum()
    found = (power(SINE, sines) * power(COSINE, cosines)).mean
    value = sum(float(c) * np.exp(-(sigma**2) * k / 2) for k, c in found.items())
    assert value == pytest.approx(integral, abs=1e-12)


def test_a_sum_that_is_not_real_has_no_mean():
    with pytest.raises(ValueError, match="not real"):
        _ = Wave({1: (Fraction(0), Fraction(1))}).mean


def test_only_the_squares_are_left_in_the_mean_of_a_measured_outer_product():
    found = mean_outer()
    half = Fraction(1, 2)
    assert found["h", "phi"] == found["phi", "h"] == {}
    assert SPREAD == found["phi", "phi"] == {0: half, 4: -half}
    assert found["h", "h"] == {0: half, 4: half}


def test_the_measured_direction_is_that_of_the_law_at_the_measured_angle():
    """h(theta + d) from the law of the system, beside the combination that is averaged."""
    import sympy

    from theory.systems.bearing_dac.model import SYSTEM

    assert SYSTEM.law("Proposition 1").right == "column(-sin(theta), cos(theta))"
    theta, d = sympy.symbols("theta d", real=True)
    h = sympy.Matrix([-sympy.sin(theta), sympy.cos(theta)])
    phi = sympy.Matrix([sympy.cos(theta), sympy.sin(theta)])
    turned = h.subs(theta, theta + d)
    combined = sympy.cos(d) * h - sympy.sin(d) * phi
    assert sympy.simplify(sympy.expand_trig(turned) - combined) == sympy.zeros(2, 1)
    assert sympy.simplify(h * h.T + phi * phi.T) == sympy.eye(2)
