"""One step of sign-based consensus in discrete time, in exact rationals.

Without its disturbance the law x' in -beta B W SGN(B'x) is the gradient flow of beta times the
total variation TV(x) = sum of w_ij |x_i - x_j|. Its explicit step over h subtracts
h beta B W sgn(B'x); its implicit step is the point x in y - h beta B W SGN(B'x), that is

    x = argmin 1/2 |x - y|^2 + h beta TV(x).

The level sets of x are minimum cuts: the nodes above a level m are those that can keep more than m
after each edge has carried all that it can. Sets of nodes are split at their mean until every set
can even itself out.

References
----------
D. S. Hochbaum, "An efficient algorithm for image segmentation, Markov random fields and related
problems", Journal of the ACM 48 (2001): levels by minimum cuts.
A. Chambolle and J. Darbon, "On total variation minimization and surface evolution using parametric
maximum flows", International Journal of Computer Vision 84 (2009).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from sensortrack.networks import Network

from .balancing import balanced

Numbers = Sequence[Fraction]
Link = tuple[int, int, int]


@dataclass(frozen=True)
class Levelled:
    """The minimiser with the flow that proves it.

    Parameters
    ----------
    values : tuple of Fraction
        x, one a node: y less the net outflow of `flows`.
    flows : tuple of Fraction
        One an edge, from its first node to its second: at most the capacity in size, and the
        capacity from the larger to the smaller where the two values differ.
    """

    values: tuple[Fraction, ...]
    flows: tuple[Fraction, ...]


def levelled(links: Sequence[Link], y: Sequence[int]) -> Levelled:
    """Minimise 1/2 |x - y|^2 + sum of capacity |x_i - x_j|.

    Parameters
    ----------
    links : sequence of (int, int, int)
        Two nodes, the smaller first, and the capacity of each edge.
    y : sequence of int
        One number a node.

    Returns
    -------
    Levelled
    """
    y, values, flows = list(y), [Fraction(0)] * len(y), [Fraction(0)] * len(links)
    work = [(list(range(len(y))), list(range(len(links))))]
    while work:
        nodes, edges = work.pop()
        size, total = len(nodes), sum(y[i] for i in nodes)
        at = {node: place for place, node in enumerate(nodes)}
        inner = [(at[i], at[j], size * c) for i, j, c in (links[e] for e in edges)]
        found, stuck = balanced(inner, [size * y[i] - total for i in nodes])
        if not stuck:
            for i in nodes:
                values[i] = Fraction(total, size)
            for e, flow in zip(edges, found, strict=True):
                flows[e] = Fraction(flow, size)
            continue
        high = {nodes[place] for place in stuck}
        sides: dict[bool, list[int]] = {True: [], False: []}
        for e in edges:
            i, j, c = links[e]
            if (i in high) == (j in high):
                sides[i in high].append(e)
            else:
                flow = c if i in high else -c
                flows[e], y[i], y[j] = Fraction(flow), y[i] - flow, y[j] + flow
        for side, within in sides.items():
            work.append(([i for i in nodes if (i in high) == side], within))
    return Levelled(tuple(values), tuple(flows))


def proximal(network: Network, y: Numbers, length: Fraction) -> Levelled:
    """Minimise 1/2 |x - y|^2 + length TV(x) on a network.

    Parameters
    ----------
    network : Network
        Of any number of components; m edges.
    y : sequence of Fraction, length n
    length : Fraction
        Step h times gain beta, not negative.

    Returns
    -------
    Levelled
        ``values`` x with ``flows`` f on the edges: x = y - B f, |f_e| <= length w_e.
    """
    capacities = [length * weight for weight in network.exact_weights()]
    unit = math.lcm(*(v.denominator for v in (*y, *capacities)))
    links = [
        (i, j, int(c * unit)) for (i, j), c in zip(network.edges.tolist(), capacities, strict=True)
    ]
    found = levelled(links, [int(v * unit) for v in y])
    return Levelled(tuple(v / unit for v in found.values), tuple(f / unit for f in found.flows))


def implicit_step(
    network: Network, x: Numbers, length: Fraction, push: Numbers | None = None
) -> tuple[Fraction, ...]:
    """The implicit step: the state x + M push, levelled.

    Parameters
    ----------
    network : Network
    x : sequence of Fraction, length n
        State, or error.
    length : Fraction
        Step h times gain beta, not negative.
    push : sequence of Fraction, length n, optional
        Change of the averaged signals during the step, |push_i| <= h gamma_i; M takes its mean in
        each component off. None for no disturbance.

    Returns
    -------
    tuple of Fraction
        The state one step later.
    """
    return proximal(network, _pushed(network, x, push), length).values


def explicit_step(
    network: Network, x: Numbers, length: Fraction, push: Numbers | None = None
) -> tuple[Fraction, ...]:
    """The explicit step x - length B W sgn(B'x) + M push, with sgn(0) = 0.

    Parameters and result are those of `implicit_step`.
    """
    after = _pushed(network, x, push)
    for (i, j), weight in zip(network.edges.tolist(), network.exact_weights(), strict=True):
        flow = length * weight * ((x[i] > x[j]) - (x[i] < x[j]))
        after[i], after[j] = after[i] - flow, after[j] + flow
    return tuple(after)


def centred(network: Network, x: Numbers) -> list[Fraction]:
    """M x: each component's mean taken off."""
    centred = list(x)
    for nodes in network.components():
        mean = sum((x[i] for i in nodes), Fraction(0)) / len(nodes)
        for i in nodes:
            centred[i] -= mean
    return centred


def _pushed(network: Network, x: Numbers, push: Numbers | None) -> list[Fraction]:
    if push is None:
        return [Fraction(v) for v in x]
    return [v + change for v, change in zip(x, centred(network, push), strict=True)]
