"""Matrices put into formulas, beside numpy on integers."""

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from theory.algebra.noncommuting import letters, scalars
from verification.exact.evaluate import add, at, identity, matrices, multiply, quadratic, scaled

entries = st.integers(-9, 9)
squares = st.lists(st.lists(entries, min_size=3, max_size=3), min_size=3, max_size=3)


def exact(rows):
    return tuple(tuple(Fraction(x) for x in row) for row in rows)


def same(rows, array):
    return [[int(x) for x in row] for row in rows] == np.asarray(array).tolist()


@given(squares, squares, entries)
def test_arithmetic_is_that_of_integers(a, b, c):
    x, y = np.array(a), np.array(b)
    assert same(multiply(exact(a), exact(b)), x @ y)
    assert same(add(exact(a), exact(b), c), x + c * y)
    assert same(scaled(c, exact(a)), c * x)
    assert quadratic(tuple(b[0]), exact(a)) == int(y[0] @ x @ y[0])


@given(squares, squares, entries)
def test_a_form_takes_words_transposes_and_powers(a, b, step):
    A, B = letters("A B")
    (h,) = scalars("h")
    form = 2 * A + h * (A.T * B) - h * h * (B * A)
    x, y = np.array(a), np.array(b)
    values = {"A": exact(a), "B": exact(b)}
    parts = matrices(form, values)
    assert same(parts[0], 2 * x)
    assert same(parts[1], x.T @ y)
    assert same(parts[2], -(y @ x))
    assert same(at(form, values, Fraction(step)), 2 * x + step * (x.T @ y) - step**2 * (y @ x))


def test_the_identity():
    assert same(identity(2), [[1, 0], [0, 1]])
