"""Consensus along differences: the law of the step, agreement, convex sets, turned axes."""

from fractions import Fraction

import numpy as np
import pytest

from sensortrack.consensus import IsotropicConsensus, LinearConsensus, SignConsensus
from sensortrack.errors import InputError
from sensortrack.network_families import family_network
from sensortrack.networks import Network

GRAPHS = ("path:4", "cycle:5", "complete:4", "star:6", "grid:2,3")
H = 0.1


def turn(angle):
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def cost(network, x, y, capacity):
    apart = x[network.edges[:, 0]] - x[network.edges[:, 1]]
    return 0.5 * ((x - y) ** 2).sum() + capacity * np.linalg.norm(apart, axis=1).sum()


@pytest.mark.parametrize("graph", GRAPHS)
@pytest.mark.parametrize("beta", [0.3, 2.0, 30.0])
def test_an_implicit_step_minimises_its_cost(graph, beta):
    """No point nearby is better, by more than the square of the tolerance allows."""
    network, rng = family_network(graph), np.random.default_rng(3)
    law = IsotropicConsensus(network, (beta,), (2,), H)
    y = rng.normal(size=(network.n, 2))
    state = law.step(law.init(np.zeros_like(y)), y)
    least = cost(network, state.x, y, H * beta)
    for size in (1e-3, 1e-2, 1e-1, 1.0):
        for _ in range(20):
            other = state.x + size * rng.normal(size=y.shape)
            assert cost(network, other, y, H * beta) >= least - 1e-12
    mean = np.tile(y.mean(axis=0), (network.n, 1))
    assert least <= min(cost(network, y, y, H * beta), cost(network, mean, y, H * beta)) + 1e-12
    assert state.x.mean(axis=0) == pytest.approx(y.mean(axis=0), abs=1e-14)


@pytest.mark.parametrize("graph", GRAPHS)
def test_blocks_of_one_number_are_sign_consensus(graph):
    network, rng = family_network(graph), np.random.default_rng(4)
    one = IsotropicConsensus(network, (0.8, 3.0), (1, 1), H)
    other = SignConsensus(network, np.array([0.8, 3.0]), H)
    r = rng.normal(size=(network.n, 2))
    first, second = one.init(r), other.init(r)
    for _ in range(12):
        r = r + 0.01 * rng.normal(size=r.shape)
        first, second = one.step(first, r), other.step(second, r)
        assert first.x == pytest.approx(second.x, abs=1e-6)


@pytest.mark.parametrize("graph", GRAPHS)
def test_a_large_gain_gives_exact_agreement_part_by_part(graph):
    network, rng = family_network(graph), np.random.default_rng(5)
    law = IsotropicConsensus(network, (1e4, 1e4), (2, 1), H)
    y = rng.normal(size=(network.n, 3))
    state = law.step(law.init(np.zeros_like(y)), y)
    assert state.status.exact
    assert np.ptp(state.x, axis=0) == pytest.approx(0, abs=1e-14)
    active = np.ones(network.m, dtype=bool)
    active[0] = False
    parts = Network(network.names, network.edges[active]).components()
    state = law.step(law.init(np.zeros_like(y)), y, active=active)
    for part in parts:
        assert state.x[part] == pytest.approx(np.tile(y[part].mean(axis=0), (len(part), 1)))


@pytest.mark.parametrize("method", ["implicit", "explicit"])
def test_turned_signals_give_turned_estimates(method):
    network, rng = family_network("cycle:5"), np.random.default_rng(6)
    law = IsotropicConsensus(network, (1.0,), (2,), H, method)
    plain = law.init(rng.normal(size=(5, 2)))
    other = law.init(plain.x @ turn(0.7).T)
    for _ in range(6):
        r = rng.normal(size=(5, 2))
        plain, other = law.step(plain, r), law.step(other, r @ turn(0.7).T)
        assert other.x == pytest.approx(plain.x @ turn(0.7).T, abs=1e-6)


def test_constant_signals_stay_in_every_convex_set_by_implicit_steps():
    """A disc, a half plane and a strip; explicit steps leave them near agreement only a little."""
    network, rng = family_network("cycle:5"), np.random.default_rng(7)
    for _ in range(6):
        angle = rng.uniform(0, 2 * np.pi, 5)
        r = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        for method, room in (("implicit", 1e-7), ("explicit", H * 0.5 * 2)):
            law = IsotropicConsensus(network, (0.5,), (2,), H, method)
            state = law.init(r)
            for _ in range(15):
                state = law.step(state, r)
                assert np.linalg.norm(state.x, axis=1).max() <= 1 + room
                assert state.x[:, 0].min() >= r[:, 0].min() - room
                assert state.x[:, 1].max() <= r[:, 1].max() + room


def test_an_explicit_step_that_is_not_crowded_is_a_convex_combination():
    """Farthest points in many directions do not move out; a crowded step may leave the hull."""
    network, rng = family_network("complete:4"), np.random.default_rng(13)
    angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    sides, left = np.stack([np.cos(angle), np.sin(angle)]), 0
    for _ in range(200):
        law = IsotropicConsensus(network, (rng.uniform(0.1, 8),), (2,), H, "explicit")
        r = rng.normal(size=(4, 2))
        state = law.init(r)
        after = law.step(state, r)
        out = ((after.x @ sides).max(axis=0) > (state.x @ sides).max(axis=0) + 1e-12).any()
        assert not out or law.crowding(state) > 1
        left += bool(out)
    assert left > 20
    assert law.crowding(law.init(np.zeros((4, 2)))) == np.inf


def test_weights_multiply_the_gain_link_by_link():
    edges, rng = family_network("cycle:4").edges, np.random.default_rng(12)
    weights = (Fraction(1, 2), Fraction(3), Fraction(1), Fraction(2))
    network = Network(["a", "b", "c", "d"], edges, weights)
    r = rng.normal(size=(4, 1))
    one = IsotropicConsensus(network, (0.7,), (1,), H)
    other = SignConsensus(network, 0.7, H)
    first, second = one.init(r), other.init(r)
    for _ in range(4):
        first, second = one.step(first, r), other.step(second, r)
        assert first.x == pytest.approx(second.x, abs=1e-6)
    law = LinearConsensus(network)
    state = law.step(law.init(r), r)
    wanted = r - law.gain * network.laplacian() @ r
    assert state.x == pytest.approx(wanted, abs=1e-12)


def test_the_sum_is_kept_and_a_step_changes_nothing_that_went_in():
    network, rng = family_network("grid:2,3"), np.random.default_rng(8)
    law = IsotropicConsensus(network, (1.0,), (3,), H)
    state = law.init(rng.normal(size=(6, 3)))
    before = state.x.tobytes(), state.w.tobytes()
    r = rng.normal(size=(6, 3))
    after = law.step(state, r)
    assert (state.x.tobytes(), state.w.tobytes()) == before
    assert after.w.sum(axis=0) == pytest.approx(0, abs=1e-13)
    assert after.x.tobytes() == law.step(state, r).x.tobytes()


def test_linear_consensus_agrees_on_constant_signals_as_fast_as_its_gain_says():
    network, rng = family_network("cycle:6"), np.random.default_rng(9)
    law = LinearConsensus(network)
    values = np.linalg.eigvalsh(network.laplacian().toarray())
    factor = (values[-1] - values[1]) / (values[-1] + values[1])
    r = rng.normal(size=(6, 2))
    state = law.init(r)
    start = np.linalg.norm(r - r.mean(axis=0))
    for k in range(1, 30):
        state = law.step(state, r)
        assert np.linalg.norm(state.x - r.mean(axis=0)) <= factor**k * start * (1 + 1e-9) + 1e-14
    assert state.x.mean(axis=0) == pytest.approx(r.mean(axis=0), abs=1e-14)


@pytest.mark.parametrize(
    "changes,name",
    [
        ({"beta": (-1.0,)}, "beta"),
        ({"beta": (float("inf"),)}, "beta"),
        ({"h": 0.0}, "h"),
        ({"method": "euler"}, "method"),
    ],
)
def test_bad_parameters_are_refused_by_name(changes, name):
    given = {"network": family_network("path:3"), "beta": (1.0,), "sizes": (2,), "h": H}
    with pytest.raises(InputError) as error:
        IsotropicConsensus(**(given | changes))
    assert error.value.name == name


def test_linear_steps_that_would_grow_are_refused():
    with pytest.raises(InputError) as error:
        LinearConsensus(family_network("path:3"), 1.0)
    assert error.value.name == "gain"
    with pytest.raises(InputError) as error:
        LinearConsensus(Network(["a", "b", "c"], np.array([[0, 1]])))
    assert error.value.name == "graph"
