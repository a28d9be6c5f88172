"""Variances and peaks under noise, beside python-control's Lyapunov equation and norms."""

from fractions import Fraction

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.strategies import definite_matrices
from verification.systems.variational.noise_gains import noise_gain
from verification.systems.variational.numbers import spectral_radius
from verification.systems.variational.peak_gains import peak_gain
from verification.systems.variational.steps import step_limit

THREE = st.integers(1, 3).flatmap(lambda n: st.tuples(*[definite_matrices(n)] * 3))
PARTS = st.fractions(Fraction(1, 20), Fraction(9, 10), max_denominator=40)


def question(three, part):
    """Gains, and a step that is this part of the limit."""
    gains = dict(zip("MKC", three, strict=True))
    limit = step_limit(gains).value
    return {**gains, "h": (Fraction(limit) * part).limit_denominator(10**4)}


def systems(values):
    """The three maps as state spaces, state (e, w): e from chi, e from nu, velocity from nu."""
    h = float(values["h"])
    m, k, c = (np.array([[float(x) for x in row] for row in values[n]]) for n in "MKC")
    n, damped = len(m), np.linalg.inv(m + h * c)
    one, zero = np.eye(n), np.zeros((n, n))
    step = np.block([[one, h * one], [-h * damped @ k, damped @ (m - h * h * k)]])
    by_chi = np.vstack([zero, -h * damped @ k])
    by_nu = np.vstack([-h * one, h * h * damped @ k])
    place, speed = np.hstack([one, zero]), np.hstack([zero, one])
    return [
        control.ss(step, by_chi, place, zero, h),
        control.ss(step, by_nu, place, zero, h),
        control.ss(step, by_nu, speed, -one, h),
    ]


@settings(max_examples=25, deadline=None)
@given(THREE, PARTS)
def test_variances_are_those_of_the_lyapunov_equation(three, part):
    values = question(three, part)
    found = noise_gain(values).value
    if found[0] == "inf":
        assert float(spectral_radius(values).value) >= 1
        return
    for gain, system in zip(found, systems(values), strict=True):
        spread = control.dlyap(system.A, system.B @ system.B.T)
        wanted = np.trace(system.C @ spread @ system.C.T + system.D @ system.D.T)
        assert gain == pytest.approx(wanted, rel=1e-6)


@settings(max_examples=25, deadline=None)
@given(THREE, PARTS)
def test_peaks_are_reached_and_not_exceeded_on_a_frequency_grid(three, part):
    """No frequency exceeds the peak (one-sided), and a fine grid comes near it."""
    values = question(three, part)
    found = peak_gain(values).value
    if found[0] == "inf":
        return
    angles = np.linspace(0, np.pi, 2001)
    for gain, system in zip(found, systems(values), strict=True):
        response = system(np.exp(1j * angles), squeeze=False)
        sizes = np.linalg.svd(np.moveaxis(response, -1, 0), compute_uv=False)[:, 0]
        assert sizes.max() <= gain * (1 + 1e-7)
        assert sizes.max() >= gain * 0.9


@pytest.mark.parametrize("damping", ["1/4", "3"])
@pytest.mark.parametrize("which", [0, 1, 2])
def test_peaks_are_python_controls_norm(damping, which):
    one = ((Fraction(1),),)
    values = {"M": one, "K": one, "C": ((Fraction(damping),),), "h": Fraction(1, 5)}
    found = peak_gain(values).value[which]
    norm = control.system_norm(systems(values)[which], "inf", tol=1e-9)
    assert found == pytest.approx(norm, rel=1e-6)


@pytest.mark.parametrize("h", ["1/10", "1/2", "2"])
def test_one_coordinate_has_the_closed_forms(h):
    """var(e)/var(chi) = hk(2m + hc)/(cD), D = 4m + 2hc - h^2 k; the velocity gains one."""
    m, k, c, h = Fraction(2), Fraction(3), Fraction(5), Fraction(h)
    values = {"M": ((m,),), "K": ((k,),), "C": ((c,),), "h": h}
    last = 4 * m + 2 * h * c - h * h * k
    by_chi = h * k * (2 * m + h * c) / (c * last)
    by_nu = h * (c * c * (2 * m + h * c) + 2 * m * k * (m + h * c)) / (c * k * last)
    found = noise_gain(values).value
    assert found == pytest.approx([float(by_chi), float(by_nu), float(1 + by_chi)], rel=1e-14)
