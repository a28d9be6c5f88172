"""Routings bound every cut at once; cuts of a product are those of its factors."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import connected_networks, rationals

from .cut_cases import ABOVE, BELOW, CLEAR, KINDS, SMALL, THRESHOLD, all_cuts, some_nodes
from .documents import accepts
from .samples import LADDER, PAIR, PATH, RING, TREE, cuts, enumeration, ring_routing


def ring_inputs(b, gamma="3"):
    return {"graph": RING, "gamma": gamma, "b": b}


@pytest.mark.parametrize("b, holds", [("3", True), ("299/100", False), ("4", True)])
def test_a_routing_proves_its_largest_load(b, holds):
    assert accepts(ABOVE, [cuts(ring_routing())], ring_inputs(b), THRESHOLD) == holds


@st.composite
def routings(draw):
    """Any routing of any connected network: along a tree, plus flows around its cycles."""
    network = draw(connected_networks(min_nodes=2, max_nodes=6, weighted=True))
    n, edges = network.n, network.edges.tolist()
    parent, walk = {0: None}, [0]
    for i in walk:
        for number, pair in enumerate(edges):
            j = sum(pair) - i
            if i in pair and j not in parent:
                parent[j] = (i, number)
                walk.append(j)
    unit = draw(st.integers(1, 3))
    flows = []
    for source in range(n):
        flow = []
        surplus = [unit * (n * (i == source) - 1) for i in range(n)]
        for j in reversed(walk[1:]):
            i, number = parent[j]
            flow.append([number, surplus[j] if edges[number][0] == j else -surplus[j]])
            surplus[i] += surplus[j]
        flows.append(flow)
    return network, unit, flows


@given(routings(), st.data())
def test_a_routing_along_a_tree_proves_nothing_below_the_threshold(routing, more):
    network, unit, flows = routing
    gamma = some_nodes(more.draw, network.n, SMALL)
    every = list(all_cuts(network, gamma, [Fraction(0)] * network.n))
    threshold = max(load / k for _, k, load, _, _ in every)
    weights = network.weights or [Fraction(1)] * network.m
    loads = [
        sum(g * abs(a) for g, flow in zip(gamma, flows, strict=True) for e, a in flow if e == edge)
        / (network.n * unit * weights[edge])
        for edge in range(network.m)
    ]
    witness = cuts({"kind": "routing", "unit": unit, "flows": flows})
    inputs = {"graph": network.to_data(), "gamma": [*map(str, gamma)]}
    assert max(loads) >= threshold
    for b in {*loads, threshold, threshold * Fraction(99, 100)}:
        believed = accepts(ABOVE, [witness], inputs | {"b": str(b)}, THRESHOLD)
        assert not (believed and b < threshold)
        assert believed or b < max(loads)


@given(routings(), rationals(Fraction(1, 4), 2, 4))
def test_a_gap_is_closed_only_if_no_cut_lies_in_it(routing, gamma):
    """With one gamma a routing above b still proves b where no value of N/k can lie between."""
    network, unit, flows = routing
    every = list(all_cuts(network, [gamma] * network.n, [Fraction(0)] * network.n))
    values = {load / k for _, k, load, _, _ in every}
    witness = cuts({"kind": "routing", "unit": unit, "flows": flows})
    for b in {v + d for v in values for d in (0, Fraction(-1, 10**6), Fraction(1, 10**6))}:
        inputs = {"graph": network.to_data(), "gamma": str(gamma), "b": str(b)}
        if accepts(ABOVE, [witness], inputs, THRESHOLD):
            assert b >= max(values)


def leaking(change):
    routing = ring_routing()
    change(routing)
    return cuts(routing)


@pytest.mark.parametrize(
    "change",
    [
        lambda r: r["flows"][0][0].__setitem__(1, r["flows"][0][0][1] + 1),  # one unit more
        lambda r: r["flows"][0].pop(),
        lambda r: r["flows"].pop(),
        lambda r: r["flows"].append([]),
        lambda r: r["flows"].reverse(),
        lambda r: r.__setitem__("unit", 1),
        lambda r: r.__setitem__("unit", 0),
        lambda r: r.__setitem__("unit", -2),
        lambda r: r["flows"][0].append([4, 0]),  # on no edge
        lambda r: r["flows"][0].append([-1, 0]),
        lambda r: r["flows"][0].append([0, "1/2"]),
        lambda r: r["flows"][0].append([0]),
        lambda r: r.__setitem__("flows", []),
        lambda r: r.__setitem__("unit", "1e2"),
    ],
)
def test_a_routing_that_leaks_is_refused(change):
    assert accepts(ABOVE, [cuts(ring_routing())], ring_inputs("9"), THRESHOLD)
    assert not accepts(ABOVE, [leaking(change)], ring_inputs("9"), THRESHOLD)


def test_a_detour_counts_both_ways():
    there_and_back = leaking(lambda r: r["flows"][0].extend([[0, 500], [0, -500]]))
    gamma = ["3", "3", "3", "2"]  # more than one value: no gap is closed
    assert accepts(ABOVE, [there_and_back], ring_inputs("1000", gamma), THRESHOLD)
    assert not accepts(ABOVE, [there_and_back], ring_inputs("9", gamma), THRESHOLD)
    assert accepts(ABOVE, [cuts(ring_routing())], ring_inputs("9", gamma), THRESHOLD)


def test_a_routing_says_nothing_about_rates_under_unlike_bounds():
    inputs = {"graph": RING, "gamma": "3", "b": "9", "f": "99", "e": ["1", "0", "0", "0"]}
    unlike = inputs | {"gamma": ["3", "3", "3", "2"]}
    for witness in (cuts(ring_routing()), cuts(enumeration(0, 1, 2, 3))):
        assert accepts(CLEAR, [witness], inputs, KINDS)
    assert not accepts(CLEAR, [cuts(ring_routing())], unlike, KINDS)
    assert accepts(CLEAR, [cuts(enumeration(0, 1, 2, 3))], unlike, KINDS)


@given(routings(), st.sampled_from([Fraction(0), Fraction(1), Fraction(3, 2)]), st.data())
def test_a_routing_shows_no_rate_that_some_cut_does_not_keep(routing, gamma, more):
    network, unit, flows = routing
    error = [Fraction(1), *[Fraction(0)] * (network.n - 1)]
    every = list(all_cuts(network, [gamma] * network.n, error))
    b = more.draw(rationals(Fraction(1, 2), 6, 3))
    gaps = [(b * k - load, p, spread) for _, k, load, p, spread in every]
    least = min(gap for gap, _, _ in gaps)
    witness = cuts({"kind": "routing", "unit": unit, "flows": flows})
    inputs = {"graph": network.to_data(), "gamma": str(gamma), "b": str(b), "e": [*map(str, error)]}
    sharp = max(spread * p / gap**2 for gap, p, spread in gaps) if least > 0 else Fraction(100)
    for f in (sharp * Fraction(999, 1000), sharp, sharp * 9, sharp * 10**6):
        believed = accepts(CLEAR, [witness], inputs | {"f": str(f)}, KINDS)
        assert not believed or (least > 0 and f >= sharp)


@given(st.lists(connected_networks(max_nodes=3, weighted=True), min_size=2, max_size=2), SMALL)
def test_a_product_is_clear_if_and_only_if_its_factors_are(factors, gamma):
    """Against all cuts of the product's own graph."""
    one, two = factors
    n = two.n
    pairs = [
        (i * n + j, k * n + j, w)
        for (i, k), w in zip(one.edges.tolist(), one.weights, strict=True)
        for j in range(n)
    ] + [
        (i * n + j, i * n + k, w)
        for (j, k), w in zip(two.edges.tolist(), two.weights, strict=True)
        for i in range(one.n)
    ]
    flat = {
        "nodes": [str(i) for i in range(one.n * n)],
        "edges": [[i, j] for i, j, _ in pairs],
        "weights": [str(w) for _, _, w in pairs],
    }
    graph = {"product": [one.to_data(), two.to_data()]}
    inner = [enumeration(*range(factor.n)) for factor in factors]
    whole = cuts(enumeration(*range(one.n * n)))
    product = cuts({"kind": "product", "parts": inner})
    for b in (Fraction(0), gamma / 3, gamma, 2 * gamma, 5 * gamma):
        inputs = {"gamma": str(gamma), "b": str(b)}
        assert accepts(ABOVE, [product], inputs | {"graph": graph}, THRESHOLD) == accepts(
            ABOVE, [whole], inputs | {"graph": flat}, THRESHOLD
        )


PIECES = {"nodes": ["a", "b", "c", "d"], "edges": [[1, 2], [2, 3]]}
PRODUCTS = [
    {"product": [PAIR, PIECES]},
    {"product": [PIECES, PAIR]},
    {"product": [PAIR, {"product": [PAIR, PAIR]}]},
    {"product": [PAIR]},
    {"product": []},
    {"product": [PAIR, PAIR], "weights": []},
    {"product": PAIR},
]


@pytest.mark.parametrize("graph", PRODUCTS)
def test_factors_are_two_or_more_each_connected_and_no_product(graph):
    inputs = {"graph": graph, "gamma": "0", "b": "1"}
    for count in range(4):
        item = cuts({"kind": "product", "parts": [TREE] * count})
        assert not accepts(ABOVE, [item], inputs, THRESHOLD)
    assert not accepts(BELOW, [{"kind": "cut", "factor": 0, "nodes": [0]}], inputs, THRESHOLD)
    fine = inputs | {"graph": {"product": [PAIR, PAIR]}}
    assert accepts(ABOVE, [cuts({"kind": "product", "parts": [TREE, TREE]})], fine, THRESHOLD)


NESTED = {"product": [{"product": [PAIR, PAIR]}, PAIR]}


@pytest.mark.parametrize(
    "graph, gamma, witness, holds",
    [
        (LADDER, "1", {"kind": "cut", "factor": 1, "nodes": [2]}, True),
        (LADDER, "1", {"kind": "cut", "factor": 0, "nodes": [0]}, False),
        (LADDER, "1", {"kind": "cut", "factor": 2, "nodes": [0]}, False),
        (LADDER, "1", {"kind": "cut", "factor": -1, "nodes": [2]}, False),
        (LADDER, "1", {"kind": "cut", "factor": 1, "nodes": [3]}, False),
        (LADDER, "1", {"kind": "cut", "nodes": [2]}, False),
        (LADDER, ["1"] * 6, {"kind": "cut", "factor": 1, "nodes": [2]}, False),
        (LADDER, "-1", {"kind": "cut", "factor": 1, "nodes": [2]}, False),
        (PATH, "1", {"kind": "cut", "factor": 0, "nodes": [2]}, False),
        (NESTED, "1", {"kind": "cut", "factor": 0, "nodes": [0]}, False),
    ],
)
def test_cuts_of_products(graph, gamma, witness, holds):
    inputs = {"graph": graph, "gamma": gamma, "b": "8/3"}
    assert accepts(BELOW, [witness], inputs, THRESHOLD) == holds
