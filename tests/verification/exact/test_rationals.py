"""Exact numbers in and out."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.errors import InputError
from verification.exact.rationals import above, below, nearest, parse_exact


@pytest.mark.parametrize(
    "text,value",
    [
        ("0.1", Fraction(1, 10)),
        ("1/3", Fraction(1, 3)),
        (" 2e-3 ", Fraction(1, 500)),
        ("-.5", Fraction(-1, 2)),
        (7, Fraction(7)),
        (0.1, Fraction(0.1)),
    ],
)
def test_a_decimal_text_is_that_decimal_and_a_float_its_dyadic(text, value):
    assert parse_exact(text, "h") == value


@pytest.mark.parametrize(
    "bad",
    [
        "nan",
        "inf",
        "1/0",
        "one",
        "",
        "1e999",
        "1_000",
        True,
        None,
        math.nan,
        math.inf,
        "9" * 2000,
        "1e-9999999999",
        "0x10",
        "1/2/3",
        [1],
    ],
)
def test_what_is_no_finite_number_is_refused_by_name(bad):
    with pytest.raises(InputError) as error:
        parse_exact(bad, "h")
    assert str(error.value).startswith("h: ")


@given(st.fractions())
def test_doubles_enclose(value):
    assert Fraction(below(value)) <= value <= Fraction(above(value))
    assert below(value) in (above(value), math.nextafter(above(value), -math.inf))
    assert nearest(value) in (below(value), above(value))


def test_beyond_the_largest_double():
    huge = Fraction(10) ** 400
    assert nearest(huge) == math.inf
    assert above(huge) == math.inf
    assert below(huge) == math.nextafter(math.inf, 0)
    assert below(-huge) == -math.inf
