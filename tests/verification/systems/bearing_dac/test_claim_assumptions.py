"""What the claims assume matters: without it, what they say is false."""

from fractions import Fraction

import numpy as np
import pytest

from verification.certificates.make import CertificateError, certificate
from verification.systems.bearing_dac.claims.common import proof
from verification.systems.bearing_dac.genuine_bearings import late_position, singular_later

PATH = np.array([[-1.0, 0], [1, -1], [0, 1]])


def laplacian(incidence):
    return incidence @ incidence.T


def implicit_step(x, push):
    """argmin |y - x|^2/2 + push |B'y|_1 on three sensors in a row, by its dual."""
    flow, step = np.zeros(PATH.shape[1]), 1 / 4
    for _ in range(200):
        flow = np.clip(flow + step * PATH.T @ (x - PATH @ flow), -push, push)
    return x - PATH @ flow


def test_internal_states_of_another_sum_agree_off_the_average():
    w, h = np.array([2.0, 0.0, 1.0]), 0.05
    for _ in range(40):
        w = implicit_step(w, h)
    assert np.ptp(w) == pytest.approx(0, abs=1e-9)
    assert w.mean() == pytest.approx(1)


def test_one_line_of_sight_leaves_a_line_of_positions():
    rows, z = np.array([[-0.6, 0.8], [-0.6, 0.8], [0.6, -0.8]]), np.array([1.0, 1.0, -1.0])
    assert np.linalg.matrix_rank(rows) == 1
    first, *_ = np.linalg.lstsq(rows, z, rcond=None)
    other = first + 7 * np.array([0.8, 0.6])
    assert rows @ other == pytest.approx(z)
    assert abs(np.linalg.det(rows.T @ rows)) < 1e-12


def test_noise_in_a_bearing_breaks_the_equation_of_the_sensor():
    place, target, noise = np.array([1.0, 2.0]), np.array([4.0, 6.0]), 0.1
    angle = np.arctan2(4.0, 3.0) + noise
    h = np.array([-np.sin(angle), np.cos(angle)])
    assert h @ (place - target) == pytest.approx(5 * np.sin(noise))


def test_no_form_of_the_gain_serves_a_network_in_pieces():
    """Two sensors without a link: lambda_2 = 0, and no multiple of M is below L."""
    values = np.linalg.eigvalsh(laplacian(np.zeros((2, 1))) - 0.1 * (np.eye(2) - 0.5))
    assert values.min() < -0.05


def test_implicit_steps_below_the_threshold_lose_agreement():
    """Three sensors in a row need 4/3; the disturbance of the first link, step by step."""
    u = np.array([1.0, -1.0, -1.0])
    push = u - u.mean()
    x = {}
    for gain in (1.2, 1.5):
        x[gain] = np.zeros(3)
        for _ in range(20):
            x[gain] = implicit_step(x[gain] + 0.1 * push, 0.1 * gain)
    assert np.ptp(x[1.5]) == pytest.approx(0, abs=1e-9)
    assert np.ptp(x[1.2]) > 0.1


def test_explicit_steps_settle_from_their_multiples_only():
    push = Fraction(1, 10)
    ends = []
    for start in (Fraction(4, 10), Fraction(3, 10)):
        difference = start
        for _ in range(10):
            sign = (difference > 0) - (difference < 0)
            difference -= 2 * push * sign
        ends.append(difference)
    assert ends[0] == 0
    assert abs(ends[1]) == push


def forged(document, **change):
    inputs = document["inputs"] | change
    witness = [item for item in document["witness"] if item["kind"] != "congruence"]
    return certificate("bearing_dac", document["name"], inputs, witness, document["case"])


@pytest.mark.parametrize(
    "change",
    [
        {"a": ["2/3", "2/3", "-1/3"]},  # sums 1 and 1, and no indicator
        {"a": ["1", "1", "0"]},
        {"c": "1"},  # no bearing
        {"beta": "1"},  # below the printed gain
        {"gamma": "0"},
        {"lambda_2": "3"},
        {"t": "22"},  # before the printed time
        {"t": "24"},  # after agreement
        {"k": "10"},
    ],
)
def test_a_late_position_needs_each_of_its_numbers(change):
    document = late_position().document
    assert forged(document)["verdict"] == "REFUTED"
    with pytest.raises(CertificateError):
        forged(document, **change)


@pytest.mark.parametrize(
    "change", [{"a": ["2/3", "2/3", "-1/3"]}, {"d": "1"}, {"s": "0"}, {"t": "0"}, {"beta": "2"}]
)
def test_a_singular_matrix_needs_each_of_its_numbers(change):
    document = singular_later().document
    assert forged(document)["verdict"] == "REFUTED"
    with pytest.raises(CertificateError):
        forged(document, **change)


@pytest.mark.parametrize(
    "name, case",
    [("prop_1_identity", "REFUTED"), ("prop_1_clockwise", "PROVED"), ("theorem_1_form_root", "X")],
)
def test_a_proof_proves_its_own_case_only(name, case):
    with pytest.raises((CertificateError, KeyError)):
        proof(name, case)
