"""The implicit step: the minimiser by its optimality conditions, by a second road, and its laws."""

import math
from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, networks, rationals, trees
from verification.exact.cuts.extreme import slowest, threshold
from verification.exact.runs.prox import (
    centred,
    explicit_step,
    implicit_step,
    proximal,
)

from .tree_prox import tree_prox

LENGTHS = rationals(0, 3, 6)
FEW = settings(max_examples=30)


def numbers(draw, n, most=3, denominator=4):
    return [draw(rationals(-most, most, denominator)) for _ in range(n)]


def square(x):
    return sum(v * v for v in x)


@st.composite
def steps(draw, drawn):
    network = draw(drawn)
    return network, numbers(draw, network.n), draw(LENGTHS)


def assert_optimal(network, y, length, found):
    """y - x = B f with f on the edges a subgradient of length TV at x."""
    left = list(y)
    pairs = zip(network.edges.tolist(), network.exact_weights(), found.flows, strict=True)
    for (i, j), w, flow in pairs:
        gap = found.values[i] - found.values[j]
        assert abs(flow) <= length * w
        assert flow * gap == length * w * abs(gap)
        left[i], left[j] = left[i] - flow, left[j] + flow
    assert tuple(left) == found.values


@given(steps(networks(1, 9, weighted=True)))
@FEW
def test_the_flow_proves_the_minimiser(step):
    network, y, length = step
    assert_optimal(network, y, length, proximal(network, y, length))


@pytest.mark.parametrize("family", ["random_geometric:150,0.15,3", "karate", "grid:9,8"])
@pytest.mark.parametrize("length", [Fraction(1, 50), Fraction(2, 3), Fraction(7)])
def test_larger_networks_are_solved_exactly(family, length):
    network, rng = read_network(family), np.random.default_rng(5)
    y = [Fraction(int(v), 1000) for v in rng.integers(-9999, 9999, network.n)]
    found = proximal(network, y, length)
    assert_optimal(network, y, length, found)
    assert max(found.values) - min(found.values) < max(y) - min(y)


@given(steps(trees(1, 9, weighted=True)))
@FEW
def test_on_trees_dynamic_programming_finds_the_same(step):
    assert implicit_step(*step) == tree_prox(*step)


@given(steps(networks(1, 8, weighted=True)), st.data())
@FEW
def test_the_mean_of_each_component_is_kept_whatever_the_push(step, data):
    network, x, _ = step
    push = numbers(data.draw, network.n)
    for after in (implicit_step(*step, push), explicit_step(*step, push)):
        for nodes in network.components():
            assert sum(after[i] for i in nodes) == sum(x[i] for i in nodes)


@given(steps(connected_networks(2, 7, weighted=True)), st.data())
@FEW
def test_the_implicit_step_brings_any_two_states_together(step, data):
    network, x, length = step
    y = numbers(data.draw, network.n)
    images = implicit_step(network, x, length), implicit_step(network, y, length)
    assert square(a - b for a, b in zip(*images, strict=True)) <= square(
        a - b for a, b in zip(x, y, strict=True)
    )


def worst_cut(network, push):
    """Largest |push(S)|/k of a cut, the norm of M push that is polar to total variation."""
    push = centred(network, push)
    links = list(zip(network.edges.tolist(), network.exact_weights(), strict=True))
    loads = []
    for size in range(1, network.n):
        for inside in combinations(range(network.n), size):
            k = sum(w for (i, j), w in links if (i in inside) != (j in inside))
            loads.append(abs(sum(push[i] for i in inside)) / k)
    return max(loads)


@given(connected_networks(2, 6, weighted=True), st.data())
@FEW
def test_agreement_is_kept_up_to_the_worst_cut_of_the_push_and_not_beyond(network, data):
    push, zero = numbers(data.draw, network.n), [Fraction(0)] * network.n
    worst = worst_cut(network, push)
    assert not any(implicit_step(network, zero, worst, push))
    if worst:
        assert any(implicit_step(network, zero, worst * Fraction(999, 1000), push))


def driving(cut, bounds):
    """The disturbance that drives the sides of a cut apart."""
    return [bound if i in cut else -bound for i, bound in enumerate(bounds)]


@given(connected_networks(2, 7, weighted=True), st.data())
@FEW
def test_the_threshold_is_that_of_continuous_time_at_every_step(network, data):
    gamma = [data.draw(rationals(0, 3, 4)) for _ in range(network.n)]
    h = data.draw(rationals(Fraction(1, 9), 9, 9))
    sharp, zero = threshold(network, gamma), [Fraction(0)] * network.n
    push = [h * u for u in driving(sharp.cut, gamma)]
    assert not any(implicit_step(network, zero, h * sharp.value, push))
    if sharp.value:
        assert any(implicit_step(network, zero, h * sharp.value * Fraction(999, 1000), push))


@st.composite
def fast_enough(draw):
    """A network, bounds, a gain above the threshold, a step, and the slowest cut with r^2."""
    network = draw(connected_networks(2, 6, weighted=True))
    gamma = [draw(rationals(0, 2, 3)) for _ in range(network.n)]
    beta = threshold(network, gamma).value + draw(rationals(Fraction(1, 5), 3, 5))
    start = [Fraction(1), *[Fraction(0)] * (network.n - 1)]
    found = slowest(network, gamma, beta, start)
    rate_squared = square(centred(network, start)) / found.value
    return network, gamma, beta, draw(rationals(Fraction(1, 9), 2, 9)), found.cut, rate_squared


@given(fast_enough(), st.data())
@FEW
def test_each_implicit_step_shortens_the_error_by_its_share(case, data):
    """|x+| <= max(0, |x| - h r), squared so that nothing is rounded."""
    network, gamma, beta, h, _, rate_squared = case
    x = centred(network, numbers(data.draw, network.n))
    push = [h * data.draw(st.fractions(-g, g, max_denominator=4)) for g in gamma]
    after = square(implicit_step(network, x, h * beta, push))
    before, share = square(x), h * h * rate_squared
    if before <= share:
        assert after == 0
    else:  # sqrt(after) <= sqrt(before) - sqrt(share)
        slack = before + share - after
        assert slack >= 0
        assert slack**2 >= 4 * before * share


@given(fast_enough(), rationals(Fraction(1, 7), 4, 7))
@FEW
def test_the_number_of_steps_is_attained_on_the_ray_of_the_slowest_cut(case, length):
    network, gamma, beta, h, cut, rate_squared = case
    share = Fraction(len(cut), network.n)
    x = tuple(length * ((i in cut) - share) for i in range(network.n))
    push = [h * u for u in driving(cut, gamma)]
    due = square(x) / (h * h * rate_squared)
    steps = math.isqrt(math.ceil(due) - 1) + 1  # the root, rounded up
    for _ in range(steps):
        assert any(x)
        x = implicit_step(network, x, h * beta, push)
    assert not any(x)


def test_the_explicit_step_of_two_sensors_never_agrees_and_the_implicit_one_does():
    pair, length = read_network("complete:2"), Fraction(1, 10)
    x = y = (Fraction(3, 20), Fraction(-3, 20))
    for k in range(20):
        x, y = explicit_step(pair, x, length), implicit_step(pair, y, length)
        assert x == ((-1) ** k * Fraction(1, 20), -((-1) ** k) * Fraction(1, 20))
        assert any(y) == (k == 0)


def test_a_step_of_length_zero_changes_nothing_and_a_long_one_levels_all():
    network = Network(list("abcd"), np.array([[0, 1], [1, 2]]))
    y = [Fraction(v) for v in (1, 5, 0, 7)]
    assert implicit_step(network, y, Fraction(0)) == tuple(y)
    assert implicit_step(network, y, Fraction(9)) == (2, 2, 2, 7)
