"""Factors by which an update multiplies second moments, where their eigenvalues lie close."""

from fractions import Fraction

import numpy as np
import pytest

from verification.systems.cyclic_spsa.stability import radius as radii
from verification.systems.cyclic_spsa.stability.radius import spectral_radius

from .test_stability import block, radius

ZERO3, ZERO4 = ((((Fraction(0),) * n,) * n) for n in (3, 4))


def near_singular(seed, size):
    """A Hessian with one small eigenvalue, in hundredths."""
    rows = np.random.default_rng(seed).normal(size=(size, size - 1))
    form = rows @ rows.T + 0.06 * np.eye(size)
    return tuple(
        tuple(Fraction(round(100 * float(form[max(i, j), min(i, j)])), 100) for j in range(size))
        for i in range(size)
    )


@pytest.mark.parametrize("alpha", ["0.05", "0.1", "0.12", "0.15", "0.2"])
def test_a_diagonal_hessian_without_noise_has_the_radius_of_its_diagonal(alpha):
    h = tuple(map(Fraction, ("37/16", "243/47", "17/26")))
    a = Fraction(alpha)
    answer = spectral_radius(block(h=h, Xi=ZERO3, eta=(Fraction(0),) * 3) | {"alpha": a})
    b, step = np.array([float(x) for x in h]), float(a)
    literal = np.diag(1 - 2 * step * b) + step**2 * np.outer(np.ones(3), b**2)
    assert answer.verdict == "PROVED"
    assert answer.value == pytest.approx(max(abs(np.linalg.eigvals(literal))), rel=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_hessians_close_to_singular_ones_are_proved(seed):
    values = block(h=None, H=near_singular(seed, 4), Xi=ZERO4, eta=(Fraction(0),) * 4)
    alpha = Fraction(1, 40)
    answer = spectral_radius(values | {"alpha": alpha})
    assert answer.verdict == "PROVED"
    assert answer.value == pytest.approx(radius(values, float(alpha)), rel=1e-8)
    assert answer.lower <= answer.value <= answer.upper


@pytest.mark.parametrize("miss, value", [(Fraction(0), 0.9802), (Fraction(1, 10**8), None)])
def test_a_candidate_that_is_not_proved_must_have_a_small_residual(monkeypatch, miss, value):
    """P = (1, -1)(1, -1)' is multiplied by 1 - 2 alpha/10 + 2 (alpha/10)^2, without noise."""
    line = [[Fraction(1), Fraction(-1)], [Fraction(-1), Fraction(1)]]
    hessian = ((Fraction(1), Fraction(9, 10)), (Fraction(9, 10), Fraction(1)))
    values = block(H=hessian, Xi=((Fraction(0),) * 2,) * 2, eta=(Fraction(0),) * 2)
    alpha = Fraction(1, 10)
    near = 1 - alpha / 5 + alpha**2 / 50 + miss
    monkeypatch.setattr(radii, "MOST_STACKED", 0)
    monkeypatch.setattr(radii, "leading_multiplier", lambda *_: (near, line))
    monkeypatch.setattr(radii, "_proved", lambda *_: None)
    found = spectral_radius(values | {"alpha": alpha})
    assert found.value == value
    assert found.verdict == ("UNDECIDED" if value is None else "SUPPORTED")


def test_one_update_may_leave_nothing():
    values = block(h=(Fraction(3),), Xi=((Fraction(0),),), eta=(Fraction(0),))
    found = spectral_radius(values | {"alpha": Fraction(1, 3)})
    assert found.exact == {"kind": "rational", "value": "0"}
    assert (found.lower, found.value, found.upper) == (0, 0, 0)
