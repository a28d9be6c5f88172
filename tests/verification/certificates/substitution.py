"""Expressions of the checker's language, evaluated by numpy for random exact matrices."""

import ast
from fractions import Fraction

import numpy as np

LETTERS = {
    "A": "matrix: n",
    "B": "matrix: n m",
    "S": "symmetric: n",
    "P": "positive definite: n",
    "Q": "positive semidefinite: n",
    "x": "vector: n",
    "y": "vector: n",
    "g": "positive",
    "j": "nonnegative",
    "a": "real",
}
"""Symbols for statements made up in tests."""


SIZES = {
    "1": 1,
    "2": 2,
    "n": 3,
    "m": 4,
    "d": 5,
    "k": 6,
    "l": 2,
    "N": 5,
    "N1": 2,
    "N2": 6,
    "K": 3,
    "M": 4,
}


def values(symbols, seed):
    """Random integer matrices and scalars of the declared kinds, as exact arrays."""
    random = np.random.default_rng(seed)
    drawn = {}
    for letter, kind in symbols.items():
        name, _, size = kind.partition(": ")
        if not size:
            low = {"positive": 1, "nonnegative": 0}.get(name, -4)
            drawn[letter] = Fraction(int(random.integers(low, 5)))
            continue
        rows, columns = (size.split() + ["1" if name == "vector" else size] * 2)[:2]
        entries = random.integers(-4, 5, (SIZES[rows], SIZES[columns]))
        if name not in ("matrix", "vector"):
            entries = entries @ entries.T + (name == "positive definite") * np.eye(
                len(entries), dtype=int
            )
        drawn[letter] = np.vectorize(Fraction, otypes=[object])(entries)
    return drawn


def evaluated(text, drawn):
    """Value of an expression; a number beside a square matrix stands for its multiple of I."""
    return _value(ast.parse(text, mode="eval").body, drawn)


def _value(node, drawn):
    if isinstance(node, ast.Constant):
        return Fraction(node.value)
    if isinstance(node, ast.Name):
        return drawn[node.id]
    if isinstance(node, ast.UnaryOp):
        return -_value(node.operand, drawn)
    if isinstance(node, ast.Call):
        inner = _value(node.args[0], drawn)
        return inner if isinstance(inner, Fraction) else inner.T
    left, right = _value(node.left, drawn), _value(node.right, drawn)
    if isinstance(node.op, ast.Pow):
        return power(left, int(right))
    if isinstance(node.op, ast.Div):
        return left / right
    if isinstance(node.op, ast.Mult):
        return times(left, right)
    return plus(left, right if isinstance(node.op, ast.Add) else times(Fraction(-1), right))


def power(base, exponent):
    return base if exponent == 1 else times(base, power(base, exponent - 1))


def times(a, b):
    return a * b if Fraction in (type(a), type(b)) else a @ b


def plus(a, b):
    if type(a) is type(b):
        assert type(a) is Fraction or a.shape == b.shape
        return a + b
    number, rows = (a, b) if isinstance(a, Fraction) else (b, a)
    if number == 0:
        return rows
    assert rows.shape[0] == rows.shape[1]
    return rows + number * np.eye(len(rows), dtype=int)


def total(item, given_, drawn):
    """What the derivation adds up to."""
    parts = []
    for factor, inner, p in item["squares"]:
        x = evaluated(inner, drawn)
        flipped = x if isinstance(x, Fraction) else x.T
        parts.append(times(evaluated(factor, drawn), times(flipped, times(evaluated(p, drawn), x))))
    for left, k, right in item["relations"]:
        relation = evaluated(given_[int(k.rstrip("'"))], drawn)
        relation = relation.T if "'" in k and not isinstance(relation, Fraction) else relation
        parts.append(times(evaluated(left, drawn), times(relation, evaluated(right, drawn))))
    if not parts:
        return Fraction(0)
    value = parts[0]
    for part in parts[1:]:
        value = plus(value, part)
    return value


def goals(show):
    """The expressions that derivations of these predicates have to produce."""
    for text in show:
        node = ast.parse(text, mode="eval").body
        if isinstance(node, ast.Compare):
            yield f"{ast.unparse(node.left)} - ({ast.unparse(node.comparators[0])})"
        elif node.func.id == "pd":
            yield ast.unparse(node.args[0])
        else:
            a2, a1, a0 = map(ast.unparse, node.args)
            yield from (f"{a2} - ({a0})", f"{a2} + ({a0})")
            yield from (f"{a2} + ({a1}) + ({a0})", f"{a2} - ({a1}) + ({a0})")
