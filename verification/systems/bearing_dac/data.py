"""What the questions about consensus share: checked data, components, and lambda_2."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from sensortrack.errors import InputError
from sensortrack.networks import Network
from verification.exact.rationals import nearest
from verification.exact.spectral_gap import (
    NoBracketError,
    connectivity_bracket,
    connectivity_estimate,
)

BY_COMPONENT = "the network has {} components; each agrees on its own average, and the {} counts"


def disturbance(values: Mapping[str, Any]) -> tuple[Fraction, ...]:
    """Bounds gamma_i on the disturbance, one a node.

    Raises
    ------
    InputError
        One of them is negative.
    """
    gamma: tuple[Fraction, ...] = values["gamma"]
    low = min(gamma)
    if low < 0:
        raise InputError("gamma", f"{low}", "bounds of at least 0 are needed")
    return gamma


def positive_gain(values: Mapping[str, Any]) -> Fraction:
    """The gain beta.

    Raises
    ------
    InputError
        It is not above 0.
    """
    beta: Fraction = values["beta"]
    if beta <= 0:
        raise InputError("beta", f"{beta}", "a gain above 0 is needed")
    return beta


def explicit(network: Network) -> Network:
    """The same network by its edges, without factors."""
    if not network.factors:
        return network
    return Network(
        names=network.names,
        edges=np.array(network.edges),
        weights=network.weights,
        label=network.label,
    )


def parts_note(network: Network, which: str) -> tuple[str, ...]:
    """Say that a disconnected network is answered by component, and which component counts."""
    if network.is_connected():
        return ()
    return (BY_COMPONENT.format(len(network.components()), which),)


def components(network: Network) -> list[tuple[Network, Sequence[int]]]:
    """Components of two nodes or more, with their node numbers in the network."""
    if network.is_connected():
        return [(network, range(network.n))]
    lists = [nodes for nodes in network.components() if len(nodes) > 1]
    return [(network.subnetwork(nodes), nodes) for nodes in lists]


@dataclass(frozen=True)
class Connectivity:
    """lambda_2 of a connected network as a double, and what could not be proved about it."""

    value: float
    notes: tuple[str, ...] = ()


def connectivity(network: Network) -> Connectivity:
    """lambda_2 of a connected network: bracketed exactly where feasible, else in floating point.

    Raises
    ------
    NoBracketError
        Neither road leads to a value.
    """
    try:
        gap = connectivity_bracket(network)
        return Connectivity(nearest((gap.lower + gap.upper) / 2))
    except NoBracketError as error:
        if network.factors:
            inner = [connectivity(factor) for factor in network.factors]
            return min(inner, key=lambda one: one.value)
        value = connectivity_estimate(network)
        if value is None:
            raise
        return Connectivity(value, (f"lambda_2 in floating point: {error}",))


def norm(x: Sequence[Fraction]) -> float:
    """Euclidean norm, to the last digit or so."""
    square = sum((v * v for v in x), Fraction(0))
    return float(root_below(square))


def root_below(square: Fraction, bits: int = 120) -> Fraction:
    """A rational at most sqrt(square), `bits` bits long; the root itself if that is rational."""
    if square == 0:
        return Fraction(0)
    top, bottom = math.isqrt(square.numerator), math.isqrt(square.denominator)
    if top * top == square.numerator and bottom * bottom == square.denominator:
        return Fraction(top, bottom)
    size = square.numerator.bit_length() - square.denominator.bit_length()
    shift = max(0, bits - size // 2)
    scaled = square.numerator * 4**shift // square.denominator
    return Fraction(math.isqrt(scaled), 2**shift)
