"""Moments of laws and quadratic forms, and second moments of recursions, beside enumeration."""

from fractions import Fraction
from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from theory.algebra.moments.laws import RADEMACHER, gaussian, symmetric, two_point
from theory.algebra.moments.quadratic import (
    Fourth,
    agrees,
    coincidences,
    fourth,
    mean_square,
    variance,
)
from theory.algebra.moments.recursions import Randomness
from theory.algebra.noncommuting import letters

LAWS = [RADEMACHER, two_point(Fraction(3, 2)), gaussian(Fraction(1, 3)), symmetric([2, 7])]


def test_moments_of_known_laws():
    assert [gaussian(2).moment(k) for k in (0, 1, 2, 3, 4, 6)] == [1, 0, 2, 0, 12, 120]
    assert [RADEMACHER.moment(k) for k in range(5)] == [1, 0, 1, 0, 1]
    assert gaussian(Fraction(5, 7)).excess == 0
    assert RADEMACHER.excess == -2


@pytest.mark.parametrize("moments", [[-1], [2, 3], [1, 2, 3]])
def test_moments_that_no_law_has_are_refused(moments):
    with pytest.raises(ValueError, match="moments"):
        symmetric(moments)


def test_what_is_not_known_is_refused():
    with pytest.raises(ValueError, match="up to"):
        symmetric([1, 2]).moment(6)
    with pytest.raises(ValueError, match="order"):
        RADEMACHER.moment(-2)
    with pytest.raises(ValueError, match="variance"):
        gaussian(-1)


def test_there_are_fifteen_ways_for_four_indices_to_coincide():
    assert len({*coincidences(4)}) == 15


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_fourth_moments_hold_in_every_case(law):
    assert agrees(fourth(law), law)
    assert not agrees(Fourth(law.variance**2, law.excess + 1), law)


@given(st.lists(st.integers(-4, 4), min_size=6, max_size=6), st.integers(1, 3))
@settings(max_examples=20)
def test_squares_of_quadratic_forms_agree_with_all_signs(entries, size):
    q = [[Fraction(0)] * 3 for _ in range(3)]
    for (i, j), x in zip(((0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)), entries, strict=True):
        q[i][j] = q[j][i] = Fraction(x)
    law = two_point(size)
    forms = [
        sum(q[i][j] * x[i] * x[j] for i in range(3) for j in range(3))
        for x in product((-size, size), repeat=3)
    ]
    mean = Fraction(sum(forms), 8)
    assert mean_square(q, law) == sum(f * f for f in forms) / 8
    assert variance(q, law) == sum((f - mean) ** 2 for f in forms) / 8


def test_a_gaussian_quadratic_form_has_the_textbook_variance():
    q = [[Fraction(1), Fraction(2)], [Fraction(2), Fraction(-3)]]
    assert variance(q, gaussian(5)) == 2 * 25 * (1 + 4 + 4 + 9)


def test_words_of_another_structure_are_refused():
    random = Randomness({"x": RADEMACHER}, {"y": "N"}, frozenset("QN"))
    x, y, q, a = letters("x y Q A", ("Q", "N"))
    for form in (x * (y.T * q * y) * (y.T * q * y) * x.T, x * (x.T * a * x) * x.T, x * q * x.T):
        with pytest.raises(ValueError, match="word"):
            random.mean(form)
    with pytest.raises(ValueError, match="fourth moments of y"):
        random.mean(y * (y.T * q * y) * y.T)


def test_odd_words_vanish_and_even_ones_split():
    random = Randomness({"x": gaussian(2)}, {"y": "N"}, frozenset("QN"))
    x, y, q = letters("x y Q", ("Q", "N"))
    assert not random.mean(x * y.T).terms
    assert str(random.mean(x * (x.T * q * x) * x.T)) == "8*Q + 4*trace(Q)*I"
    assert str(random.mean(y * (x.T * q * x) * y.T)) == "2*trace(Q)*N"
    assert str(random.mean(x * (y.T * q * y) * x.T)) == "2*trace(Q*N)*I"
    assert str(random.mean(q * x * x.T)) == "2*Q"
