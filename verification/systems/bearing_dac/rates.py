"""How fast sign-based consensus agrees: rates, times, and the connectivity that the paper uses."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate
from verification.exact.cuts.cut_components import spread
from verification.exact.cuts.extreme import CutBracket, margin, slowest
from verification.exact.laplacians.elimination import CHECKED
from verification.exact.laplacians.spectral_gap import (
    Gap,
    NoBracketError,
    connectivity_bracket,
    connectivity_value,
    exact_connectivity,
)
from verification.exact.rationals import above, below, nearest
from verification.exact.square_roots import exact_square_root, square_root_beside

from .brackets import OPEN, SYSTEM, USABLE, answer
from .critical import explained
from .gains import NO_LAMBDA, reaches_printed_gain
from .network_inputs import (
    Numbers,
    bounds_of,
    component_notes,
    gain_of,
    graph_data,
    network_of,
    node_data,
    pieces,
    squared_norm,
)

LONGEST = "the largest time counts"

EDGE_BYTES = 10
"""Fewest bytes that an edge of a large network takes in a file."""

SHARP = Fraction(1, 10**10)
"""Relative width of a bracket whose middle is the value; the upper end of others is closer."""


def margin_rate_squared(values: Mapping[str, Any]) -> Answer:
    """c^2: above the threshold beta*, |x| falls at least at the rate (beta - beta*) c.

    Parameters
    ----------
    values : mapping
        ``graph``: Network.

    Returns
    -------
    Answer
        With a certificate where one is short enough.

    Raises
    ------
    InputError
        The network has no edge.
    """
    network = network_of(values)
    found = margin(network)
    exact = None if found.value is None else {"kind": "rational", "value": str(found.value)}
    shown = answer(
        "margin_rate_squared",
        {"graph": graph_data(network)},
        found,
        (found.lower, found.upper),
        None if found.value is None else nearest(found.value),
        exact,
        component_notes(network, "the smallest value counts"),
    )
    return replace(shown, more=explained(network, found))


def algebraic_connectivity(values: Mapping[str, Any]) -> Answer:
    """lambda_2, the second smallest eigenvalue of the Laplacian.

    Parameters, errors are those of `margin_rate_squared`.

    Returns
    -------
    Answer
        Proved by an elimination in integers, with a certificate where that is short enough, else
        with a note; SUPPORTED for a network whose elimination would be too long.
    """
    network = network_of(values)
    try:
        gap = connectivity_bracket(network)
    except NoBracketError as error:
        value = connectivity_value(network)
        if value is None:
            return Answer(verdict="UNDECIDED", notes=(NO_LAMBDA,))
        return Answer(value=value, notes=(f"{error}: computed, its residual checked",))
    exact = exact_connectivity(network, gap)
    data = exact.to_data() if exact else None
    width = gap.upper - gap.lower
    ends = below(gap.lower), above(gap.upper) or 0.0  # no negative zero
    notes = ["not connected"] if gap.upper == 0 else []
    if width > USABLE * gap.upper:
        return Answer(None, None, *ends, None, "UNDECIDED", notes=(*notes, OPEN))
    middle = (gap.lower + gap.upper) / 2 if width <= SHARP * gap.upper else gap.upper
    document = None
    try:
        document = _connectivity_certificate(network, gap)
    except CertificateError as error:
        notes.append(f"{_how(gap)}; no certificate: {error}")
    value = exact.nearest if exact else nearest(middle)
    return Answer(value, data, *ends, None, "PROVED", document, None, tuple(notes))


def _how(gap: Gap) -> str:
    if gap.upper == 0:
        return "proved by a vector that is constant on a component and on the rest"
    if not gap.above:
        return "a closed form of complete networks and of those that join a part to the rest"
    return f"proved by an elimination in exact integers, {gap.steps:.1e} multiplications"


def _connectivity_certificate(network: Network, gap: Gap) -> dict[str, Any]:
    if gap.steps > CHECKED or not (gap.above or gap.upper == 0):
        raise CertificateError("checking one would take more than a minute")
    if network.m > check.FILE_BYTES // EDGE_BYTES and not network.factors:
        raise CertificateError(f"a file with {network.m} edges is too large to be read")
    inputs = {"graph": network.to_data()}
    name = "algebraic_connectivity"
    if gap.upper == 0:
        return certificate(SYSTEM, name, inputs, [gap.below], "PROVED 0", lower="0", upper="0")
    witness = [gap.above, gap.below]
    return certificate(SYSTEM, name, inputs, witness, lower=gap.lower, upper=gap.upper)


def settling_time(values: Mapping[str, Any]) -> Answer:
    """|x0| over the smallest rate (beta k - N)/sqrt(p) of a cut; infinite at small gains.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``gamma``: tuple of Fraction, one a node; ``beta``: a positive
        rational; ``x0``: tuple of Fraction, one a node, projected to mean zero.

    Returns
    -------
    Answer
        With a certificate where one is short enough, beside the printed time if the gain is at
        least the printed one.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, or beta <= 0.

    References
    ----------
    George, Theorem 1.
    """
    network, gamma, beta = network_of(values), bounds_of(values), gain_of(values)
    x0: Numbers = values["x0"]
    found = slowest(network, gamma, beta, x0)
    inputs = {
        "graph": graph_data(network),
        "gamma": node_data(gamma),
        "beta": beta,
        "x0": list(x0),
    }
    notes = component_notes(network, LONGEST)
    more = explained(network, found)
    if found.infinite:
        return replace(_never(inputs, found, notes), more=more)
    printed = None
    if reaches_printed_gain(network, gamma, beta):
        printed = printed_time(network, [spread([x0[i] for i in n]) for n in pieces(network)])
    ends = square_root_beside(found.lower, down=True), square_root_beside(found.upper, down=False)
    exact = exact_square_root(found.value)
    shown = answer(
        "settling_time",
        inputs,
        found,
        ends,
        exact.nearest if exact else None,
        exact.to_data() if exact else None,
        notes,
        printed,
    )
    return replace(shown, more=more)


def _never(inputs: dict[str, Any], found: CutBracket, notes: tuple[str, ...]) -> Answer:
    """At or below the threshold a disturbance keeps a cut open for ever."""
    document = certificate(
        SYSTEM, "settling_time", inputs, [found.reaches], "INFINITE", lower="inf", upper="inf"
    )
    reason = "beta is at most the threshold: a disturbance keeps the sides of a cut apart"
    return Answer(
        math.inf, None, math.inf, math.inf, None, "PROVED", document, None, (*notes, reason)
    )


def printed_settling_time(values: Mapping[str, Any]) -> Answer:
    """The printed time |x0|/lambda_2.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``x0``: tuple of Fraction, one a node.

    Returns
    -------
    Answer
        SUPPORTED: computed in floating point.

    Raises
    ------
    InputError
        The network has no edge.
    """
    network = network_of(values)
    x0: Numbers = values["x0"]
    parts = [[x0[i] for i in nodes] for nodes in pieces(network)]
    notes = [*component_notes(network, LONGEST)]
    if any(sum(part) for part in parts):
        notes.append("x0 does not have the mean zero of an error: its norm is taken as given")
    value = printed_time(network, [squared_norm(part) for part in parts])
    if value is None:
        return Answer(verdict="UNDECIDED", notes=(*notes, NO_LAMBDA))
    return Answer(value=value, notes=tuple(notes))


def printed_time(network: Network, squares: Sequence[Fraction]) -> float | None:
    """|x0|/lambda_2, the largest over the components; their |x0|^2 are given."""
    times = []
    for nodes, square in zip(pieces(network), squares, strict=True):
        lam = connectivity_value(network.subnetwork(nodes))
        if not lam:
            return None
        times.append(nearest(square_root_beside(square, down=True) or Fraction(0)) / lam)
    return max(times)
