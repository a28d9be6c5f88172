"""What is counted while a certificate is checked, so that no file costs minutes or all memory."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.strategies import connected_networks, rationals
from verification.certificates import check

from .cut_cases import ABOVE, THRESHOLD
from .documents import checked
from .samples import PAIR, PATH, RING, cuts, enumeration, run

GAP_ABOVE = ["gap_above(graph, s)"]
KINDS = {"graph": "graph", "s": "number"}
AGREES = ["agrees(graph, beta, x0, t)"]
RUNS = {"graph": "graph", "beta": "number", "x0": "nodes", "t": "number"}


def graph(n, edges, **more):
    return {"nodes": [*map(str, range(n))], "edges": [list(edge) for edge in edges], **more}


def long_number(k):
    return 10**3990 + 2 * k + 1


def test_one_gap_serves_a_wide_star_in_a_moment():
    n = 30000
    order = [*range(1, n), 0]
    part = {"kind": "gap", "least": "99/100", "order": order, "bits": 8}
    star = graph(n, [(0, i) for i in range(1, n)])
    checked(ABOVE, [cuts(part)], {"graph": star, "gamma": "1", "b": "5/2"}, THRESHOLD)


@given(
    connected_networks(min_nodes=2, max_nodes=8, weighted=True),
    rationals(Fraction(1, 9), 9),
    rationals(Fraction(0), 3),
    rationals(Fraction(0), 4),
    st.booleans(),
)
def test_one_bound_for_all_nodes_is_settled_as_the_lemma_says(network, top, gamma, b, unit):
    weights = [Fraction(w) for w in network.weights or [1] * network.m]
    weights = [Fraction(1) for _ in weights] if unit else weights
    links = [(i, j, w) for (i, j), w in zip(network.edges.tolist(), weights, strict=True)]
    number = check.constant
    one = check.Cuts(
        None, ([*range(network.n)], links), number(gamma), number(b), number(1), number(0)
    )
    n, common = network.n, math.lcm(*(w.denominator for w in weights))
    degrees = sorted(sum(v in link[:2] for link in links) for v in range(n))
    fits, fewest = True, 1 if any(d % 2 for d in degrees) else 2
    for s in range(1, n // 2 + 1):
        leaving = sum(max(d - s + 1, 0) for d in degrees[:s])
        grains = max(fewest, leaving, math.ceil(2 * common * s * (n - s) / (n * top)))
        fits &= b * grains / common >= 2 * gamma * s * (n - s) / Fraction(n)
    if fits:
        one.settle(top)
    else:
        with pytest.raises(check.Reject, match="may fail"):
            one.settle(top)


def test_numbers_of_thousands_of_digits_do_not_go_with_many_nodes():
    n, long = 90000, str(10**3990)
    inputs = {"graph": graph(n, [(i, i + 1) for i in range(n - 1)]), "gamma": long, "b": long}
    with pytest.raises(check.Reject, match="too long"):
        checked(ABOVE, [cuts({"kind": "tree"})], inputs, THRESHOLD)


@pytest.mark.parametrize("long", [False, True])
def test_a_cut_of_long_numbers_counts_for_many(long, monkeypatch):
    monkeypatch.setattr(check, "CUT_STEPS", 100)
    weights = [f"1/{long_number(k)}" if long else f"1/{k + 3}" for k in range(4)]
    inputs = {"graph": RING | {"weights": weights}, "gamma": "0", "b": "1"}
    witness = [cuts(enumeration(0, 1, 2, 3))]
    if long:
        with pytest.raises(check.Reject, match="too many cuts"):
            checked(ABOVE, witness, inputs, THRESHOLD)
    else:
        checked(ABOVE, witness, inputs, THRESHOLD)


def test_a_run_of_long_numbers_stops_at_the_budget():
    a, c = 25, 4
    edges = [(i, a + j) for i in range(a) for j in range(c)]
    inputs = {
        "graph": graph(a + c, edges, weights=[f"1/{long_number(i)}" for i, _ in edges]),
        "beta": "1",
        "x0": [str(i) for i in range(a + c)],
        "t": "1",
    }
    piece = (f"1/{10**20}", ["0"] * (a + c), ["-1"] * len(edges))
    with pytest.raises(check.Reject, match="numbers too long"):
        checked(AGREES, [run(piece, piece, piece)], inputs, RUNS)


def test_bits_times_edges_are_limited(monkeypatch):
    item = {"kind": "sparse_ldl", "order": [0, 1, 2, 3], "bits": 100}
    checked(GAP_ABOVE, [item], {"graph": RING, "s": "1"}, KINDS)
    monkeypatch.setattr(check, "LIVE", 799)
    with pytest.raises(check.Reject, match="too much"):
        checked(GAP_ABOVE, [item], {"graph": RING, "s": "1"}, KINDS)


def test_rows_that_are_moved_in_an_elimination_are_counted(monkeypatch):
    """Each child of a hub and of one of many nodes leaves rows to move into the hub's wide one."""
    middle, n = 60, 3061
    children = range(middle + 1, n)
    edges = [(0, i) for i in children] + [(1 + i % middle, i) for i in children]
    item = {"kind": "sparse_ldl", "order": [*children, *range(middle + 1)], "bits": 20}
    checked(GAP_ABOVE, [item], {"graph": graph(n, edges), "s": "1/10"}, KINDS)
    monkeypatch.setattr(check, "CUT_STEPS", 100)
    with pytest.raises(check.Reject, match="too much"):
        checked(GAP_ABOVE, [item], {"graph": graph(n, edges), "s": "1/10"}, KINDS)


def test_no_factor_of_a_graph_without_weights_has_weights():
    kinds = {"graph": "unweighted graph"}
    checked(["nodes(graph) == 4"], [], {"graph": {"product": [PAIR, PAIR]}}, kinds)
    with pytest.raises(check.Reject, match="without weights"):
        checked(["nodes(graph) == 6"], [], {"graph": {"product": [PAIR, PATH]}}, kinds)
