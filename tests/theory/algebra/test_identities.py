"""A derivation written as algebra leaves behind the terms that prove it."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from theory.algebra.identities import ONE, Identity, Square, Term, Zero, hypotheses, identity
from theory.algebra.noncommuting import Form, letters
from theory.algebra.rewriting import derive, reduce, rules

P, X, Y, S = letters("P X Y S", ("S",))
RELATIONS = (P * P - P, X * P - Y, S * X - X)


def multiplied_out(zero: Zero) -> Form:
    return Identity("", zero.form, RELATIONS, zero.combination).residual


@given(st.data())
def test_every_operation_keeps_the_derivation(data: st.DataObject) -> None:
    known = list(hypotheses(RELATIONS))
    for _ in range(data.draw(st.integers(1, 6))):
        a, b = data.draw(st.sampled_from(known)), data.draw(st.sampled_from(known))
        form = data.draw(st.sampled_from([P, X, Y, S, ONE]))
        made = [a + b, a - b, a.after(form), a.before(form), a.T, a.times(Fraction(2, 3))]
        known.append(data.draw(st.sampled_from(made)))
    assert all(not multiplied_out(zero).terms for zero in known)


def test_an_identity_that_does_not_follow_is_refused() -> None:
    first = hypotheses(RELATIONS)[0]
    with pytest.raises(ValueError, match="leaves"):
        identity("P = 0", P, RELATIONS, first)


def test_a_forged_combination_leaves_something() -> None:
    good = identity("P P = P", P * P - P, RELATIONS, hypotheses(RELATIONS)[0])
    assert good.holds
    for term in (Term(ONE, 1, ONE), Term(2 * ONE, 0, ONE), Term(ONE, 0, ONE, True)):
        assert not Identity(good.name, good.goal, good.relations, (term,)).holds


def test_alike_terms_are_gathered() -> None:
    first = hypotheses(RELATIONS)[0]
    twice = identity("2(P P - P) = 0", 2 * (P * P - P), RELATIONS, first + first)
    assert [str(term.left) for term in twice.combination] == ["2"]
    nothing = identity("0 = 0", P - P, RELATIONS, first - first)
    assert nothing.combination == ()


def test_squares_make_an_inequality() -> None:
    square = Square(2 * ONE, X, S)
    made = identity("2 X'SX >= 0", 2 * (X.T * S * X), RELATIONS, hypotheses(RELATIONS)[0].times(0),
                    [square])  # fmt: skip
    assert made.predicate == "2*T(X)*S*X >= 0"
    assert made.to_data() == {"squares": [["2", "X", "S"]], "relations": []}


def test_words_are_replaced_until_none_is_left() -> None:
    made = derive("P P P = P", P * P * P - P, RELATIONS, {0: "P P"})
    assert made.holds
    assert made.predicate == "-P + P*P*P == 0"
    transposed = derive("X'S = X'", X.T * S - X.T, RELATIONS, {2: "S X"})
    assert all(term.transposed for term in transposed.combination)


def test_what_is_taken_away_and_what_is_left_are_the_whole() -> None:
    taken, rest = reduce(X * P * P + S, RELATIONS, rules(RELATIONS, {0: "P P", 1: "X P"}))
    assert not (taken.form + rest - X * P * P - S).terms
    assert not multiplied_out(taken).terms
    assert str(rest) == "S + Y"


def test_a_word_that_is_not_there_and_an_endless_chain_are_refused() -> None:
    with pytest.raises(ValueError, match="does not occur"):
        rules(RELATIONS, {0: "X Y"})
    growing = (P - P * P,)
    with pytest.raises(ValueError, match="go on"):
        reduce(P, growing, rules(growing, {0: "P"})[:1])
