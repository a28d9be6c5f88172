"""Affine matrices of unknowns: what is written is what is evaluated, exactly and in doubles."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import rationals
from verification.exact.evaluate import add, identity, multiply, scaled
from verification.lmi.affine import block, known, product, rectangular, symmetric


def transpose(a):
    return tuple(zip(*a, strict=True))


def matrices(rows, columns):
    row = st.tuples(*[rationals(-3, 3, 7)] * columns)
    return st.tuples(*[row] * rows)


def symmetrics(n):
    return matrices(n, n).map(lambda a: add(a, transpose(a)))


@settings(max_examples=40)
@given(st.integers(1, 3), st.data())
def test_an_inequality_is_what_it_reads(n, data):
    a, p, y = (data.draw(s) for s in (matrices(n, n), symmetrics(n), matrices(1, n)))
    r, c = data.draw(rationals(-2, 2)), data.draw(matrices(n, 1))
    unknown, gain = symmetric("P", n), rectangular("Y", 1, n)
    written = (
        r**2 * unknown - known(a).T @ unknown @ known(a) + known(c) @ gain - gain.T @ known(c).T
    )
    cy = multiply(c, y)
    meant = add(scaled(r**2, p), multiply(multiply(transpose(a), p), a), -1)
    meant = add(add(meant, cy), transpose(cy), -1)
    assert written.at({"P": p, "Y": y}) == meant
    assert written.T.at({"P": p, "Y": y}) == transpose(meant)
    assert set(written.unknowns) == {"P", "Y"}
    floats = {name: np.array(value, dtype=float) for name, value in {"P": p, "Y": y}.items()}
    assert np.allclose(written.expression(floats), np.array(meant, dtype=float))


@settings(max_examples=30)
@given(st.integers(1, 3), st.integers(1, 3), st.data())
def test_blocks_stand_where_they_are_written(n, m, data):
    p, z, y = (data.draw(s) for s in (symmetrics(n), symmetrics(m), matrices(m, n)))
    unknown = rectangular("Y", m, n)
    whole = block([[symmetric("Z", m), unknown], [unknown.T, symmetric("P", n)]])
    found = whole.at({"P": p, "Z": z, "Y": y})
    top = tuple(a + b for a, b in zip(z, y, strict=True))
    assert found == top + tuple(a + b for a, b in zip(transpose(y), p, strict=True))


@given(st.integers(1, 4), st.integers(1, 4), st.integers(1, 4), st.data())
def test_products_are_exact(n, m, k, data):
    a, b = data.draw(matrices(n, m)), data.draw(matrices(m, k))
    assert product(a, b) == multiply(a, b)
    assert product(a, identity(m)) == a
    assert product(identity(m), b) == b


def test_a_tall_slice_of_the_identity_is_not_the_identity():
    tall = ((Fraction(1), Fraction(0)), (Fraction(0), Fraction(1)), (Fraction(0), Fraction(0)))
    assert product(tall, identity(2)) == tall
    assert product(identity(3), tall) == tall


def test_what_cannot_be_is_refused():
    p, y = symmetric("P", 2), rectangular("Y", 1, 2)
    with pytest.raises(ValueError, match="a product of two unknown matrices"):
        y @ p
    with pytest.raises(ValueError, match="do not multiply"):
        known(identity(3)) @ p
    with pytest.raises(ValueError, match="a sum needs like shapes"):
        p + y
    with pytest.raises(ValueError, match="block 2,1 is"):
        block([[p, y.T], [y.T, p]])
    with pytest.raises(ValueError, match="block row 2 has 1 parts; 2 are needed"):
        block([[p, y.T], [y]])
