"""Discretisation rules: recursion, limit and order, beside the derived schemes and exact motion."""

from fractions import Fraction

import numpy as np
import pytest
from scipy.linalg import expm

from theory.algebra.discretisation import (
    HALF,
    LEFT,
    MIDPOINT,
    ONE,
    RIGHT,
    TRAPEZOID,
    ZERO,
    Rule,
    discretised,
    order,
    residual,
)
from theory.algebra.lagrange import Recursion
from theory.algebra.noncommuting import Form, letters
from theory.systems.variational.statements.common import LEAPFROG, SCHEME, C, K, M, lagrangian
from verification.exact.evaluate import at

SKEWED = Rule("skewed", ((Fraction(1, 3), ZERO), (Fraction(2, 3), ONE)))
SIMPSON = Rule("Simpson", ((Fraction(1, 6), ZERO), (Fraction(2, 3), HALF), (Fraction(1, 6), ONE)))
RULES = (LEFT, RIGHT, MIDPOINT, TRAPEZOID, SKEWED, SIMPSON)
ORDERS = dict(zip(RULES, (1, 1, 2, 2, 1, 2), strict=True))
GAINS = {
    "M": np.array([[2.0, 0.5], [0.5, 1.0]]),
    "K": np.array([[4.0, 1.0], [1.0, 3.0]]),
    "C": np.array([[1.0, 0.2], [0.2, 0.5]]),
}


def damping(u: Form) -> Form:
    return -(C * u)


def scheme_of(rule: Rule) -> Recursion:
    return discretised(lagrangian, damping, rule)


def same(left: Recursion, right: Recursion) -> bool:
    pairs = zip((left.a2, left.a1, left.a0), (right.a2, right.a1, right.a0), strict=True)
    return not any((a - b).terms for a, b in pairs)


def test_the_printed_scheme_is_the_left_rectangle_and_its_repair_the_trapezoid() -> None:
    assert same(scheme_of(LEFT), SCHEME)
    assert same(scheme_of(TRAPEZOID), LEAPFROG)
    assert not same(scheme_of(MIDPOINT), LEAPFROG)


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.name)
def test_every_rule_has_the_continuous_estimator_as_its_limit(rule: Rule) -> None:
    q0, q1, q2 = letters("q0 q1 q2")
    assert not (residual(scheme_of(rule))[0] - (M * q2 + C * q1 + K * q0)).terms


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.name)
def test_order_is_the_measured_one(rule: Rule) -> None:
    """Halving the step from the exact motion at two nodes divides the error at t = 4 by 2^order."""
    errors = [error_at_four(scheme_of(rule), samples) for samples in (400, 800)]
    measured = np.log2(errors[0] / errors[1])
    assert order(scheme_of(rule)) == ORDERS[rule]
    assert measured == pytest.approx(ORDERS[rule], abs=0.05)


def error_at_four(scheme: Recursion, samples: int) -> float:
    h = Fraction(4, samples)
    exact = {n: tuple(tuple(Fraction(x) for x in row) for row in rows) for n, rows in GAINS.items()}
    a2, a1, a0 = (
        np.array(at(part, exact, h), dtype=float) for part in (scheme.a2, scheme.a1, scheme.a0)
    )
    inverse = np.linalg.inv(GAINS["M"])
    pull, drag = -inverse @ GAINS["K"], -inverse @ GAINS["C"]
    flow = expm(np.block([[np.zeros((2, 2)), np.eye(2)], [pull, drag]]) * float(h))
    start = np.array([1.0, -1.0, 0.0, 0.5])
    older, x = start[:2], (flow @ start)[:2]
    for _ in range(samples - 1):
        older, x = x, np.linalg.solve(a2, -a1 @ x - a0 @ older)
    end = np.linalg.matrix_power(flow, samples) @ start
    return float(np.abs(x - end[:2]).max())


@pytest.mark.parametrize(
    "points, said",
    [
        (((HALF, ZERO),), "sum to one"),
        (((ONE, Fraction(2)),), "outside"),
        (((ONE, Fraction(-1, 9)),), "outside"),
    ],
)
def test_a_rule_that_is_none_is_refused(
    points: tuple[tuple[Fraction, Fraction], ...], said: str
) -> None:
    with pytest.raises(ValueError, match=said):
        Rule("none", points)


def test_a_rule_without_the_force_has_another_limit() -> None:
    """The limit shows what was put in: without damping there is no C q1."""
    free = discretised(lagrangian, lambda _: Form({}), LEFT)
    q0, q2 = letters("q0 q2")
    assert not (residual(free)[0] - (M * q2 + K * q0)).terms
    assert order(free) == 2
