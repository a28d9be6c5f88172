"""Cuts of graphs: every way to show that all are clear, and a cut that is not, against all cuts."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import connected_networks, networks, trees
from verification.certificates import check

from .cut_cases import (
    ABOVE,
    CLEAR,
    DRIFTS,
    FREE,
    KINDS,
    REACHED,
    SPREAD,
    THRESHOLD,
    all_cuts,
    cases,
    clear,
    data,
    reached,
    whole_enumerations,
    without,
)
from .documents import accepts, checked
from .samples import PAIR, RING, TREE, cuts, enumeration


@given(cases(networks(max_nodes=6, weighted=True)), st.data())
def test_enumeration_accepts_if_and_only_if_every_cut_is_clear(case, more):
    network, gamma, error, b, f, every = case
    witness = whole_enumerations(network, lambda nodes: more.draw(st.permutations(nodes)))
    believed = accepts(CLEAR, [witness], data(network, gamma, error, b, f), KINDS)
    assert believed == all(clear(b, f, cut) for cut in every)


@given(cases(connected_networks(max_nodes=7)), st.data())
def test_enumeration_with_one_load_for_all_uses_twins(case, more):
    """Networks without weights and one gamma have many twins; skipping them must lose no cut."""
    network, gamma, _, _, f, _ = case
    inputs = {"graph": network.to_data(), "gamma": str(gamma[0]), "b": "1", "f": str(f), "e": "0"}
    witness = whole_enumerations(network, lambda nodes: more.draw(st.permutations(nodes)))
    every = list(all_cuts(network, [gamma[0]] * network.n, [Fraction(0)] * network.n))
    for b in {load / k + d for _, k, load, _, _ in every for d in (0, Fraction(-1, 1000))}:
        if b >= 0:
            believed = accepts(CLEAR, [witness], inputs | {"b": str(b)}, KINDS)
            assert believed == all(clear(b, f, cut) for cut in every)


@given(cases(trees(max_nodes=7, weighted=True)))
def test_on_a_tree_single_edges_decide(case):
    network, gamma, error, b, f, every = case
    believed = accepts(CLEAR, [cuts(TREE)], data(network, gamma, error, b, f), KINDS)
    assert believed == all(clear(b, f, cut) for cut in every)


@given(cases(networks(min_nodes=2, max_nodes=6, weighted=True)), st.data())
def test_a_cut_is_believed_if_and_only_if_it_reaches(case, more):
    network, gamma, error, b, f, every = case
    inside = more.draw(st.lists(st.integers(-1, network.n), unique=True, max_size=network.n))
    found = next((cut for cut in every if {*cut[0]} == {*inside}), None)
    witness = {"kind": "cut", "nodes": inside}
    inputs = data(network, gamma, error, b, f)
    assert accepts(REACHED, [witness], inputs, KINDS) == bool(found and reached(b, f, found))
    drifts = bool(found and found[2] > b * found[1])
    assert accepts(DRIFTS, [witness], without(inputs, "f", "e"), THRESHOLD) == drifts


@given(cases(networks(max_nodes=6, weighted=True)))
def test_a_spread_given_as_a_number_is_that_number(case):
    network, _, _, b, f, every = case
    inputs = {"graph": network.to_data(), "b": str(b), "f": str(f), "s": "7/3"}
    witness = whole_enumerations(network, list)
    free = [(cut[0], cut[1], 0, cut[3], Fraction(7, 3)) for cut in every]
    assert accepts(SPREAD, [witness], inputs, FREE) == all(clear(b, f, cut) for cut in free)


def test_one_number_for_all_nodes_is_one_number_at_every_node():
    """An error that is the same everywhere has no spread, whatever the number."""
    inputs = {"graph": PAIR, "gamma": "0", "b": "1", "f": "1/1000", "e": "4"}
    assert accepts(CLEAR, [cuts(TREE)], inputs, KINDS)
    assert not accepts(REACHED, [{"kind": "cut", "nodes": [0]}], inputs, KINDS)
    assert accepts(REACHED, [{"kind": "cut", "nodes": [0]}], inputs | {"e": ["4", "-4"]}, KINDS)


@pytest.mark.parametrize(
    "part",
    [
        TREE,
        enumeration(0, 1, 2),
        enumeration(0, 1, 2, 2),
        enumeration(0, 1, 2, 4),
        enumeration(0, 1, 2, 3, 3),
        enumeration(0, 1, 2, True),
        {"kind": "enumeration"},
        {"kind": "product", "parts": []},
        {"kind": "__init__", "graph": 1},
        {"kind": "load", "s": 0, "inside": 0},
        {"kind": ["tree"]},
        None,
    ],
)
def test_parts_that_do_not_fit_the_graph(part):
    assert accepts(
        ABOVE, [cuts(enumeration(2, 0, 3, 1))], {"graph": RING, "gamma": "3", "b": "3"}, THRESHOLD
    )
    assert not accepts(ABOVE, [cuts(part)], {"graph": RING, "gamma": "3", "b": "3"}, THRESHOLD)
    assert not accepts(ABOVE, [cuts(part)], {"graph": RING, "gamma": "3", "b": "99"}, THRESHOLD)


@pytest.mark.parametrize("b, f, s", [("-1", "1", "1"), ("1", "-1", "1"), ("1", "1", "-1")])
def test_bounds_that_are_negative_are_refused(b, f, s):
    inputs = {"graph": PAIR, "b": b, "f": f, "s": s}
    assert not accepts(SPREAD, [cuts(TREE)], inputs, FREE)
    assert not accepts(
        ["cut_reaches(graph, 0, b, f, s)"], [{"kind": "cut", "nodes": [0]}], inputs, FREE
    )


def test_a_factor_of_zero_shows_nothing_about_a_spread():
    inputs = {"graph": PAIR, "b": "1", "f": "0", "s": "1"}
    assert not accepts(SPREAD, [cuts(TREE)], inputs, FREE)


def test_a_dense_network_stops_at_the_budget(monkeypatch):
    """No cut of this network can be left out, and no two nodes are twins."""
    monkeypatch.setattr(check, "CUT_STEPS", 5000)
    n = 60
    pairs = [[i, j] for j in range(n) for i in range(j)]
    graph = {
        "nodes": [str(i) for i in range(n)],
        "edges": pairs,
        "weights": [str(1 + (i + 1) * (j + 1) * (i + j) % 7) for i, j in pairs],
    }
    inputs = {"graph": graph, "gamma": "1", "b": "1/25"}
    with pytest.raises(check.Reject, match="too many cuts"):
        checked(ABOVE, [cuts(enumeration(*range(n)))], inputs, THRESHOLD)


def test_the_budget_is_one_for_all_parts(monkeypatch):
    """Many components of a few thousand steps each must not add up to a day."""
    ring = [[i, (i + 1) % 12] for i in range(12)]
    pairs = [[12 * c + min(p), 12 * c + max(p)] for c in range(20) for p in ring]
    graph = {"nodes": [str(i) for i in range(240)], "edges": pairs}
    inputs = {"graph": graph, "gamma": "1", "b": "3"}
    witness = [cuts(*[enumeration(*range(12))] * 20)]
    assert accepts(ABOVE, witness, inputs, THRESHOLD)
    monkeypatch.setattr(check, "CUT_STEPS", 1500)
    with pytest.raises(check.Reject, match="too many cuts"):
        checked(ABOVE, witness, inputs, THRESHOLD)
