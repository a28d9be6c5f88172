"""How long it takes to find and prove an exact gain threshold, against the size of the network."""

from __future__ import annotations

from fractions import Fraction

import pytest

from sensortrack.data import load_network, real_networks
from sensortrack.networks import Network, read_network
from verification.exact.cuts.extreme import threshold

LABELS = (
    "sndlib_polska",
    "sndlib_janos_us",
    "sndlib_germany50",
    "karate",
    "random_geometric:60,0.25,1",
    "random_geometric:100,0.2,2",
    "complete:120",
    "path:10000",
    "grid:100,100",
)
"""From a dozen nodes to ten thousand: searched, routed, dense, a tree, a product."""


def network_of(label: str) -> Network:
    return load_network(label) if label in real_networks() else read_network(label)


@pytest.mark.parametrize("label", LABELS)
def test_exact_threshold(benchmark, label: str) -> None:
    network = network_of(label)
    bounds = [Fraction(1)] * network.n

    found = benchmark.pedantic(threshold, (network, bounds), rounds=3)

    kind = found.clear["parts"][0]["kind"]
    benchmark.extra_info |= {"nodes": network.n, "edges": network.m, "witness": kind}
    benchmark.extra_info |= {"threshold": str(found.value)}
    assert found.closed
