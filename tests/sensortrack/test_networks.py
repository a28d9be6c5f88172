"""The network value: what it refuses at birth, and what its small methods promise."""

from fractions import Fraction

import networkx as nx
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.network_families import family_network
from sensortrack.networks import MAX_EDGES, DecimalNames, Network, read_network
from tests.strategies import connected_networks, networks, trees

TRIANGLE = [[0, 1], [0, 2], [1, 2]]


def as_networkx(network: Network) -> nx.Graph:
    graph = nx.Graph()
    graph.add_nodes_from(range(network.n))
    weights = network.weights or (Fraction(1),) * network.m
    for (i, j), weight in zip(network.edges.tolist(), weights, strict=True):
        graph.add_edge(i, j, weight=float(weight))
    return graph


# ------------------------------------------------------------------- birth


@pytest.mark.parametrize(
    "names, edges, weights, words",
    [
        ([], [], None, "no node"),
        ("abc", TRIANGLE, None, "not a list of texts"),
        (["a", 2, "c"], TRIANGLE, None, "not a list of texts"),
        (["a", "", "c"], TRIANGLE, None, "node 1 has an empty name"),
        (["a", "b", "a"], TRIANGLE, None, "two nodes are called 'a'"),
        (["a", "b", "c"], [0, 1, 2], None, "shape (3,)"),
        (["a", "b", "c"], [[0, 1, 2]], None, "shape (1, 3)"),
        (["a", "b", "c"], [[0.0, 1.0]], None, "type float64"),
        (["a", "b", "c"], [[False, True]], None, "type bool"),
        (["a", "b", "c"], [[0, 3]], None, "numbers from 0 to 2"),
        (["a", "b", "c"], [[-1, 2]], None, "numbers from 0 to 2"),
        (["a", "b", "c"], [[0, 1], [2, 2]], None, "edge 1 joins the node 'c' to itself"),
        (["a", "b", "c"], [[0, 1], [2, 1]], None, "smaller node number first"),
        (["a", "b", "c"], [[1, 2], [0, 1], [1, 2]], None, "between 'b' and 'c' is listed twice"),
        (["a", "b", "c"], TRIANGLE, [1, 2], "2 weights for 3 edges"),
        (["a", "b", "c"], TRIANGLE, [1, 0, 1], "edge 1 has the weight 0"),
        (["a", "b", "c"], TRIANGLE, [1, 1, Fraction(-1, 2)], "edge 2 has the weight"),
        (["a", "b", "c"], TRIANGLE, [1, 0.5, 1], "edge 1 has the weight 0.5"),
        (["a", "b", "c"], TRIANGLE, [1, True, 1], "edge 1 has the weight True"),
    ],
)
def test_refuses_what_is_no_simple_graph(names, edges, weights, words):
    with pytest.raises(InputError) as caught:
        Network(names, np.array(edges), weights)
    assert caught.value.name == "graph"
    assert words in str(caught.value)


def test_keeps_a_copy_that_nobody_can_change():
    edges = np.array(TRIANGLE)
    network = Network(["a", "b", "c"], edges)
    edges[0] = 2, 2
    assert network.edges.tolist() == TRIANGLE
    assert network.edges.dtype == np.int64
    with pytest.raises(ValueError, match="read-only"):
        network.edges[0] = 2, 2
    with pytest.raises(AttributeError):
        network.label = "other"


def test_an_edgeless_network_is_a_value():
    network = Network(["alone"], [])
    assert (network.n, network.m) == (1, 0)
    assert network.is_connected()
    assert network.is_tree()
    assert network.components() == [[0]]
    assert network.laplacian().toarray().tolist() == [[0.0]]


def test_whole_weights_become_fractions():
    assert Network(["a", "b"], [[0, 1]], [2]).weights == (Fraction(2),)


def test_shows_itself_without_its_edges():
    assert repr(family_network("cycle:5")) == "Network('cycle:5', n=5, m=5)"


# ----------------------------------------------------------- decimal names


@given(st.integers(0, 40), st.integers(-50, 50), st.integers(-50, 50))
def test_decimal_names_behave_as_the_tuple_of_them(count, start, stop):
    names, plain = DecimalNames(count), tuple(map(str, range(count)))
    assert len(names) == count
    assert tuple(names) == plain
    assert names[start:stop] == plain[start:stop]
    assert [name in names for name in map(str, range(-3, 45))] == [
        name in plain for name in map(str, range(-3, 45))
    ]
    for name in plain:
        assert names.index(name) == plain.index(name)


@pytest.mark.parametrize("name", ["5", "01", "-1", "", "a", "²", "1" * 30, 1, None])
def test_decimal_names_hold_nothing_else(name):
    assert name not in DecimalNames(5)


def test_decimal_names_say_what_is_missing():
    names = DecimalNames(5)
    assert names.index("3", 3) == 3
    with pytest.raises(ValueError, match="'3' is not in"):
        names.index("3", 4)
    with pytest.raises(IndexError):
        names[5]
    assert repr(names) == "DecimalNames(5)"


# ----------------------------------------------------------------- methods


@given(networks(weighted=True))
def test_laplacian_is_that_of_networkx_and_its_rows_sum_to_zero(network):
    laplacian = network.laplacian().toarray()
    expected = nx.laplacian_matrix(as_networkx(network), nodelist=range(network.n)).toarray()
    np.testing.assert_allclose(laplacian, expected, atol=1e-12)
    np.testing.assert_allclose(laplacian.sum(axis=1), 0, atol=1e-12)
    np.testing.assert_array_equal(laplacian, laplacian.T)


@given(networks())
def test_handshake(network):
    assert network.laplacian().diagonal().sum() == 2 * network.m


@given(st.booleans().flatmap(lambda weighted: networks(weighted=weighted)))
def test_every_edge_has_its_weight_and_one_where_none_are_given(network):
    exact = network.exact_weights()
    assert exact == (network.weights or (1,) * network.m)
    assert network.float_weights().tolist() == [float(weight) for weight in exact]


@given(networks(max_nodes=12))
def test_components_are_those_of_networkx_in_order(network):
    parts = network.components()
    expected = sorted(sorted(part) for part in nx.connected_components(as_networkx(network)))
    assert parts == expected
    assert all(type(node) is int for part in parts for node in part)
    assert network.is_connected() == (len(parts) == 1)


@given(networks(weighted=True), st.data())
def test_subnetwork_keeps_the_order_of_the_edge_list(network, data):
    kept = data.draw(st.lists(st.sampled_from(range(network.n)), min_size=1))
    nodes = sorted(set(kept))
    part = network.subnetwork(kept)

    old = zip(network.edges.tolist(), network.weights, strict=True)
    inside = [((i, j), weight) for (i, j), weight in old if i in nodes and j in nodes]
    assert list(part.names) == [network.names[node] for node in nodes]
    assert [(nodes[i], nodes[j]) for i, j in part.edges.tolist()] == [edge for edge, _ in inside]
    assert list(part.weights) == [weight for _, weight in inside]


def test_subnetwork_of_all_nodes_keeps_the_factors():
    grid = family_network("grid:2,3")
    assert grid.subnetwork(range(6)) is grid
    assert grid.subnetwork(range(5)).factors == ()


@pytest.mark.parametrize("nodes", [[], [-1], [3], [0, 7]])
def test_subnetwork_refuses_numbers_that_are_no_nodes(nodes):
    with pytest.raises(InputError) as caught:
        family_network("path:3").subnetwork(nodes)
    assert caught.value.name == "nodes"


@given(trees(max_nodes=12))
def test_drawn_trees_are_trees(tree):
    assert tree.is_tree()
    assert nx.is_tree(as_networkx(tree))


@given(connected_networks(max_nodes=10))
def test_tree_means_connected_and_acyclic(network):
    assert network.is_connected()
    assert network.is_tree() == nx.is_tree(as_networkx(network))


@given(networks(weighted=True))
def test_data_give_the_network_back(network):
    data = network.to_data()
    again = Network(data["nodes"], data["edges"], [Fraction(text) for text in data["weights"]])
    assert list(again.names) == list(network.names)
    assert again.edges.tolist() == network.edges.tolist()
    assert again.weights == network.weights


def test_data_without_weights_have_no_such_entry():
    assert family_network("path:2").to_data() == {"nodes": ["0", "1"], "edges": [[0, 1]]}


# ---------------------------------------------------------------- products


@given(st.lists(connected_networks(max_nodes=4) | networks(max_nodes=4), min_size=2, max_size=3))
def test_products_are_numbered_row_by_row(factors):
    product = Network.product(factors, "drawn")
    expected = as_networkx(factors[0])
    for count, factor in enumerate(factors[1:], start=1):
        size = factors[count].n
        pairs = nx.cartesian_product(expected, as_networkx(factor))
        expected = nx.relabel_nodes(pairs, {(i, j): i * size + j for i, j in pairs})
    edges = sorted((min(edge), max(edge)) for edge in expected.edges())

    assert product.n == len(expected)
    assert product.m == len(edges)  # before the edges are listed
    assert [tuple(edge) for edge in product.edges.tolist()] == edges
    assert not product.edges.flags.writeable
    assert list(product.names) == [str(i) for i in range(product.n)]
    assert product.to_data() == {"product": [factor.to_data() for factor in factors]}
    assert product.components() == sorted(sorted(p) for p in nx.connected_components(expected))
    assert product.is_connected() == nx.is_connected(expected)


def test_a_product_may_be_given_by_its_edges_as_well():
    lazy = family_network("grid:2,3")
    again = Network(lazy.names, lazy.edges[::-1], None, lazy.factors, "again")
    assert again.to_data() == lazy.to_data()


@pytest.mark.parametrize(
    "names, edges, weights",
    [
        (DecimalNames(4), [[0, 1], [0, 2], [1, 3]], None),
        (DecimalNames(4), [[0, 1], [0, 2], [1, 2], [2, 3]], None),
        (DecimalNames(5), [[0, 1], [0, 2], [1, 3], [2, 3]], None),
        (DecimalNames(4), [[0, 1], [0, 2], [1, 3], [2, 3]], [1, 1, 1, 1]),
    ],
)
def test_factors_of_another_network_are_refused(names, edges, weights):
    path = family_network("path:2")
    with pytest.raises(InputError, match="graph: "):
        Network(names, edges, weights, (path, path))


def test_a_product_needs_two_unweighted_factors():
    path = family_network("path:2")
    heavy = Network(["a", "b"], [[0, 1]], [2])
    for factors in ([], [path], [path, heavy]):
        with pytest.raises(InputError, match="graph: a product"):
            Network.product(factors)


def test_what_is_decided_from_factors_lists_no_edge():
    cube = family_network("hypercube:24")
    assert (cube.n, cube.m) == (2**24, 24 * 2**23)
    assert cube.is_connected()
    assert len(cube.to_data()["product"]) == 24
    assert "edges" not in vars(cube)
    assert cube.m > MAX_EDGES
    with pytest.raises(InputError, match="201326592 edges"):
        _ = cube.edges
    with pytest.raises(AttributeError, match="no attribute 'nodes'"):
        _ = cube.nodes


# ----------------------------------------------------------------- reading


@pytest.mark.parametrize(
    "text, words",
    [
        ("pth:6", "Did you mean path:n?"),
        ("Path:6", "Did you mean path:n?"),
        ("random-geometric:9,1,1", "Did you mean random_geometric:n,radius,seed?"),
        ("", "'' is not a family, and there is no such file"),
        ("nowhere.csv", "there is no such file"),
        ("nowhere\0.csv", "there is no such file"),
        ("x\ny", "'x\\ny' is not a family"),
        ("x" * 5000, "cannot be read"),
    ],
)
def test_what_is_neither_family_nor_file(text, words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as caught:
        read_network(text)
    assert caught.value.name == "graph"
    assert words in str(caught.value)
    first = str(caught.value).splitlines()[0]
    assert first.startswith("graph: ")
    assert len(first) < 300


def test_a_family_has_neither_name_nor_weight():
    with pytest.raises(InputError, match="graph: the name 'a' with a family"):
        read_network("path:3", name="a")
    with pytest.raises(InputError, match="weight: 'w' with a family"):
        read_network("path:3", weight="w")


def test_a_network_without_edges_is_refused():
    with pytest.raises(InputError, match="graph: random_geometric:3,1e-9,0 has 3 node"):
        read_network("random_geometric:3,1e-9,0")


def test_a_family_wins_over_a_file_and_a_path_over_the_family(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "petersen").write_text("source,target\na,b\n")
    assert read_network("petersen").n == 10
    with pytest.raises(InputError, match=r"ends in 'nothing'; a file called \.graphml"):
        read_network("./petersen")
