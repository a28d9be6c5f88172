"""Matrices: congruence, combination, vectors, and a matrix that the witness chooses."""

from fractions import Fraction
from itertools import pairwise

import flint
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.strategies import rationals

from .documents import accepts, congruence, provable, text, vector

A = {"A": "matrix"}


def is_definite(rows):
    """Sylvester: all leading minors are positive."""
    exact = [[flint.fmpq(x.numerator, x.denominator) for x in map(Fraction, row)] for row in rows]
    leading = [[row[:k] for row in exact[:k]] for k in range(1, len(rows) + 1)]
    return all(flint.fmpq_mat(minor).det() > 0 for minor in leading)


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
    assert (provable(["pd(A)"], {"A": text(rows)}, A) is not None) == is_definite(rows)


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


RAGGED = [
    [["1", "0"], ["0", "1", "9"]],
    [["1", "0", "9"], ["0", "1"]],
    [["1", "0"], ["0"]],
    [["1", "0"], ["0", "1"], []],
]


@pytest.mark.parametrize("rows", RAGGED)
def test_rows_of_unlike_lengths_are_no_matrix(rows):
    assert not accepts(["pd(A)"], [congruence([1, 0], [0, 1])], {"A": rows}, A)
    assert not accepts(["A == A"], [], {"A": rows}, A)


@pytest.mark.parametrize("show", ["A*B == A*B", "B*A == B*A", "A + B == A + B", "A != B", "A == B"])
def test_matrices_of_unlike_shapes_are_neither_added_nor_multiplied_nor_compared(show):
    inputs = {
        "A": [["1", "0"], ["0", "1"]],
        "B": [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]],
    }
    kinds = {"A": "matrix", "B": "matrix"}
    assert not accepts([show], [], inputs, kinds)
    assert accepts([show.replace("B", "A").replace("!=", "==")], [], inputs, kinds)


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
        assert provable(["pd(A)"], {"A": rows}, A)
        rows[-1][-1] = str(Fraction(1, 2 * n) / larger**8)
        assert not provable(["pd(A)"], {"A": rows}, A)
