"""The step limit under late data, beside polynomials, simulation and known values."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.strategies import definite_matrices, rationals
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.systems.variational.delays import delay_step_limit
from verification.systems.variational.steps import step_limit


def scalars(m, k, c, d):
    one = [((Fraction(v),),) for v in (m, k, c)]
    return dict(zip("MKC", one, strict=True)) | {"d": Fraction(d)}


def radius(m, k, c, h, d):
    """Largest root of m(z - 1)^2 + hc z(z - 1) + h^2 k z^(1 - d), times z^(d - 1) if d > 1."""
    lift = max(d - 1, 0)
    inner = np.polymul([m], np.polymul([1, -1], [1, -1]))
    inner = np.polyadd(inner, h * c * np.polymul([1, 0], [1, -1]))
    pull = [h * h * k] + [0] * (1 - d + lift)
    return np.abs(np.roots(np.polyadd(np.concatenate([inner, np.zeros(lift)]), pull))).max()


@pytest.mark.parametrize(
    "gains,limits",
    [
        ((1, 1, 1), (3.236068, 1, 0.543689, 0.370980, 0.281094)),
        ((1, 4, 4), (2.414214, 1, 0.585043, 0.411517, 0.317002)),
    ],
)
def test_published_limits_come_out(gains, limits):
    for d, limit in enumerate(limits):
        answer = delay_step_limit(scalars(*gains, d))
        assert answer.value == pytest.approx(limit, abs=5e-7)
        assert answer.verdict == "PROVED"


@settings(max_examples=15, deadline=None)
@given(*(rationals(Fraction(1, 5), 5) for _ in range(3)), st.integers(0, 6))
def test_one_coordinate_agrees_with_the_roots_of_its_polynomial(m, k, c, d):
    answer = delay_step_limit(scalars(m, k, c, d))
    m, k, c = map(float, (m, k, c))
    assert answer.lower <= answer.value <= answer.upper
    assert answer.upper / answer.lower - 1 <= 1e-7
    assert radius(m, k, c, 0.999 * answer.lower, d) < 1
    assert radius(m, k, c, 1.001 * answer.upper, d) > 1


@settings(max_examples=10, deadline=None)
@given(*(rationals(Fraction(1, 5), 5) for _ in range(3)))
def test_one_sample_late_leaves_the_ratio_of_damping_and_stiffness(m, k, c):
    answer = delay_step_limit(scalars(m, k, c, 1))
    assert answer.lower <= float(c / k) * (1 + 1e-12)
    assert answer.upper >= float(c / k) * (1 - 1e-12)


@settings(max_examples=5, deadline=None)
@given(definite_matrices(2), definite_matrices(2), definite_matrices(2), st.integers(0, 3))
def test_two_coordinates_decay_below_and_do_not_above(m, k, c, d):
    answer = delay_step_limit({"M": m, "K": k, "C": c, "d": Fraction(d)})
    assert answer.verdict == "PROVED"
    m, k, c = (np.array([[float(x) for x in row] for row in rows]) for rows in (m, k, c))

    def grown(h, steps=4000):
        rng = np.random.default_rng(0)
        past = [rng.normal(size=2) for _ in range(d + 2)]
        for _ in range(steps):
            x1, x0, late = past[-1], past[-2], past[-1 - d]
            force = m @ (2 * x1 - x0) + h * c @ x1 - h * h * k @ late
            past = [*past[1:], np.linalg.solve(m + h * c, force)]
        return np.linalg.norm(past[-1])

    assert grown(1.02 * answer.upper) > grown(0.98 * answer.lower)


def test_without_delay_it_is_the_step_limit():
    values = scalars(2, 3, 1, 0)
    plain = step_limit(values)
    late = delay_step_limit(values)
    assert late.value == plain.value
    assert late.lower <= plain.lower <= plain.upper <= late.upper


def test_a_certificate_does_not_serve_another_delay_or_a_shifted_bracket():
    document = delay_step_limit(scalars(1, 1, 1, 2)).certificate
    check.check_document(document, statements())
    for change in (
        {"inputs": document["inputs"] | {"d": "3"}},
        {"case": "PROVED 3"},
        {"lower": "3/5", "upper": "4/5"},
        {"upper": "1/2", "lower": "2/5"},
    ):
        with pytest.raises(check.Reject):
            check.check_document(document | change, statements())


def test_a_smaller_basis_proves_nothing():
    """Blocks that are not orthonormal, or a form without them, are refused."""
    document = delay_step_limit(scalars(1, 1, 1, 2)).certificate
    found = {"congruence", "combination"}
    forged = [dict(item) for item in document["witness"] if item["kind"] not in found]
    forged[2] = dict(forged[1])
    with pytest.raises(CertificateError):
        certificate(
            "variational",
            "delay_step_limit",
            {"M": [[1]], "K": [[1]], "C": [[1]], "d": 2},
            forged,
            case="PROVED 2",
            lower=Fraction(document["lower"]),
            upper=Fraction(document["upper"]),
        )


@pytest.mark.parametrize("d", ["-1", "1/2", "101"])
def test_a_delay_that_is_no_number_of_samples_is_refused(d):
    with pytest.raises(InputError) as error:
        delay_step_limit(scalars(1, 1, 1, d))
    assert error.value.name == "d"
    assert "whole number" in str(error.value)


def test_a_long_delay_is_answered_without_a_certificate():
    answer = delay_step_limit(scalars(1, 1, 1, 40))
    assert answer.certificate is None
    assert answer.lower is None
    assert math.isclose(radius(1, 1, 1, answer.value, 40), 1, rel_tol=1e-6)
