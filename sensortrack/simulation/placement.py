"""Where sensors stand and who is linked with whom, from a few keys of a scenario."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sensortrack.data import load_network, network_places
from sensortrack.errors import InputError
from sensortrack.network_families import family_network
from sensortrack.networks import Network, read_network
from sensortrack.tables import Pair, Vector

from .parts import SensorPart, need, one_of

Floats = NDArray[np.float64]
MOST = 500
"""Sensors that are placed at most."""


@dataclass(frozen=True)
class NetworkPart:
    """Links between the sensors: exactly one of five ways to say it.

    ``links`` names them; ``family`` is one of the numbered families, whose nodes are the sensors in
    order; ``data`` a real network that is shipped, likewise; ``file`` a GraphML or CSV file whose
    nodes have the names of the sensors; ``radius_m`` links all sensors that are no farther apart.
    """

    links: tuple[Pair, ...] = ()
    family: str = ""
    data: str = ""
    file: str = ""
    radius_m: float = 0.0


@dataclass(frozen=True)
class PlacementPart:
    """Sensors that are not listed: on a ``ring``, at ``random`` in a square, or as a ``network``.

    A ring has the radius, a square the side and a real network the larger extent ``size_m``, around
    ``centre_m``. ``network`` places sensors at the nodes of the network of ``data``.
    """

    kind: str
    count: int = 0
    size_m: float = 1000.0
    centre_m: Vector = (0.0, 0.0, 0.0)
    seed: int = 0


def placed(part: PlacementPart, network: NetworkPart) -> tuple[SensorPart, ...]:
    """Make the sensors of a placement.

    Raises
    ------
    InputError
        With the name of the key that is out of range.
    """
    one_of("placement.kind", part.kind, ("ring", "random", "network"))
    need(part.size_m > 0, "placement.size_m", f"{part.size_m}", "a size above 0 is needed")
    if part.kind == "network":
        need(bool(network.data), "network.data", "not given", "a real network is needed")
        names = load_network(network.data).names
        places = network_places(network.data)
        flat = places - (places.max(axis=0) + places.min(axis=0)) / 2
        flat = flat * part.size_m / np.ptp(flat, axis=0).max()
    else:
        needed = f"2 to {MOST} sensors are needed"
        need(2 <= part.count <= MOST, "placement.count", f"{part.count}", needed)
        names = [str(k) for k in range(1, part.count + 1)]
        flat = _ring(part) if part.kind == "ring" else _square(part)
    corner = np.array(part.centre_m)
    return tuple(
        SensorPart(name, (x + corner[0], y + corner[1], float(corner[2])))
        for name, (x, y) in zip(names, flat.tolist(), strict=True)
    )


def _ring(part: PlacementPart) -> Floats:
    angle = 2 * np.pi * np.arange(part.count) / part.count
    return part.size_m * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _square(part: PlacementPart) -> Floats:
    need(part.seed >= 0, "placement.seed", f"{part.seed}", "a number of 0 or more is needed")
    return part.size_m * (np.random.default_rng(part.seed).random((part.count, 2)) - 0.5)


def network_of(part: NetworkPart, names: tuple[str, ...], places: Floats) -> Network:
    """The network of the sensors.

    Parameters
    ----------
    part : NetworkPart
    names : tuple of str
    places : array (n, 2)
        In m.

    Raises
    ------
    InputError
        Not exactly one way is given, a name is unknown, the number of nodes differs from that of
        the sensors, or the network is not connected.
    """
    ways = [key for key in WAYS if getattr(part, key)]
    found, needed = " and ".join(ways) or "nothing", f"one of {', '.join(WAYS)} is needed"
    need(len(ways) == 1, "network", found, needed)
    key = ways[0]
    made = WAYS[key](part, names, places)
    needed = "a connected network is needed"
    count = len(made.components())
    need(count == 1, f"network.{key}", f"{count} parts without a link between them", needed)
    return made


def _linked(part: NetworkPart, names: tuple[str, ...], _: Floats) -> Network:
    edges = []
    for pair in part.links:
        for name in pair:
            one_of("network.links", name, names)
        edges.append(sorted(map(names.index, pair)))
    return Network(names, np.array(edges))


def _near(part: NetworkPart, names: tuple[str, ...], places: Floats) -> Network:
    apart = np.linalg.norm(places[:, None] - places[None], axis=2)
    edges = np.argwhere(np.triu(apart <= part.radius_m, 1))
    return Network(names, edges.reshape(-1, 2))


def _numbered(part: NetworkPart, names: tuple[str, ...], _: Floats) -> Network:
    key = "family" if part.family else "data"
    try:
        made = family_network(part.family) if part.family else load_network(part.data)
    except InputError as error:
        raise InputError(f"network.{key}", error.found, error.needed, error.cure) from None
    found, needed = f"{made.n} nodes", f"{len(names)} are needed, one a sensor"
    need(made.n == len(names), f"network.{key}", found, needed)
    return replace(made, names=names, factors=(), edges=np.asarray(made.edges))


def _read(part: NetworkPart, names: tuple[str, ...], _: Floats) -> Network:
    try:
        made = read_network(part.file)
    except InputError as error:
        raise InputError("network.file", error.found, error.needed, error.cure) from None
    for name in made.names:
        needed = f"one of the sensors {', '.join(names)} is needed"
        need(name in names, "network.file", f"a node {name!r}", needed)
    places = np.array([names.index(name) for name in made.names])
    return Network(names, np.sort(places[np.asarray(made.edges)], axis=1))


WAYS: Mapping[str, Callable[[NetworkPart, tuple[str, ...], Floats], Network]] = {
    "links": _linked,
    "family": _numbered,
    "data": _numbered,
    "file": _read,
    "radius_m": _near,
}
