"""Identities of least squares, row by row and averaged, hold for drawn rows."""

import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.theory.substitution import substituted
from theory.algebra import averages

NUMBERS = st.integers(-4, 4)
TANGENTS = st.lists(st.fractions(-2, 2, max_denominator=3), min_size=2, max_size=4)


def rows(draw, n, columns):
    return sp.Matrix(
        n, columns, draw(st.lists(NUMBERS, min_size=n * columns, max_size=n * columns))
    )


@st.composite
def stacks(draw):
    n = draw(st.integers(2, 4))
    h, z, y, p = rows(draw, n, 2), rows(draw, n, 1), rows(draw, 2, 1), rows(draw, 2, 1)
    assume((h.T * h).det() != 0)
    x = (h.T * h).inv()
    known = {"H": h, "z": z, "X": x, "Y": n * x, "g": x * h.T * z, "y": y, "d": h * p, "p": p}
    return known, {"r": sp.Rational(1, n)}


def holds(entry, values):
    assert entry.holds
    for form in (*entry.relations, entry.goal):
        assert substituted(form, *values, size=2).is_zero_matrix, (entry.name, str(form))


@settings(max_examples=10, deadline=None)
@given(stacks())
def test_least_squares_and_its_averaged_form(values):
    for entry in (*averages.least_squares(), averages.averaged()):
        holds(entry, values)


@settings(max_examples=10, deadline=None)
@given(stacks(), NUMBERS)
def test_one_more_sensor_adds_its_own_terms(values, m):
    (matrices, _), n = values, values[0]["H"].rows
    h, z, row, p = matrices["H"], matrices["z"], sp.Matrix([2, -1]), matrices["p"]
    old, new = sp.eye(n + 1)[:, :n], sp.eye(n + 1)[:, n]
    known = {"H": h, "z": z, "E": old, "a": new, "h": row, "p": p}
    known |= {"K": h.col_join(row.T), "Z": z.col_join(sp.Matrix([m]))}
    for entry in averages.stacked():
        holds(entry, (known, {"m": sp.Integer(m)}))


@settings(max_examples=10, deadline=None)
@given(TANGENTS)
def test_the_determinant_is_the_spread_of_twice_the_bearings(tangents):
    n = len(tangents)
    half = [sp.Rational(t.numerator, t.denominator) for t in tangents]
    c = [(1 - t * t) / (1 + t * t) for t in half]
    s = [2 * t / (1 + t * t) for t in half]
    k = sp.Matrix([x * x - y * y for x, y in zip(c, s, strict=True)])
    twice = sp.Matrix([2 * x * y for x, y in zip(c, s, strict=True)])
    centre = sp.eye(n) - sp.ones(n, n) / n
    known = {"k": k, "l": twice, "M": centre, "e": sp.ones(n, 1)}
    scalars = {"r": sp.Rational(1, n), "a": sum(k) / n, "b": sum(twice) / n}
    for entry in averages.spread():
        holds(entry, (known, scalars))
    info = (
        sum(
            (sp.Matrix([-y, x]) * sp.Matrix([[-y, x]]) for x, y in zip(c, s, strict=True)),
            sp.zeros(2, 2),
        )
        / n
    )
    assert 4 * info.det() == 1 - scalars["a"] ** 2 - scalars["b"] ** 2
    assert (info.det() == 0) == (len({*zip(k, twice, strict=True)}) == 1)


def test_exact_averages_give_the_position_and_wrong_ones_do_not():
    n, p = sp.Matrix([[2, 1], [1, 3]]), sp.Matrix([5, -4])
    known = {"N": n, "A": n, "Y": n.inv(), "m": n * p, "d": n * p, "p": p}
    for entry in averages.agreed():
        holds(entry, (known, {}))
    off = known["d"] + sp.Matrix([0, 1])
    assert n.inv() * off != p
