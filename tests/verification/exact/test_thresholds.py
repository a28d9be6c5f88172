"""The first h at which a concave matrix polynomial stops being positive definite."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from verification.exact.definite import is_definite
from verification.exact.evaluate import add, quadratic, scaled
from verification.exact.roots import determinant, interpolate, root_between
from verification.exact.thresholds import concave_threshold, value_of


def value(powers, h):
    return add(add(powers[0], powers[1], h), powers[2], h * h)


def triples(n):
    return st.tuples(definite_matrices(n), definite_matrices(n), definite_matrices(n))


@settings(max_examples=40)
@given(st.integers(1, 4).flatmap(triples))
def test_both_sides_are_right_and_a_grid_of_eigenvalues_agrees(three):
    powers = {0: three[0], 1: three[1], 2: scaled(-1, three[2])}
    found = concave_threshold(powers)
    assert found is not None
    assert is_definite(value(powers, found.lower))
    assert quadratic(found.vector, value(powers, found.upper)) <= 0
    assert found.upper - found.lower <= Fraction(1, 10**14) * found.upper
    for part in (0.2, 0.5, 0.9, 0.999):  # an independent road: floating-point eigenvalues
        inner = np.array(value(powers, Fraction(part * float(found.lower))), dtype=float)
        assert np.linalg.eigvalsh(inner)[0] > 0
    outer = np.array(value(powers, Fraction(1.001) * found.upper), dtype=float)
    assert np.linalg.eigvalsh(outer)[0] < 0


@given(rationals(Fraction(1, 10), 9), rationals(0, 9), rationals(Fraction(1, 10), 9))
def test_scalars_follow_the_quadratic_formula(m, c, k):
    powers = {0: ((4 * m,),), 1: ((2 * c,),), 2: ((-k,),)}
    expected = (c + math.sqrt(c * c + 4 * m * k)) / k
    assert value_of(concave_threshold(powers)) == pytest.approx(float(expected), rel=1e-14)


def test_a_rational_threshold_is_recognised():
    found = concave_threshold({0: ((Fraction(4),),), 1: ((Fraction(2),),), 2: ((Fraction(-2),),)})
    assert found.exact.to_data() == {"kind": "rational", "value": "2"}
    assert (found.upper, value_of(found)) == (2, 2.0)


def test_an_exact_threshold_isolates_one_root_of_its_polynomial():
    one = ((Fraction(1),),)
    exact = concave_threshold({0: scaled(4, one), 1: scaled(2, one), 2: scaled(-1, one)}).exact
    assert exact.polynomial == (-4, -2, 1)
    assert exact.low < Fraction(exact.nearest) < exact.high
    data = exact.to_data()
    low, high = map(Fraction, data["interval"])
    signs = [sum(c * x**k for k, c in enumerate(data["polynomial"])) > 0 for x in (low, high)]
    assert signs == [False, True]


@given(st.lists(st.integers(-9, 9), min_size=1, max_size=6).filter(lambda c: c[-1] != 0))
def test_interpolation_finds_the_polynomial_up_to_a_factor(coefficients):
    found = interpolate(
        lambda x: sum((Fraction(c, 7) * x**k for k, c in enumerate(coefficients)), Fraction(0)), 7
    )
    ratio = Fraction(found[-1], coefficients[-1])
    assert [c * ratio for c in coefficients] == list(found)


def test_no_root_and_two_roots_are_told_from_one():
    assert root_between((-2, 0, 1), Fraction(2), Fraction(3)) is None
    assert root_between((6, -5, 1), Fraction(1), Fraction(4)) is None
    assert root_between((6, -5, 1), Fraction(1), Fraction(5, 2)).low == 2


@given(st.integers(1, 4).flatmap(definite_matrices))
def test_the_determinant_is_that_of_floats(rows):
    assert float(determinant(rows)) == pytest.approx(np.linalg.det(np.array(rows, float)), rel=1e-6)
