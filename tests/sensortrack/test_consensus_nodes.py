"""Agents that know their neighbours' messages only, lost messages, and agents that come and go."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.consensus import SignConsensus, change_members, nodes_of
from sensortrack.errors import InputError
from sensortrack.kernels.dual import Ascent
from sensortrack.kernels.links import links_of
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks

PATH = read_network("path:5")


def signals(network: Network, steps: int, width: int = 2, seed: int = 0) -> np.ndarray:
    walk = np.random.default_rng(seed).normal(size=(steps, network.n, width))
    return np.cumsum(0.1 * walk, axis=0)


@settings(max_examples=25)
@given(connected_networks(min_nodes=2, weighted=True), st.integers(0, 99))
def test_messages_make_the_explicit_step(network, seed) -> None:
    law = SignConsensus(network, [1.0, 3.0], 0.125, "explicit")
    nodes, r = nodes_of(law, 2), signals(network, 5, seed=seed)
    state = law.init(r[0])
    own = {name: node.init(r[0][i]) for i, (name, node) in enumerate(nodes.items())}
    for now in r[1:]:
        state = law.step(state, now)
        x = {name: held.x for name, held in own.items()}
        own = {
            name: node.step(own[name], {other: x[other] for other in node.weights}, now[i])
            for i, (name, node) in enumerate(nodes.items())
        }
        for i, held in enumerate(own.values()):
            assert np.array_equal(held.x, state.x[i])
            assert np.array_equal(held.w, state.w[i])


@pytest.mark.parametrize("graph", ["path:6", "grid:3,3", "star:5"])
def test_an_explicit_step_sees_neighbours_only(graph: str) -> None:
    network = read_network(graph)
    law = SignConsensus(network, 1.0, 0.125, "explicit")
    r = signals(network, 2)
    for changed in range(network.n):
        other = r.copy()
        other[:, changed] += 1.0
        one, two = (law.step(law.init(s[0]), s[1]) for s in (r, other))
        near = {int(j) for edge in network.edges if changed in edge for j in edge} | {changed}
        far = sorted(set(range(network.n)) - near)
        assert np.array_equal(one.x[far], two.x[far])
        assert not np.array_equal(one.x[changed], two.x[changed])


def run_dual(law: SignConsensus, r: np.ndarray, rounds: int) -> tuple[dict, dict]:
    """Dual steps by messages, from w = 0."""
    nodes = nodes_of(law, r.shape[1])
    inner = {
        name: node.begin(node.init(r[i]), r[i]) for i, (name, node) in enumerate(nodes.items())
    }
    for _ in range(rounds):
        said = {name: node.message(inner[name]) for name, node in nodes.items()}
        inner = {
            name: node.ascend(inner[name], {other: said[other] for other in node.weights})
            for name, node in nodes.items()
        }
    return nodes, inner


@settings(max_examples=25)
@given(connected_networks(min_nodes=2, weighted=True), st.integers(0, 99))
def test_messages_make_the_dual_steps(network, seed) -> None:
    law = SignConsensus(network, 1.0, 0.5)
    links = links_of(network)
    r = signals(network, 1, 1, seed)[0]
    ascent = Ascent(links, r[:, 0].copy(), 0.5 * links.link_weights(None), np.zeros(links.m))
    ascent.advance(3)
    nodes, inner = run_dual(law, r, 3)
    for e, (i, j) in enumerate(links.ends.tolist()):
        a, b = network.names[i], network.names[j]
        assert inner[a].flow[b] == -inner[b].flow[a]
        # three steps are taken before a momentum can be restarted
        assert inner[a].flow[b] == pytest.approx(ascent.flow[e], rel=0, abs=1e-13)
    done = [node.finish(inner[name]) for name, node in nodes.items()]
    assert abs(sum(held.w[0] for held in done)) < 1e-14


def test_dual_steps_reach_the_implicit_step() -> None:
    law = SignConsensus(PATH, 2.0, 0.5)
    r = signals(PATH, 1, 2, 3)[0]
    exact = law.step(law.init(r), r)
    nodes, inner = run_dual(law, r, 400)
    for i, (name, node) in enumerate(nodes.items()):
        held = node.finish(inner[name])
        assert np.allclose(held.x, exact.x[i], rtol=0, atol=1e-6)
    warm = nodes["0"].begin(nodes["0"].init(r[0]), r[0], inner["0"].flow)
    assert np.array_equal(warm.flow["1"], inner["0"].flow["1"])


def test_a_dual_step_carries_news_one_link_further() -> None:
    law = SignConsensus(PATH, 2.0, 0.5)
    r = signals(PATH, 1, 1, 4)[0]
    other = r.copy()
    other[0] += 1.0
    for rounds in range(1, 4):
        one, two = (run_dual(law, s, rounds)[1] for s in (r, other))
        same = [np.array_equal(one[k].flow[j], two[k].flow[j]) for k in one for j in one[k].flow]
        # flows of the links (0, 1), (1, 2), ... as both ends know them
        assert same == [False] * (2 * rounds) + [True] * (8 - 2 * rounds)


def lossy(protocol: str, rounds: int = 60) -> np.ndarray:
    """A path of three whose first end does not hear the second for ten steps; the mean of x."""
    network = read_network("path:3")
    law = SignConsensus(network, 1.0, 0.05, "explicit")
    nodes, r = nodes_of(law, 1), np.array([[3.0], [0.0], [0.0]])
    links = protocol == "accounts"
    own = {
        name: node.init_links(r[i]) if links else node.init(r[i])
        for i, (name, node) in enumerate(nodes.items())
    }
    for k in range(rounds):
        before = dict(own)
        for i, (name, node) in enumerate(nodes.items()):
            heard = [o for o in node.weights if not (k < 10 and (name, o) == ("0", "1"))]
            if links:
                inbox = {o: (before[o].x, before[o].sent[name]) for o in heard}
                own[name] = node.step_links(before[name], inbox, r[i])
            else:
                own[name] = node.step(before[name], {o: before[o].x for o in heard}, r[i])
    return np.array([held.x[0] for held in own.values()])


def test_one_way_loss_biases_steps_and_not_accounts() -> None:
    """Ten steps of 0.05 that one end alone has taken: w has the sum 1/2 for ever."""
    assert lossy("steps").mean() == pytest.approx(1 + 0.5 / 3, abs=1e-12)
    assert lossy("accounts").mean() == pytest.approx(1, abs=1e-12)


@settings(max_examples=25)
@given(connected_networks(min_nodes=2, weighted=True), st.integers(0, 99))
def test_accounts_without_loss_are_the_explicit_step(network, seed) -> None:
    law = SignConsensus(network, 1.0, 0.125, "explicit")
    nodes, r = nodes_of(law, 2), signals(network, 6, seed=seed)
    state = law.init(r[0])
    own = {name: node.init_links(r[0][i]) for i, (name, node) in enumerate(nodes.items())}
    for now in r[1:]:
        state = law.step(state, now)
        before = own
        own = {
            name: node.step_links(
                before[name],
                {other: (before[other].x, before[other].sent[name]) for other in node.weights},
                now[i],
            )
            for i, (name, node) in enumerate(nodes.items())
        }
        for i, held in enumerate(own.values()):
            assert np.allclose(held.x, state.x[i], rtol=0, atol=1e-12)


def agreed(law: SignConsensus, r: np.ndarray):
    state = law.init(r)
    for _ in range(40):
        state = law.step(state, r)
    assert np.ptp(state.x) < 1e-15
    return state


def test_an_heir_keeps_the_mean_of_the_survivors_right() -> None:
    r = np.array([[1.0], [5.0], [2.0], [0.0], [7.0]])
    law = SignConsensus(PATH, 4.0, 0.25)
    state = agreed(law, r)
    rest = PATH.subnetwork(range(4))
    later, handed = change_members(law, state, rest, r[:4], {"4": "3"})
    assert abs(handed.w.sum()) < 1e-14
    for _ in range(40):
        handed = later.step(handed, r[:4])
    assert np.allclose(handed.x, 2.0, rtol=0, atol=1e-14)
    later, lost = change_members(law, state, rest, r[:4], {"4": None})
    for _ in range(40):
        lost = later.step(lost, r[:4])
    # the error is (r_i - mean)/(n - 1) = (7 - 3)/4: all stay at the mean of before
    assert np.allclose(lost.x, 3.0, rtol=0, atol=1e-14)


def test_one_that_joins_moves_no_mean() -> None:
    r = np.array([[1.0], [5.0], [2.0], [0.0]])
    law = SignConsensus(read_network("path:4"), 4.0, 0.25)
    state = agreed(law, r)
    signal = np.vstack([r, [[7.0]]])
    later, joined = change_members(law, state, PATH, signal)
    assert joined.w[4] == 0
    for _ in range(40):
        joined = later.step(joined, signal)
    assert np.allclose(joined.x, 3.0, rtol=0, atol=1e-14)


@pytest.mark.parametrize(
    "heirs, rows, name",
    [
        ({}, 4, "heirs"),
        ({"4": "4"}, 4, "heirs"),
        ({"4": "zoe"}, 4, "heirs"),
        ({"4": "3", "2": "3"}, 4, "heirs"),
        ({"4": "3"}, 5, "r"),
    ],
)
def test_bad_changes_are_refused(heirs: dict[str, str], rows: int, name: str) -> None:
    law = SignConsensus(PATH, 1.0, 0.25)
    state = law.init(np.zeros((5, 1)))
    with pytest.raises(InputError) as caught:
        change_members(law, state, PATH.subnetwork(range(4)), np.zeros((rows, 1)), heirs)
    assert caught.value.name == name


def test_another_number_of_components_is_refused() -> None:
    law = SignConsensus(PATH, 1.0, 0.25)
    state = law.init(np.zeros((5, 1)))
    with pytest.raises(InputError, match=r"^r: "):
        change_members(law, state, PATH, np.zeros((5, 2)))


def test_bad_messages_are_refused() -> None:
    node = nodes_of(SignConsensus(PATH, 1.0, 0.25), 1)["1"]
    own, zero = node.init([0.0]), [0.0]
    with pytest.raises(InputError, match=r"^inbox: a message of '3' to '1'"):
        node.step(own, {"3": zero}, zero)
    with pytest.raises(InputError, match=r"^inbox: "):
        node.step(own, {"0": [np.nan]}, zero)
    with pytest.raises(InputError, match=r"^inbox: nothing of '2'"):
        node.ascend(node.begin(own, zero), {"0": zero})
    with pytest.raises(InputError, match=r"^r: "):
        node.step(own, {}, [1.0, 2.0])
    with pytest.raises(InputError, match=r"^inbox: "):
        node.step_links(node.init_links(zero), {"0": (zero, [np.inf])}, zero)
    with pytest.raises(InputError, match=r"^beta: "):
        nodes_of(SignConsensus(PATH, [1.0, 2.0], 0.25), 3)
