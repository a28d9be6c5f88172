"""Laws in the notation of the papers."""

import pytest
from latex2mathml.converter import convert

from theory.expressions import parse
from theory.latex import formula, law
from theory.systems import SYSTEMS


@pytest.mark.parametrize(
    "text,written",
    [
        ("a - (b - c)", r"a - \left(b - c\right)"),
        ("(a + b)*c", r"\left(a + b\right)\,c"),
        ("-beta*B*x", r"-\beta\,B\,x"),
        ("a - -b*c", r"a - \left(-b\,c\right)"),
        ("T(a*b)**2", r"\left(\left(a\,b\right)^{\mathsf T}\right)^{2}"),
        ("a/(b + c)", r"\frac{a}{b + c}"),
        ("d(b_hat) == next(x)", r"\dot{\hat{b}} = x^{+}"),
        ("sum(a - b)", r"\sum_i \left(a - b\right)"),
        ("largest(x) <= gamma", r"\left\lVert x\right\rVert \le \gamma"),
        ("sqrt(a)*inv(B)", r"\sqrt{a}\,B^{-1}"),
    ],
)
def test_brackets_stand_where_they_are_needed_and_nowhere_else(text, written):
    assert formula(parse(text)) == written


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_every_law_and_guard_becomes_mathml(system):
    for given in system.laws:
        assert convert(law(given)).startswith("<math")
    for guard in system.guards:
        assert convert(formula(guard.tree)).startswith("<math")
