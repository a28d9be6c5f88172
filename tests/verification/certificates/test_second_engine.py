"""Every matrix that a certificate shows to be definite is definite by ball arithmetic as well."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from verification.exact.balls import ball_definite

from .documents import provable, text
from .samples import samples
from .second_engine import decided_by_balls, definite_matrices_of

A = {"A": "matrix"}


@pytest.mark.parametrize("key", sorted(samples()))
def test_what_a_certificate_shows_to_be_definite_is_so_by_balls(key, samples, known):
    shown = definite_matrices_of(samples[key], known)
    items = [item["kind"] for item in samples[key]["witness"]]
    assert len(shown) == items.count("congruence") + items.count("combination")
    for rows in shown:
        assert decided_by_balls(rows) is True


def test_some_samples_have_such_matrices(samples, known):
    assert sum(bool(definite_matrices_of(made, known)) for made in samples.values()) >= 10


@given(st.integers(1, 4).flatmap(definite_matrices), rationals(-6, 1, 6))
def test_the_two_engines_agree_where_balls_can_tell(rows, shift):
    moved = [[x + shift * (i == j) for j, x in enumerate(row)] for i, row in enumerate(rows)]
    answer = decided_by_balls(moved)
    found = provable(["pd(A)"], {"A": text(moved)}, A) is not None
    assert answer is None or answer == found


@pytest.mark.parametrize("bits", [64, 256])
def test_balls_do_not_decide_what_is_singular(bits):
    third = Fraction(1, 3)
    assert ball_definite([[third, third], [third, third]], bits) is None
    assert ball_definite([[third, third], [third, third + Fraction(1, 10**9)]], bits) is True
    assert ball_definite([[third, third], [third, third - Fraction(1, 10**9)]], bits) is False
