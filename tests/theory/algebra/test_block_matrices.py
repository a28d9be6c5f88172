"""Block matrices of forms, and the identity behind the dissipation of (20) for every size."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from theory.algebra.block_matrices import Blocks, coefficients, hessian
from theory.algebra.noncommuting import Form, letters
from theory.systems.variational.block_form import (
    CHANGE,
    CONSERVED,
    CONSTRAINT,
    ENERGY,
    LEFT,
    MULTIPLIERS,
    RIGHT,
)
from theory.systems.variational.statements.common import SYMMETRIC, C, K, M, h
from verification.exact.evaluate import add, assembled, multiply, scaled

HALF = Fraction(1, 2)


def transposed(rows):
    return tuple(zip(*rows, strict=True))


def test_the_corrected_energy_changes_by_the_loss_for_gains_of_every_size() -> None:
    product = MULTIPLIERS * CONSTRAINT
    assert not (product + product.T - CHANGE)


def test_another_multiplier_does_not_do() -> None:
    twice = (MULTIPLIERS + MULTIPLIERS) * CONSTRAINT
    assert twice + twice.T - CHANGE


@settings(max_examples=20)
@given(
    st.integers(1, 3).flatmap(lambda n: st.tuples(*[definite_matrices(n)] * 3)),
    rationals(Fraction(1, 20), 3),
)
def test_the_identity_holds_in_numbers(three, step) -> None:
    """A'PA - P + (h/4) G'CG = 0 with A = E^-1 F, in floats."""
    gains = dict(zip(SYMMETRIC, three, strict=True))
    e, f, p = (
        np.array(assembled(side, gains, step), dtype=float) for side in (LEFT, RIGHT, CONSERVED)
    )
    a = np.linalg.solve(e, f)
    n = len(gains["M"])
    g = (a + np.eye(2 * n))[n:]
    c = np.array(gains["C"], dtype=float)
    rest = a.T @ p @ a - p + float(step) / 4 * g.T @ c @ g
    assert np.abs(rest).max() <= 1e-9 * (1 + np.abs(p).max()) * (1 + np.abs(a).max()) ** 2


def test_energies_are_the_printed_blocks() -> None:
    zero = Form({})
    assert not (ENERGY - Blocks(((HALF * K, zero), (zero, HALF * M))))
    corner = HALF * (h * K) * HALF
    wanted = Blocks(((HALF * K, corner), (corner, HALF * M + HALF * HALF * (h * C))))
    assert not (CONSERVED + CONSERVED - (wanted + wanted))


def test_products_sums_and_transposes_are_those_of_numbers() -> None:
    a, b = letters("A B")
    left = Blocks(((a, b), (b, a.T)))
    values = {
        "A": ((Fraction(1), Fraction(2)), (Fraction(3), Fraction(5))),
        "B": ((Fraction(0), Fraction(-1)), (Fraction(7), Fraction(2))),
    }
    one = Fraction(1)
    whole = assembled(left, values, one)
    assert assembled(left * left.T, values, one) == multiply(whole, transposed(whole))
    assert assembled(left + left.T, values, one) == add(whole, transposed(whole))
    assert assembled(left - left - left, values, one) == scaled(-1, whole)


def test_coefficients_and_hessian_rebuild_what_they_came_from() -> None:
    x, y, k = letters("x y K", "K")
    equation = 3 * (k * x) - y
    found = coefficients([equation], ("x", "y"))
    assert not (found.rows[0][0] * x + found.rows[0][1] * y - equation).terms
    form = x.T * k * y
    matrix = hessian(form, ("x", "y"))
    assert not (matrix - matrix.T)
    assert not (matrix.rows[0][1] - HALF * k).terms


def test_shapes_that_do_not_fit_are_refused() -> None:
    (a,) = letters("A")
    row, column = Blocks(((a, a),)), Blocks(((a,), (a,)))
    with pytest.raises(ValueError, match="sum"):
        row + column
    with pytest.raises(ValueError, match="product"):
        row * row
    with pytest.raises(ValueError, match="rows"):
        Blocks(((a,), (a, a)))
    with pytest.raises(ValueError, match="rows"):
        Blocks(())
