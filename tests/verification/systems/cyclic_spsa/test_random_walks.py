"""Targets that make random steps: the closed form of one coordinate, enumeration, simulation."""

from fractions import Fraction
from itertools import product
from math import sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from tests.verification.systems.cyclic_spsa.literal import LAWS, root
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.errors.random_walks import WALK, random_walk_mse
from verification.systems.cyclic_spsa.errors.stationary import MEAN_SQUARE, stationary_mse

PARTS = st.fractions(Fraction(1, 10), Fraction(3), max_denominator=10)


def question(given_):
    return read_inputs(WALK, given_, None, "cyclic_spsa.random_walk_mse").values


def mse(**given_):
    return random_walk_mse(question(given_)).value


@settings(max_examples=30, deadline=None)
@given(PARTS, PARTS, PARTS, PARTS, st.fractions(Fraction(1, 20), Fraction(19, 20)))
def test_one_coordinate_has_its_closed_form(h, variance, w, beta, part):
    n = variance / (2 * beta**2) + w / (4 * beta**2)
    alpha = 2 * part / (h * (1 + n))
    x = alpha * h
    above = 2 * w - 3 * x * w
    above += x * x * ((1 + n) * (5 * w / 4 + variance / 2) + w * w / (8 * beta**2))
    wanted = above / (2 * x - x * x * (1 + n))
    texts = {"Xi": variance, "W": w, "beta": beta, "alpha": alpha}
    assert mse(h=[str(h)], **{k: str(v) for k, v in texts.items()}) == float(wanted)


def test_one_coordinate_has_the_value_of_an_earlier_computation():
    found = mse(h=[1], Xi="0.5", W=1, beta=1, alpha="0.1")
    assert found == pytest.approx(9.317568, rel=1e-7)


@pytest.mark.parametrize(
    "beta, alpha, error", [("0.3", "0.01", 10.021353), ("0.3", "1e-4", 100.0019)]
)
def test_errors_without_noise_have_the_values_of_an_earlier_computation(beta, alpha, error):
    assert sqrt(mse(h=[1], W=1, beta=beta, alpha=alpha)) == pytest.approx(error, rel=1e-6)


HESSIAN = [["2", "0.5"], ["0.5", "1"]]
NOISE = [["0.3", "0.1"], ["0.1", "0.2"]]
WALKS = [["0.02", "0.01"], ["0.01", "0.03"]]


def floats(rows):
    return np.array([[float(x) for x in row] for row in rows])


def settled(k, instants, beta=0.8, alpha=0.15):
    """The mean square over all outcomes of the draws, from update to update."""
    h, noise, walk = (floats(rows) for rows in (HESSIAN, NOISE, WALKS))
    half, stride = root(noise), root(walk)
    points, weights = LAWS["gaussian"]
    draws = [(np.array(x), np.prod(p)) for x, p in zip(
        product(points, repeat=2), product(weights, repeat=2), strict=True)]  # fmt: skip
    signs = np.array(list(product((-1.0, 1.0), repeat=2)))
    cases = []
    for later, p in draws:
        for before, q in draws if instants == 2 else [(later, 1.0)]:
            for move, r in draws if instants == 2 else [(np.zeros(2), 1.0)]:
                cases += [
                    (s, half @ before, half @ later, stride @ move, p * q * r / 4) for s in signs
                ]
    delta, xi_before, xi_later, moves, chances = (np.array(x) for x in zip(*cases, strict=True))
    spread = np.zeros((2, 2))
    for _ in range(400):
        waiting = spread + (2 * k - (instants - 1)) * walk
        arms = root(waiting) * 2**0.5
        new = np.zeros((2, 2))
        for error in [sign * arm for arm in arms for sign in (-1, 1)]:
            first = error - beta * delta - xi_before
            second = error + beta * delta - moves - xi_later
            change = ((second @ h * second) - (first @ h * first)).sum(axis=1) / 2
            after = error - alpha * delta * (change / (2 * beta))[:, None] - moves
            new += after.T @ (chances[:, None] * after) / 4
        done = abs(new - spread).max() < 1e-14
        spread = new
        if done:
            break
    return np.trace(spread)


@pytest.mark.parametrize("k, instants", [(1, 2), (2, 2), (2, 1)])
def test_full_blocks_settle_where_the_algorithm_does(k, instants):
    given_ = {"H": HESSIAN, "Xi": NOISE, "W": WALKS, "beta": "0.8", "alpha": "0.15"}
    found = mse(**given_, k=k, reading={1: "one", 2: "two"}[instants])
    assert found == pytest.approx(settled(k, instants), rel=1e-9)


def test_a_target_at_rest_leaves_the_error_of_the_noise():
    given_ = {"H": HESSIAN, "Xi": NOISE, "beta": "0.8", "alpha": "0.15"}
    still = read_inputs(MEAN_SQUARE, given_, None, "cyclic_spsa.stationary_mse").values
    assert mse(**given_, W=0) == stationary_mse(still).value


def test_error_is_infinite_from_the_limit_on():
    # N = W/(4 beta^2) = 1/4: alpha h (1 + N) = 2 at 8/5
    assert mse(h=[1], W=1, beta=1, alpha="1.6") == "inf"
    assert mse(h=[1], W=1, beta=1, alpha="1.599") != "inf"


@pytest.mark.parametrize(
    "bad",
    [{"W": "-1"}, {"W": [["1", "2"], ["2", "1"]]}, {"W": [["1", "0"], ["1", "1"]]}, {"alpha": 0}],
)
def test_random_walks_refuse_what_is_no_covariance(bad):
    given_ = {"H": HESSIAN, "W": 1, "beta": 1, "alpha": "0.1", **bad}
    with pytest.raises(InputError) as raised:
        mse(**given_)
    assert raised.value.name == next(iter(bad))
