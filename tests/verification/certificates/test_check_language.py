"""The language of expressions: what it multiplies out, and what it refuses."""

import pytest

from .documents import accepts, document, judged, statement
from .samples import derivation
from .substitution import LETTERS


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


@pytest.mark.parametrize(
    "show, holds",
    [
        ("trace(A) == 5", True),
        ("trace(A) == 10", False),
        ("diag(A) - A == 0", False),
        ("diag(x) - diag(A)*diag(A)/4*diag(x) == 0", False),
        ("T(x)*diag(x)*x == 1 + 8", True),
        ("diag(diag(A)) == diag(A)", True),
        ("trace(diag(x)) == 3", True),
        ("trace(T(x)) == 3", False),
        ("diag(T(x)) == 0", False),
        ("trace(A*T(A)) - trace(T(A)*A) == 0", True),
    ],
)
def test_diagonals_and_traces(show, holds):
    data = {"A": [[1, 2], [3, 4]], "x": [[1], [2]]}
    assert accepts([show], [], data, dict.fromkeys(data, "matrix")) == holds


@pytest.mark.parametrize("word", ["trace", "diag"])
def test_diagonals_of_letters_are_refused(word):
    assert not accepts([f"{word}(S) - {word}(S) == 0"], [derivation()], symbols=LETTERS)


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
