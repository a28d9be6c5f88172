"""Square roots of positive semidefinite matrices are enclosed, singular ones too."""

from fractions import Fraction

import flint
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import rationals
from verification.exact.spectra.matrix_roots import root_enclosure


def rows(matrix):
    return tuple(tuple(Fraction(x) for x in row) for row in matrix)


@settings(max_examples=25, deadline=None)
@given(st.integers(1, 4), st.data())
def test_squares_of_semidefinite_matrices_have_their_root_enclosed(n, data):
    half = [[data.draw(rationals(-3, 3, 4)) for _ in range(n)] for _ in range(n - n // 2)]
    given_ = [[sum((r[i] * r[j] for r in half), Fraction(0)) for j in range(n)] for i in range(n)]
    square = [
        [sum((a * b for a, b in zip(x, y, strict=True)), Fraction(0)) for y in given_]
        for x in given_
    ]
    found = root_enclosure(rows(square))
    with flint.ctx.workprec(300):
        for i in range(n):
            for j in range(n):
                exact = flint.arb(flint.fmpq(given_[i][j].numerator, given_[i][j].denominator))
                assert found[i, j].overlaps(exact)
                assert found[i, j].rad() < 1e-30 * (1 + abs(max(map(max, given_), key=abs)))


def test_two_by_two_root_has_its_closed_form():
    found = root_enclosure(rows([["0.3", "0.1"], ["0.1", "0.2"]]))
    root_det = 0.05**0.5
    wanted = (np.array([[0.3, 0.1], [0.1, 0.2]]) + root_det * np.eye(2)) / (
        0.5 + 2 * root_det
    ) ** 0.5
    values = np.array([[float(x) for x in row] for row in found.tolist()])
    assert values == pytest.approx(wanted, rel=1e-14)


def test_equal_eigenvalues_and_extreme_units_do_no_harm():
    tiny = Fraction(1, 10**80)
    matrix = [[2 * tiny * (i == j) + tiny for j in range(4)] for i in range(4)]
    found = root_enclosure(rows(matrix))
    with flint.ctx.workprec(300):
        again = found * found
        for i in range(4):
            for j in range(4):
                ratio = again[i, j] / flint.arb(flint.fmpq(1, 10**80))
                assert abs(float(ratio.mid()) - (3 if i == j else 1)) < 1e-25


def test_zero_has_the_root_zero():
    assert all(x == 0 for x in root_enclosure(rows([[0, 0], [0, 0]])).entries())
