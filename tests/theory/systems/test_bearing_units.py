"""What the printed gain and the printed time leave open about units, by the units of the laws."""

import pytest

from theory.expressions import check_comparison, kind_of, parse
from theory.kinds import FormulaError
from theory.systems.bearing_dac import SYSTEM
from theory.units import parse_unit

KINDS = SYSTEM.kinds()


def test_the_one_of_the_printed_gain_has_no_unit_of_a_gain():
    check_comparison(parse("beta >= gamma"), KINDS)
    with pytest.raises(FormulaError):
        check_comparison(parse("beta >= 1 + gamma"), KINDS)


def test_the_printed_time_has_the_unit_of_an_entry_and_becomes_a_time_over_a_gain():
    entry, second = parse_unit("c", SYSTEM.units), parse_unit("s")
    assert kind_of(parse("largest(e_x)"), KINDS).unit == entry
    assert entry != second
    assert kind_of(parse("largest(e_x)/beta"), KINDS).unit == second


def test_entries_of_p_and_of_q_differ_in_unit():
    assert KINDS["P"].unit != KINDS["q"].unit
    assert any("units" in gap.missing for gap in SYSTEM.gaps)
