"""A formula whose terms do not have one unit is reported with the units of its terms."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from theory.dimensions import clashes, written
from theory.expressions import Tree, kind_of, parse, walk
from theory.kinds import FormulaError, Kind
from theory.units import parse_unit

UNITS = {"x": "m", "t": "s", "v": "m/s", "n": "1", "w": Kind(parse_unit("m"), (2, 1))}
SPSA = {
    "alpha": "L^2/F", "beta": "L", "d": "1", "delta": "L", "mu": "F/L^2", "M": "F/L^2",
    "c2": "F^2/L^2", "c3": "F^2/L^2", "c4": "F^2", "c_v": "F",
}  # fmt: skip
"""Cost in F, positions in L, as Assumptions 1 to 6 of Erofeeva and Granichin have them."""


@pytest.mark.parametrize(
    "text", ["x + v*t", "x/t - 3*v", "sin(n) + 1", "w + 2*w", "x > 0", "n*x == v*t", "-x + x"]
)
def test_a_formula_that_fits_has_no_clash(text: str) -> None:
    assert clashes(text, UNITS) == ()


def test_terms_are_named_with_their_units() -> None:
    (clash,) = clashes("x + v*t - 2*v", UNITS)
    assert clash.terms == (("x", "m"), ("v*t", "m"), ("2*v", "m/s"))
    expected = "x + v*t - 2*v: terms of different units: "
    assert str(clash) == f"{expected}x is in m, v*t is in m, 2*v is in m/s"


def test_what_is_inside_is_named_first_and_what_is_built_on_it_is_not_judged() -> None:
    inner, outer = clashes("n*(x + t) + x + v", UNITS)
    assert inner.formula == "x + t"
    assert outer.terms == (("x", "m"), ("v", "m/s"))
    assert len(clashes("x*(n + t)", UNITS)) == 1


@pytest.mark.parametrize(
    "text, what", [("sin(x)", "angle"), ("w*w", "inner sizes"), ("x + w", "shapes")]
)
def test_calls_products_and_shapes_are_judged_too(text: str, what: str) -> None:
    assert what in str(clashes(text, UNITS))


def test_both_sides_of_a_comparison_are_terms() -> None:
    (clash,) = clashes("x <= v", UNITS)
    assert clash.terms == (("x", "m"), ("v", "m/s"))


@pytest.mark.parametrize(
    "text, odd, unit",
    [
        ("M**2*d + c3/beta", "c3/beta", "F^2/L^3"),
        ("d*c2 + d**2*M**2*beta**2 + c4/beta", "c4/beta", "F^2/L"),
        ("d*c2 + c_v**2", "c_v**2", "F^2"),
        ("mu*delta + 3*mu*delta**2 + M*beta", "3*mu*delta**2", "F"),
    ],
)
def test_printed_constants_of_cyclic_spsa_that_no_unit_fits(text: str, odd: str, unit: str) -> None:
    (clash,) = clashes(text, SPSA, generic=("F", "L"))
    units = dict(clash.terms)
    assert units.pop(odd) == unit
    assert len(set(units.values())) == 1


@pytest.mark.parametrize(
    "text",
    ["M**2*d + c3/(8*beta**2)", "2*(mu - alpha*d*M**2)", "2*d*c2 + (c3*delta**2 + c4)/beta**2"],
)
def test_their_corrected_forms_fit(text: str) -> None:
    assert clashes(text, SPSA, generic=("F", "L")) == ()


def test_a_name_without_a_unit_and_a_unit_that_is_none_are_refused() -> None:
    with pytest.raises(FormulaError, match="y is not declared"):
        clashes("x + y", UNITS)
    with pytest.raises(ValueError, match="km"):
        clashes("x", {"x": "km"})


def leaves() -> st.SearchStrategy[Tree]:
    names = st.sampled_from(["x", "t", "v", "n"]).map(lambda name: ("name", name))
    return names | st.integers(0, 9).map(lambda number: ("number", number))


def grown(inner: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    binary = st.tuples(st.sampled_from(["+", "-", "*", "/"]), inner, inner)
    powers = st.tuples(st.just("power"), inner, st.integers(1, 3))
    minus = inner.map(lambda tree: ("*", ("number", -1), tree))
    return binary | powers | minus | inner.map(lambda tree: ("call", "norm", tree))


TREES = st.recursive(leaves(), grown, max_leaves=12)


@given(TREES)
def test_written_text_reads_back(tree: Tree) -> None:
    assert parse(written(tree)) == tree


@given(TREES.filter(lambda tree: ("number", 0) not in walk(tree)))
def test_no_clash_if_and_only_if_the_formula_has_a_kind(tree: Tree) -> None:
    scalars = {name: unit for name, unit in UNITS.items() if isinstance(unit, str)}
    kinds = {name: Kind(parse_unit(unit)) for name, unit in scalars.items()}
    try:
        kind_of(tree, kinds)
        fits = True
    except FormulaError:
        fits = False
    found = clashes(written(tree), scalars)
    assert bool(found) is not fits
