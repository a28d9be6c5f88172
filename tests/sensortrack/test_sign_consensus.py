"""The consensus law: its steps against their formulas, what they keep, and what they refuse."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.consensus import SignConsensus
from sensortrack.errors import InputError
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, networks

SIX = np.array([1.0, 2.0, 0.5, 3.0, 0.25, 1.5])


def incidence(network: Network) -> np.ndarray:
    found = np.zeros((network.n, network.m))
    for e, (i, j) in enumerate(network.edges):
        found[i, e], found[j, e] = 1, -1
    return found


def weights(network: Network) -> np.ndarray:
    return np.array([float(w) for w in network.weights or [1] * network.m])


def signals(seed: int, steps: int, n: int, width: int) -> np.ndarray:
    """Random walks with small whole numbers, so that equal values occur."""
    rng = np.random.default_rng(seed)
    return np.cumsum(rng.integers(-2, 3, size=(steps, n, width)), axis=0).astype(float)


@given(networks(weighted=True), st.integers(1, 9), st.integers(0, 99))
def test_an_explicit_step_is_the_dense_formula(network, width, seed) -> None:
    law = SignConsensus(network, 2.0, 0.25, "explicit")
    b, a = incidence(network), weights(network)
    r = signals(seed, 4, network.n, width)
    state = law.init(r[0])
    w, x = state.w, state.x
    for now in r[1:]:
        state = law.step(state, now)
        w = w - 0.5 * b @ (a[:, None] * np.sign(b.T @ x))
        x = w + now
        # sums of at most seven weights below 10, in another order
        assert np.allclose(state.w, w, rtol=0, atol=1e-13)
        assert np.allclose(state.x, x, rtol=0, atol=1e-13)
        x = state.x


@given(connected_networks(min_nodes=2, weighted=True), st.integers(0, 99))
def test_an_implicit_step_satisfies_the_optimality_conditions(network, seed) -> None:
    law = SignConsensus(network, [1.0, 0.1], 0.5)
    r = np.random.default_rng(seed).normal(size=(3, network.n, 2))
    state = law.init(r[0])
    for now in r[1:]:
        y = state.w + now
        state = law.step(state, now)
        assert state.status.exact
        b, links = incidence(network), state.links
        flow = np.empty((2, network.m))
        flow[:, links.rank] = state.flows
        limit = 0.5 * np.outer([1.0, 0.1], weights(network))
        fall = (b.T @ state.x).T
        assert np.allclose(y - b @ flow.T, state.x, rtol=0, atol=1e-13)
        assert (np.abs(flow) <= limit).all()
        assert np.allclose(flow * fall, limit * np.abs(fall), rtol=0, atol=1e-13)


@pytest.mark.parametrize("graph", ["path:6", "complete:5", "grid:4,4", "star:7", "petersen"])
@pytest.mark.parametrize("method", ["implicit", "explicit"])
def test_the_sum_of_w_stays_zero(graph: str, method: str) -> None:
    network = read_network(graph)
    law = SignConsensus(network, SIX, 0.1, method)
    r = np.random.default_rng(1).normal(size=(50, network.n, 6))
    state = law.init(r[0])
    for now in r[1:]:
        state = law.step(state, now)
    assert np.abs(state.w.sum(axis=0)).max() < 50 * network.n * 2.0**-50


@pytest.mark.parametrize("graph", ["path:6", "complete:5", "grid:4,4", "star:7", "petersen"])
def test_implicit_steps_agree_exactly_and_explicit_ones_do_not(graph: str) -> None:
    network = read_network(graph)
    found = {}
    for method in ("implicit", "explicit"):
        law = SignConsensus(network, 3.0, 0.1, method)
        r = np.random.default_rng(2).normal(size=(network.n, 3))
        state = law.init(r)
        for _ in range(100):
            state = law.step(state, r)
        found[method] = np.ptp(state.x, axis=0)
        assert (np.linalg.norm(state.x - r.mean(axis=0), axis=0) <= law.chatter + 1e-12).all()
    assert (found["implicit"] == 0).all()
    assert (found["explicit"] > 0).all()


def test_each_component_of_a_network_agrees_on_its_own_mean() -> None:
    network = Network(["a", "b", "c", "d", "e"], np.array([[0, 2], [1, 3]]))
    r = np.array([[1.0], [2.0], [5.0], [8.0], [7.0]])
    law = SignConsensus(network, 10.0, 1.0)
    state = law.step(law.init(r), r)
    assert state.x.ravel().tolist() == [3.0, 5.0, 3.0, 5.0, 7.0]


@pytest.mark.parametrize("method", ["implicit", "explicit"])
def test_a_link_that_does_not_carry_is_as_good_as_none(method: str) -> None:
    network = read_network("cycle:5")
    less = Network(network.names, network.edges[[0, 1, 3, 4]])
    r = np.random.default_rng(3).normal(size=(2, 5, 2))
    law = SignConsensus(network, 0.7, 0.2, method)
    start = law.init(r[0])
    masked = law.step(start, r[1], active=[True, True, False, True, True])
    other = law.step(start, r[1], network=less)
    assert np.allclose(masked.x, other.x, rtol=0, atol=1e-15)
    assert not np.allclose(masked.x, law.step(start, r[1]).x, rtol=0, atol=1e-3)


def test_a_link_heard_one_way_moves_the_mean_for_ever() -> None:
    network = read_network("path:3")
    law = SignConsensus(network, 1.0, 0.5, "explicit")
    r = np.array([[3.0], [0.0], [0.0]])
    state = law.step(law.init(r), r, active=[[False, True], [True, True]])
    assert state.w.ravel().tolist() == [0.0, 0.5, 0.0]


@pytest.mark.parametrize(
    "change, name",
    [
        ({"beta": -1.0}, "beta"),
        ({"beta": [1.0, np.inf]}, "beta"),
        ({"beta": [[1.0]]}, "beta"),
        ({"h": 0.0}, "h"),
        ({"h": np.nan}, "h"),
        ({"method": "midpoint"}, "method"),
        ({"tolerance": -1.0}, "tolerance"),
        ({"iterations": 0}, "iterations"),
        ({"iterations": 2.5}, "iterations"),
    ],
)
def test_a_bad_law_is_refused(change: dict[str, object], name: str) -> None:
    with pytest.raises(InputError) as caught:
        SignConsensus(**{"network": read_network("path:3"), "beta": 1.0, "h": 0.1} | change)
    assert caught.value.name == name


@pytest.mark.parametrize(
    "r, w, name",
    [
        ([1.0, 2.0, 3.0], None, "r"),
        (np.zeros((2, 2)), None, "r"),
        (np.zeros((3, 3)), None, "r"),
        ([[1.0, 2.0], [np.nan, 0.0], [0.0, 0.0]], None, "r"),
        (np.zeros((3, 2)), np.ones((3, 2)), "w"),
        (np.zeros((3, 2)), np.zeros((3, 1)), "w"),
        (np.zeros((3, 2)), np.full((3, 2), np.inf), "w"),
    ],
)
def test_a_bad_start_is_refused(r: object, w: object, name: str) -> None:
    law = SignConsensus(read_network("path:3"), [1.0, 2.0], 0.1)
    with pytest.raises(InputError) as caught:
        law.init(r, w)
    assert caught.value.name == name


@pytest.mark.parametrize(
    "r, options, name",
    [
        (np.zeros((3, 1)), {}, "r"),
        (np.full((3, 2), np.nan), {}, "r"),
        (np.zeros((3, 2)), {"network": read_network("path:4")}, "graph"),
        (np.zeros((3, 2)), {"active": [True]}, "active"),
        (np.zeros((3, 2)), {"active": [1, 0]}, "active"),
        (np.zeros((3, 2)), {"active": np.ones((2, 2), dtype=bool)}, "active"),
    ],
)
def test_a_bad_step_is_refused(r: object, options: dict[str, object], name: str) -> None:
    law = SignConsensus(read_network("path:3"), 1.0, 0.1)
    with pytest.raises(InputError) as caught:
        law.step(law.init(np.zeros((3, 2))), r, **options)
    assert caught.value.name == name
