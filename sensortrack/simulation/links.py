"""Which links of a network carry at which sample: outages, and losses by chance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network
from sensortrack.tables import Pair

from .observing import generator
from .parts import Scenario

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class DropoutPart:
    """Each link fails in each period with this probability, independent of all others."""

    rate: float = 0.0


@dataclass(frozen=True)
class OutagePart:
    """From one time to another a link between two sensors carries nothing."""

    link: Pair
    from_s: float
    until_s: float = float("inf")


def carrying(scenario: Scenario, seed: int, time: Floats, network: Network) -> NDArray[np.bool_]:
    """Whether each link carries in the period that ends at each sample, samples by links."""
    names, rate = list(network.names), scenario.parts.get("dropout", DropoutPart()).rate
    found = np.ones((len(time), network.m), dtype=bool)
    for column, (i, j) in enumerate(np.asarray(network.edges)):
        pair = sorted((names[i], names[j]))
        if rate > 0:
            found[:, column] &= generator(seed, *pair, "dropout").random(len(time)) >= rate
        for outage in scenario.parts["outage"]:
            if sorted(outage.link) == pair:
                off = (time >= outage.from_s - 1e-9) & (time < outage.until_s - 1e-9)
                found[off, column] = False
    return found


def outage_events(scenario: Scenario) -> list[dict[str, Any]]:
    """When each outage begins, and ends if it does."""
    found: list[dict[str, Any]] = []
    for outage in scenario.parts["outage"]:
        link = f"link between {outage.link[0]} and {outage.link[1]}"
        text = f"{link} carries nothing"
        found.append({"time": outage.from_s, "kind": "link_lost", "text": text})
        if outage.until_s <= scenario.header.duration_s:
            text = f"{link} carries again"
            found.append({"time": outage.until_s, "kind": "link_back", "text": text})
    return found
