"""Gradients, squares and energies in letters agree with generic matrices."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import definite_matrices
from tests.theory.substitution import generic, substituted, vector
from theory.algebra.noncommuting import Form, letters
from theory.algebra.quadratic_forms import complete, decrease, gradient, split
from theory.systems.variational.statements.common import (
    SYMMETRIC,
    C,
    K,
    M,
    discrete_energy,
    energy,
    h,
)

X, U, Y, V = letters("x u y v", SYMMETRIC)
H = sp.Symbol("h")
ENTRIES = st.integers(-5, 5)
MATRICES = {name: generic(name) for name in SYMMETRIC} | {name: vector(name) for name in "xuyv"}
STEP = (Y - X - h * U, M * V + h * C * V - M * U + h * K * Y)
WORDS = {0: "x", 1: "M u"}


def value(form: Form) -> sp.Matrix:
    return substituted(form, MATRICES, {"h": H})


@pytest.mark.parametrize("letter", ["x", "u"])
def test_gradient_is_the_derivative_of_the_generic_form(letter: str) -> None:
    form = discrete_energy(X, U)
    whole = value(form)[0]
    slopes = sp.Matrix([sp.diff(whole, entry) for entry in MATRICES[letter]])
    assert (value(gradient(form, letter)) - slopes).applyfunc(sp.expand).is_zero_matrix


def test_gradient_of_what_has_no_such_letter_is_zero() -> None:
    assert not gradient(U.T * M * U, "x").terms


def test_corrected_energy_is_a_square_and_the_stability_condition() -> None:
    (square,), rest = split(discrete_energy(X, U), [("x", "K")])
    assert str(square.inner) == "x + 1/2*h*u"
    condition = 4 * M + 2 * (h * C) - h * h * K
    assert not (rest - Fraction(1, 8) * (U.T * condition * U)).terms
    total = square.form + rest
    assert (value(total) - value(discrete_energy(X, U))).applyfunc(sp.expand).is_zero_matrix


@given(st.fractions(1, 5, max_denominator=5), st.fractions(-5, 5, max_denominator=5))
def test_completing_gives_back_the_form(a: Fraction, b: Fraction) -> None:
    form = a * (X.T * K * X) + b * (X.T * K * U + U.T * K * X) + U.T * C * U
    square, rest = complete(form, "x", "K")
    assert not (square.form + rest - form).terms
    assert not (rest - U.T * C * U + (b * b / a) * (U.T * K * U)).terms


def test_completing_refuses_what_is_no_such_form() -> None:
    with pytest.raises(ValueError, match="a multiple of x'Kx"):
        complete(U.T * M * U, "x", "K")
    with pytest.raises(ValueError, match="must meet K only"):
        complete(X.T * K * X + X.T * C * U + U.T * C * X, "x", "K")
    with pytest.raises(ValueError, match="one term"):
        complete(X.T * K * X + h * (X.T * K * X), "x", "K")


def test_corrected_energy_falls_by_the_dissipation() -> None:
    loss = Fraction(1, 4) * (h * ((U + V).T * C * (U + V)))
    fall = decrease(discrete_energy(X, U), discrete_energy(Y, V), STEP, WORDS)
    assert not (fall - decrease(loss, Form({}), STEP, WORDS)).terms


@given(st.data(), st.fractions(Fraction(1, 10), 3, max_denominator=10))
@settings(max_examples=20)
def test_corrected_energy_falls_by_the_dissipation_in_drawn_steps(
    data: st.DataObject, step: Fraction
) -> None:
    """A second road: solve the recursion for the next state."""
    known = {name: sp.Matrix(data.draw(definite_matrices(2))) for name in SYMMETRIC}
    m, k, c = known["M"], known["K"], known["C"]
    x, u = (sp.Matrix(data.draw(st.lists(ENTRIES, min_size=2, max_size=2))) for _ in "xu")
    h_ = sp.Rational(step.numerator, step.denominator)
    y = x + h_ * u
    v = (m + h_ * c).inv() * (m * u - h_ * k * y)
    known |= {"x": x, "u": u, "y": y, "v": v}
    loss = Fraction(1, 4) * (h * ((U + V).T * C * (U + V)))
    missing = discrete_energy(X, U) - discrete_energy(Y, V) - loss
    assert substituted(missing, known, {"h": h_}).is_zero_matrix


def test_printed_energy_grows_from_rest() -> None:
    """From u = 0 the fall of the printed energy is minus a square."""
    fall = decrease(energy(X, U), energy(Y, V), STEP, WORDS)
    zero = Form({}, frozenset(SYMMETRIC))
    gain = fall.substitute({"u": zero}) + Fraction(1, 2) * (V.T * M * V)
    first_step = (STEP[1].substitute({"u": zero}),)
    assert not decrease(gain, zero, first_step, {0: "M v"}).terms
