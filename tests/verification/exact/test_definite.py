"""Definiteness of exact matrices: a witness either way, and a second engine that agrees."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from verification.exact.balls import ball_definite
from verification.exact.definite import (
    as_rows,
    asymmetry,
    combination,
    congruence,
    is_definite,
    negative_vector,
)
from verification.exact.evaluate import add, quadratic, scaled

sizes = st.integers(1, 5)


def dominant(rows, factor):
    """G E G' by plain fractions, and whether each row is strictly diagonally dominant."""
    n = len(rows)
    left = [[sum(g[k] * rows[k][j] for k in range(n)) for j in range(n)] for g in factor]
    product = [[sum(row[k] * g[k] for k in range(n)) for g in factor] for row in left]
    return all(2 * product[i][i] > sum(map(abs, product[i])) for i in range(n))


@given(sizes.flatmap(definite_matrices))
def test_a_definite_matrix_has_a_congruence_and_no_vector(rows):
    assert dominant(rows, congruence(rows))
    assert negative_vector(rows) is None


@given(sizes.flatmap(definite_matrices), st.data())
def test_a_matrix_with_a_direction_removed_has_a_vector(rows, data):
    """E - t vv'/(v'E^-1 v) is singular for t = 1 and indefinite beyond: both sides exactly."""
    n = len(rows)
    v = data.draw(st.lists(rationals(-3, 3, 4), min_size=n, max_size=n).filter(any))
    inverse = np.linalg.inv(np.array(rows, dtype=float))
    size = Fraction(float(np.array(v, float) @ inverse @ np.array(v, float)))
    outer = tuple(tuple(a * b for b in v) for a in v)
    beyond = add(rows, outer, -Fraction(11, 10) / size)
    x = negative_vector(beyond)
    assert x is not None
    assert quadratic(x, beyond) <= 0
    assert congruence(beyond) is None
    assert is_definite(add(rows, outer, -Fraction(9, 10) / size))


@given(sizes.flatmap(definite_matrices))
def test_the_ball_engine_agrees(rows):
    assert ball_definite(rows) is True
    assert ball_definite(scaled(-1, rows)) is False


@pytest.mark.parametrize(
    "rows",
    [[[0]], [[1, 1], [1, 1]], [[2, -1, -1], [-1, 2, -1], [-1, -1, 2]], [[0, 1], [1, 0]], [[-1]]],
)
def test_semidefinite_ties_are_decided_exactly(rows):
    rows = as_rows(rows)
    x = negative_vector(rows)
    assert x is not None
    assert quadratic(x, rows) <= 0


@pytest.mark.parametrize("exponent", [20, 60, 120])
def test_a_hair_beside_singular_is_decided(exponent):
    hair = Fraction(1, 10**exponent)
    assert is_definite(as_rows([[1, 1 - hair], [1 - hair, 1]]))
    assert not is_definite(as_rows([[1, 1 + hair], [1 + hair, 1]]))


def test_wildly_scaled_entries_are_no_obstacle():
    small = Fraction(1, 10**300)
    rows = as_rows([[small, 0, 0], [0, 1, Fraction(1, 2)], [0, Fraction(1, 2), 1 / small]])
    assert dominant(rows, congruence(rows))


@given(st.integers(2, 4).flatmap(lambda n: st.tuples(*[definite_matrices(n)] * 2)), rationals(0, 5))
def test_a_sum_of_proved_matrices_is_found(two, factor):
    rows = add(two[0], two[1], factor)
    found = dict(combination(rows, {3: two[0], 7: two[1]}))
    total = scaled(0, rows)
    for k, c in found.items():
        assert c > 0
        total = add(total, {3: two[0], 7: two[1]}[k], c)
    assert found
    assert total == rows


def test_a_difference_is_no_combination():
    a, b = as_rows([[2, 0], [0, 1]]), as_rows([[1, 0], [0, 1]])
    assert combination(add(a, b, -Fraction(1, 2)), {0: a, 1: b}) == []
    assert combination(as_rows([[1, 1], [1, 5]]), {0: a, 1: b}) == []


def test_the_first_unlike_pair_is_named():
    assert asymmetry(as_rows([[1, 2], [0, 1]])) == (0, 1)
    assert asymmetry(as_rows([[1, 2], [2, 1]])) is None
