"""Cuts of graphs: every way to show that all are clear, and a cut that is not, against all cuts."""

from fractions import Fraction
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import connected_networks, networks, rationals, trees
from verification.certificates import check

from .documents import accepts, checked
from .samples import LADDER, PAIR, PATH, RING, TREE, cuts, enumeration, ring_routing

KINDS = {"graph": "graph", "gamma": "nodes", "b": "number", "f": "number", "e": "nodes"}
CLEAR = ["cuts_clear(graph, gamma, b, f, e)"]
REACHED = ["cut_reaches(graph, gamma, b, f, e)"]
THRESHOLD = {"graph": "graph", "gamma": "nodes", "b": "number"}
ABOVE = ["cuts_clear(graph, gamma, b, 1, 0)"]
BELOW = ["cut_reaches(graph, gamma, b, 1, 0)"]
DRIFTS = ["cut_drifts(graph, gamma, b)"]
FREE = {"graph": "graph", "b": "number", "f": "number", "s": "number"}
SPREAD = ["cuts_clear(graph, 0, b, f, s)"]


def all_cuts(network, gamma, error):
    """(nodes, k, N, p, E) of every cut of every component, from the definitions."""
    weights = network.weights or [1] * network.m
    links = [(i, j, w) for (i, j), w in zip(network.edges.tolist(), weights, strict=True)]
    for part in network.components():
        n = len(part)
        mean = sum(error[i] for i in part) / Fraction(n)
        spread = sum((error[i] - mean) ** 2 for i in part)
        for s in range(1, n):
            for inside in combinations(part, s):
                k = sum(Fraction(w) for i, j, w in links if (i in inside) != (j in inside))
                indicator = {i: (i in inside) - Fraction(s, n) for i in part}  # M 1_S
                load = sum(gamma[i] * abs(indicator[i]) for i in part)
                yield inside, k, load, sum(v * v for v in indicator.values()), spread


def clear(b, f, cut):
    _, k, load, p, spread = cut
    return b * k >= load and f * (b * k - load) ** 2 >= spread * p


def reached(b, f, cut):
    _, k, load, p, spread = cut
    return b * k <= load or f * (b * k - load) ** 2 <= spread * p


def some_nodes(draw, n, entries):
    return draw(st.lists(entries, min_size=n, max_size=n))


POSITIVE = rationals(Fraction(1, 20), 10)
SMALL = rationals(0, 3, 4)


@st.composite
def cases(draw, drawn):
    """A network with loads, an error, and numbers on which the two conditions are balanced."""
    network = draw(drawn)
    gamma = some_nodes(draw, network.n, SMALL)
    error = some_nodes(draw, network.n, rationals(-2, 2, 3))
    every = list(all_cuts(network, gamma, error))
    b, f = draw(SMALL), draw(POSITIVE)
    if every and draw(st.booleans()):  # exactly at the worst cut, or a little beside it
        b = max(cut[2] / cut[1] for cut in every) + draw(st.sampled_from([0, 1, Fraction(1, 99)]))
        rest = [(cut[4] * cut[3], (b * cut[1] - cut[2]) ** 2) for cut in every]
        if all(free for _, free in rest):
            scale = draw(st.sampled_from([1, 1, Fraction(98, 99), 2]))
            f = max(due / free for due, free in rest) * scale or f
    return network, gamma, error, b, f, every


def data(network, gamma, error, b, f):
    numbers = {"gamma": [*map(str, gamma)], "e": [*map(str, error)]}
    return {"graph": network.to_data(), "b": str(b), "f": str(f), **numbers}


def whole_enumerations(network, shuffle):
    return cuts(*(enumeration(*shuffle(range(len(part)))) for part in network.components()))


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


def without(inputs, *names):
    return {key: value for key, value in inputs.items() if key not in names}


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


def test_a_routing_bounds_the_threshold_only():
    inputs = {"graph": RING, "gamma": "3", "b": "9", "f": "99", "e": ["1", "0", "0", "0"]}
    assert not accepts(CLEAR, [cuts(ring_routing())], inputs, KINDS)
    assert accepts(CLEAR, [cuts(enumeration(0, 1, 2, 3))], inputs, KINDS)


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
    assert accepts(ABOVE, [cuts(enumeration(2, 0, 3, 1))], ring_inputs("3"), THRESHOLD)
    assert not accepts(ABOVE, [cuts(part)], ring_inputs("3"), THRESHOLD)


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
