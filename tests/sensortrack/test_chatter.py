"""How far explicit steps keep agents apart."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.consensus import SignConsensus, chatter_bound
from sensortrack.errors import InputError
from sensortrack.kernels.links import links_of
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks

PAIR = links_of(read_network("path:2"))


@settings(max_examples=50)
@given(connected_networks(min_nodes=2, max_nodes=6, weighted=True), st.integers(0, 99))
def test_runs_end_below_the_bound(network, seed) -> None:
    """Constant signals, and signals that part ways at random, against a gain that holds them."""
    rng = np.random.default_rng(seed)
    n, h = network.n, 0.125
    lightest = min(float(w) for w in network.weights) if network.weights else 1.0
    for gamma in (0.0, 0.5):
        beta = gamma * n / lightest + 1
        law = SignConsensus(network, beta, h, "explicit")
        bound = chatter_bound(law.links, law.gains, h, gamma)[0]
        assert np.isfinite(bound)
        r = lightest * rng.normal(size=(n, 1))  # so near that 100 samples bring them together
        state = law.init(r)
        for k in range(200):
            r = r + h * gamma * rng.choice([-1.0, 1.0], size=(n, 1))
            state = law.step(state, r)
            if k >= 100:
                assert np.linalg.norm(state.x - r.mean()) <= bound + 1e-9


def test_two_agents_come_as_close_to_the_bound_as_one_likes() -> None:
    law = SignConsensus(read_network("path:2"), 1.0, 0.1, "explicit")
    assert law.chatter == pytest.approx([0.1 * np.sqrt(2)], rel=1e-15)
    assert law.jump == pytest.approx([0.1], rel=1e-15)
    r = np.array([[1e-9], [-1e-9]])
    state = law.step(law.init(r), r)
    assert np.linalg.norm(state.x) == pytest.approx(law.chatter[0], rel=1e-7)


def test_implicit_steps_do_not_chatter() -> None:
    assert SignConsensus(read_network("path:2"), [1.0, 2.0], 0.1).chatter.tolist() == [0.0, 0.0]


def test_the_worst_component_counts() -> None:
    """A path of two, one of three and a node alone."""
    network = Network(list("abcdef"), np.array([[0, 1], [2, 3], [3, 4]]))
    alone = read_network("path:3")
    gains = np.array([1.0, 3.0])
    found = chatter_bound(links_of(network), gains, 0.1)
    assert np.array_equal(found, chatter_bound(links_of(alone), gains, 0.1))
    single = Network(["a"], np.empty((0, 2), dtype=np.int64))
    assert chatter_bound(links_of(single), gains, 0.1).tolist() == [0.0, 0.0]


def test_a_known_rate_sharpens_the_bound_and_a_small_gain_has_none() -> None:
    gains = np.array([1.0])
    links = links_of(read_network("complete:6"))
    assert chatter_bound(links, gains, 0.1, 0.2)[0] > chatter_bound(links, gains, 0.1, 0.2, 4.0)[0]
    assert chatter_bound(PAIR, gains, 0.1, gamma=1.0)[0] == np.inf


@pytest.mark.parametrize("name", ["gamma", "rate"])
@pytest.mark.parametrize("value", [-1.0, np.nan, np.inf])
def test_bad_numbers_are_refused(name: str, value: float) -> None:
    with pytest.raises(InputError) as caught:
        chatter_bound(PAIR, np.array([1.0]), 0.1, **{name: value})
    assert caught.value.name == name
