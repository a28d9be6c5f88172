"""All cuts of a small network, one by one: the plain road that clever ones are compared with."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from sensortrack.networks import Network

LARGEST = 16
"""Most nodes: 2^15 - 1 cuts."""


class CutData(NamedTuple):
    """Weight k, disturbance N and p = s (n - s)/n of a cut."""

    k: Fraction
    load: Fraction
    p: Fraction


def enumerate_all(network: Network, gamma: Sequence[Fraction]) -> list[CutData]:
    """Measure every cut, straight from the definitions.

    Parameters
    ----------
    network : Network
        2 to 16 nodes, connected or not.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance.

    Returns
    -------
    list of CutData
        One for each of the 2^(n-1) - 1 ways to split the nodes in two.

    Raises
    ------
    ValueError
        The network has fewer than 2 or more than 16 nodes.
    """
    n = network.n
    if not 2 <= n <= LARGEST:
        raise ValueError(f"{n} nodes; 2 to {LARGEST} are needed")
    masks = np.arange(1, 2 ** (n - 1))  # the last node is never inside
    inside = (masks[:, None] >> np.arange(n)) & 1 == 1
    weights = network.exact_weights()
    found = []
    for side in inside:
        s = int(side.sum())
        leaving = side[network.edges[:, 0]] != side[network.edges[:, 1]]
        k = sum((w for w, leaves in zip(weights, leaving, strict=True) if leaves), Fraction(0))
        within = sum((g for g, here in zip(gamma, side, strict=True) if here), Fraction(0))
        share = Fraction(s, n)
        load = (1 - share) * within + share * (sum(gamma, Fraction(0)) - within)
        found.append(CutData(k, load, Fraction(s * (n - s), n)))
    return found
