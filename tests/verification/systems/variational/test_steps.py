"""Step limits of the variational estimator beside an independent road: eigenvalues of the map."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import definite_matrices, rationals
from verification.certificates import check
from verification.certificates.make import statements
from verification.exact.evaluate import scaled
from verification.systems.variational.steps import decide_step, leapfrog_step_limit, step_limit

ONE = ((Fraction(1),),)
TWO = {
    "M": ((Fraction(1), Fraction(0)), (Fraction(0), Fraction(2))),
    "K": ((Fraction(5), Fraction(1)), (Fraction(1), Fraction(2))),
    "C": ((Fraction(3, 5), Fraction(1, 10)), (Fraction(1, 10), Fraction(9, 10))),
}


def radius(gains, h, centred=False):
    """Spectral radius of one step, assembled in floats from the printed lines of (20)."""
    m, k, c = (np.array(gains[name], dtype=float) for name in "MKC")
    n, h = len(m), float(h)
    left, right = (m + h * c / 2, m - h * c / 2) if centred else (m + h * c, m)
    velocity = np.linalg.solve(left, np.hstack([-h * k, right - h * h * k]))
    step = np.vstack([np.hstack([np.eye(n), h * np.eye(n)]), velocity])
    return np.abs(np.linalg.eigvals(step)).max()


def gains(n):
    return st.fixed_dictionaries({name: definite_matrices(n) for name in "MKC"})


@settings(max_examples=25)
@given(st.integers(1, 3).flatmap(gains))
def test_the_limit_parts_stable_from_unstable_steps(values):
    for quantity, centred in ((step_limit, False), (leapfrog_step_limit, True)):
        answer = quantity(values)
        assert answer.verdict == "PROVED"
        assert answer.lower <= answer.value <= answer.upper
        assert radius(values, 0.99 * answer.lower, centred) < 1
        assert radius(values, 1.01 * answer.upper, centred) > 1
        entry = check.check_document(answer.certificate, statements())
        assert Fraction(entry["lower"]) <= Fraction(answer.value) <= Fraction(entry["upper"])


@settings(max_examples=25)
@given(gains(2), rationals(Fraction(1, 20), 6))
def test_the_condition_agrees_with_the_limit(values, h):
    answer, limit = decide_step({**values, "h": h}), step_limit(values)
    assert (answer.verdict == "PROVED") == (h < Fraction(limit.upper))
    assert answer.margin == pytest.approx(limit.value - float(h))


def test_doubles_just_beside_the_limit_are_decided_apart():
    limit = step_limit(TWO)
    inside = decide_step({**TWO, "h": Fraction(limit.lower)})
    outside = decide_step({**TWO, "h": Fraction(limit.upper)})
    assert (inside.verdict, outside.verdict) == ("PROVED", "REFUTED")


def test_exactly_at_a_rational_limit_a_solution_does_not_decay():
    values = {"M": ONE, "K": scaled(2, ONE), "C": ONE}
    assert decide_step({**values, "h": Fraction(2)}).verdict == "REFUTED"
    hair = Fraction(1, 10**30)
    assert decide_step({**values, "h": 2 - hair}).verdict == "PROVED"
    assert decide_step({**values, "h": 2 + hair}).verdict == "REFUTED"


@given(gains(2), rationals(Fraction(1, 5), 5))
@settings(max_examples=15)
def test_a_new_unit_of_time_rescales_the_limit(values, unit):
    """h counts in units; K scales with 1/unit^2 and C with 1/unit."""
    other = {
        "M": values["M"],
        "K": scaled(1 / unit**2, values["K"]),
        "C": scaled(1 / unit, values["C"]),
    }
    assert step_limit(other).value == pytest.approx(
        float(unit) * step_limit(values).value, rel=1e-12
    )


@pytest.mark.parametrize(
    "name,rows,words",
    [
        ("M", [[1, 2], [0, 1]], "not symmetric"),
        ("K", [[1, 2], [2, 1]], "not positive definite: x = ("),
        ("C", [[0, 0], [0, 1]], "not positive definite"),
        ("C", [[1]], "the size of M"),
    ],
)
def test_a_bad_gain_is_named_with_a_witness(name, rows, words):
    bad = {**TWO, name: tuple(tuple(map(Fraction, row)) for row in rows)}
    with pytest.raises(InputError) as error:
        step_limit(bad)
    assert error.value.name == name
    assert words in str(error.value)


@pytest.mark.parametrize("h", [Fraction(0), Fraction(-1, 3)])
def test_a_step_that_is_not_positive_is_refused(h):
    with pytest.raises(InputError, match=r"^h: "):
        decide_step({**TWO, "h": h})


def test_a_larger_matrix_is_certified():
    n = 20
    rng = np.random.default_rng(0)
    values = {}
    for name in "MKC":
        a = rng.integers(-9, 10, (n, n))
        rows = a @ a.T + 9 * np.eye(n, dtype=int)
        values[name] = tuple(tuple(Fraction(int(x), 50) for x in row) for row in rows)
    answer = step_limit(values)
    assert answer.verdict == "PROVED"
    assert answer.upper / answer.lower < 1 + 1e-10


@pytest.mark.parametrize(
    "m,k,c,expected",
    [
        ("1e-200", "1e200", "1e-100", 2e-200),
        ("1", "1e-300", "1", 2e300),
        ("1e300", "1e300", "1e-300", 2.0),
    ],
)
def test_units_far_from_one_are_no_obstacle(m, k, c, expected):
    answer = step_limit({n: ((Fraction(x),),) for n, x in zip("MKC", (m, k, c), strict=True)})
    assert answer.verdict == "PROVED"
    assert answer.value == pytest.approx(expected, rel=1e-12)


def test_unlike_units_of_two_coordinates_are_balanced():
    small, large = Fraction(1, 10**100), Fraction(10**100)
    gains = {name: ((Fraction(1), Fraction(0)), (Fraction(0), Fraction(1))) for name in "KC"}
    answer = step_limit({"M": ((small, Fraction(0)), (Fraction(0), large)), **gains})
    assert (answer.verdict, answer.value) == ("PROVED", 2.0)


def test_a_limit_beyond_all_doubles_is_undecided():
    values = {"M": ONE, "K": ((Fraction(1, 10**300),),), "C": ((Fraction(10**300),),)}
    assert step_limit(values).verdict == "UNDECIDED"
    assert decide_step({**values, "h": Fraction(1)}).verdict == "PROVED"
