"""The step with the least error: a search in floats, an approximation, closed forms, scaling."""

from fractions import Fraction
from math import sqrt

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from sensortrack.errors import InputError
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.errors.best_step import best_step
from verification.systems.cyclic_spsa.errors.stationary import BEST, stationary_mse

FULL = [["2", "0.5"], ["0.5", "1"]]
NOISE = [["0.3", "0.1"], ["0.1", "0.2"]]
BASE = {"H": FULL, "Xi": NOISE, "beta": "0.8", "eta": ["0.01", "-0.02"]}


def question(given_):
    return read_inputs(BEST, given_, None, "cyclic_spsa.best_step").values


def best(**given_):
    return best_step(question(given_)).value


@pytest.mark.parametrize("more", [{}, {"law": "two_point"}, {"reading": "one"}, {"k": "3"}])
def test_no_step_of_a_search_is_better(more):
    given_ = {**BASE, **more}
    alpha, error = best(**given_)
    values = question(given_)

    def square(x):
        found = stationary_mse({**values, "alpha": Fraction(x)}, certified=False).value
        return 1e9 if found == "inf" else found

    found = minimize_scalar(square, bounds=(0, 1), method="bounded", options={"xatol": 1e-9})
    assert alpha == pytest.approx(found.x, rel=1e-5)
    assert error == pytest.approx(sqrt(found.fun), rel=1e-12)
    assert all(square(alpha * (1 + x)) > square(alpha) for x in (-1e-6, 1e-6))


def test_small_drifts_have_the_cube_root_law():
    d, variance, beta = 2, 0.1, 1.0
    kappa = 1 + variance / (2 * beta**2)
    for drift in (1e-6, 1e-9):
        rule = (8 * (2 * drift) ** 2 / (d * d * variance * kappa)) ** (1 / 3)
        found = best(h=[1, 1], Xi="0.1", beta=1, eta=[str(drift), 0])[0]
        assert found == pytest.approx(rule, rel=10 * drift ** (2 / 3))


def test_one_coordinate_without_noise_is_reached_in_one_step():
    assert best(h=["4"], beta=1, eta=["0.5"], reading="one") == [0.25, 0.0]


def test_one_coordinate_has_the_root_of_its_cubic():
    # D = k = h = 1, no noise: (c/alpha - w)^2 + N c^2 (1/alpha)/(2 - alpha (1 + N))
    eta, beta = 0.5, 1.0
    n, c, w = eta**2 / (4 * beta**2), 2 * eta, 1.5 * eta
    x = np.linspace(1.2, 1.3, 200_001)
    errors = (c / x - w) ** 2 + n * c**2 / (x * (2 - x * (1 + n)))
    alpha, error = best(h=[1], beta=1, eta=["0.5"])
    assert alpha == pytest.approx(x[errors.argmin()], abs=1e-6)
    assert error == pytest.approx(sqrt(errors.min()), rel=1e-10)


def random_block(d):
    rng = np.random.default_rng(d)
    half = rng.integers(-5, 6, (d, 2 * d))
    return half @ half.T, rng.integers(-3, 4, d), rng.permutation(d)


def test_relabelled_coordinates_have_the_same_best_step():
    hessian, eta, order = random_block(5)
    first = best(H=hessian.tolist(), beta=5, eta=eta.tolist(), Xi=2)
    turned = hessian[np.ix_(order, order)]
    assert best(H=turned.tolist(), beta=5, eta=eta[order].tolist(), Xi=2) == pytest.approx(
        first, rel=1e-13
    )


def test_large_block_is_worse_on_both_sides():
    hessian, eta, _ = random_block(13)
    given_ = {"H": hessian.tolist(), "beta": 5, "eta": eta.tolist(), "Xi": 2}
    alpha, error = best(**given_)
    squares = [
        stationary_mse({**question(given_), "alpha": Fraction(alpha * (1 + x))}).value
        for x in (-1e-4, 0, 1e-4)
    ]
    assert squares[1] == pytest.approx(error**2, rel=1e-13)
    assert squares[1] < min(squares[0], squares[2])


def test_units_scale_the_best_step_and_its_error():
    alpha, error = best(**BASE)
    far = best(
        H=[["2e40", "0.5e40"], ["0.5e40", "1e40"]],
        Xi=[["0.3e80", "0.1e80"], ["0.1e80", "0.2e80"]],
        beta="0.8e40",
        eta=["0.01e40", "-0.02e40"],
    )
    assert far == pytest.approx([alpha * 1e-40, error * 1e40], rel=1e-13)


def test_drifts_far_below_the_noise_have_a_step_or_no_word():
    given_ = {"h": [1, 1], "beta": 1, "Xi": 1}
    tiny = best(**given_, eta=["1e-200", 0])[0]
    rule = (8 * 4 / (4 * 1.5)) ** (1 / 3)
    assert tiny * 1e133 == pytest.approx(rule * 10 ** (-1 / 3), rel=1e-10)
    far = {**given_, "Xi": "1e380", "beta": "1e190", "eta": ["1e-390", 0]}
    assert best_step(question(far)).verdict == "UNDECIDED"


def test_bounds_are_close():
    answer = best_step(question(BASE))
    certified = next(note for note in answer.notes if note.startswith("certified"))
    low, high = (float(x) for x in certified.split(":")[1].split(";")[0].split(" to "))
    assert low < answer.value[0] < high
    assert high - low < 1e-14 * high


def test_there_is_no_best_step_without_drift():
    answer = best_step(question({**BASE, "eta": 0}))
    assert answer.value == [0, 0]
    assert "no step is the best" in answer.notes[0]


@pytest.mark.parametrize("name, bad", [("law", "levy"), ("beta", "0"), ("reading", "three")])
def test_best_step_refuses_what_it_does_not_know(name, bad):
    with pytest.raises(InputError) as raised:
        best(**{**BASE, name: bad})
    assert raised.value.name == name
