"""Laws become scalar lines: in order, without repetition, exact where data are known."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from theory.codegen.lower import entries
from theory.codegen.printing import source_of
from theory.codegen.python import python
from theory.codegen.scalars import Algebra, Pool
from theory.codegen.stepper import Slot
from theory.systems.variational.stepper import STEPPER


def test_equal_expressions_are_one_object():
    pool = Pool()
    a, b = pool.name("a"), pool.name("b")
    assert pool.add(pool.mul(a, b), a) is pool.add(pool.mul(a, b), a)
    assert pool.mul(a, b) is not pool.mul(b, a)


def test_numbers_fold_exactly_and_zero_and_one_disappear():
    pool = Pool()
    a, third = pool.name("a"), pool.const(Fraction(1, 3))
    assert pool.add(third, pool.add(third, third)).value == 1
    assert pool.mul(pool.const(0), a).value == 0
    assert pool.mul(a, pool.const(1)) is a
    assert pool.add(pool.const(0), a) is a
    assert pool.div(a, pool.const(1)) is a


@given(st.lists(st.fractions(-3, 3, max_denominator=9), min_size=8, max_size=8))
def test_matrix_arithmetic_on_numbers_is_exact(numbers):
    pool = Pool()
    algebra = Algebra(pool)
    a, b = (
        tuple(tuple(pool.const(x) for x in numbers[k + i : k + i + 2]) for i in (0, 2))
        for k in (0, 4)
    )
    product = algebra.mul(a, b)
    x, y = numbers[:4], numbers[4:]
    assert product[0][1].value == x[0] * y[1] + x[1] * y[3]
    assert algebra.transpose(product)[1][0] is product[0][1]


def test_a_symmetric_matrix_is_kept_as_a_triangle():
    assert entries(Slot("M", ("n", "n"), "kg", "gain"), 2) == ["M_00", "M_01", "M_11"]
    assert entries(Slot("h", (), "s", "step"), 2) == ["h"]


def test_no_line_is_computed_twice_and_each_is_used():
    for function in source_of(STEPPER).functions:
        texts = [id(line.expr) for line in function.lines]
        assert len({*texts}) == len(texts)
        names = [line.name for line in function.lines]
        assert len({*names}) == len(names)


def test_known_gains_leave_fewer_operations_and_exact_constants():
    gains = {n: [[Fraction(i == j) for j in range(3)] for i in range(3)] for n in "MKC"}
    free, fixed = source_of(STEPPER), source_of(STEPPER, given={**gains, "h": [[Fraction(1, 3)]]})
    assert fixed.operations["step"] < free.operations["step"] / 2
    assert fixed.layout("context") == ()
    assert fixed.digest != free.digest
    assert repr(float(Fraction(4, 3))) in python(fixed)


@pytest.mark.parametrize("n", [1, 2, 5])
def test_any_number_of_coordinates_is_lowered(n):
    source = source_of(STEPPER, n)
    assert len(source.layout("state")) == 3 * n
    space = {}
    exec(python(source), space)
    gains = [float(i == j) for _ in range(3) for i in range(n) for j in range(i, n)]
    state = space["step"]([*gains, 0.5], [1.0] * 3 * n, [0.0] * 2 * n)
    assert state[: 2 * n] == pytest.approx([1.5] * n + [(1 - 0.75) / 1.5] * n)
