"""Forms compute like the matrices that they stand for."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.theory.substitution import substituted
from theory.algebra.noncommuting import Form, inverse, letters, scalars

NAMES = "A B S"
SYMMETRIC = ("S",)
ENTRIES = st.integers(-4, 4)
MATRICES = st.lists(ENTRIES, min_size=4, max_size=4).map(lambda e: sp.Matrix(2, 2, e))
VALUES = st.builds(lambda a, b, s: {"A": a, "B": b, "S": s + s.T}, MATRICES, MATRICES, MATRICES)


@st.composite
def forms(draw: st.DrawFn) -> Form:
    """Sums of up to four words of up to three letters, times powers of one scalar."""
    known = dict(zip(NAMES.split(), letters(NAMES, SYMMETRIC), strict=True))
    (h,) = scalars("h")
    total = Form({}, frozenset(SYMMETRIC))
    for _ in range(draw(st.integers(1, 4))):
        word = draw(st.lists(st.sampled_from(["A", "B", "S", "A'", "B'"]), min_size=1, max_size=3))
        part = draw(st.sampled_from([h * h, h, Form({((), ()): Fraction(1)}, h.symmetric)]))
        for letter in word:
            form = known[letter.rstrip("'")]
            part = part * (form.T if letter.endswith("'") else form)
        total = total + part * draw(st.fractions(-3, 3, max_denominator=4))
    return total


def value(form: Form, values: dict[str, sp.Matrix]) -> sp.Matrix:
    return substituted(form, values, {"h": sp.Rational(2, 3)}, size=2)


@settings(max_examples=40)
@given(forms(), forms(), VALUES)
def test_arithmetic_is_that_of_matrices(f: Form, g: Form, values: dict[str, sp.Matrix]) -> None:
    assert value(f + g, values) == value(f, values) + value(g, values)
    assert value(f - g, values) == value(f, values) - value(g, values)
    assert value(f * g, values) == value(f, values) * value(g, values)
    assert value(3 * f, values) == 3 * value(f, values)


@settings(max_examples=40)
@given(forms(), forms(), VALUES)
def test_transpose_turns_products_around(f: Form, g: Form, values: dict[str, sp.Matrix]) -> None:
    assert value(f.T, values) == value(f, values).T
    assert not ((f * g).T - g.T * f.T).terms
    assert not (f.T.T - f).terms


@settings(max_examples=40)
@given(forms(), forms(), VALUES)
def test_substitution_is_evaluation_at_the_value(
    f: Form, g: Form, values: dict[str, sp.Matrix]
) -> None:
    changed = {**values, "A": value(g, values)}
    assert value(f.substitute({"A": g}), values) == value(f, changed)


@settings(max_examples=40)
@given(forms())
def test_a_form_is_the_sum_of_its_coefficients(f: Form) -> None:
    (h,) = scalars("h")
    parts = f.coefficient("h", 0) + h * f.coefficient("h", 1) + h * h * f.coefficient("h", 2)
    assert not (parts - f).terms


def test_text_reads_as_a_person_writes() -> None:
    m, c, x = letters("M C x", ("M", "C"))
    (h,) = scalars("h")
    assert str(m + h * c - Fraction(1, 2) * (h * h * (x.T * m * x))) == (
        "M + h*C - 1/2*h**2*T(x)*M*x"
    )
    assert str(m - m) == "0"


def test_only_a_single_scalar_has_an_inverse() -> None:
    h, k = scalars("h k")
    assert not (inverse(h * h) * h * h - inverse(h) * h).terms
    for form in (h + k, h * k, letters("M")[0]):
        with pytest.raises(ValueError, match="one scalar"):
            inverse(form)
