"""Matrices: congruence, combination, vectors, ranges of a variable, recursions of second order."""

from fractions import Fraction
from itertools import pairwise

import flint
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from verification.certificates.check import Reject
from verification.certificates.make import CertificateError

from .documents import accepts, proved_by_search

A = {"A": "matrix"}


def text(rows):
    return [[str(x) for x in row] for row in rows]


def congruence(*rows):
    return {"kind": "congruence", "rows": [list(row) for row in rows]}


def vector(*x):
    return {"kind": "vector", "x": list(x)}


def is_definite(rows):
    """Sylvester: all leading minors are positive."""
    exact = [[flint.fmpq(x.numerator, x.denominator) for x in map(Fraction, row)] for row in rows]
    leading = [[row[:k] for row in exact[:k]] for k in range(1, len(rows) + 1)]
    return all(flint.fmpq_mat(minor).det() > 0 for minor in leading)


def provable(show, inputs, kinds=A, witness=()):
    """The witness that is found, or None; the checker itself runs within the search."""
    try:
        return proved_by_search(show, witness, inputs, kinds)
    except (Reject, CertificateError):
        return None


@st.composite
def symmetric(draw, n):
    rows = [[draw(rationals(-4, 4, 6)) for _ in range(n)] for _ in range(n)]
    shift = draw(rationals(-2, 8, 4))
    return [
        [(rows[i][j] + rows[j][i]) / 2 + (shift if i == j else 0) for j in range(n)]
        for i in range(n)
    ]


@given(st.integers(1, 4).flatmap(symmetric))
def test_a_matrix_is_proved_definite_if_and_only_if_its_minors_are_positive(rows):
    assert (provable(["pd(A)"], {"A": text(rows)}) is not None) == is_definite(rows)


@given(st.integers(1, 4).flatmap(symmetric), st.data())
def test_no_factor_whatever_proves_a_matrix_definite_that_is_not(rows, data):
    assume(not is_definite(rows))
    n = len(rows)
    entries = st.lists(st.integers(-9, 9), min_size=n, max_size=n)
    factor = data.draw(st.lists(entries, min_size=n, max_size=n))
    assert not accepts(["pd(A)"], [congruence(*factor)], {"A": text(rows)}, A)


@given(st.integers(1, 4).flatmap(symmetric), st.data())
def test_a_vector_shows_that_a_matrix_is_not_definite_if_its_form_is_not_positive(rows, data):
    x = data.draw(st.lists(st.integers(-5, 5), min_size=len(rows), max_size=len(rows)))
    form = sum(
        a * b * entry
        for a, row in zip(x, rows, strict=True)
        for b, entry in zip(x, row, strict=True)
    )
    believed = accepts(["dips(A)"], [vector(*x)], {"A": text(rows)}, A)
    assert believed == (any(x) and form <= 0)
    assert not (believed and is_definite(rows))


@pytest.mark.parametrize(
    "rows, factor, holds",
    [
        ([["2", "1"], ["1", "1"]], [[1, 0], [-1, 2]], True),
        ([["2", "1"], ["1", "1"]], [[1, 0], [0, 1]], False),  # a row only just not dominant
        ([["2", "1"], ["1", "1/2"]], [[1, 0], [-1, 2]], False),  # singular
        ([["2", "1"], ["1", "1"]], [[1, 0], [1, 0]], False),  # singular factor
        ([["2", "1"], ["1", "1"]], [[0, 0], [0, 0]], False),
        ([["2", "1"], ["0", "1"]], [[1, 0], [0, 1]], False),  # not symmetric
        ([["2", "1"]], [[1]], False),  # not square
        ([["-2", "0"], ["0", "-1"]], [[1, 0], [0, 1]], False),
        ([["1"]], [[1]], True),
        ([["0"]], [[1]], False),
        ([["2", "1"], ["1", "1"]], [[1]], False),  # of another size
        ([["2", "1"], ["1", "1"]], [[1, 0], [-1]], False),
        ([["2", "1"], ["1", "1"]], [["1", "0"], ["-1", "2"]], True),
        ([["2", "1"], ["1", "1"]], [["1/2", 0], ["-1/2", 1]], False),  # integers are due
    ],
)
def test_congruence(rows, factor, holds):
    assert accepts(["pd(A)"], [congruence(*factor)], {"A": rows}, A) == holds


@pytest.mark.parametrize("rows", [[], [[]], [["1"], []], ["1"], [["1", "0"], ["0"]], "1", None, 1])
def test_what_is_no_matrix(rows):
    assert not accepts(["pd(A)"], [congruence([1])], {"A": rows}, A)


@pytest.mark.parametrize(
    "terms, holds",
    [
        ([[0, "3"]], True),
        ([[0, 1], [0, "2"]], True),
        ([[0, "2"]], False),
        ([[0, "4"], [0, "-1"]], False),  # a negative coefficient
        ([[0, "3"], [0, "0"]], True),
        ([], False),
        ([["0", "3"]], True),
        ([[1, "3"]], False),  # itself, not yet proved
        ([[-1, "3"]], False),
        ([[0, "3", 1]], False),
        ([[0, "3"], [1, "0"]], False),
    ],
)
def test_combination(terms, holds):
    show, witness = ["pd(A)", "pd(3*A)"], {"kind": "combination", "terms": terms}
    assert accepts(show, [congruence([1]), witness], {"A": [["1/3"]]}, A) == holds


def test_a_combination_of_nothing_is_not_definite():
    show, terms = ["pd(A)", "pd(A - A)"], {"kind": "combination", "terms": [[0, 0]]}
    assert not accepts(show, [congruence([1]), terms], {"A": [["1"]]}, A)


def test_a_combination_of_another_size_is_refused():
    kinds, inputs = {"A": "matrix", "B": "matrix"}, {"A": [["1"]], "B": [["1", "0"], ["0", "1"]]}
    terms = {"kind": "combination", "terms": [[0, 1]]}
    assert not accepts(["pd(A)", "pd(B)"], [congruence([1]), terms], inputs, kinds)


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


@given(st.lists(rationals(-1, 1, 5), min_size=2, max_size=3))
def test_a_quadratic_that_falls_can_be_chosen_by_the_witness(diagonal):
    """exists(P, P > 0 and P - A'PA > 0) is accepted for P = I if and only if |A| < 1."""
    n = len(diagonal)
    rows = [[str(x if i == j else 0) for j in range(n)] for i, x in enumerate(diagonal)]
    eye = [[str(int(i == j)) for j in range(n)] for i in range(n)]
    show, chosen = ["exists(P, pd(P), pd(P - T(A)*P*A))"], {"kind": "matrix", "rows": eye}
    found = provable(show, {"A": rows}, A, [chosen])
    assert bool(found) == all(abs(x) < 1 for x in diagonal)


@pytest.mark.parametrize("rows", [[["1", "1"], ["0", "1"]], [["1"]], [["1", "0"]], [], "P"])
def test_a_chosen_matrix_that_is_lopsided_or_of_another_size_is_refused(rows):
    show = ["exists(P, pd(P), pd(P - 1/4*T(A)*P*A))"]
    witness = [{"kind": "matrix", "rows": rows}, congruence([1, 0], [0, 1])] * 2
    assert not accepts(show, witness, {"A": [["1", "0"], ["0", "1"]]}, A)


def test_hilbert_matrices_of_growing_size_are_definite():
    for n, larger in pairwise(range(2, 9)):
        rows = [[str(Fraction(1, i + j + 1)) for j in range(n)] for i in range(n)]
        assert provable(["pd(A)"], {"A": rows})
        rows[-1][-1] = str(Fraction(1, 2 * n) / larger**8)
        assert not provable(["pd(A)"], {"A": rows})
