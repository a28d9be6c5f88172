"""Chosen gains and steps: what is certified holds in numbers, and no neighbour is better."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import definite_matrices
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.systems.variational.design import (
    DESIGNS,
    gains_for_decay,
    step_for_gains,
)
from verification.systems.variational.gain_search import Noises
from verification.systems.variational.noise_gains import exact_traces
from verification.systems.variational.numbers import spectral_radius

RATES = st.fractions(Fraction(1, 20), 3, max_denominator=50)
STEPS = st.fractions(Fraction(1, 50), Fraction(1, 2), max_denominator=100)
VARIANCE = st.fractions(Fraction(1, 100), 4, max_denominator=100)


def asked(decay="1/2", h="1/10", chi="1", nu="1", **more):
    texts = {"decay": decay, "h": h, "chi": chi, "nu": nu, **more}
    return {name: Fraction(text) for name, text in texts.items()}


def gains_of(found):
    return {name: ((found.gains[name],),) for name in "MKC"}


@settings(max_examples=15, deadline=None)
@given(RATES, STEPS, VARIANCE, VARIANCE)
def test_chosen_gains_have_the_decay_and_the_variances(decay, h, chi, nu):
    found = gains_for_decay({"decay": decay, "h": h, "chi": chi, "nu": nu})
    assert check.check_document(found.certificate, statements())["verdict"] == "PROVED"
    gains = gains_of(found)
    assert spectral_radius({**gains, "h": h}).upper <= math.exp(-float(decay * h)) * (1 + 1e-12)
    by_chi, by_nu, speed = exact_traces(gains, h)
    assert found.bound["position"] == pytest.approx(float(chi * by_chi + nu * by_nu))
    assert float(chi * by_chi + nu * by_nu) <= found.bound["position"]
    assert found.bound["velocity"] >= float(nu * speed)


@settings(max_examples=40)
@given(
    st.floats(0.05, 0.95),
    st.floats(0.05, 0.95),
    st.floats(0.05, 1.0),
    st.floats(0.1, 3.0),
    st.floats(0.1, 3.0),
)
def test_variances_are_those_of_the_stationary_covariance(a, part, h, chi, nu):
    """The closed forms against a Lyapunov equation that numpy solves."""
    g = part * (2 + 2 * a)
    step = np.array([[1, h], [-g / h, a - g]])
    by_chi, by_nu = np.array([[0], [-g / h]]), np.array([[-h], [g]])
    noise = chi * by_chi @ by_chi.T + nu * by_nu @ by_nu.T
    whole = np.eye(4) - np.kron(step, step)
    spread = np.linalg.solve(whole, noise.reshape(-1)).reshape(2, 2)
    noises = Noises(h, chi, nu)
    assert noises.of_position(a, g) == pytest.approx(spread[0, 0], rel=1e-6)
    assert noises.of_velocity(a, g) == pytest.approx(spread[1, 1] + nu, rel=1e-6)


@pytest.mark.parametrize("more", [{}, {"noise": "1/5"}])
def test_no_neighbour_is_quieter(more):
    values = asked(**more)
    found = gains_for_decay(values)
    best = found.bound["velocity"]
    k, c = float(found.gains["K"]), float(found.gains["C"])
    rng = np.random.default_rng(3)
    h = float(values["h"])
    noises = Noises(h, 1.0, 1.0)
    circle = math.exp(-float(values["decay"]) * h)
    for _ in range(2000):
        damping, pull = c * math.exp(rng.normal()), k * math.exp(rng.normal())
        a = 1 / (1 + h * damping)
        g = h * h * pull * a
        radius = np.abs(np.roots([1, -(1 + a - g), a])).max()
        allowed = float(values.get("noise", math.inf))
        if radius <= circle and noises.of_position(a, g) <= allowed:
            assert noises.of_velocity(a, g) >= best * (1 - 1e-5)


def test_without_a_limit_both_roots_meet():
    """Critical damping: a = r^2 and g = (1 - r)^2."""
    found = gains_for_decay(asked())
    r, h = math.exp(-0.05), 0.1
    assert float(found.gains["C"]) == pytest.approx((1 / r**2 - 1) / h, rel=1e-4)
    assert float(found.gains["K"]) == pytest.approx((1 / r - 1) ** 2 / h**2, rel=1e-4)


def test_a_level_that_no_gains_keep_has_no_answer():
    found = gains_for_decay(asked(noise="1/1000000"))
    assert (found.gains, found.verdict, found.certificate) == ({}, "UNDECIDED", None)


@settings(max_examples=15, deadline=None)
@given(st.integers(1, 3).flatmap(lambda n: st.tuples(*[definite_matrices(n)] * 3)))
def test_the_chosen_step_is_stable_and_no_other_on_a_grid_is_much_better(three):
    gains = dict(zip("MKC", three, strict=True))
    found = step_for_gains(gains)
    assert found.verdict == "PROVED"
    limit = found.bound["step_limit"]
    assert 0 < found.gains["h"] < limit
    for part in range(1, 20):
        h = Fraction(limit) * part / 20
        other = spectral_radius({**gains, "h": h})
        assert found.bound["radius"] <= float(other.value) * 1.02


@pytest.mark.parametrize("mass, pull", [("1e-200", "1e200"), ("1e200", "1e-200"), ("1", "1e300")])
def test_gains_far_apart_still_get_a_stable_step(mass, pull):
    gains = {"M": mass, "K": pull, "C": "1"}
    found = step_for_gains({name: ((Fraction(text),),) for name, text in gains.items()})
    assert found.verdict == "PROVED"
    assert found.gains["h"] > 0


@pytest.mark.parametrize(
    "wrong, name",
    [
        ({"decay": "0"}, "decay"),
        ({"decay": "-1"}, "decay"),
        ({"decay": "1000"}, "decay"),
        ({"decay": "1/100000000"}, "decay"),
        ({"h": "0"}, "h"),
        ({"chi": "-1"}, "chi"),
        ({"nu": "-1"}, "nu"),
        ({"chi": "0", "nu": "0"}, "chi"),
        ({"noise": "0"}, "noise"),
    ],
)
def test_bad_wishes_are_refused(wrong, name):
    with pytest.raises(InputError, match=name):
        gains_for_decay(asked(**wrong))


def test_a_smaller_circle_or_variance_is_not_proved():
    """Planted false promises about the chosen gains."""
    found = gains_for_decay(asked())
    document = found.certificate
    inputs = {n: Fraction(v) for n, v in document["inputs"].items() if isinstance(v, str)}
    inputs |= gains_of(found)
    witness = [item for item in document["witness"] if item["kind"] == "matrix"]
    assert certificate("variational", "design", inputs, witness)
    for name, factor in (("r", "0.999"), ("noise", "0.999"), ("speed", "0.999")):
        false = inputs | {name: inputs[name] * Fraction(factor)}
        with pytest.raises(CertificateError):
            certificate("variational", "design", false, witness)


def test_every_choice_is_known_by_its_inputs():
    required = [
        frozenset(entry.name for entry in design.inputs if entry.default is None)
        for design in DESIGNS
    ]
    assert len({*required}) == len(required)
