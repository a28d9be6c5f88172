"""Claims about weights, costs and constraints, on a second road: plain numbers and quadrature."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verification.certificates.make import CertificateError
from verification.systems.cyclic_spsa.claims import DECISIONS
from verification.systems.cyclic_spsa.claims.common import replayed
from verification.systems.cyclic_spsa.claims.moments import gaussian_errors, gaussian_square

NODES, WEIGHTS = np.polynomial.hermite_e.hermegauss(30)
WEIGHTS = WEIGHTS / WEIGHTS.sum()
variances = st.lists(st.floats(0.1, 50), min_size=1, max_size=6)


def decided(name):
    return DECISIONS[f"cyclic_spsa.{name}"]()


@settings(max_examples=40)
@given(variances, st.floats(-5, 5))
def test_the_harmonic_mean_makes_the_risk_half_the_squared_error(squares, error):
    """The mean over two-point errors of each sensor, less its value at error zero."""

    def risk(k, d):
        each = [np.mean([(d + s * math.sqrt(v)) ** 2 for s in (1, -1)]) / v for v in squares]
        return k / (2 * len(squares)) * sum(each)

    right = len(squares) / sum(1 / v for v in squares)
    assert risk(right, error) - risk(right, 0) == pytest.approx(error**2 / 2, abs=1e-9)
    printed = sum(squares)
    excess = risk(printed, error) - risk(printed, 0)
    assert excess >= error**2 / 2 - 1e-9  # never too small, and right for one sensor alone
    if len(squares) > 1 and abs(error) > 0.1:
        assert excess > 1.5 * error**2 / 2


def test_the_table_of_constants_is_computed_from_its_first_column():
    for variances_, printed, scale, right in decided("eq_3_mean_risk").replay[1:]:
        a, b = (Fraction(x) for x in variances_.split(", "))
        assert Fraction(printed) == a + b
        assert Fraction(right) == 2 * a * b / (a + b)
        assert Fraction(scale) == Fraction(printed) / Fraction(right)


@pytest.mark.parametrize("change", [{"l": 1}, {"p": "1/2"}, {"K": 2}, {"a": 0}])
def test_a_wrong_constant_needs_each_of_its_numbers(change):
    good = {"a": 1, "b": 4, "m": 1, "p": 0, "K": 5, "l": "25/8"}
    assert replayed("eq_3_mean_risk", good)
    with pytest.raises((CertificateError, ZeroDivisionError)):
        replayed("eq_3_mean_risk", good | change)


def test_the_right_constant_refutes_nothing():
    with pytest.raises(CertificateError):
        replayed("eq_3_mean_risk", {"a": 1, "b": 4, "m": "8/5", "p": 1, "K": "8/5", "l": 1})


def test_weights_from_the_measurement_pull_the_fit_towards_the_sensor():
    rho, d = 100.0, 5.0
    measured = np.array([rho - d, rho + d])
    fit = (1 / measured).sum() / (1 / measured**2).sum()
    assert decided("eq_20_weights_measured").sharp_value == pytest.approx(fit / rho)
    grid = np.linspace(95, 105, 100_001)
    cost = sum((z - grid) ** 2 / z**2 for z in measured)
    assert grid[cost.argmin()] == pytest.approx(fit, abs=2e-4)
    steady = sum((z - grid) ** 2 for z in measured)
    assert grid[steady.argmin()] == pytest.approx(rho, abs=2e-4)


@pytest.mark.parametrize("angle, relative", [(math.radians(0.5), 0.05), (0.3, 0.2)])
def test_the_mean_square_of_a_position_is_known_exactly(angle, relative):
    """Gauss-Hermite quadrature over both errors."""
    total = 0.0
    for x, p in zip(NODES, WEIGHTS, strict=True):
        for y, q in zip(NODES, WEIGHTS, strict=True):
            stretch, turn = 1 + relative * y, angle * x
            miss = math.hypot(stretch * math.sin(turn), stretch * math.cos(turn) - 1)
            total += p * q * miss**2
    assert gaussian_square(angle, relative) == pytest.approx(total, rel=1e-9)
    assert gaussian_square(angle, relative) < angle**2 + relative**2


@pytest.mark.parametrize("angle, relative", [(math.radians(0.5), 0.05), (0.3, 0.2)])
def test_the_variances_of_a_position_are_known_exactly(angle, relative):
    """The same quadrature: along the line of sight, across it, and together with the bias."""
    along, across = [], []
    for x in NODES:
        along.append((1 + relative * NODES) * math.cos(angle * x))
        across.append((1 + relative * NODES) * math.sin(angle * x))
    weights = np.outer(WEIGHTS, WEIGHTS)
    means = [float(np.sum(weights * part)) for part in (along, across)]
    squares = [float(np.sum(weights * np.square(part))) for part in (along, across)]
    wanted = squares[0] - means[0] ** 2, squares[1]
    assert means[1] == pytest.approx(0, abs=1e-15)
    assert gaussian_errors(angle, relative)[1:] == pytest.approx(wanted, rel=1e-9)
    bias = 1 - means[0]
    assert sum(wanted) + bias**2 == pytest.approx(gaussian_square(angle, relative), rel=1e-12)


def test_the_exact_variances_at_section_5_are_the_published_pair_of_numbers():
    _, along, across = gaussian_errors(math.radians(0.5), 0.05)
    assert along == pytest.approx(0.002499812528, rel=1e-9)
    assert across == pytest.approx(7.633892714e-5, rel=1e-9)


def test_the_exact_trace_at_section_5_is_the_published_pair_of_numbers():
    decision = decided("eq_14_trace_exact")
    assert decision.sharp_value == pytest.approx(0.002576152905, rel=1e-9)
    assert decision.printed_value == pytest.approx(0.002576154355, rel=1e-9)


def test_the_measured_distance_is_too_long_in_the_mean_square():
    rho, k = 100.0, 0.05
    mean = float(np.sum(WEIGHTS * ((rho + rho * k * NODES) * k) ** 2))
    assert mean / (rho * k) ** 2 == pytest.approx(decided("eq_14_sigma").printed_value)


def test_unlike_copies_reach_the_least_common_value():
    common = min((x - 1) ** 2 + (x + 1) ** 2 for x in np.linspace(-3, 3, 6001))
    assert common == pytest.approx(2)
    assert (2 - 1) ** 2 + (0 + 1) ** 2 == 2


def test_terms_across_parts_spoil_the_sum():
    rng = np.random.default_rng(5)
    half, d = rng.normal(size=(4, 4)), rng.normal(size=4)
    h, a = half @ half.T, np.diag([1.0, 1, 0, 0])
    b = np.eye(4) - a
    block = a @ h @ a + b @ h @ b
    for matrix, equal in ((block, True), (h, False)):
        parts = (a @ d) @ matrix @ (a @ d) + (b @ d) @ matrix @ (b @ d)
        assert math.isclose(parts, d @ matrix @ d) is equal


def test_a_constraint_of_lower_rank_has_no_certificate():
    """With an incomplete basis the completeness that the checker multiplies out fails."""
    files = decided("eq_6_reduced").certificates
    inputs = files["cyclic_spsa.eq_6_reduced_formation"]["inputs"]
    short = inputs | {"N": [row[:1] for row in inputs["N"]], "W": [["1/2"]]}
    with pytest.raises(CertificateError):
        replayed("eq_6_reduced_formation", short, "PROVED")
