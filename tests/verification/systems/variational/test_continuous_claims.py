"""The claims about the continuous estimator on a second road: plain numbers, python-control."""

import copy
import math
from fractions import Fraction

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.linalg import eigh, expm

from tests.strategies import definite_matrices, rationals
from theory.systems.variational.claims.continuous import CLAIMS
from verification.certificates import check
from verification.certificates.make import CertificateError, statements
from verification.systems.variational.claims.best_damping import planar_gains, planar_instance
from verification.systems.variational.claims.continuous import DECISIONS
from verification.systems.variational.energies import energies, energies_over_time, state
from verification.verdict import Verdict

SIZES = st.integers(1, 3)
TWO = planar_gains(Fraction(1), Fraction(2))


def array(rows):
    return np.array([[float(entry) for entry in row] for row in rows])


def drift(m, k, c):
    """The matrix of (12) for (x, u)."""
    n = len(m)
    inverse = np.linalg.inv(m)
    return np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ k, -inverse @ c]])


def energy(m, k, cross=0.0):
    """The matrix of E + cross x'Mu."""
    return np.block([[k, cross * m], [cross * m, m]]) / 2


@st.composite
def gains(draw):
    """M, K symmetric positive definite and a C with C + C' positive definite, not symmetric."""
    n = draw(SIZES)
    m, k, c = (array(draw(definite_matrices(n))) for _ in range(3))
    skew = np.array([[float(draw(rationals(-3, 3, 4))) for _ in range(n)] for _ in range(n)])
    return m, k, c + skew - skew.T


def largest(m, k, c, strength, rate):
    """The largest a with (C + C')/2 - a (strength M + rate C'K^-1 C) >= 0."""
    load = strength * m + rate * c.T @ np.linalg.solve(k, c)
    return float(eigh((c + c.T) / 2, (load + load.T) / 2, eigvals_only=True)[0])


def test_each_claim_has_one_decision_and_the_verdict_that_the_certificates_say():
    assert {*DECISIONS} == {claim.id for claim in CLAIMS}
    found = {claim.rpartition(".")[2]: decide().verdict for claim, decide in DECISIONS.items()}
    assert found == {
        "prop_3_1": Verdict.PROVED,
        "eq_15_dissipation": Verdict.PROVED,
        "theorem_3_2_stability": Verdict.PROVED,
        "theorem_3_2_citation": Verdict.CORRECTED,
    }


@settings(max_examples=25, deadline=None)
@given(gains())
def test_the_energy_has_the_printed_rate_for_any_damping(three):
    m, k, c = three
    a, e = drift(m, k, c), energy(m, k)
    rate = a.T @ e + e @ a
    n = len(m)
    expected = np.zeros((2 * n, 2 * n))
    expected[n:, n:] = -(c + c.T) / 2
    assert rate == pytest.approx(expected, abs=1e-9 * (1 + np.abs(rate).max()))


@settings(max_examples=25, deadline=None)
@given(gains(), st.integers(0, 2**31))
def test_the_strict_function_bounds_every_run(three, seed):
    """V(t) <= exp(-2at) V(0) on the flow of (12), for half of the largest admissible a."""
    m, k, c = three
    a = largest(m, k, c, 6, 2) / 2
    assert a > 0
    matrix, form = drift(m, k, c), energy(m, k, 4 * a)
    assert np.linalg.eigvalsh(form)[0] > 0
    start = np.random.default_rng(seed).normal(size=len(matrix))
    for t in (0.1, 1.0, 5.0):
        now = expm(matrix * t) @ start
        bound = math.exp(-2 * a * t) * (start @ form @ start)
        assert now @ form @ now <= bound * (1 + 1e-9)


@settings(max_examples=25, deadline=None)
@given(gains())
def test_python_control_finds_the_poles_where_the_rate_puts_them(three):
    m, k, c = three
    matrix = drift(m, k, c)
    n = len(matrix)
    poles = control.ss(matrix, np.eye(n), np.eye(n), np.zeros((n, n))).poles()
    a = largest(m, k, c, 6, 2)
    assert max(poles.real) <= -a * (1 - 1e-6)
    gramian = control.lyap(matrix.T, np.eye(n))
    assert np.linalg.eigvalsh((gramian + gramian.T) / 2)[0] > 0


@settings(max_examples=25, deadline=None)
@given(gains(), rationals(Fraction(1, 10), Fraction(19, 10), 20))
def test_the_condition_of_the_strict_function_is_sharp(three, part):
    """V' is negative definite exactly below the largest e, and V is positive there."""
    assume(part != 1)
    m, k, c = three
    e = float(part) * largest(m, k, c, 1, 0.25)
    matrix, form = drift(m, k, c), energy(m, k, e)
    worst = np.linalg.eigvalsh(matrix.T @ form + form @ matrix)[-1]
    assert (worst < 0) == (part < 1)
    assert part > 1 or np.linalg.eigvalsh(form)[0] > 0


@settings(max_examples=25, deadline=None)
@given(
    SIZES.flatmap(lambda n: st.tuples(*[definite_matrices(n)] * 2)), rationals(Fraction(1, 9), 1)
)
def test_damping_in_proportion_to_the_mass_has_one_rate(two, part):
    m, k = map(array, two)
    g = float(part) * 0.99 * math.sqrt(eigh(k, m, eigvals_only=True)[0])
    matrix, form = drift(m, k, 2 * g * m), energy(m, k, g)
    rate = matrix.T @ form + form @ matrix
    assert rate == pytest.approx(-2 * g * form, abs=1e-9 * (1 + np.abs(rate).max()))
    assert np.linalg.eigvals(matrix).real == pytest.approx(-g, abs=1e-6 * (1 + g))


@settings(max_examples=25, deadline=None)
@given(gains())
def test_no_damping_is_faster_than_the_ceiling(three):
    m, k, c = three
    ceiling = (np.linalg.det(k) / np.linalg.det(m)) ** (1 / (2 * len(m)))
    assert max(np.linalg.eigvals(drift(m, k, c)).real) >= -ceiling * (1 + 1e-6)


@settings(max_examples=15, deadline=None)
@given(rationals(Fraction(1, 3), 3, 6), rationals(Fraction(1, 3), 3, 6))
def test_the_planar_damping_reaches_the_ceiling_while_it_is_positive(p, q):
    ratio = max(p, q) ** 2 / min(p, q) ** 2
    assume(abs(ratio - (3 + 2 * math.sqrt(2))) > 1e-6)
    if ratio > 3 + 2 * math.sqrt(2):
        with pytest.raises(CertificateError, match="not positive definite"):
            planar_instance(p, q)
    else:
        assert planar_instance(p, q)["inputs"]["s"] in (p * q, str(p * q))


def test_the_planar_polynomial_is_a_fourth_power_and_modal_damping_is_slower():
    s = sp.Symbol("s")
    m, k, c = (sp.Matrix(TWO[name]) for name in "MKC")
    assert sp.factor((s**2 * m + s * c + k).det()) == (s + 2) ** 4
    best = max(np.linalg.eigvals(drift(*(array(TWO[name]) for name in "MKC"))).real)
    modal = max(
        np.linalg.eigvals(drift(array(TWO["M"]), array(TWO["K"]), np.diag([2.0, 8.0]))).real
    )
    assert best == pytest.approx(-2, abs=1e-2)
    assert modal == pytest.approx(-1, abs=1e-2)


def test_without_damping_errors_stay():
    """C + C' = 0: the flow of M = K = 1, C = 0 has A^2 = -1, and a skew C keeps E as well."""
    undamped = sp.Matrix([[0, 1], [-1, 0]])
    assert undamped**2 == -sp.eye(2)
    turning = np.array([[0.0, 3.0], [-3.0, 0.0]])
    matrix, form = drift(np.eye(2), np.eye(2), turning), energy(np.eye(2), np.eye(2))
    assert matrix.T @ form + form @ matrix == pytest.approx(np.zeros((4, 4)), abs=1e-12)
    assert max(np.linalg.eigvals(matrix).real) == pytest.approx(0, abs=1e-9)


def test_without_stiffness_the_position_error_stays():
    """K = diag(1, 0) is only semidefinite: (0, 1) at rest is an equilibrium."""
    matrix = drift(np.eye(2), np.diag([1.0, 0.0]), np.eye(2))
    assert not (matrix @ np.array([0.0, 1.0, 0.0, 0.0])).any()


def test_with_damping_that_grows_in_time_the_position_error_stays():
    """x'' + (2 + e^t) x' + x = 0 has E' <= -2u^2 and the solution 1 + e^-t."""
    t = sp.Symbol("t")
    x = 1 + sp.exp(-t)
    assert sp.simplify(x.diff(t, 2) + (2 + sp.exp(t)) * x.diff(t) + x) == 0
    assert sp.limit(x, t, sp.oo) == 1


def test_the_cited_theorem_leaves_the_position_where_it_is():
    decision = DECISIONS["variational.theorem_3_2_citation"]()
    rows = [list(map(Fraction, row)) for row in decision.replay[1:]]
    for k, x, u, level, rate in rows:
        assert (x, float(u)) == (1, pytest.approx(math.exp(-float(k) * math.log(2))))
        assert (level, rate) == ((x * x + u * u) / 2, -u * u)


def test_the_table_of_polynomials_has_the_roots_that_it_names():
    (_, *rows) = DECISIONS["variational.theorem_3_2_stability"]().replay
    wanted = ([1, 10, 33, 40, 16], [1, 8, 24, 32, 16])
    for (_, coefficients, _), expected in zip(rows, wanted, strict=True):
        assert [int(entry) for entry in coefficients.split(", ")] == expected


def test_the_figure_shows_a_solution():
    """x'' = -x' - x by central differences, and V falls as exp(-t)."""
    step = 1e-4
    for t in (0.5, 3.0, 7.0):
        (before, _), (x, u), (after, _) = (state(t + k * step) for k in (-1, 0, 1))
        assert (after - before) / (2 * step) == pytest.approx(u, abs=1e-6)
        assert (after - 2 * x + before) / step**2 == pytest.approx(-x - u, abs=1e-5)
        assert energies(x, u)[1] == pytest.approx(energies(*state(0.0))[1] * math.exp(-t))
    (strict, printed) = energies_over_time().curves
    assert len(strict.x) == len(printed.x)


PLANTED = [
    ("prop_3_1", "C*u + K*x", "K*x"),
    ("eq_15_dissipation", "-1/2*T(u)*S*u", "-T(u)*S*u"),
    ("theorem_3_2_stability", "- 2*a*(", "- 9*a*("),
    ("theorem_3_2_stability", "pd(K - 16*a**2*M)", "pd(K - 64*a**2*M)"),
    ("theorem_3_2_stability_rate", "-2*g*(", "-3*g*("),
    ("theorem_3_2_stability_ceiling", ">= B*r**2", ">= 2*B*r**2"),
    ("theorem_3_2_stability_planar", "(s + p*q)**4", "(s + p)**4"),
    ("theorem_3_2_stability_attained", "**4 == 0*A", "**3 == 0*A"),
    ("theorem_3_2_citation", "== -1/2*T(u)*S*u", "== -1/2*T(x)*S*x"),
    ("theorem_3_2_citation_repair", "+ T(u)*Q*u", "+ 2*T(u)*Q*u"),
]


@pytest.mark.parametrize("name, old, new", PLANTED)
def test_a_planted_false_statement_is_not_proved(name, old, new):
    """The certificate of the true statement, relabelled, is refused."""
    documents = (entry for decide in DECISIONS.values() for entry in decide().certificates.values())
    (document,) = (copy.deepcopy(entry) for entry in documents if entry["name"] == name)
    known = copy.deepcopy(statements())
    ((_, case),) = known[f"variational.{name}"]["cases"].items()
    false = [text.replace(old, new) for text in case["show"]]
    assert false != case["show"]
    check.check_document(document, known)
    case["show"] = false
    document["digest"] = check.digest_of(known[f"variational.{name}"])
    with pytest.raises(check.Reject):
        check.check_document(document, known)


def test_stability_does_not_follow_without_its_condition():
    """Without the definition of Q, Q > 0 says nothing, and the certificate is refused."""
    decision = DECISIONS["variational.theorem_3_2_stability"]()
    document = copy.deepcopy(decision.certificates["variational.theorem_3_2_stability"])
    known = copy.deepcopy(statements())
    statement = known["variational.theorem_3_2_stability"]
    statement["given"] = statement["given"][:-1]
    document["digest"] = check.digest_of(statement)
    with pytest.raises(check.Reject, match="no relation 3"):
        check.check_document(document, known)
