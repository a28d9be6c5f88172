"""Largest generalised eigenvalues beside closed forms and ball arithmetic."""

from fractions import Fraction

import flint
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import definite_matrices, rationals
from verification.exact.evaluate import add, identity, multiply, quadratic, scaled
from verification.exact.spectra.rayleigh import generalized_ratio, image_ratio


def exact(rows):
    return tuple(tuple(Fraction(x) for x in row) for row in rows)


@st.composite
def pencils(draw, largest=5):
    """S symmetric of any sign, P positive definite."""
    n = draw(st.integers(1, largest))
    rows = [[draw(rationals(-3, 3, 6)) for _ in range(n)] for _ in range(n)]
    s = exact([[rows[min(i, j)][max(i, j)] for j in range(n)] for i in range(n)])
    return s, draw(definite_matrices(n))


def ball_largest(s, p, bits=300):
    """Certain enclosure of the largest eigenvalue from those of P^-1 S."""
    with flint.ctx.workprec(bits):
        top, bottom = (
            flint.arb_mat(
                [[flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in r] for r in m]
            )
            for m in (s, p)
        )
        values = [z.real for z in flint.acb_mat(bottom.solve(top)).eig(multiple=True)]
        return max(x.lower() for x in values), max(x.upper() for x in values)


@settings(max_examples=60)
@given(pencils())
def test_the_bracket_holds_what_ball_arithmetic_says(pencil):
    s, p = pencil
    low, high = ball_largest(s, p)
    assume(abs(low) > 1e-9)
    found = generalized_ratio(s, p)
    assert found.lower <= found.value <= found.upper
    assert flint.arb(found.lower) <= high
    assert flint.arb(found.upper) >= low
    assert found.width <= 1e-12


@settings(max_examples=30)
@given(pencils(largest=3), rationals(-2, 2, 3))
def test_shifting_the_pencil_shifts_the_value(pencil, shift):
    s, p = pencil
    moved = generalized_ratio(add(s, p, shift), p).value
    assert moved == pytest.approx(generalized_ratio(s, p).value + float(shift), abs=1e-11)


@settings(max_examples=30)
@given(pencils(largest=3), st.lists(rationals(-3, 3, 5), min_size=3, max_size=3))
def test_no_vector_beats_the_upper_bound(pencil, x):
    s, p = pencil
    x = tuple(x[: len(s)])
    assume(any(x))
    assert quadratic(x, s) <= Fraction(generalized_ratio(s, p).upper) * quadratic(x, p)


def test_closed_forms():
    # [[0, 1], [1, 1]] has the golden ratio, a rotation grows nothing, a shear of 1 its square
    golden = (1 + 5**0.5) / 2
    assert generalized_ratio(exact([[0, 1], [1, 1]]), identity(2)).value == pytest.approx(golden)
    turn, shear = exact([[0, -1], [1, 0]]), exact([[1, 1], [0, 1]])
    assert image_ratio(identity(2), turn, identity(2)).value == 1.0
    assert image_ratio(identity(2), shear, identity(2)).value == pytest.approx(golden**2, rel=1e-12)


@pytest.mark.parametrize("n", [1, 2, 5])
def test_a_multiple_largest_eigenvalue_is_no_obstacle(n):
    third = scaled(Fraction(1, 3), identity(n))
    found = generalized_ratio(third, identity(n))
    assert Fraction(found.lower) <= Fraction(1, 3) < Fraction(found.upper)
    assert found.width <= 1e-12


def test_zero_and_negative_values_have_their_sides():
    assert generalized_ratio(scaled(0, identity(2)), identity(2)).upper == 0.0
    negative = generalized_ratio(exact([[-2, 0], [0, -3]]), identity(2))
    assert negative.lower == -2.0
    assert -2.0 < negative.upper < -2.0 + 1e-11
    # largest eigenvalue 0, attained at (1, 1): no relative width exists there
    edge = generalized_ratio(exact([[-1, 1], [1, -1]]), identity(2))
    assert -1e-11 < edge.lower <= 0.0 < edge.upper < 1e-11


def test_a_nearly_singular_weight_asks_for_more_bits():
    tiny = Fraction(1, 10**40)
    p = exact([[1, 1 - tiny], [1 - tiny, 1]])
    found = generalized_ratio(identity(2), p)
    assert found.value == pytest.approx(1e40, rel=1e-12)
    assert found.width <= 1e-12
    assert found.stage == "160 bits"


@settings(max_examples=20)
@given(pencils(largest=3), st.integers(-150, 150))
def test_units_of_single_coordinates_do_not_matter(pencil, power):
    s, p = pencil
    unit = Fraction(10) ** power
    change = exact(
        [[unit * (i == j == 0) + (i == j != 0) for j in range(len(s))] for i in range(len(s))]
    )
    moved = [multiply(multiply(change, m), change) for m in (s, p)]
    assert generalized_ratio(*moved).value == pytest.approx(
        generalized_ratio(s, p).value, abs=1e-11
    )


def test_a_weight_that_is_not_positive_definite_is_refused():
    with pytest.raises(InputError, match="P: a matrix that is not positive definite"):
        generalized_ratio(identity(2), exact([[1, 2], [2, 1]]))
