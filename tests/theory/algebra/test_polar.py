"""Identities of angles and distances hold for positions that one can write down."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.theory.substitution import substituted
from theory.algebra import polar

U, V = sp.Matrix([1, 0]), sp.Matrix([0, 1])
SMALL = st.fractions(-3, 3, max_denominator=4).map(sp.sympify)
POSITIVE = st.integers(1, 9).map(lambda k: sp.Rational(k, 3))
PLACES = st.tuples(SMALL, SMALL).map(sp.Matrix)


def direction(k):
    """Sine and cosine of an angle whose half has the tangent k."""
    return 2 * k / (1 + k * k), (1 - k * k) / (1 + k * k)


@st.composite
def sights(draw):
    """A sensor, a target, and an error of the angle and of the distance."""
    sine, cosine = direction(draw(SMALL))
    b, a = direction(draw(SMALL))
    e, n = sp.Matrix([sine, cosine]), sp.Matrix([cosine, -sine])
    s, rho, d = draw(PLACES), draw(POSITIVE), draw(SMALL)
    letters = {"u": U, "v": V, "e": e, "n": n, "s": s, "r": s + rho * e}
    return letters, {"S": sine, "C": cosine, "a": a, "b": b, "rho": rho, "d": d}


def check(entries, letters, numbers):
    """Hypotheses hold for these matrices, and so does what follows from them."""
    for entry in entries:
        for form in (*entry.relations, entry.goal):
            assert substituted(form, letters, numbers).is_zero_matrix, (entry.name, form)


@settings(max_examples=15, deadline=None)
@given(sights())
def test_an_exact_measurement_is_inverted(sight):
    letters, numbers = sight
    check(polar.inverse(), letters | {"p": letters["r"]}, numbers)


@settings(max_examples=15, deadline=None)
@given(sights())
def test_the_error_is_the_distance_times_a_turned_vector(sight):
    letters, n = sight
    bearing = n["a"] * letters["e"] + n["b"] * letters["n"]
    p = letters["s"] + n["rho"] * (1 + n["d"]) * bearing
    check(polar.error(), letters | {"p": p}, n)


@settings(max_examples=6, deadline=None)
@given(sights())
def test_the_covariance_and_the_rotation_are_those_of_two_by_two_matrices(sight):
    letters, n = sight
    f, k, rho = sp.Rational(1, 7), sp.Rational(1, 20), n["rho"]
    jacobian = sp.Matrix.hstack(rho * letters["n"], letters["e"])
    turn = sp.Matrix([[n["S"], -n["C"]], [n["C"], n["S"]]])
    true = jacobian * sp.diag(f**2, (rho * k) ** 2) * jacobian.T
    printed = turn * sp.diag((rho * f) ** 2, (rho * k) ** 2) * turn.T
    made = letters | {"J": jacobian, "Q": turn, "X": true, "Y": printed, "i": sp.eye(2)}
    check(polar.covariance(), made, n | {"f": f, "k": k})
    check(polar.rotation(), made, n)


@settings(max_examples=10, deadline=None)
@given(sights(), st.integers(1, 5))
def test_the_mean_position_is_a_sum_over_outcomes(sight, weight):
    """Three angles, symmetric with the weight in the middle, and two distances."""
    letters, n = sight
    share = sp.Rational(1, weight + 2)
    w, k, sines = (
        sp.Matrix(x)
        for x in ([share, weight * share, share], [n["a"], 1, n["a"]], [n["b"], 0, -n["b"]])
    )
    v, z = (
        sp.Matrix([sp.Rational(1, 3), sp.Rational(2, 3)]),
        sp.Matrix([n["rho"] - 2, n["rho"] + 1]),
    )
    g = (k.T * w)[0]
    if g == 0:
        return
    laws = {"w": w, "k": k, "l": sines, "o": sp.ones(3, 1), "v": v, "z": z, "t": sp.ones(2, 1)}
    check(polar.mean_position(), letters | laws, n | {"g": g, "q": 1 / g})
    total = sp.zeros(2, 1)
    for i in range(3):
        for j in range(2):
            bearing = k[i] * letters["e"] + sines[i] * letters["n"]
            total += w[i] * v[j] * (letters["s"] + z[j] / g * bearing)
    assert (total - letters["r"]).is_zero_matrix


@pytest.mark.parametrize("family", ["inverse", "error", "mean_position", "covariance", "rotation"])
def test_no_identity_holds_without_its_hypotheses(family):
    for entry in getattr(polar, family)():
        assert entry.holds
        assert entry.goal.terms
        assert entry.combination
