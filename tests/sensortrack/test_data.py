"""The shipped networks against numbers that were computed elsewhere."""

import csv
from importlib.resources import files
from pathlib import Path

import networkx as nx
import numpy as np
import pytest

from sensortrack import data
from sensortrack.data import different, load_network, real_networks
from sensortrack.errors import InputError
from sensortrack.networks import read_network

OUTSIDE = Path(__file__).parents[1] / "data" / "real_networks.csv"
ROWS = list(csv.DictReader(OUTSIDE.read_text().splitlines()))
EDGES = str(files("sensortrack.data") / "graphs" / "edges.csv")


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["graph"])
def test_networks_have_the_numbers_computed_elsewhere(row):
    network = load_network(row["graph"])
    spectrum = np.linalg.eigvalsh(network.laplacian().toarray())
    degrees = network.laplacian().diagonal()
    graph = nx.Graph(network.edges.tolist())

    assert network.label == row["graph"]
    assert network.n == int(row["nodes"])
    assert network.m == int(row["edges"])
    assert network.is_connected() == (row["connected"] == "True")
    assert (degrees.min(), degrees.max()) == (int(row["min_degree"]), int(row["max_degree"]))
    assert spectrum[1] == pytest.approx(float(row["algebraic_connectivity"]), abs=6e-10)
    assert spectrum[-1] == pytest.approx(float(row["laplacian_max_eigenvalue"]), abs=6e-9)
    assert nx.diameter(graph) == int(row["diameter"])
    assert nx.node_connectivity(graph) == int(row["node_connectivity"])
    assert nx.is_bipartite(graph) == (row["bipartite"] == "True")


def test_all_networks_are_compared():
    assert real_networks() == tuple(row["graph"] for row in ROWS)


@pytest.mark.parametrize("name", real_networks())
def test_the_file_read_by_a_user_is_the_same_network(name):
    shipped, read = load_network(name), read_network(EDGES, name=name)
    numbered = sorted(sorted(int(read.names[i]) for i in edge) for edge in read.edges.tolist())
    assert numbered == sorted(shipped.edges.tolist())


def test_nodes_carry_their_real_names():
    network = load_network("sndlib_polska")
    assert list(network.names[:3]) == ["Gdansk", "Bydgoszcz", "Kolobrzeg"]


@pytest.mark.parametrize(
    "names, expected",
    [
        ([], []),
        (["a", "b"], ["a", "b"]),
        (["a", "b", "a"], ["a (0)", "b", "a (2)"]),
        (["a", "a", "a (0)"], ["a (0) (0)", "a (1)", "a (0) (2)"]),
    ],
)
def test_names_that_occur_twice_get_their_place(names, expected):
    assert different(names) == expected


def test_an_unknown_network_is_told_the_nearest():
    with pytest.raises(InputError, match=r"Did you mean sndlib_polska\?"):
        load_network("sndlib_poland")


def test_the_licence_goes_with_the_data():
    notice = files(data).joinpath("graphs", "NOTICE.md").read_text(encoding="utf-8")
    assert "Copyright (c) 2023 Piotr Jurkiewicz" in notice
    assert "Permission is hereby granted" in notice
