"""Formulas: what is in the language, and which units and shapes fit."""

import pytest

from theory.expressions import calls, canonical, check_comparison, kind_of, names, parse
from theory.kinds import FormulaError, Kind
from theory.units import NUMBER, parse_unit


def kind(unit: str, *shape: int | str) -> Kind:
    rows, columns = (*shape, 1, 1)[:2]
    return Kind(parse_unit(unit), (rows, columns))


KINDS = {
    "h": kind("s"),
    "x": kind("m", 3),
    "u": kind("m/s", 3),
    "y": kind("m", 2),
    "M": kind("kg", 3, 3),
    "K": kind("kg/s^2", 3, 3),
    "B": kind("1", "n", "m"),
    "w": kind("m", "n"),
    "angle": kind("rad"),
}


@pytest.mark.parametrize(
    "text, expected",
    [
        ("h*u", kind("m", 3)),
        ("x/h", kind("m/s", 3)),
        ("T(u)*M*u/2", kind("J")),
        ("x*T(x)", kind("m^2", 3, 3)),
        ("inv(M)", kind("1/kg", 3, 3)),
        ("inv(M)*K*x", kind("m/s^2", 3)),
        ("T(B)*w", kind("m", "m")),
        ("d(d(x))", kind("m/s^2", 3)),
        ("norm(x)", kind("m")),
        ("largest(u)", kind("m/s")),
        ("sgn(w)", kind("1", "n")),
        ("sqrt(T(x)*x)", kind("m")),
        ("sqrt(h)*sqrt(h)", kind("s")),
        ("h**3", kind("s^3")),
        ("det(M)", kind("kg^3")),
        ("det(B*T(B))", kind("1")),
        ("column(h, h)", kind("s", 2)),
        ("column(cos(angle), sin(angle))", kind("1", 2)),
        ("mean(x*T(x))", kind("m^2", 3, 3)),
        ("-next(x) + previous(x)", kind("m", 3)),
        ("(M + h*h*K)*u", kind("kg m/s", 3)),
    ],
)
def test_units_and_shapes_follow_the_formula(text: str, expected: Kind) -> None:
    assert kind_of(parse(text), KINDS) == expected


@pytest.mark.parametrize(
    "text, what",
    [
        ("x + u", "same unit"),
        ("x + y", "same unit and shape"),
        ("M*y", "inner sizes"),
        ("x*x", "inner sizes"),
        ("h + 1", "same unit"),
        ("x/x", "a scalar is needed"),
        ("x**2", "a scalar is needed"),
        ("inv(x)", "square"),
        ("det(x)", "square"),
        ("det(M*B)", "inner sizes"),
        ("sqrt(x)", "scalar"),
        ("sin(h)", "angle"),
        ("column(h, 1)", "one unit"),
        ("column(x, x)", "scalars"),
        ("z", "not declared"),
        ("x == x", "no value"),
    ],
)
def test_what_does_not_fit_is_refused(text: str, what: str) -> None:
    with pytest.raises(FormulaError, match=what):
        kind_of(parse(text), KINDS)


def test_a_determinant_of_open_size_needs_pure_numbers() -> None:
    with pytest.raises(FormulaError, match="size is needed"):
        kind_of(parse("det(w*T(w))"), KINDS)


@pytest.mark.parametrize(
    "text", ["x.y", "x[0]", "f(x)", "T(x, y)", "column()", "0.5*x", "x**y", "x**0", "a < b < c",
             "'x'", "True", "x if y else z", "x +", "T(x=1)"]
)  # fmt: skip
def test_other_texts_are_not_in_the_language(text: str) -> None:
    with pytest.raises(FormulaError):
        parse(text)


def test_zero_fits_every_unit_and_nothing_else_does() -> None:
    check_comparison(parse("h > 0"), KINDS)
    check_comparison(parse("w == 0"), KINDS)
    check_comparison(parse("norm(x) <= norm(x)"), KINDS)
    for text, what in [("h > 1", "one unit"), ("x == y", "one unit"), ("h", "comparison")]:
        with pytest.raises(FormulaError, match=what):
            check_comparison(parse(text), KINDS)


def test_names_and_calls_are_found() -> None:
    tree = parse("T(x)*M*next(x) == h")
    assert names(tree) == {"x", "M", "h"}
    assert calls(tree) == {"T", "next"}


def test_canonical_text_is_of_the_tree_not_of_the_writing() -> None:
    assert canonical(parse("x+y *z")) == canonical(parse("x + (y*z)"))
    assert canonical(parse("x + y*z")) == "(+ (name x) (* (name y) (name z)))"
    texts = ["x + y", "y + x", "x - y", "x*y", "T(x)*y", "-x", "x**2", "x == y", "x <= y"]
    assert len({canonical(parse(text)) for text in texts}) == len(texts)


def test_kinds_print_shape_and_unit() -> None:
    assert str(KINDS["u"]) == "3 by 1 in m/s"
    assert Kind(NUMBER).scalar
