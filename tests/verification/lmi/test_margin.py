"""LMIs are solved, and nothing is called a solution that is not proved here."""

import builtins
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

from sensortrack.errors import MissingExtra
from verification.exact.balls import ball_definite
from verification.exact.evaluate import add, identity, scaled
from verification.lmi import margin as margin_module
from verification.lmi.affine import block, known, rectangular, symmetric
from verification.lmi.lyapunov import contraction, contraction_lmi
from verification.lmi.margin import Lmi, Solution, Stage
from verification.lmi.solver import maximal_margin

ONE = ((Fraction(1),),)


def exact(rows):
    return tuple(tuple(Fraction(x) for x in row) for row in rows)


def stable(n, radius=0.9):
    a = np.random.default_rng(n).standard_normal((n, n))
    return exact((radius / np.abs(np.linalg.eigvals(a)).max() * a).tolist())


def check(lmi, solution):
    """Every block minus the margin is definite, by ball arithmetic instead of congruence."""
    assert isinstance(solution, Solution), str(solution)
    assert solution.margin >= 0
    for affine in lmi.positive.values():
        rows = affine.at(solution.values)
        assert ball_definite(add(rows, identity(len(rows)), -solution.margin), 400)


def test_a_scalar_has_the_margin_of_its_closed_form():
    """P = t', (r^2 - a^2) P = t with P (1 + r^2 - a^2) = 2: the margin is the smaller part."""
    lmi = contraction_lmi(scaled(Fraction(1, 2), ONE), Fraction(1))
    status, margin, values = maximal_margin(lmi.positive, lmi.unknowns, None)
    assert status == "optimal"
    assert margin == pytest.approx(2 * 0.75 / 1.75, rel=1e-6)
    assert values["P"] == pytest.approx(2 / 1.75, rel=1e-6)
    solution = lmi.solve()
    check(lmi, solution)
    assert 0.8 * margin < solution.margin < margin


@pytest.mark.parametrize("n", [1, 2, 6, 12])
def test_the_margin_is_no_less_than_that_of_steins_equation(n):
    a, r = stable(n), Fraction(19, 20)
    lmi = contraction_lmi(a, r)
    _, margin, _ = maximal_margin(lmi.positive, lmi.unknowns, None)
    p = contraction(a, r).values
    blocks = [np.array(b.at(p), dtype=float) for b in lmi.positive.values()]
    unit = sum(np.trace(b) for b in blocks) / (2 * n)
    assert margin >= min(np.linalg.eigvalsh(b)[0] for b in blocks) / unit * (1 - 1e-6)
    check(lmi, lmi.solve())


@pytest.mark.parametrize("n, most", [(6, 20), (20, 26)])
def test_few_bits_are_enough(n, most):
    lmi = contraction_lmi(stable(n), Fraction(19, 20))
    solution = lmi.solve()
    check(lmi, solution)
    assert solution.bits <= most


def test_an_infeasible_lmi_is_a_stage_and_says_by_how_much():
    stage = contraction_lmi(scaled(Fraction(2), ONE), Fraction(1)).solve()
    assert isinstance(stage, Stage)
    assert stage.stage == "margin"
    assert stage.miss == pytest.approx(-1, rel=1e-6)  # P + (1 - 4) P = 2 at P = -1
    assert "weaken the inequality" in str(stage)


@pytest.mark.parametrize("n", [1, 2, 5])
def test_an_unstable_matrix_has_no_solution(n):
    """Neither has one whose spectral radius equals r: that is where solvers say optimal."""
    for radius in (1.02, 1.0):
        a = np.diag(np.linspace(0.1, radius, n)) if n > 1 else np.array([[radius]])
        found = contraction_lmi(exact(a.tolist()), Fraction(1)).solve()
        assert isinstance(found, Stage)


def test_gradient_descent_at_two_over_l_is_not_certified():
    """mu = 1, L = 4, step 2/L: the rate is exactly 1."""
    a = exact([[0.5, 0], [0, -1]])
    assert isinstance(contraction_lmi(a, Fraction(1)).solve(), Stage)
    assert isinstance(contraction(a, Fraction(1)), Stage)
    assert isinstance(contraction(a, Fraction(10**6 + 1, 10**6)), Solution)


LIES = {
    "a wrong matrix called optimal": ("optimal", 1.0, -np.eye(2)),
    "a wrong matrix called inaccurate": ("optimal_inaccurate", 1e-3, -np.eye(2)),
    "a matrix on the edge": ("optimal", 1e-9, np.diag([1.0, 0.0])),
    "no numbers": ("infeasible_inaccurate", None, None),
    "not finite": ("optimal", 1.0, np.full((2, 2), np.nan)),
    "no margin": ("optimal", float("nan"), np.zeros((2, 2))),
    "a margin that is not positive": ("optimal", -1e-3, np.eye(2)),
}


@pytest.mark.parametrize("lie", LIES)
def test_a_solver_that_lies_is_not_believed(lie, monkeypatch):
    status, margin, value = LIES[lie]
    said = (status, margin, {} if value is None else {"P": value})
    monkeypatch.setattr(margin_module, "maximal_margin", lambda *_: said)
    found = contraction_lmi(scaled(Fraction(1, 2), identity(2)), Fraction(1)).solve()
    assert isinstance(found, Stage)
    assert found.advice


@pytest.mark.parametrize("status", ["optimal_inaccurate", "infeasible", "user_limit"])
def test_the_status_decides_nothing_a_proof_does(status, monkeypatch):
    monkeypatch.setattr(margin_module, "maximal_margin", lambda *_: (status, 0.5, {"P": np.eye(2)}))
    lmi = contraction_lmi(scaled(Fraction(1, 2), identity(2)), Fraction(1))
    found = lmi.solve()
    check(lmi, found)
    assert status in found.source


def test_constants_and_rectangular_unknowns():
    """State feedback K = Y P^-1 for an unstable matrix, P >= I: [[P, (AP+BY)'], [AP+BY, P]] > 0."""
    a, b = exact([[2, 1], [0, Fraction(3, 2)]]), exact([[0], [1]])
    p, y = symmetric("P", 2), rectangular("Y", 1, 2)
    closed = known(a) @ p + known(b) @ y
    lmi = Lmi({"P - I": p - known(identity(2)), "decrease": block([[p, closed.T], [closed, p]])})
    assert not lmi.homogeneous
    solution = lmi.solve()
    check(lmi, solution)
    p, y = (np.array(solution.values[name], dtype=float) for name in "PY")
    loop = np.array(a, dtype=float) + np.array(b, dtype=float) @ y @ np.linalg.inv(p)
    assert np.abs(np.linalg.eigvals(loop)).max() < 1


def test_a_box_too_small_is_a_stage_that_says_so():
    p = symmetric("P", 1)
    found = Lmi({"P - 2": p - 2 * known(ONE)}, box=Fraction(1)).solve()
    assert isinstance(found, Stage)
    assert found.miss == pytest.approx(-1, rel=1e-6)
    assert "larger box" in found.advice


def test_blocks_must_be_symmetric():
    y = rectangular("Y", 2, 2)
    with pytest.raises(ValueError, match="block Y: not symmetric"):
        Lmi({"Y": y}).prove({"Y": np.array([[1.0, 5.0], [0.0, 1.0]])}, 1.0, "a test")
    with pytest.raises(ValueError, match="block Z: shape"):
        Lmi({"Z": rectangular("Z", 1, 2)})


def test_a_solver_that_fails_is_a_stage(monkeypatch):
    import cvxpy

    def fail(*_, **__):
        raise cvxpy.SolverError("Solver 'CLARABEL' failed.\nTry another.")

    monkeypatch.setattr(cvxpy.Problem, "solve", fail)
    found = contraction_lmi(scaled(Fraction(1, 2), ONE), Fraction(1)).solve()
    assert isinstance(found, Stage)
    assert found.stage == "solver"
    assert "Solver 'CLARABEL' failed." in str(found)
    assert found.miss is None


def test_a_missing_solver_is_named(monkeypatch):
    true_import = builtins.__import__

    def without(name, *rest):
        if name == "cvxpy":
            raise ImportError("gone", name="cvxpy")
        return true_import(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(
        MissingExtra, match=r"cvxpy: not installed; pip install 'sensortrack\[verify\]'"
    ):
        contraction_lmi(scaled(Fraction(1, 2), ONE), Fraction(1)).solve()


def test_the_equation_needs_no_solver():
    code = (
        "import sys; from fractions import Fraction as F\n"
        "from verification.lmi.lyapunov import contraction, decay\n"
        "contraction(((F(1, 2),),), F(1)); decay(((F(-1, 2),),))\n"
        "assert not {'cvxpy', 'clarabel', 'sympy'} & set(sys.modules)\n"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
