"""Where nodes are drawn."""

import csv
from importlib.resources import files

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.data import load_network, network_places, real_networks
from sensortrack.errors import InputError
from sensortrack.network_layout import framed, spread_places
from sensortrack.networks import read_network

DEGREE_KM = np.pi / 180 * 6371.0


@pytest.mark.parametrize("label", ["path:7", "petersen", "complete:2", "grid:3,4"])
def test_neighbours_are_drawn_nearer_than_others(label):
    network = read_network(label)
    places = spread_places(network.n, network.edges)
    apart = np.linalg.norm(places[:, None] - places[None], axis=2)
    joined = np.zeros((network.n, network.n), dtype=bool)
    joined[tuple(network.edges.T)] = joined[tuple(network.edges.T[::-1])] = True
    others = ~joined & ~np.eye(network.n, dtype=bool)
    assert not others.any() or apart[joined].mean() < apart[others].mean()


def test_one_node_and_no_edge_have_a_place():
    assert np.isfinite(spread_places(1, [])).all()
    assert np.isfinite(spread_places(3, [])).all()


@given(
    st.lists(st.tuples(*[st.floats(-1e6, 1e6)] * 2), min_size=1, max_size=9),
    st.booleans(),
)
def test_places_fit_the_frame(points, equal):
    places = framed(np.array(points), 240, 170, 10, equal)
    assert (places >= 10 - 1e-6).all()
    assert (places <= np.array([230, 160]) + 1e-6).all()


def test_north_is_up_and_a_map_has_one_scale():
    places = framed(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]]), 100, 100, 0, True)
    assert places[2, 1] < places[0, 1]
    east, north = places[1, 0] - places[0, 0], places[0, 1] - places[2, 1]
    assert north == pytest.approx(2 * east)


@pytest.mark.parametrize("name", real_networks())
def test_every_real_network_has_a_place_for_every_node(name):
    places = network_places(name)
    assert places.shape == (load_network(name).n, 2)
    assert np.isfinite(places).all()


@pytest.mark.parametrize("name", ["sndlib_polska", "sndlib_nobel_germany", "sndlib_germany50"])
def test_distances_on_the_map_are_those_of_the_collection(name):
    """The shipped distances are great circles; cos(latitude) varies by 7 % within one country."""
    table = files("sensortrack.data").joinpath("graphs", "edges.csv").read_text(encoding="utf-8")
    rows = [row for row in csv.DictReader(table.splitlines()) if row["graph"] == name]
    places = network_places(name)
    for row in rows:
        step = places[int(row["source"])] - places[int(row["target"])]
        assert np.linalg.norm(step) * DEGREE_KM == pytest.approx(float(row["distance"]), rel=0.07)


def test_an_unknown_network_has_no_places():
    with pytest.raises(InputError, match="no network that is shipped"):
        network_places("polska")
