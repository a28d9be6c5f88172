"""Units read, multiply and print as a physicist expects; what carries a factor is refused."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from theory.units import BASE, NUMBER, Unit, parse_unit

POWERS = st.dictionaries(st.sampled_from(BASE), st.integers(-3, 3), max_size=4)
UNITS = POWERS.map(
    lambda powers: Unit(tuple(sorted((name, Fraction(p)) for name, p in powers.items() if p)))
)


@given(UNITS)
def test_text_reads_back(unit: Unit) -> None:
    assert parse_unit(str(unit)) == unit


@given(UNITS, UNITS, UNITS)
def test_units_form_a_group(a: Unit, b: Unit, c: Unit) -> None:
    assert (a * b) * c == a * (b * c)
    assert a * b == b * a
    assert a / a == a**0 == NUMBER
    assert (a * b) ** 2 == a**2 * b**2
    assert (a**2) ** Fraction(1, 2) == a


@pytest.mark.parametrize(
    "text, same",
    [
        ("kg m^2/s^2", "J"),
        ("N m", "J"),
        ("J/s", "W"),
        ("1/s", "Hz"),
        ("rad/s", "1/s"),
        ("m^-1", "1/m"),
        ("rad", "1"),
        ("kg/s^2", "N/m"),
    ],
)
def test_coherent_units_agree(text: str, same: str) -> None:
    assert parse_unit(text) == parse_unit(same)


@pytest.mark.parametrize(
    "text",
    ["", "km", "deg", "m/s/s", "m/1", "m^0", "m^1.5", "m  s", "2 m", "m*s", "c/s", " m", "1 m"],
)
def test_other_texts_are_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"unit: .* is needed"):
        parse_unit(text)


def test_a_generic_unit_is_one_of_its_own() -> None:
    rate = parse_unit("c/s", generic=["c"])
    assert rate != parse_unit("m/s")
    assert rate * parse_unit("s") == parse_unit("c", generic=["c"])
