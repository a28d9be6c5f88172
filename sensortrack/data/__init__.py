"""Small real data sets, each with its licence in a NOTICE beside it."""

from __future__ import annotations

import csv
from collections import Counter
from functools import cache
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from sensortrack.errors import InputError
from sensortrack.networks import Network

from .recorded import TRACKS, load_track

__all__ = ["TRACKS", "different", "load_network", "load_track", "network_places", "real_networks"]

DRAWN = frozenset({"sndlib_newyork"})
"""Networks whose coordinates are those of a drawing, not degrees."""


def real_networks() -> tuple[str, ...]:
    """Names of the real communication networks that are shipped.

    Returns
    -------
    tuple of str
        What :func:`load_network` takes, sources and licence in ``graphs/NOTICE.md``.
    """
    return tuple(dict.fromkeys(row["graph"] for row in _table("nodes")))


def load_network(name: str) -> Network:
    """Load a real communication network.

    Parameters
    ----------
    name : str
        One of :func:`real_networks`.

    Returns
    -------
    Network
        Unweighted, in the numbering of the collection; nodes carry their real names, and those
        that share one their number behind it.

    Raises
    ------
    InputError
        With the name ``graph`` if there is no network of that name.
    """
    if name not in real_networks():
        from difflib import get_close_matches

        near = get_close_matches(name, real_networks(), n=1)
        cure = f"Did you mean {near[0]}?" if near else ""
        needed = f"one of {', '.join(real_networks())}"
        raise InputError("graph", f"{name!r} is no network that is shipped", needed, cure)
    nodes = {row["node"]: row["name"] for row in _table("nodes") if row["graph"] == name}
    numbers = {node: number for number, node in enumerate(nodes)}
    edges = [
        sorted((numbers[row["source"]], numbers[row["target"]]))
        for row in _table("edges")
        if row["graph"] == name
    ]
    return Network(different(list(nodes.values())), np.array(edges), label=name)


def network_places(name: str) -> NDArray[np.float64]:
    """Where the nodes of a real network are, on a map.

    Parameters
    ----------
    name : str
        One of :func:`real_networks`.

    Returns
    -------
    ndarray, shape (n, 2)
        East and north, in degrees of the middle latitude (so that a map has one scale), or in the
        units of a drawing; in the order of the network's nodes.

    Raises
    ------
    InputError
        With the name ``graph`` if there is no network of that name.
    """
    size = load_network(name).n
    rows = [(row["x"], row["y"]) for row in _table("nodes") if row["graph"] == name]
    places = np.array(rows, dtype=float).reshape(size, 2)
    if name not in DRAWN:
        places[:, 0] *= np.cos(np.radians(places[:, 1].mean()))
    return places


def different(names: list[str]) -> list[str]:
    """Make names different: those that occur twice get their place behind them.

    Parameters
    ----------
    names : list of str
        Names, some perhaps repeated.

    Returns
    -------
    list of str
        ``["a", "b", "a"]`` becomes ``["a (0)", "b", "a (2)"]``; a name that is still taken gets
        its place once more.
    """
    while max(Counter(names).values(), default=1) > 1:
        times = Counter(names)
        names = [
            f"{name} ({place})" if times[name] > 1 else name for place, name in enumerate(names)
        ]
    return names


@cache
def _table(name: str) -> tuple[dict[str, str], ...]:
    text = files(__name__).joinpath("graphs", f"{name}.csv").read_text(encoding="utf-8")
    return tuple(csv.DictReader(text.splitlines()))
