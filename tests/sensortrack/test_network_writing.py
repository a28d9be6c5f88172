"""What is written as GraphML is read back as it was."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sensortrack.errors import InputError
from sensortrack.network_graphml import graphml_network
from sensortrack.network_writing import graphml_text
from sensortrack.networks import Network
from tests.strategies import networks


@given(networks(1, 7, weighted=True))
def test_networks_are_read_back_as_they_were(network):
    weight = "weight" if network.m else None
    found = graphml_network(graphml_text(network), "again", weight=weight)
    assert found.names == network.names
    assert np.array_equal(found.edges, network.edges)
    assert (found.weights or ()) == (network.weights or ())


NAMES = st.text("<>&\"'é漢 ab/", min_size=1).map(str.strip).filter(bool)


@given(st.lists(NAMES, min_size=2, unique=True))
def test_names_are_read_back_as_they_were(names):
    network = Network(names, np.empty((0, 2), dtype=np.int64))
    assert graphml_network(graphml_text(network), "again").names == network.names


@pytest.mark.parametrize("name", ["a\x1b[2J", "\r", "\ud800", "\x00"])
def test_names_that_xml_cannot_hold_are_refused(name):
    with pytest.raises(InputError, match="graph"):
        graphml_text(Network([name, "b"], np.array([[0, 1]])))
