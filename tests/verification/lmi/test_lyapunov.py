"""Quadratic Lyapunov functions beside certified spectral radii and closed forms."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.strategies import rationals
from verification.exact.balls import ball_definite
from verification.exact.evaluate import identity, scaled
from verification.exact.spectra.spectral import spectral_radius
from verification.lmi import lyapunov
from verification.lmi.lyapunov import contraction, contraction_lmi, decay, decay_lmi
from verification.lmi.margin import Solution, Stage


def exact(rows):
    return tuple(tuple(Fraction(x) for x in row) for row in rows)


@st.composite
def squares(draw, largest=4):
    n = draw(st.integers(1, largest))
    return exact([[draw(rationals(-3, 3, 6)) for _ in range(n)] for _ in range(n)])


@pytest.fixture
def no_solver(monkeypatch):
    """The equation alone."""
    monkeypatch.setattr(lyapunov, "LARGEST_LMI", 0)


@settings(max_examples=50)
@given(squares())
def test_the_spectral_radius_parts_proofs_from_stages(a):
    found = spectral_radius(a)
    assume(found.value > 1e-2)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lyapunov, "LARGEST_LMI", 0)
        for miss in (Fraction(1, 100), Fraction(1, 10**5)):
            below = contraction(a, Fraction(found.lower) * (1 - miss))
            assert isinstance(below, Stage)
        above = contraction(a, Fraction(found.upper) * Fraction(11, 10))
        assert isinstance(above, Solution)
        p = above.values["P"]
        assert ball_definite(p, 400)


@settings(max_examples=40)
@given(squares(), rationals(0, 2, 5))
def test_the_abscissa_parts_proofs_from_stages(a, rate):
    abscissa = max(np.linalg.eigvals(np.array(a, dtype=float)).real)
    assume(abs(abscissa + float(rate)) > 1e-2)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lyapunov, "LARGEST_LMI", 0)
        found = decay(a, rate)
    assert isinstance(found, Solution) == (abscissa < -float(rate))
    if isinstance(found, Solution):
        for affine in decay_lmi(a, rate).positive.values():
            assert ball_definite(affine.at(found.values), 400)


def test_scalars_have_closed_forms(no_solver):
    # P is scaled to 1: the margin is r^2 - a^2, and -2 a - 2 rate
    assert contraction(exact([[Fraction(1, 2)]]), Fraction(1)).margin <= Fraction(3, 4)
    assert contraction(exact([[Fraction(1, 2)]]), Fraction(1)).margin >= Fraction(3, 5)
    assert decay(exact([[-1]]), Fraction(3, 4)).margin <= Fraction(1, 2)
    assert isinstance(decay(exact([[-1]]), Fraction(1)), Stage)


@pytest.mark.parametrize("n", [40, 60])
def test_large_matrices_are_proved_without_a_solver(n):
    a = np.random.default_rng(n).standard_normal((n, n))
    a = exact((0.9 / np.abs(np.linalg.eigvals(a)).max() * a).tolist())
    assert isinstance(contraction(a, Fraction(19, 20)), Solution)
    refused = contraction(a, Fraction(17, 20))
    assert isinstance(refused, Stage)
    assert refused.miss is None or refused.miss < 0


def test_the_solver_helps_where_the_equation_fails(monkeypatch):
    """An equation that fails hands over to the margin form while n is small."""

    def fail(*_):
        raise np.linalg.LinAlgError("singular")

    monkeypatch.setattr("scipy.linalg.solve_discrete_lyapunov", fail)
    a = scaled(Fraction(1, 2), identity(2))
    found = contraction(a, Fraction(1))
    assert isinstance(found, Solution)
    assert "Clarabel" in found.source
    monkeypatch.setattr(lyapunov, "LARGEST_LMI", 1)
    stage = contraction(a, Fraction(1))
    assert isinstance(stage, Stage)
    assert "singular" in str(stage)


def test_the_blocks_are_the_printed_ones():
    a = exact([[1, 2], [3, 4]])
    lmi = contraction_lmi(a, Fraction(3))
    assert lmi.homogeneous
    assert lmi.positive["r^2 P - A'PA"].at({"P": identity(2)}) == exact([[-1, -14], [-14, -11]])
    fall = decay_lmi(a, Fraction(1)).positive["-(PA + A'P) - 2 rate P"]
    assert fall.at({"P": identity(2)}) == exact([[-4, -5], [-5, -10]])
