"""Gains for a network, for a wanted time, and edges that make smaller gains do."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from sensortrack.networks import Network
from verification.answers import Design, Designed, Input
from verification.exact.cuts.cut_components import components, spread
from verification.exact.cuts.edge_choice import with_edge
from verification.exact.cuts.extreme import CutBracket, slowest, threshold
from verification.exact.rationals import above, nearest
from verification.input_words import positive

from .brackets import NO_WITNESS
from .critical import edge_of
from .entry_gains import distance_above, entry_gains
from .gains import decide_gain, gain_threshold
from .network_inputs import Numbers, bounds_of, component_notes, gain_of, network_of
from .quantities import BETA, GAMMA, GRAPH, POSITIONS, RHO_MIN, V_MAX, X0
from .rates import settling_time

ROUNDS = 60
DIGITS = 12
"""Digits of a gain that is no short fraction."""

MOST_EDGES = 20
"""Edges that are added one after the other."""

KEPT = "at this gain agreement is kept; finite time needs more, which --set time and x0 ask for"
SMALLEST = "smallest gain at which no disturbance drives agents apart"
IN_TIME = "smallest gain at which agents agree from x0 in the wanted time, whatever the disturbance"
ONE_EDGE = "the edge of weight 1 whose addition lowers the gain threshold most"
SOME_EDGES = "edges of weight 1 one after the other, each the one that lowers the threshold most"
ALL_TRIED = "no other edge does better: each was tried, or leaves a cut that needs as much"
NOT_ALL = "chosen by the worst cuts that are known: other edges may do better"
IN_TURN = "each edge is the best beside those before it; other sets of as many edges may do better"
ENTRIES = "smallest gains that keep agreement on the entries of P and on those of q"


def smallest_gain(values: Mapping[str, Any]) -> Designed:
    """The gain threshold as a gain, with the certificate that it is enough.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``gamma``: tuple of Fraction, one a node.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, or all are zero: then any gain is enough.
    """
    network, gamma = network_of(values), bounds_of(values)
    if not any(gamma):
        raise InputError("gamma", "0", "a bound above 0: without disturbance any gain is enough")
    found = threshold(network, gamma)
    notes = component_notes(network, "the largest threshold counts")
    if found.upper is None:
        return Designed(objective=SMALLEST, notes=(*notes, NO_WITNESS))
    beta = _short(found.upper)
    decided = decide_gain({"graph": network, "gamma": gamma, "beta": beta})
    if decided.verdict != "PROVED":
        return Designed(objective=SMALLEST, notes=(*notes, *decided.notes))
    least = nearest(found.lower or Fraction(0))
    loose = () if found.closed else (f"a smaller gain may do, but none below {least:.6g}",)
    return Designed(
        gains={"beta": beta},
        objective=SMALLEST,
        bound={"threshold": above(found.upper)},
        verdict="PROVED",
        certificate=decided.certificate,
        notes=(*notes, *loose, KEPT),
    )


def gain_in_time(values: Mapping[str, Any]) -> Designed:
    """The smallest gain with which agents agree from a start within a time, in the worst case.

    A cut needs beta >= (N + |x0| sqrt(p)/time)/k. From the gain that one cut needs, the cut that is
    slowest at this gain gives the next one, until none is too slow.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``gamma``: tuple of Fraction, one a node; ``x0``: tuple of Fraction,
        one a node, projected to mean zero; ``time``: a positive rational, seconds.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, the time is not positive, or the agents agree
        at the start.
    """
    network, gamma = network_of(values), bounds_of(values)
    x0: Numbers = values["x0"]
    time = positive(values, "time", "a time")
    parts = components(network, gamma)
    if not any(spread([x0[i] for i in part.nodes]) for part in parts):
        needed = "a start apart from agreement is needed, or no x0 and no time"
        raise InputError("x0", "agents that agree", needed)
    beta, least = Fraction(0), Fraction(0)
    for part in parts:
        cut = tuple(part.nodes[:1])
        least = max(least, _need(network, gamma, x0, time, cut))
    beta = _short(least)
    for _ in range(ROUNDS):
        found = slowest(network, gamma, beta, x0)
        if found.upper is not None and found.upper <= time**2:
            return _timed(values, beta, least)
        need = _need(network, gamma, x0, time, found.cut)
        if need > beta:
            least, beta = max(least, need), _short(need)
        else:  # what is shown is weaker than what the cut needs
            beta = _short(beta * Fraction(21, 20))
    return Designed(objective=IN_TIME, notes=(f"no gain up to {nearest(beta):.6g} could be shown",))


def _need(
    network: Network, gamma: Numbers, x0: Numbers, time: Fraction, cut: Sequence[int]
) -> Fraction:
    """The gain at which one cut closes in time, rounded up where it is no rational."""
    inside = set(cut)
    part = next(part for part in components(network, gamma) if inside <= set(part.nodes))
    place = {node: i for i, node in enumerate(part.nodes)}
    k, load, s = part.task.measure([place[i] for i in cut])
    n = part.task.n
    weight = Fraction(k, part.task.weight_unit)
    pull = Fraction(load, n * part.task.gamma_unit)
    square = spread([x0[i] for i in part.nodes]) / time**2 * Fraction(s * (n - s), n)
    return (pull + distance_above(square)) / weight


def _timed(values: Mapping[str, Any], beta: Fraction, least: Fraction) -> Designed:
    answer = settling_time({**values, "beta": beta})
    if answer.verdict != "PROVED" or answer.upper > above(values["time"]):
        return Designed(objective=IN_TIME, notes=answer.notes)
    note = f"a cut needs at least the gain {nearest(least):.12g}"
    return Designed(
        gains={"beta": beta},
        objective=IN_TIME,
        bound={"settling_time": answer.upper},
        verdict="PROVED",
        certificate=answer.certificate,
        notes=(*answer.notes, note),
    )


def _short(value: Fraction) -> Fraction:
    """The value if it is a short fraction, else a decimal that is a little larger."""
    if value.denominator <= 10**6 and value.numerator <= 10**9:
        return value
    size = math.floor(math.log10(nearest(value))) if value < 10**300 else len(str(int(value)))
    unit = Fraction(10) ** (size + 1 - DIGITS)
    return -(-value // unit) * unit


def edges_to_add(values: Mapping[str, Any]) -> Designed:
    """Edges whose addition lowers the gain threshold, a given number of them.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``gamma``: tuple of Fraction, one a node; ``edges``: how many.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, or edges is not a number of edges.
    """
    network, gamma = network_of(values), bounds_of(values)
    count: Fraction = values["edges"]
    if count.denominator != 1 or not 1 <= count <= MOST_EDGES:
        needed = f"a whole number from 1 to {MOST_EDGES} is needed"
        raise InputError("edges", f"{count}", needed)
    return _with_edges(network, gamma, int(count), None)


def edges_for_gain(values: Mapping[str, Any]) -> Designed:
    """Edges, as few as one after the other allows, until a given gain is enough.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``gamma``: tuple of Fraction, one a node; ``beta``: a positive
        rational.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, or beta <= 0.
    """
    network, gamma, beta = network_of(values), bounds_of(values), gain_of(values)
    return _with_edges(network, gamma, MOST_EDGES, beta)


def _with_edges(network: Network, gamma: Numbers, most: int, wanted: Fraction | None) -> Designed:
    """Add edges up to a number, or until the threshold is at most what is wanted."""
    found = threshold(network, gamma)
    added: list[tuple[str, str]] = []
    best = True
    while len(added) < most and not _enough(found, wanted):
        chosen = edge_of(network, gamma, found)
        if chosen is None or (chosen[0].best and chosen[1] == found.lower):
            break
        best = best and chosen[0].best
        i, j = chosen[0].edge
        added.append((network.names[i], network.names[j]))
        network = with_edge(network, (i, j))
        found = threshold(network, gamma)
    objective = ONE_EDGE if most == 1 else SOME_EDGES
    if wanted is not None and not _enough(found, wanted):
        reason = (
            f"{len(added)} edges leave a threshold of {nearest(found.lower or Fraction(0)):.6g}"
        )
        return Designed(objective=objective, notes=(f"{reason}; no further one was found",))
    notes = [ALL_TRIED if best else NOT_ALL]
    if len(added) > 1:
        notes.append(IN_TURN)
    if not added:
        notes = ["the gain is enough without another edge"]
        if wanted is None:
            notes = ["no single edge lowers the threshold"]
    return _described(network, gamma, added, objective, tuple(notes))


def _enough(found: CutBracket, wanted: Fraction | None) -> bool:
    return wanted is not None and found.upper is not None and found.upper <= wanted


def _described(
    network: Network,
    gamma: Numbers,
    added: Sequence[tuple[str, str]],
    objective: str,
    notes: tuple[str, ...],
) -> Designed:
    answer = gain_threshold({"graph": network, "gamma": gamma})
    upper = None if answer.certificate is None else answer.certificate["upper"]
    beta = None if upper is None else Fraction(upper)
    return Designed(
        gains={} if beta is None else {"beta": beta},
        objective=objective,
        bound={} if answer.upper is None else {"threshold": answer.upper},
        verdict=answer.verdict,
        certificate=answer.certificate,
        notes=(*notes, *answer.notes),
        edges=tuple(added),
        network=network if added else None,
    )


def gains_for_entries(values: Mapping[str, Any]) -> Designed:
    """A gain for the entries of P and one for those of q.

    Parameters, errors and references are those of `entry_gains`.
    """
    answer = entry_gains(values)
    if answer.certificate is None:
        return Designed(objective=ENTRIES, notes=answer.notes)
    ends = answer.certificate["inputs"]
    return Designed(
        gains={f"beta_{entry}": _short(Fraction(ends[f"upper_{entry}"])) for entry in "Pq"},
        objective=ENTRIES,
        bound={f"threshold_{entry}": x for entry, x in zip("Pq", answer.upper, strict=True)},
        verdict="PROVED",
        certificate=answer.certificate,
        notes=answer.notes,
    )


TIME = Input("time", "number", "wanted: from x0 agents agree within this time", "s")
EDGES = Input("edges", "number", "how many edges of weight 1 to add", "")
DESIGNS = (
    Design("gain", "the smallest beta that keeps agreement", (GRAPH, GAMMA), smallest_gain),
    Design(
        "gain for a time",
        "the smallest beta with which agents agree from x0 in the wanted time",
        (GRAPH, GAMMA, X0, TIME),
        gain_in_time,
    ),
    Design(
        "edges to add",
        "edges that lower the threshold most",
        (GRAPH, GAMMA, EDGES),
        edges_to_add,
    ),
    Design(
        "edges for a gain",
        "edges to add until beta keeps agreement",
        (GRAPH, GAMMA, BETA),
        edges_for_gain,
    ),
    Design(
        "gains for the entries",
        "beta_P and beta_q for the averaged entries",
        (GRAPH, V_MAX, RHO_MIN, POSITIONS),
        gains_for_entries,
    ),
)
