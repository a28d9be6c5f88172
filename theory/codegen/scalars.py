"""Scalar expressions without repetition, and matrices of them.

Equal expressions are one object, so that common parts show by themselves. Constants are exact and
folded exactly; a product with zero or a sum with zero is dropped, which keeps sparsity. Nothing is
reordered: the order of summation is that of the formula, in every language that is printed.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

ZERO, ONE = Fraction(0), Fraction(1)
FUNCTIONS = ("sin", "cos", "sqrt", "sgn", "select")
"""``sgn(a, b)`` is (a > b) - (a < b), so 0 if a number is unknown; ``select(a, b, x, y)`` is x if
a > b, else y. Both sides of a select are computed, so neither may divide by zero."""
LIBM = ("sin", "cos")
"""Those whose last bit depends on the library; a square root is rounded alike everywhere."""


@dataclass(frozen=True, eq=False)
class Expr:
    """One scalar: ``op`` is ``name``, ``const``, one of ``+ - * /`` or one of `FUNCTIONS`."""

    op: str
    args: tuple[Expr, ...] = ()
    name: str = ""
    value: Fraction = ZERO

    @property
    def constant(self) -> bool:
        """Whether its value is known now."""
        return self.op == "const"

    @property
    def leaf(self) -> bool:
        """Whether it is a name or a number."""
        return not self.args


@dataclass
class Pool:
    """Makes expressions, each only once."""

    known: dict[tuple[object, ...], Expr] = field(default_factory=dict)

    def name(self, name: str) -> Expr:
        """A value that is known at run time."""
        return self.known.setdefault(("name", name), Expr("name", name=name))

    def const(self, value: Fraction | int) -> Expr:
        """An exact number."""
        exact = Fraction(value)
        return self.known.setdefault(("const", exact), Expr("const", value=exact))

    def add(self, a: Expr, b: Expr) -> Expr:
        """a + b."""
        if a.constant and b.constant:
            return self.const(a.value + b.value)
        if a.constant and a.value == ZERO:
            return b
        return a if b.constant and b.value == ZERO else self._made("+", a, b)

    def sub(self, a: Expr, b: Expr) -> Expr:
        """a - b."""
        if a.constant and b.constant:
            return self.const(a.value - b.value)
        return a if b.constant and b.value == ZERO else self._made("-", a, b)

    def mul(self, a: Expr, b: Expr) -> Expr:
        """a b."""
        if a.constant and b.constant:
            return self.const(a.value * b.value)
        for one, other in ((a, b), (b, a)):
            if one.constant and one.value in (ZERO, ONE):
                return other if one.value == ONE else one
        if a.constant and b.op == "*" and b.args[0].constant:
            # CasADi folds such constants too, rounded twice; here the product is exact
            return self.mul(self.const(a.value * b.args[0].value), b.args[1])
        return self._made("*", a, b)

    def div(self, a: Expr, b: Expr) -> Expr:
        """a / b; b is not the number zero."""
        if a.constant and b.constant:
            return self.const(a.value / b.value)
        if a.constant and a.value == ZERO:
            return a
        return a if b.constant and b.value == ONE else self._made("/", a, b)

    def call(self, op: str, *args: Expr) -> Expr:
        """One of `FUNCTIONS` of some scalars."""
        return self._made(op, *args)

    def _made(self, op: str, *args: Expr) -> Expr:
        return self.known.setdefault((op, *map(id, args)), Expr(op, args))


Matrix = tuple[tuple[Expr, ...], ...]
"""Rows of scalars; a vector has one column."""


@dataclass
class Algebra:
    """Matrix arithmetic on scalars of one pool; 1 by 1 matrices are scalars."""

    pool: Pool

    def add(self, a: Matrix, b: Matrix) -> Matrix:
        """a + b, entry by entry."""
        return _entrywise(self.pool.add, a, b)

    def sub(self, a: Matrix, b: Matrix) -> Matrix:
        """a - b, entry by entry."""
        return _entrywise(self.pool.sub, a, b)

    def mul(self, a: Matrix, b: Matrix) -> Matrix:
        """Matrix product, or a scalar times a matrix; sums run over growing indices."""
        for one, other in ((a, b), (b, a)):
            if len(one) == len(one[0]) == 1:
                return tuple(tuple(self.pool.mul(one[0][0], x) for x in row) for row in other)
        return tuple(tuple(self._dot(row, column) for column in zip(*b, strict=True)) for row in a)

    def div(self, a: Matrix, b: Matrix) -> Matrix:
        """A matrix over a scalar."""
        return tuple(tuple(self.pool.div(x, b[0][0]) for x in row) for row in a)

    def power(self, a: Matrix, exponent: int) -> Matrix:
        """A scalar multiplied by itself."""
        total = a
        for _ in range(exponent - 1):
            total = self.mul(total, a)
        return total

    def transpose(self, a: Matrix) -> Matrix:
        """Rows become columns."""
        return tuple(zip(*a, strict=True))

    def _dot(self, row: tuple[Expr, ...], column: tuple[Expr, ...]) -> Expr:
        total = self.pool.mul(row[0], column[0])
        for a, b in zip(row[1:], column[1:], strict=True):
            total = self.pool.add(total, self.pool.mul(a, b))
        return total


def _entrywise(operation: object, a: Matrix, b: Matrix) -> Matrix:
    assert callable(operation)
    return tuple(
        tuple(operation(x, y) for x, y in zip(left, right, strict=True))
        for left, right in zip(a, b, strict=True)
    )
