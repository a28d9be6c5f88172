"""Signs, directions and quotients that have a value for every data: selects instead of branches."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .scalars import Expr, Matrix, Pool

FARTHEST = 2**100
"""A solution of this size or more counts as none, in single precision as in double."""


@dataclass(frozen=True)
class Guarded:
    """The solution of two equations, or zeros.

    Parameters
    ----------
    parts : mapping of str to Expr
        Steps on the way, in order, by the end of their name.
    known : Expr
        1 if there is a solution, else 0.
    values : Matrix
        A column.
    """

    parts: Mapping[str, Expr]
    known: Expr
    values: Matrix


def signs(pool: Pool, a: Matrix, b: Matrix) -> Matrix:
    """The sign of a - b, entry by entry, from comparisons: nothing is rounded."""
    return tuple((pool.call("sgn", x, y),) for (x,), (y,) in zip(a, b, strict=True))


def direction(pool: Pool, column: Matrix) -> Matrix:
    """A vector over its length; 0 for the vector 0 and for one that is not known.

    The largest entry is divided out first, so that squares neither overflow nor vanish.
    """
    zero, one = pool.const(0), pool.const(1)
    sizes = [pool.call("select", x, zero, x, pool.sub(zero, x)) for (x,) in column]
    most = sizes[0]
    for size in sizes[1:]:
        most = pool.call("select", size, most, size, most)
    safe = pool.call("select", most, zero, most, one)
    parts = [pool.div(x, safe) for (x,) in column]
    total = zero
    for part in parts:
        total = pool.add(total, pool.mul(part, part))
    length = pool.call("sqrt", pool.call("select", total, one, total, one))
    ratios = [pool.div(part, length) for part in parts]
    known = zero
    for ratio in ratios:
        known = pool.add(known, ratio)
    least = pool.const(-len(ratios) - 1)
    return tuple((pool.call("select", known, least, ratio, zero),) for ratio in ratios)


def guarded(pool: Pool, a: Matrix, b: Matrix, bound: Expr) -> Guarded:
    """Solve A x = b for symmetric A of two rows where det A is above a bound, else 0."""
    zero, one, most = pool.const(0), pool.const(1), pool.const(FARTHEST)
    det = pool.sub(pool.mul(a[0][0], a[1][1]), pool.mul(a[0][1], a[0][1]))
    safe = pool.call("select", det, bound, det, one)
    raw = [
        pool.div(pool.sub(pool.mul(a[1][1], b[0][0]), pool.mul(a[0][1], b[1][0])), safe),
        pool.div(pool.sub(pool.mul(a[0][0], b[1][0]), pool.mul(a[0][1], b[0][0])), safe),
    ]
    known = one
    for value in reversed(raw):
        below = pool.call("select", most, value, known, zero)
        known = pool.call("select", value, pool.const(-FARTHEST), below, zero)
    known = pool.call("select", det, bound, known, zero)
    parts = {"det": det, "safe": safe, "raw0": raw[0], "raw1": raw[1], "known": known}
    values = tuple((pool.call("select", known, zero, value, zero),) for value in raw)
    return Guarded(parts, known, values)
