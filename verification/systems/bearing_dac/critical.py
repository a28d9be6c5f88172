"""What the cut that decides looks like on the user's network, and which edge would help."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network
from verification.answers import Detail
from verification.exact.cuts.edge_choice import EdgeChoice, choose_edge
from verification.exact.cuts.extreme import CutBracket, threshold
from verification.exact.rationals import nearest
from verification.input_words import brief

from .network_inputs import Numbers

SHOWN = 12
"""Nodes, and edges, that are named to a reader."""

LISTED = 10_000
"""Nodes, and edges, that the JSON document lists."""

LARGEST = 3_000_000
"""Edges of a product that are listed to describe a cut of it."""

HELPED = 200_000
"""Nodes of a network to which one edge is not worth looking for."""


def explained(
    network: Network, found: CutBracket, gamma: Numbers | None = None
) -> dict[str, Callable[[], Detail | None]]:
    """What can be said about the cut that decides, for ``Answer.more``.

    Parameters
    ----------
    network : Network
    found : CutBracket
    gamma : tuple of Fraction, optional
        Given where the bracket is the gain threshold's: then also which edge would lower it.
    """
    more: dict[str, Callable[[], Detail | None]] = {"cut": lambda: cut_detail(network, found)}
    if gamma is not None:
        more["edge_to_add"] = lambda: edge_detail(network, gamma, found)
    return more


def cut_detail(network: Network, found: CutBracket) -> Detail | None:
    """The cut that attains the bound, by names: the smaller side and the edges that leave it.

    Parameters
    ----------
    network : Network
    found : CutBracket

    Returns
    -------
    Detail or None
        None for a product of too many edges.
    """
    if network.factors and network.m > LARGEST:
        return None
    side, home = _sides(network, found)
    leaves = np.flatnonzero(side[network.edges[:, 0]] != side[network.edges[:, 1]])
    nodes, names = np.flatnonzero(side), network.names
    listed = [names[i] for i in nodes[:LISTED].tolist()]
    edges = [[names[i], names[j]] for i, j in network.edges[leaves[:LISTED]].tolist()]
    data = {
        "nodes": listed,
        "edges": edges,
        "size": len(nodes),
        "of": home,
        "edge_count": len(leaves),
        "weight": str(_weight(network, leaves)),
    }
    weight = "" if network.weights is None else f" of weight {data['weight']}"
    count = "1 edge" if len(leaves) == 1 else f"{len(leaves)} edges"
    inside = _shortened([brief(name) for name in listed[:SHOWN]], len(nodes))
    across = _shortened([_between(*ends) for ends in edges[:SHOWN]], len(leaves))
    return Detail(
        data,
        (
            ("cut", f"{len(nodes)} of {home} nodes: {inside}"),
            ("across it", f"{count}{weight}: {across}"),
        ),
    )


def edge_detail(network: Network, gamma: Numbers, found: CutBracket) -> Detail | None:
    """The edge that lowers the threshold most.

    Parameters
    ----------
    network : Network
        If it is not connected, edges within the component that decides are compared.
    gamma : tuple of Fraction, length n
    found : CutBracket
        Of the threshold.

    Returns
    -------
    Detail or None
        None where no edge can be added or the network is too large for one to matter.
    """
    if not found.lower or network.n > HELPED:
        return None
    chosen = edge_of(network, gamma, found)
    if chosen is None:
        return None
    choice, least = chosen
    known = choice.bracket is not None and choice.bracket.value is not None
    useless = choice.best and least == found.lower
    ends = [network.names[i] for i in choice.edge]
    data = {
        "edge": None if useless else ends,
        "value": nearest(least) if known else None,
        "exact": str(least) if known else None,
        "lower": nearest(least),
        "best": choice.best,
        "compared": choice.candidates,
    }
    what = "no single one lowers the threshold"
    if not useless:
        what = f"{_between(*ends)}: {_effect(choice, known, least, found.lower)}"
    return Detail(data, (("edge to add", what),))


def edge_of(
    network: Network, gamma: Numbers, found: CutBracket
) -> tuple[EdgeChoice, Fraction] | None:
    """The edge to add to the component that decides, and what the network needs then at least."""
    side, _ = _sides(network, found)
    home = _home(network, side)
    place = {node: i for i, node in enumerate(home)}
    cut = [place[i] for i in np.flatnonzero(side).tolist()]
    choice = choose_edge(network.subnetwork(home), [gamma[i] for i in home], cut)
    if choice is None:
        return None
    least = choice.least
    rest = [node for node in range(network.n) if node not in place]
    if rest and (other := network.subnetwork(rest)).m:
        least = max(least, threshold(other, [gamma[i] for i in rest]).lower or least)
    return replace(choice, edge=(home[choice.edge[0]], home[choice.edge[1]])), least


def _effect(choice: EdgeChoice, known: bool, least: Fraction, before: Fraction) -> str:
    """What an edge does to the threshold, in words."""
    lowered = f"{nearest(least):.6g}, {nearest(100 * (1 - least / before)):.3g} % lower"
    if not known:
        return f"not below {lowered}; chosen by the cuts that are known"
    if choice.best:
        return f"{lowered}, the best of {choice.candidates} edges across the cut"
    return f"{lowered}, the best that was tried"


def _home(network: Network, side: NDArray[np.bool_]) -> list[int]:
    """The component that the cut is in."""
    parts = network.components()
    start = int(np.argmax(side))
    return parts[0] if len(parts) == 1 else next(nodes for nodes in parts if start in set(nodes))


def _sides(network: Network, found: CutBracket) -> tuple[NDArray[np.bool_], int]:
    """The smaller side of the cut in its component, and that component's size."""
    side = np.zeros(network.n, dtype=bool)
    if found.product:
        factor = int(found.reaches["factor"])
        after = 1
        for other in network.factors[factor + 1 :]:
            after *= other.n
        size = network.factors[factor].n
        coordinate = np.arange(network.n) // after % size
        side = np.isin(coordinate, list(found.cut))
    else:
        side[list(found.cut)] = True
    home = _home(network, side)
    if 2 * side.sum() > len(home):
        inside = np.zeros(network.n, dtype=bool)
        inside[home] = True
        side = inside & ~side
    return side, len(home)


def _weight(network: Network, places: NDArray[np.int64]) -> Fraction:
    if network.weights is None:
        return Fraction(len(places))
    return sum((network.weights[place] for place in places.tolist()), Fraction(0))


def _between(one: str, other: str) -> str:
    """An edge by names that play no tricks with a terminal."""
    return f"{brief(one)} – {brief(other)}"


def _shortened(texts: Sequence[str], count: int) -> str:
    if count <= len(texts):
        return ", ".join(texts)
    return f"{', '.join(texts)} and {count - len(texts)} more"
