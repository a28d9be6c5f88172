"""The bounds of Theorem 1 as polynomials in letters: 1/beta is 2 half, 1/alpha is rate."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from ...algebra.identities import ONE
from ...algebra.noncommuting import Form, scalars
from ...algebra.rewriting import reduce, rules
from ...expressions import Tree
from .bounds import Bound

HALF = Fraction(1, 2)
alpha, beta, delta, mu, M, d = scalars("alpha beta delta mu M d")
root_d, half, rate = scalars("root_d half rate")
c2, c3, c4, c_v2 = scalars("c2 c3 c4 c_v2")
ROOT = root_d * root_d - d
HALVED = 2 * half * beta - ONE
ROOT_WORD, HALVED_WORD = "root_d**2", "beta half"


def without_root(form: Form) -> Form:
    """The form with d for the square of root_d."""
    _, left = reduce(form, (ROOT,), rules((ROOT,), {0: ROOT_WORD}))
    return left


def polynomial(tree: Tree, values: Mapping[str, Form]) -> Form:
    """A formula of `bounds` in letters: 1/beta is 2 half, 1/alpha is rate.

    Raises
    ------
    ValueError
        It divides by something else.
    """
    match tree:
        case ("number", value):
            return ONE * int(value)
        case ("name", name):
            return values[name]
        case ("power", base, exponent):
            product = ONE
            for _ in range(exponent):
                product = product * polynomial(base, values)
            return product
        case ("+" | "-" | "*" | "/" as sign, left, right):
            first, second = polynomial(left, values), polynomial(right, values)
            if sign == "/":
                return first * _reciprocal(second)
            return first * second if sign == "*" else first + (second if sign == "+" else -second)
    raise ValueError(f"{tree[0]} is no arithmetic of scalars")


def _reciprocal(form: Form) -> Form:
    ((powers, word), a), *more = form.terms.items()
    known = {"beta": 2 * half, "alpha": rate}
    if more or word or not {name for name, _ in powers} <= {*known}:
        raise ValueError(f"1/({form}): a power of beta or alpha is needed")
    product = ONE * (1 / a)
    for name, power in powers:
        for _ in range(power):
            product = product * known[name]
    return product


def constants(bound: Bound, values: Mapping[str, Form]) -> dict[str, Form]:
    """gamma, m, b, l and what stands between them, as polynomials."""
    found = dict(values)
    for line in (*bound.limit[:1], *bound.lines):
        found[line.name] = polynomial(line.tree, found)
    return found


LETTERS: dict[str, Form] = {
    "alpha": alpha, "beta": beta, "delta": delta, "mu": mu, "M": M, "d": d, "root_d": root_d,
    "c2": c2, "c3": c3, "c4": c4, "c_v2": c_v2, "k": ONE, "root_k": ONE,
}  # fmt: skip
