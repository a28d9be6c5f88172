"""Elimination with symmetric pivots: a factor, or a vector at which the form is negative."""

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from verification.exact.evaluate import identity, multiply, quadratic
from verification.exact.semidefinite import split

ENTRIES = st.integers(-3, 3).map(Fraction)


@st.composite
def symmetric(draw):
    n = draw(st.integers(1, 5))
    rows = [[draw(ENTRIES) for _ in range(n)] for _ in range(n)]
    return tuple(tuple(rows[min(i, j)][max(i, j)] for j in range(n)) for i in range(n))


@st.composite
def gram(draw):
    n, rank = draw(st.integers(1, 5)), draw(st.integers(1, 5))
    left = tuple(tuple(draw(ENTRIES) for _ in range(rank)) for _ in range(n))
    return multiply(left, tuple(zip(*left, strict=True)))


def check(rows):
    found, n = split(rows), len(rows)
    if found.factor is None:
        assert quadratic(found.vector, rows) < 0
        return found
    diagonal = tuple(
        tuple(p if i == j else Fraction(0) for j in range(len(found.pivots)))
        for i, p in enumerate(found.pivots)
    )
    turned = tuple(zip(*found.factor, strict=True))
    assert min(found.pivots) > 0
    assert multiply(multiply(found.factor, diagonal), turned) == rows
    assert len(found.rows) + len(found.kernel) == n
    for z in found.kernel:
        assert any(z)
        assert not any(any(row) for row in multiply(rows, tuple((x,) for x in z)))
    return found


@given(symmetric())
def test_every_symmetric_matrix_is_decided(rows):
    found = check(rows)
    least = np.linalg.eigvalsh(np.array(rows, float)).min()
    assert (least < -1e-9) <= (found.factor is None) <= (least < 1e-9)


@given(gram())
def test_gram_matrices_are_semidefinite_and_their_kernel_is_spanned(rows):
    found = check(rows)
    assert found.factor is not None
    assert len(found.rows) == np.linalg.matrix_rank(np.array(rows, float))
    assert not found.kernel or np.linalg.matrix_rank(np.array(found.kernel, float)) == len(
        found.kernel
    )


def test_zero_and_identity():
    zero = ((Fraction(0),) * 2,) * 2
    assert check(zero).rows == ()
    assert check(identity(3)).pivots == (1, 1, 1)
