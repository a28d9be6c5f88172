"""Families are those of networkx, in the numbering that the interface promises."""

import math
import sys
from itertools import product

import networkx as nx
import numpy as np
import pytest

from sensortrack.errors import InputError, MissingExtra
from sensortrack.network_families import FAMILIES, MAX_NODES, family_network, is_family
from sensortrack.networks import read_network


def rows(graph: nx.Graph, columns: int) -> nx.Graph:
    """Number the nodes (i, j) of a graph of networkx row by row."""
    return nx.relabel_nodes(graph, {(i, j): i * columns + j for i, j in graph})


def bits(graph: nx.Graph) -> nx.Graph:
    """Number the nodes (b, b, ...) by binary value."""
    return nx.relabel_nodes(graph, {node: int("".join(map(str, node)), 2) for node in graph})


EXPECTED = {
    "path:2": nx.path_graph(2),
    "path:7": nx.path_graph(7),
    "cycle:3": nx.cycle_graph(3),
    "cycle:8": nx.cycle_graph(8),
    "complete:2": nx.complete_graph(2),
    "complete:7": nx.complete_graph(7),
    "star:2": nx.star_graph(1),
    "star:7": nx.star_graph(6),
    "bipartite:1,1": nx.complete_bipartite_graph(1, 1),
    "bipartite:3,4": nx.complete_bipartite_graph(3, 4),
    "grid:1,2": nx.path_graph(2),
    "grid:5,1": nx.path_graph(5),
    "grid:3,4": rows(nx.grid_2d_graph(3, 4), 4),
    "torus:3,3": rows(nx.grid_2d_graph(3, 3, periodic=True), 3),
    "torus:4,5": rows(nx.grid_2d_graph(4, 5, periodic=True), 5),
    "hypercube:1": nx.path_graph(2),
    "hypercube:2": bits(nx.hypercube_graph(2)),
    "hypercube:5": bits(nx.hypercube_graph(5)),
    "petersen": nx.petersen_graph(),
    "karate": nx.karate_club_graph(),
}


@pytest.mark.parametrize("text", EXPECTED)
def test_families_equal_those_of_networkx(text):
    network, graph = family_network(text), EXPECTED[text]
    edges = [tuple(edge) for edge in network.edges.tolist()]
    assert edges == sorted((min(edge), max(edge)) for edge in graph.edges())
    assert list(network.names) == [str(i) for i in range(len(graph))]
    assert network.weights is None
    assert network.label == text
    assert network.m == len(edges)
    assert not network.edges.flags.writeable


def test_every_family_is_compared():
    assert {text.partition(":")[0] for text in EXPECTED} == set(FAMILIES) - {"random_geometric"}


@pytest.mark.parametrize(
    "text, factors",
    [
        ("grid:3,4", ["path:3", "path:4"]),
        ("grid:1,4", []),
        ("grid:4,1", []),
        ("torus:3,5", ["cycle:3", "cycle:5"]),
        ("hypercube:1", []),
        ("hypercube:3", ["path:2", "path:2", "path:2"]),
        ("complete:4", []),
    ],
)
def test_products_carry_their_factors(text, factors):
    assert [factor.label for factor in family_network(text).factors] == factors


def test_petersen_has_its_outer_cycle_first():
    outer = family_network("petersen").subnetwork(range(5))
    assert outer.edges.tolist() == family_network("cycle:5").edges.tolist()


def test_blanks_around_the_numbers_do_not_count():
    assert family_network(" grid : 3 , 4 ").label == "grid:3,4"


# ------------------------------------------------------------ random_geometric


@pytest.mark.parametrize("n, radius, seed", [(2, 2.0, 0), (40, 0.25, 1), (60, 0.1, 7), (9, 3.5, 5)])
def test_random_geometric_joins_what_is_near(n, radius, seed):
    network = family_network(f"random_geometric:{n},{radius},{seed}")
    points = np.random.default_rng(seed).random((n, 2))
    near = [
        [i, j]
        for i, j in product(range(n), repeat=2)
        if i < j and math.hypot(*(points[i] - points[j])) <= radius
    ]
    assert network.edges.tolist() == near
    assert network.n == n


def test_random_geometric_takes_the_radius_at_its_word():
    points = np.random.default_rng(3).random((30, 2))
    dx, dy = (points[:, None] - points[None]).T
    distances = np.unique(np.sqrt(dx * dx + dy * dy))[1:]  # without the zero
    for exact in distances[::40].tolist():
        at = family_network(f"random_geometric:30,{exact!r},3")
        under = family_network(f"random_geometric:30,{math.nextafter(exact, 0)!r},3")
        assert at.m == under.m + 1


def test_a_random_network_may_be_in_pieces():
    network = read_network("random_geometric:40,0.1,1")
    assert len(network.components()) > 1


# ------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    "text",
    [
        *("path", "path:", "path:0", "path:1", "path:x", "path:-3", "path:+3", "path:2.0"),
        *("path:1_0", "path:1 0", "path:٣", "path:3,4", "path:1e3", "path:nan", "path:" + "9" * 99),
        *("cycle:2", "complete:1", "star:1", "bipartite:0,3", "bipartite:3", "bipartite:1,2,3"),
        *("grid:3", "grid:1,1", "grid:0,5", "torus:2,5", "torus:5,2", "torus:5"),
        *("hypercube:0", "hypercube:-1", "hypercube:25", "hypercube:40"),
        *("petersen:5", "petersen:", "karate:34", "random_geometric", "random_geometric:5,0.3"),
        *("random_geometric:1,1,1", "random_geometric:5,0,1", "random_geometric:5,-1,1"),
        *("random_geometric:5,nan,1", "random_geometric:5,inf,1", "random_geometric:5,1e999,1"),
        *("random_geometric:5,0.3,-1", "random_geometric:5,0.3,1.5", "random_geometric:x,0.3,1"),
        *("random_geometric:5,1e-999,1", "random_geometric:5,0x1,1", "random_geometric:5,0.3,"),
    ],
)
def test_bad_numbers_show_how_the_family_is_typed(text):
    assert is_family(text)
    with pytest.raises(InputError) as caught:
        read_network(text)
    kind = text.partition(":")[0]
    assert caught.value.name == "graph"
    assert f"{kind} takes {FAMILIES[kind].takes}" in str(caught.value)
    assert FAMILIES[kind].usage in caught.value.cure


def test_a_torus_says_why_its_rings_have_three_nodes():
    with pytest.raises(InputError, match="a loop or a double edge"):
        read_network("torus:2,2")


@pytest.mark.parametrize(
    "text",
    [
        f"path:{MAX_NODES + 1}",
        "cycle:99999999999",
        "star:60000000",
        "complete:20000",
        "bipartite:10000,10000",
        "grid:100000,100000",
        "torus:10000,10000",
        "random_geometric:99999999,0.1,1",
        "random_geometric:20000,2,1",
    ],
)
def test_what_would_fill_the_memory_is_refused(text):
    with pytest.raises(InputError, match="at most 50000000 nodes and 50000000 edges"):
        read_network(text)


def test_unknown_families_are_told_the_nearest():
    with pytest.raises(InputError, match=r"Did you mean hypercube:d\?"):
        family_network("hypercub:3")


def test_karate_needs_networkx(monkeypatch):
    monkeypatch.setitem(sys.modules, "networkx", None)
    with pytest.raises(MissingExtra, match=r"sensortrack\[verify\]"):
        family_network("karate")


# ----------------------------------------------------------------------- size


@pytest.mark.parametrize(
    "text, nodes, edges",
    [
        ("path:1000000", 10**6, 10**6 - 1),
        ("grid:1000,1000", 10**6, 2 * 10**6 - 2000),
        ("hypercube:20", 2**20, 20 * 2**19),
    ],
)
def test_a_million_nodes_are_cheap(text, nodes, edges):
    network = family_network(text)
    assert (network.n, network.m) == (nodes, edges)
    assert network.edges.shape == (edges, 2)
    assert network.is_connected()
