"""A network with its critical cut, in the look of the reports."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from sensortrack.errors import InputError
from sensortrack.network_layout import spread_places
from sensortrack.networks import Network

from .style import COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SEPARATE = 200
"""Nodes up to which each is drawn as a ring and each link as a line."""

SPREAD = 1500
"""Nodes up to which places are found where none are given."""


def draw_cut(
    axes: Axes, network: Network, side: Collection[int], places: ArrayLike | None = None
) -> None:
    """Draw a network with one of its cuts: cut links thick, the given side filled.

    Parameters
    ----------
    axes : matplotlib Axes
    network : Network
    side : collection of int
        Numbers of the nodes on one side.
    places : array_like, shape (n, 2), optional
        East and north; by default nodes are spread so that distances are near hop distances.

    Raises
    ------
    InputError
        With the name ``side`` if a number is no node; with the name ``places`` if they do not fit
        the network, or are missing for more than `SPREAD` nodes.
    """
    from matplotlib.collections import LineCollection

    inside = _membership(network, side)
    spots = _places(network, places)
    first, second = network.edges.T
    cut = inside[first] != inside[second]
    few = network.n <= SEPARATE
    ends = spots[network.edges]
    thin, thick = (0.7, 2.2) if few else (0.15, 0.9)
    axes.add_collection(LineCollection(ends[~cut], colors=COLOURS["rule"], linewidths=thin))
    axes.add_collection(LineCollection(ends[cut], colors=COLOURS["printed"], linewidths=thick))
    size = 18 if few else max(0.2, 4000 / network.n)
    for members, fill in ((~inside, COLOURS["paper"]), (inside, COLOURS["printed"])):
        edge = COLOURS["run"] if few and fill == COLOURS["paper"] else fill
        face = fill if few or fill != COLOURS["paper"] else COLOURS["rule"]
        east, north = spots[members].T
        axes.scatter(east, north, s=size, facecolors=face, edgecolors=edge, zorder=3, lw=0.8)
    axes.set(aspect="equal")
    axes.set_axis_off()
    axes.autoscale_view()


def _membership(network: Network, side: Collection[int]) -> np.ndarray:
    nodes = np.array(sorted(side), dtype=np.int64)
    if nodes.size and not (nodes[0] >= 0 and nodes[-1] < network.n):
        found = f"nodes {nodes[0]} to {nodes[-1]}"
        raise InputError("side", found, f"node numbers from 0 to {network.n - 1} are needed")
    inside = np.zeros(network.n, dtype=bool)
    inside[nodes] = True
    return inside


def _places(network: Network, places: ArrayLike | None) -> np.ndarray:
    if places is None:
        if network.n > SPREAD:
            needed = f"places are needed for more than {SPREAD} nodes"
            raise InputError("places", f"none for {network.n} nodes", needed)
        return spread_places(network.n, network.edges)
    spots = np.asarray(places, dtype=float)
    if spots.shape != (network.n, 2) or not np.isfinite(spots).all():
        needed = f"finite numbers of shape ({network.n}, 2) are needed"
        raise InputError("places", f"an array of shape {spots.shape}", needed)
    return spots
