"""The derived second moments of cyclic SPSA beside Algorithm 1, run over all signs and noises."""

from fractions import Fraction
from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from theory.algebra.formulas import expanded, form_of
from theory.algebra.noncommuting import letters
from theory.systems.cyclic_spsa.error import adjoint, error_step, read, second_moment
from theory.systems.cyclic_spsa.statements.stability import adjoint_pull_and_kick, pull_and_kick
from verification.exact.evaluate import Rows, add, multiply, quadratic, scaled
from verification.systems.cyclic_spsa.block_inputs import Block
from verification.systems.cyclic_spsa.stability.moments import exact_operators, fmpq, rows_of

SIZE = 2


def outer(x, y):
    return tuple(tuple(a * b for b in y) for a in x)


def times(rows, x):
    return [sum((a * b for a, b in zip(row, x, strict=True)), Fraction(0)) for row in rows]


def cost(point, measured, hessian):
    """(20) for one block."""
    away = [a - b for a, b in zip(point, measured, strict=True)]
    return quadratic(away, hessian) / 2


def after(block, root, error, alpha) -> Rows:
    """E of the outer product of the error after one update of Algorithm 1, over all draws.

    The noise is root e with e of entries +1 or -1. The error is counted from where the target is
    between the two instants, or at the one instant.
    """
    size, middle = range(SIZE), [Fraction(7, 3), Fraction(-2)]
    half = [x / 2 for x in block.drift]
    total = scaled(0, block.hessian)
    draws = list(product((-1, 1), repeat=SIZE))
    for delta, late, early in product(draws, draws, draws):
        now, before = times(root, late), times(root, early)
        if block.instants == 1:
            minus = plus = [m + x for m, x in zip(middle, now, strict=True)]
        else:
            plus = [m + s + x for m, s, x in zip(middle, half, now, strict=True)]
            minus = [m - s + x for m, s, x in zip(middle, half, before, strict=True)]
        estimate = [m + a for m, a in zip(middle, error, strict=True)]
        points = [
            [x + s * block.beta * d for x, d in zip(estimate, delta, strict=True)] for s in (-1, 1)
        ]
        y = [cost(x, q, block.hessian) for x, q in zip(points, (minus, plus), strict=True)]
        gain = alpha * (y[1] - y[0]) / (2 * block.beta)
        left = [estimate[i] - gain * delta[i] - middle[i] for i in size]
        total = add(total, outer(left, left), Fraction(1, len(draws) ** 3))
    return total


@settings(max_examples=10)
@given(
    definite_matrices(SIZE),
    st.lists(rationals(-2, 2, 4), min_size=4, max_size=4),
    st.lists(rationals(-2, 2, 4), min_size=2, max_size=2),
    st.lists(rationals(-2, 2, 4), min_size=2, max_size=2),
    st.sampled_from([1, 2]),
)
def test_the_part_of_the_second_order_in_the_error_is_the_operator(
    hessian, root, drift, error, instants
):
    root = (tuple(root[:2]), tuple(root[2:]))
    noise = multiply(root, tuple(zip(*root, strict=True)))
    block = Block(hessian, "H", noise, tuple(drift), Fraction(3, 4), instants, 1)
    alpha = Fraction(2, 5)
    moments = [after(block, root, [s * x for x in error], alpha) for s in (-1, 0, 1)]
    found = scaled(Fraction(1, 2), add(add(moments[0], moments[2]), moments[1], -2))
    operators, p = exact_operators(block), outer(error, error)
    pull, kick = (rows_of(part(fmpq(p))) for part in (operators.pull, operators.kick))
    assert found == add(add(p, pull, -alpha), kick, alpha**2)


@given(definite_matrices(3), definite_matrices(3), definite_matrices(3), definite_matrices(3))
@settings(max_examples=10)
def test_the_adjoint_is_one(hessian, noise, p, z):
    block = Block(hessian, "H", noise, (Fraction(1),) * 3, Fraction(1, 2), 2, 1)
    operators = exact_operators(block)
    y = operators.hessian * fmpq(z) * operators.hessian

    def trace(a):
        return sum((a[i, i] for i in range(1, 3)), start=a[0, 0])

    inside = operators.hessian * operators.adjoint_kick(fmpq(z)) * operators.hessian
    assert trace(y * operators.kick(fmpq(p))) == trace(inside * fmpq(p))
    inside = operators.hessian * operators.adjoint_pull(fmpq(z)) * operators.hessian
    assert trace(y * operators.pull(fmpq(p))) == trace(inside * fmpq(p))


def test_the_step_is_the_known_one():
    assert error_step(2).step == read("1 - alpha*Delta*T(Delta - nu)*H")
    assert error_step(1).step == read("1 - alpha*Delta*T(Delta)*H")
    offset = error_step(2).offset
    linear = read("alpha*Delta*(T(Delta - nu)*H*chi + T(chi)*H*(Delta - nu))/2")
    assert not (offset - linear).terms


def test_the_operator_reads_as_in_the_manual():
    assert str(pull_and_kick()[0]) == "H*P + P*H"
    kick = "2*Q - 2*diag(Q) + trace(Q)*I + trace(Q*N)*I"
    assert str(pull_and_kick()[1]) == kick
    assert str(adjoint_pull_and_kick()[0]) == "H*Z + Z*H"
    assert str(adjoint_pull_and_kick()[1]) == "2*Y - 2*diag(Y) + trace(Y)*I + trace(Y)*N"
    assert second_moment().coefficient("alpha", 0) == letters("P", second_moment().symmetric)[0]
    assert len(adjoint().terms) == 7


def test_formulas_that_need_more_are_refused():
    with pytest.raises(ValueError, match="sums, products and transposes"):
        form_of("sin(x)")
    with pytest.raises(ValueError, match="stand for each other"):
        expanded(letters("x")[0], {"x": letters("y")[0], "y": letters("x")[0]})
