"""Put explicit matrices into forms: the second road to every identity between letters."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import sympy as sp

from theory.algebra.noncommuting import Form

NOTHING: Mapping[str, Any] = {}


def substituted(
    form: Form,
    matrices: Mapping[str, sp.Matrix],
    scalars: Mapping[str, Any] = NOTHING,
    size: int = 1,
) -> sp.Matrix:
    """The form's value; the empty word is the identity of the shape of the other words."""
    parts = [
        (a * sp.prod([sp.sympify(scalars[name]) ** power for name, power in powers]), word)
        for (powers, word), a in form.terms.items()
    ]
    products = [(factor, _product(word, matrices)) for factor, word in parts if word]
    shape = products[0][1].shape if products else (size, size)
    total = sp.zeros(*shape)
    for factor, word in parts:
        total += factor * (_product(word, matrices) if word else sp.eye(shape[0]))
    return total.applyfunc(sp.expand)


def _product(word: tuple[str, ...], matrices: Mapping[str, sp.Matrix]) -> sp.Matrix:
    factors = [matrices[x[:-1]].T if x.endswith("'") else matrices[x] for x in word]
    assert all(left.shape[1] == right.shape[0] for left, right in pairwise(factors)), word
    result = factors[0]
    for factor in factors[1:]:
        result = result * factor
    return result


def generic(name: str, n: int = 2) -> sp.Matrix:
    """Symmetric matrix of symbols."""
    return sp.Matrix(n, n, lambda i, j: sp.Symbol(f"{name}_{min(i, j)}{max(i, j)}"))


def vector(name: str, n: int = 2) -> sp.Matrix:
    """Column of symbols."""
    return sp.Matrix([sp.Symbol(f"{name}_{i}") for i in range(n)])
