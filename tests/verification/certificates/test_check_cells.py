"""Routings by cells: whatever the integers are, the bound is never below a cut."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.networks import Network
from tests.strategies import connected_networks
from tests.verification.exact.literal_cuts import Component, Refused, cell_loads
from verification.certificates import check

from .cut_cases import ABOVE, CLEAR, KINDS, SMALL, THRESHOLD, all_cuts, some_nodes
from .documents import REFUSALS, accepts, checked
from .samples import RING, cuts, ring_cells, ring_routing

INTEGERS = st.integers(-(2**24), 2**24)


def parts_of(network, kept):
    """Number of the connected part of each node when only some edges are kept."""
    pairs = [pair for pair, keep in zip(network.edges.tolist(), kept, strict=True) if keep]
    found = list(range(network.n))
    for _ in pairs:
        for i, j in pairs:
            found[i] = found[j] = min(found[i], found[j])
    return found


@st.composite
def cell_routings(draw):
    """Any network, any connected cells on two or three levels, any integers."""
    network = draw(connected_networks(min_nodes=2, max_nodes=7, weighted=True))
    home, levels = [0] * network.n, []
    for last in draw(st.sampled_from([(True,), (False, True), (False, False, True)])):
        within = [home[i] == home[j] for i, j in network.edges.tolist()]
        kept = [inside and not last and draw(st.booleans()) for inside in within]
        cell = parts_of(network, kept)
        places = [
            sorted({c for c, h in zip(cell, home, strict=True) if h == mine}).index(own)
            for own, mine in zip(cell, home, strict=True)
        ]
        weights = [draw(INTEGERS) for inside in within if inside]
        sources = [some_nodes(draw, network.n, INTEGERS) for _ in range(max(places) + 1)]
        levels.append([draw(st.integers(1, 300)), places, weights, sources])
        home = cell
    return network, {"kind": "cells", "scale": draw(st.integers(1, 5000)), "levels": levels}


@given(cell_routings(), st.data())
def test_no_choice_of_integers_proves_a_bound_below_the_threshold(routing, more):
    network, part = routing
    gamma = some_nodes(more.draw, network.n, SMALL)
    threshold = max(
        load / k for _, k, load, _, _ in all_cuts(network, gamma, [Fraction(0)] * network.n)
    )
    inputs = {"graph": network.to_data(), "gamma": [*map(str, gamma)]}
    up = max(cell_loads(Component(network, gamma), part))
    assert up >= threshold
    for b in {threshold * Fraction(99, 100), threshold, up, up + 1}:
        believed = accepts(ABOVE, [cuts(part)], inputs | {"b": str(b)}, THRESHOLD)
        assert not (believed and b < threshold)
        assert believed or b < up


@given(cell_routings())
def test_a_gap_is_closed_only_if_no_cut_lies_in_it(routing):
    network, part = routing
    every = list(all_cuts(network, [Fraction(2)] * network.n, [Fraction(0)] * network.n))
    values = {load / k for _, k, load, _, _ in every}
    for b in {v + d for v in values for d in (0, Fraction(-1, 10**6))}:
        inputs = {"graph": network.to_data(), "gamma": "2", "b": str(b)}
        if accepts(ABOVE, [cuts(part)], inputs, THRESHOLD):
            assert b >= max(values)


def single_nodes(flows):
    """The level whose cells are single nodes, with potentials of which the currents are these."""
    return {"kind": "cells", "scale": 8, "levels": [[2, [0, 1, 2, 3], [2**20] * 4, flows]]}


def test_single_nodes_as_cells_are_a_routing_with_one_flow_a_node():
    flows = [[0, -3, -1, -3], [0, 3, -3, 1], [0, 1, 3, 3], [0, 1, 1, 3]]
    inputs = {"graph": RING, "gamma": ["3", "3", "3", "2"], "b": "3"}
    weaker = inputs | {"b": "299/100"}
    for part in (ring_routing(), ring_cells()):
        assert accepts(ABOVE, [cuts(part)], inputs, THRESHOLD)
    repaired = single_nodes(flows)
    assert accepts(ABOVE, [cuts(repaired)], inputs | {"b": "9"}, THRESHOLD)
    assert not accepts(ABOVE, [cuts(repaired)], weaker | {"b": "1"}, THRESHOLD)


PATH6 = Network([*"abcdef"], [[i, i + 1] for i in range(5)])
HALVES = {
    "kind": "cells",
    "scale": 720,
    "levels": [
        [2, [0, 0, 0, 1, 1, 1], [1] * 5, [[0] * 6, [0] * 6]],
        [2, [0, 1, 2, 0, 1, 2], [1] * 4, [[0] * 6] * 3],
    ],
}


def test_on_a_tree_the_repair_alone_is_the_flow():
    """Two levels on a path: the middle edge carries 3, as the middle cut asks for."""
    inputs = {"graph": PATH6.to_data(), "gamma": ["1"] * 5 + ["99/100"]}
    loads = cell_loads(Component(PATH6, [Fraction(1)] * 6), HALVES)
    assert loads[2] == 3
    up = max(loads)
    assert accepts(ABOVE, [cuts(HALVES)], inputs | {"b": str(up)}, THRESHOLD)
    assert not accepts(ABOVE, [cuts(HALVES)], inputs | {"b": str(up * Fraction(9, 10))}, THRESHOLD)


def ring(change):
    part = ring_cells()
    change(part)
    return cuts(part)


CHANGES = {
    "a cell that is not connected": lambda p: p["levels"][0].__setitem__(1, [0, 1, 0, 1]),
    "a cell without a source": lambda p: p["levels"][0].__setitem__(1, [0, 1, 2, 0]),
    "a cell below zero": lambda p: p["levels"][0].__setitem__(1, [0, -1, -1, 0]),
    "cells of several nodes": lambda p: p["levels"].pop(),
    "no level": lambda p: p["levels"].clear(),
    "a cell for each of three nodes": lambda p: p["levels"][0][1].pop(),
    "a node too many": lambda p: p["levels"][0][1].append(0),
    "a weight too many": lambda p: p["levels"][1][2].append(1),
    "a weight too few": lambda p: p["levels"][0][2].pop(),
    "a potential too few": lambda p: p["levels"][0][3][0].pop(),
    "a potential too many": lambda p: p["levels"][0][3][1].append(0),
    "no source": lambda p: p["levels"][0][3].clear(),
    "a text": lambda p: p["levels"][0][3][0].__setitem__(1, "-2"),
    "a truth": lambda p: p["levels"][0][3][0].__setitem__(1, True),
    "a true cell": lambda p: p["levels"][0].__setitem__(1, [False, True, True, False]),
    "a huge potential": lambda p: p["levels"][0][3][0].__setitem__(1, 2**63),
    "a huge weight": lambda p: p["levels"][0][2].__setitem__(1, -(10**4000)),
    "a unit of zero": lambda p: p["levels"][0].__setitem__(0, 0),
    "a negative unit": lambda p: p["levels"][0].__setitem__(0, -1),
    "half a unit": lambda p: p["levels"][0].__setitem__(0, "1/2"),
    "a huge unit": lambda p: p["levels"][0].__setitem__(0, 2**64),
    "a scale of zero": lambda p: p.__setitem__("scale", 0),
    "a negative scale": lambda p: p.__setitem__("scale", -8),
    "half a scale": lambda p: p.__setitem__("scale", "1/2"),
    "a level too short": lambda p: p["levels"][0].pop(),
    "a level too long": lambda p: p["levels"][0].append([]),
    "a level that is no list": lambda p: p["levels"].__setitem__(0, {"unit": 1}),
    "levels in the wrong order": lambda p: p["levels"].reverse(),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_what_is_no_routing_by_cells_is_refused_at_any_bound(change):
    inputs = {"graph": RING, "gamma": "3", "b": "9999"}
    assert accepts(ABOVE, [cuts(ring_cells())], inputs, THRESHOLD)
    assert not accepts(ABOVE, [ring(change)], inputs, THRESHOLD)


@pytest.mark.parametrize(
    "change",
    [
        lambda p: p["levels"][0][2].__setitem__(0, 0),
        lambda p: p["levels"][0][2].__setitem__(0, -(2**20)),
        lambda p: p["levels"][0][2].__setitem__(slice(0, 4), [2**62] * 4),
        lambda p: p["levels"][0][3][0].__setitem__(1, 5),
        lambda p: p["levels"][0][3][0].__setitem__(0, 2**62),
        lambda p: p["levels"][1][3].append([0] * 4),
        lambda p: p["levels"][0].__setitem__(0, 2**62),
        lambda p: p.__setitem__("scale", 1),
        lambda p: p["levels"].append([1, [0] * 4, [], [[7] * 4]]),
    ],
)
def test_other_integers_only_make_the_bound_worse(change):
    inputs = {"graph": RING, "gamma": ["3", "3", "3", "29/10"]}
    witness = ring(change)
    assert accepts(ABOVE, [witness], inputs | {"b": str(10**40)}, THRESHOLD)
    assert not accepts(ABOVE, [witness], inputs | {"b": "29/10"}, THRESHOLD)


def test_a_bound_below_the_threshold_is_not_believed():
    for b in ("299/100", "1", "0"):
        inputs = {"graph": RING, "gamma": "3", "b": b}
        assert not accepts(ABOVE, [cuts(ring_cells())], inputs, THRESHOLD)


def test_cells_say_nothing_about_rates_under_unlike_bounds():
    inputs = {"graph": RING, "gamma": "3", "b": "9", "f": "99", "e": ["1", "0", "0", "0"]}
    unlike = inputs | {"gamma": ["3", "3", "3", "2"]}
    assert accepts(CLEAR, [cuts(ring_cells())], inputs, KINDS)
    assert not accepts(CLEAR, [cuts(ring_cells())], unlike, KINDS)
    assert accepts(CLEAR, [cuts(ring_cells())], unlike | {"e": ["0"] * 4}, KINDS)


def test_a_routing_by_cells_stops_at_the_budget(monkeypatch):
    monkeypatch.setattr(check, "CUT_STEPS", 5)
    part = ring_cells()
    part["levels"] += [[1, [0] * 4, [], [[0] * 4]]] * 9
    with pytest.raises(check.Reject, match="too many flows"):
        checked(ABOVE, [cuts(part)], {"graph": RING, "gamma": "3", "b": "9"}, THRESHOLD)


def test_the_literal_rules_refuse_what_the_checker_refuses():
    component = Component(Network([*"abcd"], RING["edges"]), [Fraction(3)] * 4)
    for name in ("a cell that is not connected", "cells of several nodes"):
        (part,) = ring(CHANGES[name])["parts"]
        with pytest.raises((Refused, *REFUSALS)):
            cell_loads(component, part)
