"""Gains of sign-based consensus: the sharp threshold, the printed one, and one given gain."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network
from verification.answers import Answer
from verification.certificates.make import certificate
from verification.exact.cuts.extreme import decide, threshold
from verification.exact.laplacians.spectral_gap import connectivity_value
from verification.exact.rationals import nearest

from .brackets import BY_INTEGERS, SYSTEM, answer, too_long
from .critical import explained
from .network_inputs import (
    Numbers,
    bounds_of,
    component_notes,
    gain_of,
    graph_data,
    network_of,
    node_data,
    pieces,
)

LARGEST = "the largest threshold counts"
NO_LAMBDA = "lambda_2 of a network of this size was not computed"


def gain_threshold(values: Mapping[str, Any]) -> Answer:
    """Smallest gain at or above which no disturbance drives agents apart.

    Parameters
    ----------
    values : mapping
        ``graph``: Network; ``gamma``: tuple of Fraction, one a node, bounds on the rates.

    Returns
    -------
    Answer
        With a certificate where one is short enough, beside the printed gain.

    Raises
    ------
    InputError
        The network has no edge, or a bound is negative.

    References
    ----------
    George, Theorem 1.
    """
    network, gamma = network_of(values), bounds_of(values)
    found = threshold(network, gamma)
    inputs = {}
    if found.clear is not None:  # else there is no certificate, and the network may be large
        inputs = {"graph": graph_data(network, found.product), "gamma": node_data(gamma)}
    exact = None if found.value is None else {"kind": "rational", "value": str(found.value)}
    shown = answer(
        "gain_threshold",
        inputs,
        found,
        (found.lower, found.upper),
        None if found.value is None else nearest(found.value),
        exact,
        component_notes(network, LARGEST),
        printed_gain(network, gamma),
    )
    return replace(shown, more=explained(network, found, gamma))


def decide_gain(values: Mapping[str, Any]) -> Answer:
    """Decide whether a gain keeps agreement whatever the disturbance.

    Parameters
    ----------
    values : mapping
        ``graph``, ``gamma`` as in `gain_threshold`; ``beta``: a positive rational.

    Returns
    -------
    Answer
        PROVED or REFUTED with a certificate, else UNDECIDED; margin = beta - threshold.

    Raises
    ------
    InputError
        The network has no edge, a bound is negative, or beta <= 0.
    """
    network, gamma, beta = network_of(values), bounds_of(values), gain_of(values)
    found = threshold(network, gamma)
    holds, witness = decide(network, gamma, beta, found)
    margin = None if found.value is None else nearest(beta - found.value)
    notes = component_notes(network, LARGEST)
    if holds is None or witness is None or too_long(network):
        reason = f"beta lies between the proved bounds {found.lower} and {found.upper}"
        if holds is not None:
            reason = f"{BY_INTEGERS}: {found.lower} and {found.upper}, and beta is not between"
        more = explained(network, found)
        return Answer(verdict="UNDECIDED", margin=margin, notes=(*notes, reason), more=more)
    verdict = "PROVED" if holds else "REFUTED"
    inputs = {
        "graph": graph_data(network, found.product),
        "gamma": node_data(gamma),
        "beta": beta,
    }
    document = certificate(SYSTEM, "gain", inputs, [witness], case=verdict)
    more = explained(network, found)
    return Answer(verdict=verdict, certificate=document, margin=margin, notes=notes, more=more)


def printed_threshold(values: Mapping[str, Any]) -> Answer:
    """The printed gain 1 + gamma sqrt(n)/lambda_2.

    Parameters, errors and references are those of `gain_threshold`.

    Returns
    -------
    Answer
        SUPPORTED: computed in floating point.
    """
    network, gamma = network_of(values), bounds_of(values)
    value = printed_gain(network, gamma)
    notes = [*component_notes(network, LARGEST)]
    if len(set(gamma)) > 1:
        notes.append("the theorem knows one gamma: the largest of each component")
    if value is None:
        return Answer(verdict="UNDECIDED", notes=(*notes, NO_LAMBDA))
    return Answer(value=value, notes=tuple(notes))


def printed_gain(network: Network, gamma: Numbers) -> float | None:
    """1 + gamma sqrt(n)/lambda_2, the largest over the components."""
    gains = []
    for nodes in pieces(network):
        lam = connectivity_value(network.subnetwork(nodes))
        if not lam:
            return None
        gains.append(1 + nearest(max(gamma[i] for i in nodes)) * math.sqrt(len(nodes)) / lam)
    return max(gains)


def reaches_printed_gain(network: Network, gamma: Numbers, beta: Fraction) -> bool:
    """Whether beta is at least the printed gain, but for rounding."""
    printed = printed_gain(network, gamma)
    return printed is not None and nearest(beta) >= printed * (1 - 1e-12)
