"""Ranges of a variable, and recursions of second order."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals

from .documents import accepts, congruence, provable, text, vector


def polynomial(coefficients):
    """A polynomial in h with scalar coefficients, as an expression."""
    powers = ["1", "h", "h**2", "h**3", "h**4"]
    return " + ".join(f"({c})*{p}" for c, p in zip(coefficients, powers, strict=False))


def least(coefficients, points):
    return min(sum(c * h**k for k, c in enumerate(coefficients)) for h in points)


@given(st.lists(rationals(-5, 5, 4), min_size=1, max_size=5), rationals(-2, 2), rationals(0, 3))
def test_a_polynomial_proved_positive_on_a_range_is_positive_there(coefficients, a, width):
    b = a + width
    found = provable([f"forall(h, {a}, {b}, pd({polynomial(coefficients)}))"], {}, {})
    points = [a + width * k / 24 for k in range(1, 25)]  # open at a, closed at b
    assert not (found is not None and (width <= 0 or least(coefficients, points) <= 0))


@given(st.lists(rationals(-5, 5, 4), min_size=1, max_size=5), rationals(-2, 2))
def test_a_polynomial_proved_positive_on_a_ray_is_positive_there(coefficients, a):
    found = provable([f"forall(h, {a}, inf, pd({polynomial(coefficients)}))"], {}, {})
    points = [a + Fraction(k * k, 8) for k in range(40)]
    assert not (found is not None and least(coefficients, points) <= 0)


@given(st.lists(rationals(-5, 5, 4), min_size=1, max_size=4), rationals(-2, 2), rationals(0, 3))
def test_a_polynomial_shown_not_positive_on_a_range_is_not_positive_there(coefficients, a, width):
    for b in (a + width, "inf"):
        show = f"forall(h, {a}, {b}, dips({polynomial(coefficients)}))"
        points = [a + (width if b != "inf" else 9) * k / 24 for k in range(25)]
        if accepts([show], [vector(1)]):
            assert max(-least([-c for c in coefficients], [h]) for h in points) <= 0


@pytest.mark.parametrize(
    "show, holds",
    [
        ("forall(h, 0, 1, pd(h))", True),  # zero at the open end only
        ("forall(h, 0, 1, pd(1 - h))", False),  # zero at the closed end
        ("forall(h, 0, 1, pd(h*(1 - h) + h))", True),
        ("forall(h, 0, 1, pd(h**4))", True),  # coefficients vanish in between
        ("forall(h, 0, 1, pd(h**4 - h**3 + h))", True),
        ("forall(h, 0, 1, pd(1))", True),  # degree 0
        ("forall(h, 0, 1, pd(0))", False),
        ("forall(h, 0, 1, pd(h - h))", False),
        ("forall(h, 0, inf, pd(h))", False),  # closed at 0
        ("forall(h, 1, inf, pd(h))", True),
        ("forall(h, 0, inf, pd(1 + h**3))", True),
        ("forall(h, 0, inf, pd(1 - h + h**2))", False),  # true, but not by these coefficients
        ("forall(h, 0, inf, pd(0))", False),
        ("forall(h, 1, 1, pd(1))", False),
        ("forall(h, 2, 1, pd(1))", False),
        ("forall(h, -2, -1, pd(-h))", True),
        ("pd(h)", False),  # a variable that nothing binds
        ("forall(h, 0, h, pd(1))", False),
        ("forall(h, 0, 1, h >= 0)", False),  # comparisons are of numbers
        ("forall(h, 0, 1, h == h)", True),
        ("forall(h, 0, 1, h != 0)", False),  # is not settled by a coefficient
        ("forall(h, 0, 1, pd(1), pd(h))", True),
        ("forall(h, 0, 1, forall(k, 0, 1, pd(h + k)))", False),  # one variable at a time
        ("forall(h, 0, 1, forall(h, 1, 2, pd(h - 1)), pd(h))", False),
        ("forall(h, 0, 1, pd(1/h))", False),
    ],
)
def test_forall(show, holds):
    assert (provable([show], {}, {}) is not None) == holds


def test_the_range_of_a_forall_ends_with_it():
    assert not provable(["forall(h, 0, 1, pd(h))", "pd(h)"], {}, {})


ROOTS = st.tuples(rationals(-2, 2, 5), rationals(-2, 2, 5))


@given(ROOTS, rationals(Fraction(1, 4), 3))
def test_jury_for_a_scalar_recursion_with_known_roots(roots, lead):
    """(z - p)(z - q): all solutions tend to 0 if and only if |p|, |q| < 1."""
    p, q = roots
    pencil = ", ".join(f"({lead * c})" for c in (1, -p - q, p * q))
    stable, unstable = max(abs(p), abs(q)) < 1, min(p, q) <= -1 <= max(p, q)
    assert bool(provable([f"schur({pencil})"], {}, {})) == stable
    believed = accepts([f"unstable({pencil})"], [congruence([1]), vector(1)])
    assert believed == unstable


@given(definite_matrices(2), definite_matrices(2), definite_matrices(2), rationals(-1, 3))
def test_a_matrix_recursion_is_proved_stable_only_if_its_companion_is(a, b, c, shift):
    def minus(m, s):
        return [[x - s * (i == j) for j, x in enumerate(row)] for i, row in enumerate(m)]

    data = {"A": text(a), "B": text(minus(b, shift)), "C": text(minus(c, shift))}
    kinds = dict.fromkeys("ABC", "matrix")
    a2, a1, a0 = (np.array([[float(Fraction(x)) for x in row] for row in m]) for m in data.values())
    inverse = np.linalg.inv(a2)
    companion = np.block([[-inverse @ a1, -inverse @ a0], [np.eye(2), np.zeros((2, 2))]])
    radius = max(abs(np.linalg.eigvals(companion)))
    if provable(["schur(A, B, C)"], data, kinds):
        assert radius < 1 + 1e-9
    x = [int(1000 * v) for v in np.linalg.eigh(a2 - a1 + a0)[1][:, 0]]
    if provable(["unstable(A, B, C)"], data, kinds, [vector(*x)]):
        assert radius > 1 - 1e-9


@pytest.mark.parametrize("lopsided", ["A", "B", "C"])
def test_a_recursion_has_symmetric_matrices(lopsided):
    eye, skew = [["1", "0"], ["0", "1"]], [["1", "1"], ["0", "1"]]
    data = {"A": eye, "B": [["2", "0"], ["0", "2"]], "C": eye} | {lopsided: skew}
    kinds = dict.fromkeys("ABC", "matrix")
    assert not accepts(
        ["unstable(A, B, C)"], [congruence([1, 0], [0, 1]), vector(1, 0)], data, kinds
    )
    stable = {"A": [["4", "0"], ["0", "4"]], "B": eye, "C": eye} | {lopsided: skew}
    assert not provable(["schur(A, B, C)"], stable, kinds)
