"""Spectral radius and energy growth of (20) beside closed forms, floats and simulation."""

import cmath
import math
import sys
from fractions import Fraction
from subprocess import run

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import definite_matrices, rationals
from verification.exact.evaluate import multiply, scaled
from verification.systems.variational.numbers import energy_ratio, spectral_radius
from verification.systems.variational.steps import step_limit

QUANTITIES = (spectral_radius, energy_ratio)
POSITIVE = rationals(Fraction(1, 10), 5)


def one(x):
    return ((Fraction(x),),)


def scalars(m, k, c, h):
    return {"M": one(m), "K": one(k), "C": one(c), "h": Fraction(h)}


def values(n):
    gains = {name: definite_matrices(n) for name in "MKC"}
    return st.fixed_dictionaries(gains | {"h": rationals(Fraction(1, 20), 3)})


def step(given_values):
    """One step in floats, from the printed lines of (20)."""
    m, k, c = (np.array(given_values[name], dtype=float) for name in "MKC")
    n, h = len(m), float(given_values["h"])
    velocity = np.linalg.solve(m + h * c, np.hstack([-h * k, m - h * h * k]))
    return np.vstack([np.hstack([np.eye(n), h * np.eye(n)]), velocity])


def energies(given_values):
    k, m = (np.array(given_values[name], dtype=float) for name in "KM")
    zero = np.zeros_like(k)
    return np.vstack([np.hstack([k, zero]), np.hstack([zero, m])])


def holds(answer, number):
    """The certified bracket is narrow and the number is in it, up to the number's own rounding."""
    assert answer.verdict == "PROVED"
    assert answer.notes == ()
    assert answer.lower <= answer.value <= answer.upper
    assert (answer.upper - answer.lower) / answer.value <= 1.0001e-10
    slack = 1e-13 * number
    return answer.lower - slack <= number <= answer.upper + slack


@settings(max_examples=60)
@given(POSITIVE, POSITIVE, POSITIVE, POSITIVE)
def test_scalars_have_closed_forms(m, k, c, h):
    a, b = float(m + h * c), float(h * h * k - 2 * m - h * c)
    root = cmath.sqrt(float((h * h * k - 2 * m - h * c) ** 2 - 4 * m * (m + h * c)))
    radius = max(abs((-b + root) / (2 * a)), abs((-b - root) / (2 * a)))
    assert holds(spectral_radius(scalars(m, k, c, h)), radius)
    # in energy coordinates the ratio is the largest squared singular value of a 2 x 2 matrix
    w = math.sqrt(k / m)
    big = np.array([[1, w * float(h)], [-w * float(h * m), float(m - h * h * k)]])
    big[1] /= a
    largest = np.linalg.svd(big, compute_uv=False)[0] ** 2
    answer = energy_ratio(scalars(m, k, c, h))
    assert answer.value == pytest.approx(largest, rel=1e-13)
    assert (answer.upper - answer.lower) / answer.value <= 1e-12


@settings(max_examples=30)
@given(st.integers(1, 3).flatmap(values))
def test_matrices_agree_with_floats(given_values):
    radius = np.abs(np.linalg.eigvals(step(given_values))).max()
    assert spectral_radius(given_values).value == pytest.approx(radius, rel=1e-7)
    root = np.linalg.cholesky(energies(given_values)).T
    growth = np.linalg.norm(root @ step(given_values) @ np.linalg.inv(root), 2) ** 2
    assert energy_ratio(given_values).value == pytest.approx(growth, rel=1e-9)


@settings(max_examples=20)
@given(values(2), st.lists(rationals(-3, 3, 5), min_size=4, max_size=4))
def test_no_state_gains_more_energy_than_the_upper_bound(given_values, state):
    z = np.array(state, dtype=float)
    before = z @ energies(given_values) @ z
    z = step(given_values) @ z
    assert z @ energies(given_values) @ z <= before * energy_ratio(given_values).upper + 1e-12


@settings(max_examples=15)
@given(st.integers(1, 2).flatmap(values), rationals(Fraction(1, 10), 10))
def test_the_time_unit_does_not_matter(given_values, unit):
    moved = {
        "M": given_values["M"],
        "K": scaled(1 / unit**2, given_values["K"]),
        "C": scaled(1 / unit, given_values["C"]),
        "h": unit * given_values["h"],
    }
    for quantity in QUANTITIES:
        assert quantity(moved).value == pytest.approx(quantity(given_values).value, rel=1e-10)


@pytest.mark.parametrize("unit", [Fraction(10) ** 150, Fraction(1, 10**150), Fraction(7, 10**9)])
def test_units_far_from_one_do_not_matter(unit):
    plain = scalars(2, 3, Fraction(1, 2), Fraction(1, 10))
    moved = scalars(2, 3 / unit**2, Fraction(1, 2) / unit, unit / 10)
    for quantity in QUANTITIES:
        assert quantity(moved).value == pytest.approx(quantity(plain).value, rel=1e-10)


@pytest.mark.parametrize("n", [1, 2, 6])
@pytest.mark.parametrize("h", [Fraction(1, 10), Fraction(1, 1000)])
def test_critical_damping_keeps_nine_digits(n, h):
    """All n modes at once have a double root of (1 + hc) z^2 + (h^2 - 2 - hc) z + 1, c = h + 2."""
    rng = np.random.default_rng(n)
    t = np.tril(rng.integers(-2, 3, (n, n)), -1) + np.eye(n, dtype=int)
    shape = tuple(tuple(map(Fraction, row)) for row in (t @ t.T).tolist())
    damping = scaled(h + 2, shape)
    answer = spectral_radius({"M": shape, "K": shape, "C": damping, "h": h})
    assert holds(answer, float(1 / (1 + h)))
    assert answer.value == pytest.approx(float(1 / (1 + h)), rel=1e-10)


def test_the_continuous_limit_at_critical_damping():
    """m = c^2/(4k): e^(-sqrt(k/m) h) up to the order of the scheme, and close to a double root."""
    h = Fraction(1, 1000)
    answer = spectral_radius(scalars(Fraction(1, 4), 1, 1, h))
    assert holds(answer, float(abs(np.roots([0.25 + 1e-3, 1e-6 - 0.5 - 1e-3, 0.25])).max()))
    assert answer.value == pytest.approx(math.exp(-2e-3), abs=1e-4)


@settings(max_examples=20)
@given(st.integers(1, 2).flatmap(values))
def test_the_radius_parts_where_the_step_limit_says(given_values):
    limit = step_limit(given_values)
    for factor, stable in ((Fraction(99, 100), True), (Fraction(101, 100), False)):
        answer = spectral_radius(given_values | {"h": Fraction(limit.value) * factor})
        assert (answer.upper < 1) if stable else (answer.lower > 1)


def test_the_printed_energy_can_grow_and_the_value_is_the_known_one():
    """M = K = C = 1: growth factor of the energy, from the singular values of the step."""
    answer = energy_ratio(scalars(1, 1, 1, 1))
    step_of_one = np.array([[1, 1], [-0.5, 0.0]])
    assert answer.lower > 1
    assert answer.value == pytest.approx(np.linalg.norm(step_of_one, 2) ** 2, rel=1e-14)


def test_the_letters_mean_what_they_mean():
    """Matrices that do not commute, against exact products done here."""
    m = ((Fraction(2), Fraction(1)), (Fraction(1), Fraction(3)))
    k = ((Fraction(5), Fraction(-1)), (Fraction(-1), Fraction(1)))
    assert multiply(m, k) != multiply(k, m)
    values_of = {"M": m, "K": k, "C": scaled(Fraction(1, 2), k), "h": Fraction(1, 5)}
    radius = np.abs(np.linalg.eigvals(step(values_of))).max()
    assert holds(spectral_radius(values_of), radius)


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_bad_inputs_are_named(quantity):
    with pytest.raises(InputError, match="h: 0"):
        quantity(scalars(1, 1, 1, 0))
    with pytest.raises(InputError, match="K: not positive definite"):
        quantity(scalars(1, -1, 1, 1))


def test_a_wide_bracket_gives_no_value(monkeypatch):
    monkeypatch.setattr("verification.exact.spectra.modes.LADDER", ())
    monkeypatch.setattr("verification.exact.spectra.spectral.WIDER", (Fraction(1, 10**4),))
    wide = spectral_radius(scalars(1, 1, Fraction(21, 10), Fraction(1, 10)))
    assert (wide.verdict, wide.value) == ("UNDECIDED", None)
    assert Fraction(wide.lower) < Fraction(10, 11) < Fraction(wide.upper)
    assert "doubles" in wide.notes[0]


def test_answering_loads_no_solver():
    code = (
        "import sys; from fractions import Fraction as F\n"
        "from verification.systems.variational.numbers import energy_ratio, spectral_radius\n"
        "one = ((F(1),),); values = {'M': one, 'K': one, 'C': one, 'h': F(1, 10)}\n"
        "spectral_radius(values); energy_ratio(values)\n"
        "assert not {'cvxpy', 'clarabel', 'scipy', 'sympy'} & set(sys.modules)\n"
    )
    done = run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
