"""Errors of whole networks in the long run, target by target, against the closed form."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.errors import InputError
from verification.inputs import read_inputs
from verification.systems.cyclic_spsa.errors.stationary import MEAN_SQUARE
from verification.systems.cyclic_spsa.network.errors import ERROR, network_error
from verification.systems.cyclic_spsa.network.inputs import network_of
from verification.systems.cyclic_spsa.network.limits import LIMITED, network_step_limit
from verification.systems.cyclic_spsa.network.plans import block_of_plan, plans_of
from verification.systems.cyclic_spsa.running.confirmed import confirm_mean_square

from .networks import PLAIN, networks

DRIFT = st.tuples(st.integers(-3, 3), st.integers(-3, 3)).map(lambda v: [f"{x}/10" for x in v])


def ask(**given):
    return network_error(read_inputs(ERROR, given).values)


def closed_form(block, alpha):
    """Mean square of each coordinate: Gaussian noise, diagonal Hessian, entry by entry."""
    h = np.array([float(block.hessian[i][i]) for i in range(block.size)])
    xi = np.array([[float(x) for x in row] for row in block.noise])
    eta, beta, two = np.array(block.drift, float), float(block.beta), block.instants == 2
    c = 2 * block.blocks * eta
    n = xi / (2 * beta**2) + np.outer(eta, eta) / (4 * beta**2) if two else np.zeros_like(xi)
    z = xi / 2 if two else xi
    mean = -c / (alpha * h)
    sides = np.add.outer(1 / (alpha * h), 1 / (alpha * h)) - 1
    hh = np.outer(h, h)
    a = (np.outer(c, c) * sides + 2 * alpha**2 * hh * z) / (
        alpha * np.add.outer(h, h) - 2 * alpha**2 * hh
    )
    own = mean**2 - c**2 / (2 * alpha * h)
    g = np.trace(np.diag(h) @ z @ np.diag(h) @ n)
    cross = (hh * n * a).sum() - (np.diag(hh * n * a)).sum()
    load = (h * (1 + np.diag(n))).sum()
    top = (h**2 * (1 + np.diag(n)) * own).sum() + (h**2 * np.diag(z)).sum() + g + cross
    s = top / (1 - alpha / 2 * load)
    w = (2 * block.blocks - (0.5 if two else 0)) * eta
    return own + alpha * s / (2 * h) + 2 * w * mean + w**2


@settings(max_examples=25, deadline=None)
@given(networks(), DRIFT, st.sampled_from(["1/7", "1/2", "6/7"]))
def test_errors_are_those_of_the_closed_form(data, drift, part):
    data = data | {"velocities": [drift]}
    limit = Fraction(network_step_limit(read_inputs(LIMITED, data).values).exact["value"])
    alpha = limit * Fraction(part)
    network = network_of(read_inputs(LIMITED, data).values)
    squares = []
    found = ask(**data, alpha=alpha)
    table = found.more["sensors"]().data
    for plan in plans_of(network):
        for place, targets in enumerate(plan.blocks.blocks):
            mean = closed_form(block_of_plan(network, plan, place), float(alpha))
            pairs = mean.reshape(-1, 2).sum(axis=1)
            squares += [*pairs]
            rms = [table[plan.own]["rms"][str(i)] for i in targets]
            assert rms == pytest.approx(np.sqrt(pairs), rel=1e-7)
    assert found.value == pytest.approx(np.sqrt(np.mean(squares)), rel=1e-7)
    assert found.lower <= found.value <= found.upper


@pytest.mark.parametrize("assignment", ["nearest", "best"])
def test_a_simulated_block_of_the_network_has_the_errors_of_the_table(assignment):
    data = PLAIN | {"assignment": assignment, "velocities": [["1/10", "1/5"]], "alpha": "1/5"}
    without = {name: value for name, value in data.items() if name != "alpha"}
    critical = network_step_limit(read_inputs(LIMITED, without).values).more["critical"]().data
    values = read_inputs(MEAN_SQUARE, critical["params"] | {"alpha": "1/5"}).values
    found = confirm_mean_square(values, width=0.05, seed=11)
    own = ask(**data).more["sensors"]().data[critical["sensor"]]
    block = own["blocks"][critical["block"]]
    assert found.interval.holds(sum(own["rms"][i] ** 2 for i in block))


def test_a_step_beyond_the_limit_names_the_sensor():
    limit = Fraction(network_step_limit(read_inputs(LIMITED, PLAIN).values).exact["value"])
    assert ask(**PLAIN, alpha=limit * Fraction(999, 1000)).value < float("inf")
    found = ask(**PLAIN, alpha=limit)
    assert found.value == "inf"
    assert "sensor 0" in found.notes[0]
    table = found.more["sensors"]().data
    assert set(table[0]["rms"]) < set(table[1]["rms"])


def test_two_point_noise_leaves_no_more_than_gaussian_noise():
    plain = PLAIN | {"alpha": "0.1", "beta": 2}
    two, gauss = (ask(**plain, law=law).value for law in ("two_point", "gaussian"))
    assert 0 < two < gauss


def test_bad_input_names_what_is_wrong():
    for wrong, name in (({"alpha": 0}, "alpha"), ({"alpha": 1, "law": "flat"}, "law")):
        with pytest.raises(InputError) as caught:
            ask(**PLAIN | wrong)
        assert caught.value.name == name
