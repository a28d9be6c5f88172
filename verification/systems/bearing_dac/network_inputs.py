"""What questions about consensus on a network are asked with, checked before any arithmetic."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from sensortrack.networks import Network
from verification.exact.cuts.cut_components import even, flat
from verification.input_words import positive

Numbers = tuple[Fraction, ...]

LARGEST = Fraction(10) ** 100
SMALLEST = 1 / LARGEST
"""Sizes of numbers whose squares and quotients still are doubles."""


def network_of(values: Mapping[str, Any]) -> Network:
    """The network, after checking that it has an edge and that all numbers are of usable size.

    Raises
    ------
    InputError
        It has none, or a number or weight is not 0 and not from 1e-100 to 1e100 in size.
    """
    usable_numbers(values)
    network: Network = values["graph"]
    if network.weights is not None:
        _usable("weight", network.weights)
    if network.m == 0:
        raise InputError("graph", "no edge", "an edge between some of the nodes is needed")
    return network


def usable_numbers(values: Mapping[str, Any]) -> None:
    """Check that all numbers that were given are 0 or of usable size.

    Raises
    ------
    InputError
        A number is not 0 and not from 1e-100 to 1e100 in size.
    """
    for name, value in values.items():
        _usable(name, value)


def _usable(name: str, value: Any) -> None:
    if isinstance(value, tuple):
        if len(value) and isinstance(value[0], Fraction) and even(value):
            value = value[:1]
        for entry in value:
            _usable(name, entry)
    elif isinstance(value, Fraction) and value and not SMALLEST <= abs(value) <= LARGEST:
        size = len(str(abs(value.numerator))) - len(str(value.denominator))
        needed = "0 or numbers from 1e-100 to 1e100 in size are needed"
        raise InputError(name, f"a number of about 1e{size}", needed)


def bounds_of(values: Mapping[str, Any]) -> Numbers:
    """gamma at each node, after checking that it is not negative.

    Raises
    ------
    InputError
        A bound is negative.
    """
    gamma: Numbers = values["gamma"]
    low = min(gamma)
    if low < 0:
        node = values["graph"].names[gamma.index(low)]
        where = "" if even(gamma) else f" at node {node}"
        raise InputError("gamma", f"{low}{where}", "bounds of at least 0 are needed")
    return gamma


def gain_of(values: Mapping[str, Any]) -> Fraction:
    """beta, after checking that it is positive.

    Raises
    ------
    InputError
        beta is zero or negative.
    """
    return positive(values, "beta", "a gain")


def graph_data(network: Network, product: bool = False) -> dict[str, Any]:
    """The certificate's graph: given by its factors only where the witness is about them."""
    return network.to_data() if product else flat(network).to_data()


def node_data(values: Numbers) -> Fraction | list[Fraction]:
    """The certificate's numbers at the nodes: one number where all are the same."""
    return values[0] if even(values) else list(values)


def pieces(network: Network) -> list[list[int]]:
    """Components of two nodes or more: the others always agree with themselves."""
    return [nodes for nodes in network.components() if len(nodes) > 1]


def component_notes(network: Network, counts: str) -> tuple[str, ...]:
    """A note for a network that is not connected."""
    count = len(network.components())
    return () if count == 1 else (f"{count} components, each on its own: {counts}",)


def squared_norm(x: Sequence[Fraction]) -> Fraction:
    """|x|^2."""
    return sum((v * v for v in x), Fraction(0))
