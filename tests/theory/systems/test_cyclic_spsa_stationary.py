"""The parts of the stationary equation, derived, beside enumeration over all signs."""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from theory.algebra.moments.laws import gaussian, symmetric, two_point
from theory.algebra.noncommuting import letters
from theory.systems.cyclic_spsa.error import SYMMETRIC, error_step
from theory.systems.cyclic_spsa.stationary import (
    excess,
    kick_of_mean,
    kick_of_noise,
    mean_step,
    own_noise,
)

(Q,) = letters("Q", SYMMETRIC)


@pytest.mark.parametrize("instants", [1, 2])
def test_mean_error_follows_the_gradient(instants):
    assert str(mean_step(instants)) == "1 - alpha*H"


@pytest.mark.parametrize("instants", [1, 2])
def test_noise_enters_as_if_the_target_had_moved_by_it(instants):
    assert own_noise(instants)


def test_what_the_mean_drives_is_what_the_noise_drives_less_its_own_square():
    assert (kick_of_noise() - kick_of_mean()).terms == Q.terms
    assert str(kick_of_noise()) == "2*Q - 2*diag(Q) + trace(Q)*I + trace(Q*N)*I"


def test_offset_is_linear_in_chi():
    assert {word.count("chi") + word.count("chi'") for _, word in error_step(2).offset.terms} == {1}


@pytest.mark.parametrize(
    "law, wanted",
    [(two_point(1), Fraction(-1, 4)), (gaussian(1), 0), (symmetric([1, 5]), Fraction(1, 4))],
)
def test_excess_is_an_eighth_of_that_of_the_fourth_moment(law, wanted):
    assert excess(law) == wanted


def test_excess_is_what_enumeration_gives():
    # e_i = -1 or 1: E (nu'H chi)^2 over all pairs of noises, less what independent ones would have
    beta, half = 0.7, np.array([[0.6, 0.2], [0.2, 0.5]])
    hessian, noise = np.array([[2.0, 0.5], [0.5, 1.0]]), half @ half
    corners = [half @ np.array(e) for e in product((-1.0, 1.0), repeat=2)]
    squares = [((x - y) @ hessian @ (x + y) / (4 * beta)) ** 2 for x in corners for y in corners]
    independent = np.trace(hessian @ noise @ hessian @ noise) / (4 * beta**2)
    inner = np.diag(half @ hessian @ half)
    wanted = float(excess(two_point(1))) / beta**2 * (inner**2).sum()
    assert np.mean(squares) - independent == pytest.approx(wanted, rel=1e-12)
