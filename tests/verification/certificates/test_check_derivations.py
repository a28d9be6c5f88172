"""Universal statements: sums of squares modulo hypotheses, for matrices of every size."""

import ast
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from .documents import accepts, document, judged, statement
from .samples import derivation, samples

SIZES = {"n": 3, "m": 4, "1": 1}
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


UNIVERSAL = sorted(key for key, made in samples().items() if not made["inputs"])


@pytest.mark.parametrize("key", UNIVERSAL)
@pytest.mark.parametrize("seed", range(3))
def test_accepted_derivations_hold_for_random_matrices(key, seed, samples, known):
    """They are identities, so that no hypothesis needs to hold for the matrices drawn."""
    made = samples[key]
    entry = known[f"{made['system']}.{made['name']}"]
    drawn = values(entry["symbols"], seed)
    shown = list(goals(entry["cases"][made["case"]]["show"]))
    for goal, item in zip(shown, made["witness"], strict=True):
        left = plus(evaluated(goal, drawn), times(Fraction(-1), total(item, entry["given"], drawn)))
        assert not np.any(left), goal


INNER = ["x", "A*x", "x + 2*y", "S*y - a*x", "x*T(y)*x", "j*y"]
FACTORS = ["1", "g", "2*g*j", "g + 1/3*j**2", "5/2"]


@given(
    st.lists(
        st.tuples(st.sampled_from(FACTORS), st.sampled_from(INNER), st.sampled_from("PQ1")),
        min_size=1,
        max_size=3,
    ),
    st.sampled_from(["x", "y", "A*y", "S*x"]),
    st.fractions(-2, 2, max_denominator=5),
)
def test_a_sum_of_squares_and_multiples_of_hypotheses_is_accepted(squares, right, c):
    """The goal is written out from its summands; any other goal is refused."""
    summands = [f"({f})*T({x})*{p}*({x})" for f, x, p in squares]
    goal = " + ".join([*summands, f"T(y)*({c})*(A*x - g*y)*T(y)*({right})"])
    witness = derivation(squares, [(f"({c})*T(y)", "0", f"T(y)*({right})")])
    given_ = ["A*x - g*y"]
    assert accepts([f"{goal} >= 0"], [witness], symbols=LETTERS, given=given_)
    assert not accepts([f"{goal} + T(x)*x >= 0"], [witness], symbols=LETTERS, given=given_)
    assert not accepts([f"{goal} == 0"], [witness], symbols=LETTERS, given=given_)
    assert not accepts([f"pd({goal})"], [witness], symbols=LETTERS, given=given_)
    if c:
        assert not accepts([f"{goal} >= 0"], [witness], symbols=LETTERS, given=["A*x - g*x"])


@pytest.mark.parametrize(
    "square",
    [
        ("-1", "x", "P"),  # a negative factor
        ("g - j", "x", "P"),
        ("a", "x", "P"),  # of unknown sign
        ("a**2", "x", "P"),  # squares of factors are not looked at
        ("1", "x", "S"),  # may be indefinite
        ("1", "x", "A"),
        ("1", "x", "-P"),
        ("1", "x", "P - Q"),
        ("1", "x", "g"),
        ("1", "x", "positive definite"),
        ("1", "x", ["P"]),
        ("1", "x", "_0"),
        ("1", "x", ""),
        ("T(x)*x", "y", "P"),  # a factor is a polynomial of scalars
        ("S", "x", "P"),
        ("1", "T(x)", "P"),  # does not fit
        ("1", "B", "B"),
        ("1", "z", "P"),
        ("1", "__class__", "P"),
        ("1", "x.T", "P"),
        ("1", "T(x", "P"),
        ("1", "x", "P", "1"),
        ("1", "x"),
    ],
)
def test_squares_that_may_be_negative_are_refused(square):
    good = derivation([("1", "x", "P")])
    assert accepts(["T(x)*P*x >= 0"], [good], symbols=LETTERS)
    bad = {"kind": "derivation", "squares": [list(square)], "relations": []}
    for goal in ("T(x)*P*x", "-T(x)*P*x", "(g - j)*T(x)*P*x", "a*T(x)*P*x", "T(x)*S*x", "T(x)*A*x"):
        assert not accepts([f"{goal} >= 0"], [bad], symbols=LETTERS)


@pytest.mark.parametrize(
    "relation",
    [
        ("1", "1", "1"),
        ("1", "-1", "1"),
        ("1", "00", "1"),
        ("1", "0 ", "1"),
        ("1", " 0", "1"),
        ("1", "+0", "1"),
        ("1", "0.0", "1"),
        ("1", "", "1"),
        ("1", "'", "1"),
        ("1", "_0", "1"),
        ("1", "zero", "1"),
        ("1", 0, "1"),
        ("1", None, "1"),
        ("1", "1/2", "1"),
        ("1", "10" * 3000, "1"),
        (1, "0", "1"),
        ("T(x)", "0", "1"),  # sizes do not fit
        ("1", "0", "x"),
        ("1", "0", "y"),
        ("2", "0", "1"),  # another multiple
        ("1", "0'", "1"),
        ("1", "0"),
    ],
)
def test_relations_that_do_not_give_the_goal_are_refused(relation):
    symbols, given_ = {"A": "matrix: n", "x": "vector: n", "y": "vector: n"}, ["A*x - y"]
    goal = ["A*x - y == 0"]
    assert accepts(goal, [derivation([], [("1", "0", "1")])], symbols=symbols, given=given_)
    bad = {"kind": "derivation", "squares": [], "relations": [list(relation)]}
    assert not accepts(goal, [bad], symbols=symbols, given=given_)


@pytest.mark.parametrize(
    "goal, squares, holds",
    [
        ("P", [("1", "1", "P")], True),
        ("g*P", [("g", "1", "P")], True),
        ("P + Q", [("1", "1", "P"), ("1", "1", "Q")], True),
        ("Q", [("1", "1", "Q")], False),  # semidefinite only
        ("j*P", [("j", "1", "P")], False),  # j may be 0
        ("0*P", [("0", "1", "P")], False),
        ("0*P", [], False),
        ("T(A)*P*A", [("1", "A", "P")], False),  # A may be singular
        ("T(A)*P*A + P", [("1", "A", "P"), ("1", "1", "P")], True),
        ("A*T(A)", [("1", "T(A)", "1")], False),
        ("-P", [("-1", "1", "P")], False),
        ("S", [("1", "1", "S")], False),
    ],
)
def test_definite_for_all_sizes(goal, squares, holds):
    assert accepts([f"pd({goal})"], [derivation(squares)], symbols=LETTERS) == holds


@pytest.mark.parametrize(
    "goal, holds",
    [
        ("A*B - A*B", True),
        ("T(A*B) - T(B)*T(A)", True),
        ("T(S) - S", True),
        ("T(T(B)) - B", True),
        ("T(A) - A", False),
        ("A*S - S*A", False),
        ("g*A - A*g", True),
        ("(A + S)**2 - A**2 - A*S - S*A - S**2", True),
        ("(A + S)**2 - A**2 - 2*A*S - S**2", False),
        ("T(x)*S*y - T(y)*S*x", False),  # equal as numbers, yet not as words
        ("A*B*A", False),
        ("B*A - B*A", False),
        ("A/2 - 1/2*A", True),
        ("A/g - A/g", False),
        ("A**0", False),
        ("A**5 - A**5", False),
        ("A**-1 - A**-1", False),
        ("(g + j)**3 - g**3 - 3*g**2*j - 3*g*j**2 - j**3", True),
    ],
)
def test_identities_need_no_witness_beyond_multiplying_out(goal, holds):
    assert accepts([f"{goal} == 0"], [derivation()], symbols=LETTERS) == holds


@pytest.mark.parametrize("order", ["<", ">", "<=", "!=", "is", "in"])
def test_other_comparisons_are_not_settled_by_derivations(order):
    assert not accepts([f"T(x)*P*x {order} 0"], [derivation([("1", "x", "P")])], symbols=LETTERS)


@pytest.mark.parametrize(
    "show, witness",
    [
        ("dips(S)", {"kind": "vector", "x": [1]}),
        ("unstable(P, S, P)", derivation([("1", "1", "P")])),
        ("forall(h, 0, 1, pd(h*P))", derivation([("h", "1", "P")])),
    ],
)
def test_predicates_about_data_are_refused_for_letters(show, witness):
    items = [witness, {"kind": "vector", "x": [1]}]
    assert not accepts([show], items[:1], symbols=LETTERS)
    assert not accepts([show], items, symbols=LETTERS)


BOMBS = [
    "((((9**4)**4)**4)**4)**4**4",
    "(((((((((((9**4)**4)**4)**4)**4)**4)**4)**4)**4)**4)**4)**4",
    "(" * 40 + "g + j + a" + ")**4" * 40,
    "((((T(x)*S*x + T(y)*S*y + T(x)*S*y)**4)**4)**4)**4",
    "+".join(["x"] * 9000),
    "-" * 15000 + "x",
    "(" * 5000 + "x" + ")" * 5000,
    "T(" * 150 + "x" + ")" * 150,
    "x" * 30000,
    "1" * 5000,
    "*".join(["(A + S + P + Q)"] * 900),
    "0x" + "f" * 19000,
    "\x00",
    "x\ny",
    "(x := 1)",
    "[x for x in A]",
    "lambda: x",
    "print(1)",
    "__import__('os')",
    "1.5*x",
    "True*x",
    "'x'",
    "x if 1 else y",
    "x @ y",
    "x // 2",
    "A[0]",
    "\ud800",
    "laplacian(x)",
    "eye(A)",
    "T()",
    "T(x, y)",
    "T(*x)",
    "x/0",
    "1/x",
    "1/(g - g)",
]


@pytest.mark.parametrize("text", BOMBS, ids=range(len(BOMBS)))
def test_hostile_expressions_are_refused_quickly(text, tmp_path):
    for item in (
        derivation([(text, "x", "P")]),
        derivation([("1", text, "P")]),
        derivation([("1", "x", text)]),
        derivation([], [(text, "0", "1")]),
        derivation([], [("1", text, "1")]),
    ):
        entry = statement(["A*y == 0"], symbols=LETTERS, given=["x - y"])
        made = document(entry, {}, [item])
        verdict, status = judged(made, tmp_path / "it.json", {"test.it": entry})
        assert status == 1, verdict["reason"]
        assert not verdict["valid"]
        assert verdict["reason"].isprintable()
