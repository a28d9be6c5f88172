"""The bounds of Theorem 1 in letters are those in numbers."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from theory.algebra.identities import ONE
from theory.algebra.noncommuting import scalars
from theory.expressions import parse
from theory.systems.cyclic_spsa.bound_letters import LETTERS, constants, polynomial, without_root
from theory.systems.cyclic_spsa.bounds import PRINTED, PROVED, table

NAMES = ("alpha", "beta", "delta", "mu", "M", "d", "c2", "c3", "c4", "c_v2")
numbers = st.floats(0.1, 3)


def value(form, values):
    """A polynomial in scalars."""
    return sum(
        float(a) * math.prod(values[name] ** power for name, power in powers)
        for (powers, _), a in form.terms.items()
    )


@settings(max_examples=30)
@given(st.lists(numbers, min_size=len(NAMES), max_size=len(NAMES)))
@pytest.mark.parametrize("bound", [PRINTED, PROVED], ids=["printed", "proved"])
def test_lines_in_letters_have_the_values_of_the_lines(bound, drawn):
    given_ = dict(zip(NAMES, drawn, strict=True)) | {"k": 1, "root_k": 1}
    known = table(bound, given_, lambda x: math.sqrt(abs(x)))
    inverse = {"half": 1 / (2 * known["beta"]), "rate": 1 / known["alpha"]}
    for name, form in constants(bound, LETTERS).items():
        if name in known and name not in ("k", "root_k"):
            assert value(form, known | inverse) == pytest.approx(known[name], rel=1e-9, abs=1e-9)


def test_the_root_of_d_goes_in_pairs():
    root_d, d = scalars("root_d d")
    assert without_root(root_d * root_d * root_d).terms == (d * root_d).terms
    assert without_root(ONE).terms == ONE.terms


@pytest.mark.parametrize("text", ["mu/gamma", "mu/(beta + 1)", "mu == M"])
def test_what_is_no_polynomial_is_refused(text):
    (gamma,) = scalars("gamma")
    with pytest.raises(ValueError, match=r"needed|no arithmetic"):
        polynomial(parse(text), LETTERS | {"gamma": gamma})
