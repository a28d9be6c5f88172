"""Claims about moving targets, lost sensors and late data, on a second road: simulated numbers."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verification.certificates.make import CertificateError, certificate
from verification.systems.variational.claims import DECISIONS
from verification.systems.variational.claims.simulated import ACCELERATION, EXAMPLE, TENTH
from verification.systems.variational.claims.witnesses import derivation
from verification.systems.variational.delays import delay_step_limit
from verification.systems.variational.moving import steady_errors

M, K, C = (np.array([[float(x) for x in row] for row in EXAMPLE[n]]) for n in "MKC")
SEEN = 4000


def run(h, samples, target, velocity, start, delay=0, averaged=False):
    """Position errors of (24) without noise; the target's motion is a function of time."""
    inverse = np.linalg.inv(M + h * C)
    p, u = start.astype(float), 0 * start
    errors = [p - target(0.0)]
    known = [errors[0]] * (delay + 1)
    for k in range(samples):
        t = k * h
        seen = (velocity(t) + velocity(t + h)) / 2 if averaged else velocity(t)
        p = p + h * (seen + u)
        errors.append(p - target(t + h))
        known = [errors[-1], *known[:delay]]
        u = inverse @ (M @ u - h * K @ known[-1])
    return np.array(errors)


def constant(x):
    """This value at all times."""
    return lambda _: x


def accelerated():
    a = np.array([float(x) for x in ACCELERATION])
    return (lambda t: a * t * t / 2), (lambda t: a * t)


def test_the_error_behind_an_accelerating_target_settles_where_the_certificate_says():
    target, velocity = accelerated()
    offset = np.array([float(x) for x in steady_errors(EXAMPLE, ACCELERATION, TENTH)])
    a = np.array([float(x) for x in ACCELERATION])
    assert offset == pytest.approx(np.linalg.solve(K, -0.05 * C @ a))
    errors = run(0.1, SEEN, target, velocity, np.ones(3))
    assert errors[-1] == pytest.approx(offset, abs=1e-8)
    repaired = run(0.1, SEEN, target, velocity, np.ones(3), averaged=True)
    assert np.abs(repaired[-1]).max() < 1e-8


@settings(max_examples=15)
@given(st.integers(0, 10**6))
def test_a_target_of_constant_velocity_is_found(seed):
    w = np.random.default_rng(seed).normal(size=3)
    errors = run(0.1, SEEN, lambda t: w * t, constant(w), np.ones(3))
    assert np.abs(errors[-1]).max() < 1e-8


def test_the_misread_velocity_leaves_the_error_that_the_statement_names():
    """Sensors of velocity s, target of velocity z: W l - 2z is what the average is wrong by."""
    s, z = np.array([0.3, -0.2, 0.1]), np.array([0.5, 0.1, -0.4])
    errors = run(0.1, SEEN, lambda t: z * t, constant(s - z), np.ones(3))
    assert errors[-1] == pytest.approx(np.linalg.solve(K, C @ (s - 2 * z)), abs=1e-8)


def test_one_sample_of_delay_ends_stability_where_the_claim_says():
    still = (constant(np.zeros(3)),) * 2
    limit = float(delay_step_limit({**EXAMPLE, "d": Fraction(1)}).value)
    for factor, grows in ((0.98, False), (1.02, True)):
        sizes = np.abs(run(limit * factor, SEEN, *still, np.ones(3), delay=1)).max(axis=1)
        assert bool(sizes[-200:].max() > sizes[1800:2000].max()) == grows


def test_a_single_coordinate_needs_the_sufficient_condition():
    """For n = 1 the limit with one sample of delay is c/k."""
    gains = {"M": ((Fraction(2),),), "K": ((Fraction(3),),), "C": ((Fraction(5),),)}
    answer = delay_step_limit({**gains, "d": Fraction(1)})
    assert answer.lower <= 5 / 3 <= answer.upper


def test_a_lost_sensor_makes_the_noise_larger_by_its_share():
    """Seeded; the ratio of two sample variances of 400 000 samples, within five deviations."""
    rng, h, samples = np.random.default_rng(4), 0.5, 400_000
    noise = rng.normal(size=(samples, 3))
    spread = []
    for sensors in (3, 2):
        mean = noise[:, :sensors].mean(axis=1)
        x = u = 0.0
        found = np.empty(samples)
        for k in range(samples):
            x = x + h * u
            u = (u - h * (x + mean[k])) / (1 + h)
            found[k] = x
        spread.append(found[1000:].var())
    assert spread[1] / spread[0] == pytest.approx(1.5, rel=0.05)


def test_the_replayed_fixed_point_is_one():
    table = DECISIONS["variational.section_4_converge"]().replay
    for row in table[1:]:
        assert Fraction(row[2]) == Fraction(row[3])


@pytest.mark.parametrize(
    "name,witness",
    [
        ("section_4_converge_uniform", [derivation()] * 6),
        ("eq_24_measured_repair", [derivation()] * 7),
        ("section_4_sensor_loss", [derivation()] * 8),
        ("section_4_noise_robust", [derivation(), derivation()]),
        ("section_4_instantaneous_necessary", [derivation((("h", "1", "1"),))]),
    ],
)
def test_a_wrong_derivation_proves_nothing(name, witness):
    with pytest.raises(CertificateError):
        certificate("variational", name, {}, witness)


def test_a_planted_step_without_delay_trouble_is_not_refuted():
    """Below the limit with one sample of delay no growing solution can be certified."""
    document = DECISIONS["variational.section_4_instantaneous"]().certificates[
        "variational.section_4_instantaneous"
    ]
    with pytest.raises(CertificateError):
        certificate(
            "variational",
            "section_4_instantaneous",
            {**EXAMPLE, "h": Fraction(1, 10)},
            document["witness"],
            case="REFUTED",
        )
