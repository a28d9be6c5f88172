"""Exact bases of what linear constraints leave free, beside sympy and random numbers."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.theory.substitution import substituted
from theory.algebra.constraints import inverse, null_space, reduced, reduction

ENTRIES = st.integers(-3, 3)


@st.composite
def matrices(draw):
    d = draw(st.integers(2, 5))
    rows = draw(st.integers(1, d - 1))
    return draw(st.lists(st.lists(ENTRIES, min_size=d, max_size=d), min_size=rows, max_size=rows))


def exact(rows):
    return sp.Matrix([[sp.Rational(str(x)) for x in row] for row in rows])


@settings(max_examples=60, deadline=None)
@given(matrices())
def test_the_kernel_is_the_one_that_sympy_finds(rows):
    basis = exact(null_space(rows))
    other = exact(rows).nullspace()
    assert basis.shape[1] == len(other)
    assert (exact(rows) * basis).is_zero_matrix
    assert basis.rank() == len(other)


@settings(max_examples=30, deadline=None)
@given(matrices(), st.data())
def test_points_of_the_constraint_are_found_again(rows, data):
    h = exact(rows)
    assume(h.rank() == len(rows))
    found = reduction(rows)
    n, w, y = (exact(m) for m in (found.basis, found.gram_inverse, found.row_inverse))
    x = sp.Matrix([data.draw(ENTRIES) for _ in range(h.shape[1])])
    z = sp.Matrix([data.draw(ENTRIES) for _ in range(n.shape[1])])
    letters = {"H": h, "N": n, "W": w, "Y": y, "x": x, "q": h * x, "z": z}
    for entry in reduced():
        for form in (*entry.relations, entry.goal):
            size = h.shape[0] if str(form).startswith("-1 + H") else w.shape[0]
            size = h.shape[1] if str(form).startswith("-1 + T(H)") else size
            assert substituted(form, letters, size=size).is_zero_matrix
    assert n * (w * n.T * x) + h.T * y * (h * x) == x


def test_a_formation_of_two_targets_leaves_one_position_free():
    found = reduction([[1, 0, -1, 0], [0, 1, 0, -1]])
    assert [len(row) for row in found.basis] == [2, 2, 2, 2]
    assert found.gram_inverse == [[Fraction(1, 2), 0], [0, Fraction(1, 2)]]


@pytest.mark.parametrize(
    "rows, reason",
    [
        ([[1, 2], [2, 4]], "rank 1 of 2 rows"),
        ([[0, 0, 0]], "rank 0 of 1 rows"),
        ([[1, 0], [1, 1]], "leave nothing free"),
        ([[1, 0], [1]], "of one length"),
        ([], "one at least"),
    ],
)
def test_constraints_that_cannot_be_reduced_are_refused(rows, reason):
    with pytest.raises(ValueError, match=reason):
        reduction(rows)


def test_a_singular_matrix_has_no_inverse():
    with pytest.raises(ValueError, match="without inverse"):
        inverse([[Fraction(1), Fraction(2)], [Fraction(2), Fraction(4)]])
