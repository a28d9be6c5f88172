"""Brackets of spectral radii beside closed forms, ball arithmetic and matrices built to be hard."""

import math
from dataclasses import replace
from fractions import Fraction

import flint
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import rationals
from verification.exact.evaluate import identity, multiply, scaled
from verification.exact.spectra.modes import candidates, integer_matrices
from verification.exact.spectra.spectral import WIDTH, pencil_radius, spectral_radius
from verification.exact.spectra.stein import proves_above, proves_below


def exact(rows):
    return tuple(tuple(Fraction(x) for x in row) for row in rows)


@st.composite
def squares(draw, largest=6, invertible=False):
    n = draw(st.integers(1, largest))
    rows = exact([[draw(rationals(-3, 3, 6)) for _ in range(n)] for _ in range(n)])
    if invertible:
        rows = exact([[x + 20 * (i == j) for j, x in enumerate(row)] for i, row in enumerate(rows)])
    return rows


def inverse(rows):
    (matrix,) = integer_matrices(rows)
    unit = math.lcm(*(x.denominator for row in rows for x in row))
    solved = flint.fmpq_mat(matrix).solve(flint.fmpq_mat(flint.fmpz_mat(integer(len(rows)))))
    return tuple(tuple(unit * Fraction(int(x.p), int(x.q)) for x in row) for row in solved.tolist())


def integer(n):
    return [[int(i == j) for j in range(n)] for i in range(n)]


def ball_radius(rows, bits=400):
    """Certain enclosure of the spectral radius from enclosures of all eigenvalues."""
    with flint.ctx.workprec(bits):
        matrix = flint.acb_mat(
            [[flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in row] for row in rows]
        )
        sizes = [abs(z) for z in matrix.eig(multiple=True)]
        return max(z.lower() for z in sizes), max(z.upper() for z in sizes)


def similar(rows, seed):
    """T A T^-1 with an integer T of determinant 1."""
    n = len(rows)
    rng = np.random.default_rng(seed)
    t = np.tril(rng.integers(-2, 3, (n, n)), -1) + np.eye(n, dtype=int)
    t = exact((t @ t.T).tolist())
    return multiply(multiply(t, rows), inverse(t))


def jordan(n, value):
    return exact([[value * (i == j) + (j == i + 1) for j in range(n)] for i in range(n)])


@settings(max_examples=60)
@given(squares())
def test_the_bracket_holds_what_ball_arithmetic_says(rows):
    low, high = ball_radius(rows)
    assume(low > 0)
    found = spectral_radius(rows)
    assert found.lower <= found.value <= found.upper
    assert flint.arb(found.lower) <= high
    assert flint.arb(found.upper) >= low
    assert found.width <= float(WIDTH) * (1 + 1e-9)


@settings(max_examples=40)
@given(squares(largest=4))
def test_false_bounds_are_never_proved(rows):
    low, _ = ball_radius(rows)
    assume(low > 1e-6)
    e, f = integer_matrices(identity(len(rows)), rows)
    middle = Fraction(float(low.mid()))
    modes = next(iter(candidates(e, f)))
    for miss in (Fraction(1, 100), Fraction(1, 10**6), Fraction(1, 10**9)):
        assert not proves_below(e, f, modes, middle * (1 - miss))
        assert not proves_above(e, f, modes, middle * (1 + miss))
        # nor if the candidates claim that it is so
        smaller = replace(modes, moduli=tuple(x * (1 - miss) / 2 for x in modes.moduli))
        larger = replace(modes, moduli=tuple(x * (1 + miss) * 2 for x in modes.moduli))
        assert not proves_below(e, f, smaller, middle * (1 - miss))
        assert not proves_above(e, f, larger, middle * (1 + miss))


@settings(max_examples=40)
@given(squares(largest=4, invertible=True), st.data())
def test_a_pencil_is_the_matrix_that_it_stands_for(e, data):
    n = len(e)
    f = exact([[data.draw(rationals(-3, 3, 6)) for _ in range(n)] for _ in range(n)])
    with_inverse, without = spectral_radius(multiply(inverse(e), f)), pencil_radius(e, f)
    assert without.lower <= with_inverse.upper
    assert with_inverse.lower <= without.upper
    assert without.value == pytest.approx(with_inverse.value, rel=1e-9)


@pytest.mark.parametrize("n", [2, 3, 4, 6, 8])
@pytest.mark.parametrize("value", [Fraction(3, 7), Fraction(-1), Fraction(999, 1000)])
def test_a_defective_eigenvalue_keeps_nine_digits(n, value):
    rows = similar(jordan(n, value), seed=n)
    found = spectral_radius(rows)
    assert Fraction(found.lower) < abs(value) < Fraction(found.upper)
    assert found.value == pytest.approx(abs(float(value)), rel=1e-10)
    # what floats alone make of it
    floats = abs(np.linalg.eigvals(np.array(rows, dtype=float))).max()
    assert n < 3 or abs(floats / abs(float(value)) - 1) > 1e-9


def test_a_defective_complex_pair_keeps_nine_digits():
    turn = exact([[Fraction(3, 5), Fraction(-4, 5)], [Fraction(4, 5), Fraction(3, 5)]])
    one, zero = identity(2), scaled(0, identity(2))
    block = tuple(a + b for a, b in zip(turn + zero, one + turn, strict=True))
    found = spectral_radius(similar(block, seed=5))
    assert Fraction(found.lower) < 1 < Fraction(found.upper)
    assert found.width <= float(WIDTH)


def test_repeated_and_nearly_equal_moduli_are_no_obstacle():
    near = Fraction(10**11 - 1, 10**11)
    diagonal = exact([[x * (i == j) for j in range(4)] for i, x in enumerate((1, -1, near, 1))])
    for rows in (diagonal, similar(diagonal, seed=3), identity(5)):
        found = spectral_radius(rows)
        assert Fraction(found.lower) < 1 < Fraction(found.upper)
        assert found.width <= float(WIDTH)


@pytest.mark.parametrize("n", [1, 3, 12])
def test_a_nilpotent_matrix_has_radius_zero(n):
    rows = scaled(1, jordan(n, 0))
    for matrix in (rows, similar(rows, seed=n)):
        assert spectral_radius(matrix).lower == spectral_radius(matrix).upper == 0


@pytest.mark.parametrize("n", [20, 60])
def test_large_matrices_are_bracketed_too(n):
    rng = np.random.default_rng(n)
    integers = rng.integers(-9, 10, (n, n))
    found = spectral_radius(exact(integers.tolist()))
    assert found.width <= float(WIDTH)
    assert found.value == pytest.approx(abs(np.linalg.eigvals(integers)).max(), rel=1e-10)


@pytest.mark.parametrize("power", [-290, -150, 0, 150, 290])
def test_units_do_not_matter(power):
    """Rows and columns scaled against each other: a change of the units of the state."""
    rows, unit = exact([[1, 2, 0], [-1, 1, 3], [2, 0, 1]]), Fraction(10) ** power
    moved = exact([[x * unit ** (i - j) for j, x in enumerate(row)] for i, row in enumerate(rows)])
    found, plain = spectral_radius(moved), spectral_radius(rows)
    assert found.value == pytest.approx(plain.value, rel=1e-10)
    assert found.width <= float(WIDTH)


def test_the_result_does_not_depend_on_what_ran_before():
    rows = similar(jordan(3, Fraction(1, 3)), seed=1)
    first = spectral_radius(rows)
    with flint.ctx.workprec(1000):
        assert spectral_radius(rows) == first


def test_a_bracket_that_stays_wide_says_so(monkeypatch):
    monkeypatch.setattr("verification.exact.spectra.modes.LADDER", ())
    found = spectral_radius(similar(jordan(3, Fraction(1, 2)), seed=2))
    assert found.width > 1e-7
    assert Fraction(found.lower) < Fraction(1, 2) < Fraction(found.upper)
    assert found.stage == "no narrower bracket from doubles"


def test_a_singular_left_side_is_refused():
    with pytest.raises(InputError, match="E: a singular matrix"):
        pencil_radius(exact([[1, 2], [2, 4]]), identity(2))
