"""Each claim of the discrete variational estimator holds up on a second road: plain numbers."""

import itertools
import random
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import definite_matrices, rationals
from theory.algebra.noncommuting import letters
from theory.systems.variational.statements.common import discrete_energy, energy
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.systems.variational.claims import DECISIONS
from verification.systems.variational.claims.discrete import REPAIR_RELATIONS
from verification.systems.variational.claims.witnesses import derivation
from verification.verdict import Verdict

GAINS = ("M", "K", "C")
SAID = {
    Verdict.PROVED: {"PROVED"},
    Verdict.CORRECTED: {"PROVED", "REFUTED"},
    Verdict.REFUTED: {"REFUTED"},
}


def arrays(three):
    return {
        n: np.array([[float(x) for x in row] for row in m])
        for n, m in zip(GAINS, three, strict=True)
    }


def one_step(g, h, x, u):
    """(20), assembled from its printed lines."""
    y = x + h * u
    return y, np.linalg.solve(g["M"] + h * g["C"], g["M"] @ u - h * g["K"] @ y)


def value(form, g, h, **vectors):
    """A 1 x 1 form in numbers."""
    known = {**g, **{k: v.reshape(-1, 1) for k, v in vectors.items()}}
    total = 0.0
    for (scalars, word), a in form.terms.items():
        product = np.eye(1)
        for letter in word:
            matrix = known[letter.rstrip("'")]
            product = product @ (matrix.T if letter.endswith("'") else matrix)
        total += float(a) * h ** dict(scalars).get("h", 0) * float(product[0, 0])
    return total


@pytest.mark.parametrize("claim", sorted(DECISIONS))
def test_every_certificate_of_a_decision_is_valid_and_matches_its_verdict(claim):
    decision = DECISIONS[claim]()
    verdicts = {
        check.check_document(document, statements())["verdict"]
        for document in decision.certificates.values()
    }
    assert verdicts == SAID[decision.verdict]
    assert decision.reason


@settings(max_examples=30)
@given(
    st.integers(1, 3).flatmap(lambda n: st.tuples(*[definite_matrices(n)] * 3)),
    rationals(Fraction(1, 20), 5),
    st.randoms(use_true_random=False),
)
def test_the_printed_energy_grows_and_the_repaired_one_falls(three, h, rng):
    g, h = arrays(three), float(h)
    draw = random.Random(rng.random())
    x, u = (np.array([draw.uniform(-1, 1) for _ in g["M"]]) for _ in range(2))
    letter_x, letter_u = letters("x u")
    zero = 0 * u
    y, v = one_step(g, h, x, zero)
    before = value(energy(letter_x, letter_u), g, h, x=x, u=zero)
    assert value(energy(letter_x, letter_u), g, h, x=y, u=v) > before
    y, v = one_step(g, h, x, u)
    form = discrete_energy(letter_x, letter_u)
    fall = value(form, g, h, x=x, u=u) - value(form, g, h, x=y, u=v)
    loss = h / 4 * float((u + v) @ g["C"] @ (u + v))
    size = 1 + abs(value(form, g, h, x=x, u=u)) + loss
    assert fall == pytest.approx(loss, abs=1e-9 * size)


def test_the_replay_table_is_the_orbit_of_the_recursion():
    table = DECISIONS["variational.discrete_energy"]().replay
    states = [(Fraction(row[1]), Fraction(row[2]), Fraction(row[3])) for row in table[1:]]
    h = Fraction(1, 10)
    for (x, u, _), (y, v, level) in itertools.pairwise(states):
        assert y == x + h * u
        assert (1 + h) * v == u - h * y
        assert level == v * v / 2 + y * y / 2
    assert states[1][2] > states[0][2]


@pytest.mark.parametrize("wrong", ["1/4", "-1/3", "-1/4*h"])
def test_a_planted_false_derivation_is_refused(wrong):
    relations = (*REPAIR_RELATIONS[:3], (wrong, "0'", "K*(x + y)"))
    with pytest.raises(CertificateError):
        certificate("variational", "discrete_energy_repair", {}, [derivation((), *relations)] * 3)


def test_a_planted_false_theorem_is_not_proved():
    """Stability without the step limit: Q may not be assumed positive where it is not given."""
    squares = ((("h", "1", "C"),), (("2", "1", "M"), ("h", "1", "C")), (("h**2", "1", "K"),))
    witness = [derivation(entry) for entry in squares]
    for last in (
        derivation((("4", "1", "M"), ("2*h", "1", "C"), ("-h**2", "1", "K"))),
        derivation((("4", "1", "M"), ("2*h", "1", "C"))),
        derivation((("1", "1", "Q"),)),
    ):
        with pytest.raises(CertificateError):
            certificate("variational", "discrete_stability_repair", {}, [*witness, last])


@pytest.mark.parametrize("claim", sorted(DECISIONS))
def test_a_figure_has_finite_numbers_within_its_axes(claim):
    figure = DECISIONS[claim]().figure
    if figure is None:
        return
    for mark in (*figure.curves, *figure.dots):
        for axis, numbers in ((figure.x, mark.x), (figure.y, mark.y)):
            slack = 1e-9 * (axis.high - axis.low)
            assert all(axis.low - slack <= number <= axis.high + slack for number in numbers)
    assert figure.title
    assert figure.finding.endswith(".")
    assert figure.caption.endswith(".")
