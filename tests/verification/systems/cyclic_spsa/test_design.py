"""Designs: what is certified is checked again, and what is best is compared with neighbours."""

from fractions import Fraction

import pytest

from sensortrack.errors import InputError
from verification.certificates import check
from verification.certificates.make import statements
from verification.cli.design import _matching
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.design import DESIGNS
from verification.systems.cyclic_spsa.errors.stationary import MEAN_SQUARE, stationary_mse
from verification.systems.cyclic_spsa.network.errors import ERROR, network_error
from verification.systems.cyclic_spsa.network.limits import LIMITED, network_step_limit

from .networks import PLAIN

BLOCK = {"h": [1, 2], "Xi": "0.5", "eta": ["0.1", 0]}


def choose(**given):
    design = _matching(DESIGNS, {*given})
    return design.answer(read_inputs(design.inputs, given).values)


def mse(gains, **more):
    values = {"h": None, "H": None, "law": "gaussian", **gains, **more}
    return stationary_mse({entry.name: values[entry.name] for entry in MEAN_SQUARE}).value


def valid(found):
    return check.check_document(found.certificate, statements())


@pytest.mark.parametrize("given", [BLOCK | {"beta": 1}, BLOCK | {"beta": 1, "reading": "one"}])
def test_the_step_of_a_block_is_stable_and_neighbours_are_worse(given):
    found = choose(**given)
    entry = valid(found)
    assert entry["verdict"] == found.verdict == "PROVED"
    assert Fraction(entry["inputs"]["alpha"]) == found.gains["alpha"]
    best = mse(found.gains)
    assert best**0.5 == pytest.approx(found.bound["rms"])
    assert best <= found.bound["rms"] ** 2 * (1 + 1e-15)
    for factor in (Fraction(99, 100), Fraction(101, 100)):
        assert mse(found.gains, alpha=found.gains["alpha"] * factor) > best
    assert found.gains["alpha"] < found.bound["step_limit"]


def test_beta_is_the_smallest_that_is_nearly_as_good_as_any():
    found = choose(**BLOCK)
    valid(found)
    beta = found.gains["beta"]
    assert found.gains["reading"] == "two"
    far, near = (choose(**BLOCK, beta=x).bound["rms"] for x in (10**6, beta * Fraction(98, 100)))
    assert found.bound["rms"] <= 1.01 * far
    assert near > 1.01 * far


def test_one_instant_is_chosen_where_the_lag_counts_more_than_the_noise():
    found = choose(Xi="1/100", eta=[10, 0])
    assert found.gains["reading"] == "one"
    assert found.gains["H"] == ((1, 0), (0, 1))
    assert found.bound["rms"] < choose(h=[1, 1], Xi="1/100", eta=[10, 0], beta=10**6).bound["rms"]


def test_units_scale_the_choice():
    one, other = choose(**BLOCK), choose(h=[1, 2], Xi="500000", eta=[100, 0])
    assert other.gains["alpha"] == one.gains["alpha"]
    assert float(other.gains["beta"]) == pytest.approx(1000 * float(one.gains["beta"]), rel=0.01)
    assert other.bound["rms"] == pytest.approx(1000 * one.bound["rms"], rel=1e-3)


def test_the_step_of_a_network_is_below_its_limit_and_neighbours_are_worse():
    moving = PLAIN | {"velocities": [["1/10", 0], [0, 0], ["-1/10", 0]]}
    found = choose(**moving)
    assert Fraction(valid(found)["upper"]) > found.gains["alpha"]
    limit = network_step_limit(read_inputs(LIMITED, moving).values)
    assert found.bound["step_limit"] == limit.lower

    def error(alpha):
        return network_error(read_inputs(ERROR, {**moving, "alpha": alpha}).values).value

    best = error(found.gains["alpha"])
    assert best == pytest.approx(found.bound["rms"])
    for factor in (Fraction(98, 100), Fraction(102, 100)):
        assert error(found.gains["alpha"] * factor) > best


@pytest.mark.parametrize(
    "given, name",
    [
        (BLOCK | {"eta": 0, "beta": 1}, "eta"),
        (BLOCK | {"eta": 0}, "eta"),
        (BLOCK | {"beta": -1}, "beta"),
        (BLOCK | {"law": "flat"}, "law"),
        (PLAIN, "velocities"),
        (PLAIN | {"beta": 0, "velocities": [[1, 0]]}, "beta"),
    ],
)
def test_bad_input_names_what_is_wrong(given, name):
    with pytest.raises(InputError) as caught:
        choose(**given)
    assert caught.value.name == name


@pytest.mark.parametrize("given", [{}, {"Xi": 1}, {"h": [1], "beta": 1, "m_max": 1}])
def test_without_enough_inputs_the_choices_are_listed(given):
    with pytest.raises(InputError) as caught:
        choose(**given)
    assert all(design.summary in caught.value.cure for design in DESIGNS)


def test_the_step_that_removes_the_whole_error_is_not_rounded():
    found = choose(h=[3], eta=[1], beta=1, reading="one")
    assert found.gains["alpha"] == Fraction(1, 3)
    assert found.bound["rms"] < 1e-30


def test_a_drift_that_doubles_hardly_hold_still_gets_a_design():
    found = choose(Xi=0, eta=["1e-300", 0])
    assert found.verdict == "PROVED"
    assert valid(found)["verdict"] == "PROVED"
