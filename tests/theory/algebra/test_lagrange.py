"""The discrete Lagrange-d'Alembert equation, against sympy's derivative of a written-out sum."""

import pytest
import sympy as sp

from tests.theory.substitution import generic, substituted, vector
from theory.algebra.lagrange import discrete_equation, first_variation, recursion
from theory.algebra.noncommuting import Form, letters
from theory.systems.variational.statements.common import (
    EQUATION,
    PRINTED,
    SCHEME,
    SYMMETRIC,
    C,
    K,
    M,
    centred_dissipation,
    h,
    lagrangian,
)

N = 3
H = sp.Symbol("h")
GAINS = {name: generic(name) for name in SYMMETRIC}
NODES = [vector(f"x{k}") for k in range(N + 2)]
SPEEDS = [(NODES[k + 1] - NODES[k]) / H for k in range(N + 1)]


def action(last: int) -> sp.Expr:
    """Sum of h L(x_k, u_k) up to k = last, written out in components."""
    terms = [
        u.T * GAINS["M"] * u - x.T * GAINS["K"] * x
        for x, u in zip(NODES[: last + 1], SPEEDS, strict=False)
    ]
    return H * sum((term[0] for term in terms), sp.Integer(0)) / 2


def slope(node: int, last: int) -> sp.Matrix:
    """Derivative of the action with respect to one node."""
    total = action(last)
    return sp.Matrix([sp.diff(total, entry) for entry in NODES[node]])


def value(form: Form, node: int) -> sp.Matrix:
    known = GAINS | {"x": NODES[node], "u": SPEEDS[node] if node <= N else sp.zeros(2, 1)}
    return substituted(form, known | {"v": SPEEDS[node - 1]}, {"h": H})


def same(left: sp.Matrix, right: sp.Matrix) -> bool:
    return bool((left - right).applyfunc(sp.simplify).is_zero_matrix)


@pytest.mark.parametrize("node", [1, 2])
def test_first_variation_is_the_derivative_at_inner_nodes(node: int) -> None:
    assert same(value(first_variation(lagrangian), node), slope(node, N - 1))


def test_forced_equation_is_the_printed_recursion() -> None:
    assert not (EQUATION + PRINTED).terms
    forced = slope(1, N - 1) - H * GAINS["C"] * SPEEDS[1]
    assert same(value(EQUATION, 1), forced)


def test_the_printed_sum_would_demand_that_the_last_velocity_vanishes() -> None:
    (v,) = letters("v")
    surplus = first_variation(lagrangian, last_term=True)
    assert not (surplus - M * v).terms
    assert same(value(surplus, N + 1), slope(N + 1, N))


def test_recursion_eliminates_the_velocities() -> None:
    assert not (SCHEME.a2 - (M + h * C)).terms
    assert not (SCHEME.a1 - (h * h * K - 2 * M - h * C)).terms
    assert not (SCHEME.a0 - M).terms
    made = sum(
        (
            substituted(part, GAINS, {"h": H}) * NODES[k]
            for k, part in enumerate([SCHEME.a0, SCHEME.a1, SCHEME.a2])
        ),
        sp.zeros(2, 1),
    )
    assert same(made, -H * value(EQUATION, 1))


def test_centred_force_makes_the_recursion_symmetric_about_the_node() -> None:
    made = recursion(discrete_equation(lagrangian, centred_dissipation))
    flipped = {"h": -1 * h}
    assert not (made.a2 - made.a0.substitute(flipped)).terms
    assert not (made.a1 - made.a1.substitute(flipped)).terms


def test_a_wrong_printed_recursion_would_be_found() -> None:
    u, v, x = letters("u v x")
    explicit = M * u - (M - h * C) * v + h * K * x
    assert (EQUATION + explicit).terms
