"""Gains that hold while links switch, while some are lost, and after the loss of an agent.

The length of the error is a Lyapunov function that all networks on the same agents share: while
beta is at or above the threshold of the network that holds at the moment, it does not grow. So the
threshold of a family of networks is the largest of its members, however fast they follow each
other; and there is none if a member is not connected.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations
from typing import Any

from sensortrack.errors import InputError
from sensortrack.networks import Network
from verification.answers import Answer, Detail
from verification.certificates.make import CertificateError, certificate
from verification.exact.cut_problem import Hurdle, problem
from verification.exact.cuts.cut_components import flat
from verification.exact.cuts.cut_families import disjoint, worst_threshold
from verification.exact.cuts.extreme import CutBracket, threshold
from verification.exact.rationals import below, nearest
from verification.input_words import brief

from .brackets import SYSTEM, answer
from .critical import cut_detail
from .network_inputs import Numbers, bounds_of, network_of, node_data

MOST = 2000
"""Networks in a family."""

MOST_NODES = 100_000
"""Nodes of all networks of a family together."""

LOOKED_AT = 20
"""Lists of links from each of which some are lost, where all ways are too many."""

DENSE = 600
"""Nodes of a network that a certificate may show to be apart."""

KEPT = "|x| is a common Lyapunov function: no link needs to hold for any length of time"
NO_DISTURBANCE = "nothing disturbs the agents: any gain keeps agreement, but not all reach it"
OLD_MEAN = (
    "the other agents stay at the average that includes the lost agent's signal, unless it hands "
    "its state w to a neighbour before it goes"
)


@dataclass(frozen=True)
class Member:
    """One network of a family.

    Parameters
    ----------
    network : Network
    gamma : tuple of Fraction
        Of its agents.
    what : str
        What makes it this one, for a reader.
    data : dict
        The same for the ``--json`` document.
    """

    network: Network
    gamma: Numbers
    what: str
    data: Mapping[str, Any]


def switching_threshold(values: Mapping[str, Any]) -> Answer:
    """Smallest gain that keeps agreement while the links switch or fail, however fast.

    Parameters
    ----------
    values : mapping
        ``graph``: Network with all links that may hold; ``gamma``: tuple of Fraction, one a node;
        ``links``: tuple of tuples of places in the edge list, the links that hold together;
        ``drop``: how many of them may be lost at the same time.

    Returns
    -------
    Answer
        Infinite if some network of the family is not connected; else with a certificate whose
        graph has the networks as its components.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, or drop is not a whole number from 0 to the
        number of links.

    References
    ----------
    George, Theorem 1, and section 5 on networks that change.
    """
    network, gamma = flat(network_of(values)), bounds_of(values)
    drop = _drop_of(values, min(map(len, values["links"])))
    if len(values["links"]) > MOST or len(values["links"]) * network.n > MOST_NODES:
        found = f"{len(values['links'])} lists for {network.n} nodes"
        needed = f"at most {MOST}, and at most {MOST_NODES} nodes in all, are needed"
        raise InputError("links", found, needed)
    count = sum(math.comb(len(places), drop) for places in values["links"])
    if count > MOST or count * network.n > MOST_NODES:
        return _too_many(network, gamma, values["links"], drop, count)
    family = list(_switched(network, gamma, values["links"], drop))
    return _family_answer("switching_threshold", family, (KEPT,))


def node_loss_threshold(values: Mapping[str, Any]) -> Answer:
    """Smallest gain that keeps agreement among the others whichever agent is lost.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``gamma``: tuple of Fraction, one a node.

    Returns
    -------
    Answer
        Infinite if some agent's loss leaves a network that is not connected.

    Raises
    ------
    InputError
        The network has no edge or fewer than three nodes, or a bound is negative.
    """
    network, gamma = flat(network_of(values)), bounds_of(values)
    if network.n < 3:
        raise InputError("graph", f"{network.n} nodes", "three are needed, so that two are left")
    if network.n * (network.n - 1) > MOST_NODES:
        reason = f"{network.n} networks of {network.n - 1} nodes are too many to decide one by one"
        return Answer(verdict="UNDECIDED", notes=(reason,))
    family = []
    for lost, name in enumerate(network.names):
        kept = [i for i in range(network.n) if i != lost]
        rest = network.subnetwork(kept)
        data = {"lost": name}
        bounds = tuple(gamma[i] for i in kept)
        family.append(Member(rest, bounds, f"without {brief(name)}", data))
    return _family_answer("node_loss_threshold", family, (OLD_MEAN,))


def _drop_of(values: Mapping[str, Any], links: int) -> int:
    """How many links may be lost, after checking that it is a number of links."""
    drop: Fraction = values["drop"]
    if drop.denominator != 1 or not 0 <= drop <= links:
        raise InputError("drop", f"{drop}", f"a whole number from 0 to {links} links is needed")
    return int(drop)


def _switched(
    network: Network, gamma: Numbers, lists: Sequence[Sequence[int]], drop: int
) -> Iterator[Member]:
    """A network for each list of links and each choice of the links that are lost."""
    for number, places in enumerate(lists, start=1):
        for gone in combinations(places, drop):
            kept = [place for place in places if place not in gone]
            lost = [[network.names[i] for i in network.edges[place].tolist()] for place in gone]
            what = f"list {number}" if len(lists) > 1 else "all links"
            if lost:
                what += " without " + ", ".join(f"{brief(a)} – {brief(b)}" for a, b in lost)
            data = {"list": number, "lost": lost}
            yield Member(_with_links(network, kept), gamma, what, data)


def _with_links(network: Network, places: Sequence[int]) -> Network:
    weights = network.weights
    if weights is not None:
        weights = tuple(weights[place] for place in places)
    return Network(network.names, network.edges[list(places)], weights, (), network.label)


def _family_answer(name: str, family: Sequence[Member], notes: tuple[str, ...]) -> Answer:
    """The largest threshold of a family."""
    for member in family:
        if not member.network.is_connected() and any(member.gamma):
            return _apart(name, member)
    if not any(any(member.gamma) for member in family):
        return Answer(value=0.0, notes=(NO_DISTURBANCE,))
    graph = disjoint([member.network for member in family])
    gamma = tuple(bound for member in family for bound in member.gamma)
    found = worst_threshold(graph, gamma)
    worst, own = _place_of(family, found)
    shown = answer(
        name,
        {"graph": graph.to_data(), "gamma": node_data(gamma)},
        found,
        (found.lower, found.upper),
        None if found.value is None else nearest(found.value),
        None if found.value is None else {"kind": "rational", "value": str(found.value)},
        (f"the largest of {len(family)} networks", *notes),
    )
    more = {
        "worst": lambda: Detail(dict(worst.data), (("worst", worst.what),)),
        "cut": lambda: cut_detail(worst.network, own),
    }
    return replace(shown, more=more)


def _place_of(family: Sequence[Member], found: CutBracket) -> tuple[Member, CutBracket]:
    """The member that the cut is in, and the bracket with the cut in that member's numbers."""
    shift = 0
    for member in family:
        if found.cut[0] < shift + member.network.n:
            return member, replace(found, cut=tuple(i - shift for i in found.cut))
        shift += member.network.n
    raise AssertionError("the cut is in no network of the family")


def _apart(name: str, member: Member) -> Answer:
    """A network that is not connected never agrees."""
    network = member.network
    document, notes = None, [f"{member.what}: not connected, so that no gain is enough"]
    if network.n <= DENSE:
        part = network.components()[0]
        inside = set(part)
        x = [network.n - len(part) if i in inside else -len(part) for i in range(network.n)]
        inputs = {"graph": network.to_data(), "gamma": node_data(member.gamma)}
        witness = [{"kind": "vector", "x": x}]
        try:
            document = certificate(
                SYSTEM, name, inputs, witness, "INFINITE", lower="inf", upper="inf"
            )
        except CertificateError as error:
            notes.append(f"no certificate: {error}")
    verdict = "SUPPORTED" if document is None else "PROVED"
    ends = None if document is None else math.inf
    more = {"worst": lambda: Detail(dict(member.data), (("worst", member.what),))}
    return Answer(math.inf, None, ends, ends, None, verdict, document, None, tuple(notes), more)


def _too_many(
    network: Network, gamma: Numbers, lists: Sequence[Sequence[int]], drop: int, count: int
) -> Answer:
    """What bad cuts say about a family that is too large to go through."""
    found: list[tuple[Fraction, Member]] = []
    for number, places in enumerate(lists[:LOOKED_AT], start=1):
        whole = _with_links(network, places)
        for side in _candidates(whole, gamma):
            leaves = [e for e, (i, j) in enumerate(whole.edges.tolist()) if side[i] != side[j]]
            gone = sorted(leaves, key=lambda e: (-_weight(whole, e), e))[:drop]
            if len(gone) < drop:
                gone += [e for e in range(whole.m) if e not in set(gone)][: drop - len(gone)]
            kept = [e for e in range(whole.m) if e not in set(gone)]
            lost = [[whole.names[i] for i in whole.edges[e].tolist()] for e in gone]
            what = "all links" if len(lists) == 1 else f"list {number}"
            what += " without " + ", ".join(f"{brief(a)} – {brief(b)}" for a, b in lost)
            rest = _with_links(whole, kept)
            member = Member(rest, gamma, what, {"list": number, "lost": lost})
            if not rest.is_connected() and any(gamma):
                return _apart("switching_threshold", member)
            task = problem(rest, gamma)
            k, load, _ = task.measure([i for i, inside in enumerate(side) if inside])
            found.append((task.ratio(Hurdle(load, k)), member))
    least, worst = max(found, key=lambda pair: pair[0])
    notes = (
        f"{count} networks are too many to decide one by one: {worst.what} needs at least lower",
    )
    more = {"worst": lambda: Detail(dict(worst.data), (("worst", worst.what),))}
    return Answer(lower=below(least), verdict="UNDECIDED", notes=notes, more=more)


def _candidates(network: Network, gamma: Numbers) -> list[list[bool]]:
    """Sides of the critical cut and of the lightest cut of one node."""
    if network.m == 0:
        return [[node == 0 for node in range(network.n)]]
    cut = set(threshold(network, gamma).cut)
    degrees = [Fraction(0)] * network.n
    for e, ends in enumerate(network.edges.tolist()):
        for node in ends:
            degrees[node] += _weight(network, e)
    light = degrees.index(min(degrees))
    return [
        [node in cut for node in range(network.n)],
        [node == light for node in range(network.n)],
    ]


def _weight(network: Network, place: int) -> Fraction:
    return Fraction(1) if network.weights is None else network.weights[place]
