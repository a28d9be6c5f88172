"""Universal statements: sums of squares modulo hypotheses, for matrices of every size."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from .documents import accepts
from .samples import derivation, samples
from .substitution import LETTERS, evaluated, goals, plus, times, total, values

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
