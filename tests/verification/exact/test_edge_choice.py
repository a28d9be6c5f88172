"""The edge to add, against all edges one by one."""

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from verification.exact.cuts import edge_choice
from verification.exact.cuts.cut_reference import enumerate_all
from verification.exact.cuts.edge_choice import EdgeChoice, choose_edge, with_edge
from verification.exact.cuts.extreme import threshold

ONE = Fraction(1)


def worst(network: Network, gamma: Sequence[Fraction]) -> Fraction:
    return max(cut.load / cut.k for cut in enumerate_all(network, gamma))


def missing(network: Network) -> list[tuple[int, int]]:
    joined = {tuple(edge) for edge in network.edges.tolist()}
    pairs = [(i, j) for j in range(network.n) for i in range(j)]
    return [pair for pair in pairs if pair not in joined]


def chosen(network: Network, gamma: Sequence[Fraction]) -> EdgeChoice | None:
    return choose_edge(network, gamma, threshold(network, gamma).cut)


@given(connected_networks(2, 7, weighted=True), st.data())
@settings(max_examples=40)
def test_no_edge_does_better(network: Network, data: st.DataObject) -> None:
    gamma = data.draw(st.lists(rationals(0, 3, 4), min_size=network.n, max_size=network.n))
    choice = chosen(network, gamma)
    if not missing(network) or not any(gamma):
        assert choice is None
        return
    values = {pair: worst(with_edge(network, pair), gamma) for pair in missing(network)}
    if choice is None:  # all edges across the critical cut are there: no other one helps
        assert min(values.values()) == worst(network, gamma)
        return
    assert choice.best
    assert choice.bracket
    assert choice.least == choice.bracket.value == values[choice.edge] == min(values.values())


@pytest.mark.parametrize("name, edge", [("path:6", Fraction(3, 2)), ("star:6", Fraction(5, 3))])
def test_paths_are_closed_and_stars_are_not_helped(name: str, edge: Fraction) -> None:
    network = read_network(name)
    choice = chosen(network, [ONE] * 6)
    assert choice
    assert choice.least == edge


def test_the_new_edge_has_the_weight_one_and_is_the_last() -> None:
    network = Network(["a", "b", "c"], [[0, 1], [1, 2]], (ONE / 2, ONE / 3))  # type: ignore[arg-type]
    longer = with_edge(network, (0, 2))
    assert longer.edges.tolist() == [[0, 1], [1, 2], [0, 2]]
    assert longer.weights == (ONE / 2, ONE / 3, ONE)


@pytest.mark.parametrize("roads", [{"TRIED_NODES": 5}, {"TRIED_NODES": 5, "PAIRED_NODES": 5}])
def test_large_networks_get_an_edge_across_their_cut(
    roads: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A barbell of 6 + 6 nodes: whatever the road, the edge joins the two bells."""
    for name, value in roads.items():
        monkeypatch.setattr(edge_choice, name, value)
    bells = [(i + 6 * b, j + 6 * b) for b in (0, 1) for j in range(6) for i in range(j)]
    names = [str(i) for i in range(12)]
    network = Network(names, np.array([*bells, (5, 6)]))
    choice = chosen(network, [ONE] * 12)
    assert choice
    assert (choice.best, choice.bracket) == (False, None)
    i, j = choice.edge
    assert i < 6 <= j
    assert (i, j) != (5, 6)
    assert choice.least == 3
    assert worst(with_edge(network, choice.edge), [ONE] * 12) >= choice.least


def test_an_end_that_is_joined_to_all_others_is_passed_over(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(edge_choice, "PAIRED_NODES", 2)
    star = chosen(read_network("star:5"), [ONE] * 5)
    assert star
    assert 0 not in star.edge
    path = chosen(read_network("path:3"), [ONE] * 3)
    assert path
    assert path.edge == (0, 2)
