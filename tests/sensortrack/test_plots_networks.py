"""A network with a cut, drawn with matplotlib."""

import matplotlib as mpl
import numpy as np
import pytest

from sensortrack.data import load_network, network_places
from sensortrack.errors import InputError
from sensortrack.networks import read_network
from sensortrack.plots import COLOURS, draw_cut, style


@pytest.fixture
def axes():
    from matplotlib.figure import Figure

    with style():
        return Figure().add_subplot()


@pytest.mark.parametrize("label, side", [("petersen", [0, 1, 2, 3, 4]), ("path:300", range(150))])
def test_the_links_of_the_cut_are_the_thick_ones(axes, label, side):
    network = read_network(label)
    draw_cut(axes, network, side)
    thin, thick = axes.collections[:2]
    assert thick.get_linewidths()[0] > thin.get_linewidths()[0]
    assert len(thick.get_segments()) == {"petersen": 5, "path:300": 1}[label]
    assert len(thin.get_segments()) + len(thick.get_segments()) == network.m


def test_the_given_side_is_filled_where_it_lies(axes):
    network, places = load_network("sndlib_polska"), network_places("sndlib_polska")
    draw_cut(axes, network, [1, 2, 7, 9], places)
    _, filled = axes.collections[2:]
    assert np.allclose(filled.get_offsets(), places[[1, 2, 7, 9]])
    assert np.allclose(filled.get_facecolor()[0], mpl.colors.to_rgba(COLOURS["printed"]))


@pytest.mark.parametrize(
    "name, arguments",
    [
        ("side", ([0, 6], None)),
        ("side", ([-1], None)),
        ("places", ([0], np.zeros((5, 2)))),
        ("places", ([0], np.full((6, 2), np.nan))),
    ],
)
def test_what_does_not_fit_the_network_is_refused(axes, name, arguments):
    with pytest.raises(InputError) as error:
        draw_cut(axes, read_network("path:6"), *arguments)
    assert error.value.name == name


def test_large_networks_need_places(axes):
    with pytest.raises(InputError, match="places"):
        draw_cut(axes, read_network("path:2000"), [0])
