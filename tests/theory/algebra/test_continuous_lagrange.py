"""The continuous Lagrange-d'Alembert equation, against sympy's derivatives along a path."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from tests.theory.substitution import generic, substituted
from theory.algebra.continuous_lagrange import (
    along,
    decay,
    equation,
    expansion,
    first_variation,
    principle,
    second_order,
    unrestricted,
)
from theory.algebra.identities import ONE, Square
from theory.algebra.noncommuting import Form, letters, scalars
from theory.algebra.quadratic_forms import symmetrised
from theory.systems.variational.statements import decays
from theory.systems.variational.statements.common import (
    EQUATION,
    HALF,
    C,
    K,
    M,
    dissipation,
    energy,
    lagrangian,
)

T = sp.Symbol("t")
PATH = sp.Matrix([sp.Function(f"x_{i}")(T) for i in range(2)])
SPEED = PATH.diff(T)
VARIATION = sp.Matrix([sp.Function(f"d_{i}")(T) for i in range(2)])
ANY = sp.Matrix(2, 2, sp.symbols("C_00 C_01 C_10 C_11"))
KNOWN = {
    "M": generic("M"),
    "K": generic("K"),
    "C": ANY,
    "x": PATH,
    "u": SPEED,
    "w": SPEED.diff(T),
    "d": VARIATION,
    "p": VARIATION.diff(T),
}
X, U = letters("x u")


def value(form: Form) -> sp.Matrix:
    return substituted(form, KNOWN)


def same(left: sp.Matrix, right: sp.Matrix) -> bool:
    return bool((left - right).applyfunc(sp.simplify).is_zero_matrix)


def action() -> sp.Expr:
    """The integrand (11), in components."""
    return sp.Rational(1, 2) * ((SPEED.T * KNOWN["M"] * SPEED)[0] - (PATH.T * KNOWN["K"] * PATH)[0])


def test_equation_is_the_euler_lagrange_equation_of_the_components() -> None:
    integrand = action()
    left = sp.Matrix(
        [
            sp.diff(integrand, v).diff(T) - sp.diff(integrand, q)
            for q, v in zip(PATH, SPEED, strict=True)
        ]
    )
    made = unrestricted(equation(lagrangian, dissipation), "C")
    assert same(value(made), left + ANY * SPEED)


def test_equation_is_what_the_recursion_tends_to() -> None:
    (w,) = letters("w")
    (h,) = scalars("h")
    slope = EQUATION.substitute({"v": U - h * w}).coefficient("h", 1)
    assert not (slope + equation(lagrangian, dissipation)).terms


def test_only_the_symmetric_part_of_a_weight_counts() -> None:
    (weight,) = letters("B")
    made = equation(lambda _, u: HALF * (u.T * weight * u), lambda x, _: Form({}) * x)
    (w,) = letters("w")
    assert not (made - HALF * ((weight + weight.T) * w)).terms


def test_first_variation_is_the_derivative_of_the_varied_integrand() -> None:
    e = sp.Symbol("e")
    varied = action().subs(dict(zip(PATH, PATH + e * VARIATION, strict=True))).doit()
    slope = sp.Matrix([sp.diff(varied, e).subs(e, 0)])
    assert same(value(first_variation(lagrangian)), slope)


def test_along_is_the_derivative_in_time() -> None:
    form = symmetrised(X.T * K * U + U.T * M * U)
    assert same(value(along(form)), value(form).diff(T))


def test_the_principle_needs_no_hypothesis() -> None:
    for made in principle(lagrangian, dissipation):
        assert made.holds
        assert not made.combination


def test_a_lagrangian_that_is_not_quadratic_is_refused() -> None:
    with pytest.raises(ValueError, match="leaves"):
        principle(lambda x, u: lagrangian(x, u) * lagrangian(x, u), dissipation)
    with pytest.raises(ValueError, match="leaves"):
        expansion(energy(X, U) * energy(X, U))


def test_the_energy_is_quadratic() -> None:
    assert expansion(energy(X, U)).holds


def test_second_order_finds_the_coefficients() -> None:
    found = second_order(equation(lagrangian, dissipation))
    assert [str(part) for part in (found.mass, found.damping, found.stiffness)] == ["M", "C", "K"]


def test_an_equation_with_more_in_it_is_refused() -> None:
    (f,) = letters("f")
    with pytest.raises(ValueError, match="f is left"):
        second_order(equation(lagrangian, lambda x, u: dissipation(x, u) + f))


@given(st.integers(1, 6))
def test_a_rate_is_believed_up_to_what_the_squares_give(times: int) -> None:
    """V = E + g x'Mu with C = 2gM falls at the rate 2g, neither more nor less."""
    form, g = decays.crossed(decays.g), decays.g
    if times == 2:
        assert decay(form, times * g, decays.EXACT_GIVEN, {0: "M w"}, ()).holds
    else:
        with pytest.raises(ValueError, match="leaves"):
            decay(form, times * g, decays.EXACT_GIVEN, {0: "M w"}, ())


def test_dissipation_of_a_skew_force_vanishes() -> None:
    """A gyroscopic force, C' = -C, changes no energy."""
    free = unrestricted(C, "C")
    motion = unrestricted(equation(lagrangian, dissipation), "C")
    skew = (motion, free + free.T)
    made = decay(energy(X, U), Form({}), skew, {0: "M w", 1: "C"}, ())
    assert made.holds
    with pytest.raises(ValueError, match="leaves"):
        decay(energy(X, U), Form({}), skew, {0: "M w", 1: "C"}, (Square(ONE, U, M),))
