"""Fewest links of a cut by the number of nodes inside, and the rate of consensus from it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
ENUMERATED = 16
"""Nodes up to which all cuts are looked at."""
ROOM = 1e-9
"""Relative room for rounding in an eigenvalue."""


@dataclass(frozen=True, eq=False)
class Profile:
    """What cuts of a network cost.

    Parameters
    ----------
    n : int
        Nodes.
    fewest : array (n // 2,) of float
        Entry s - 1 is no larger than the number of links of any cut with s nodes inside.
    gap : float
        lambda_2, computed.
    """

    n: int
    fewest: Floats
    gap: float

    @property
    def threshold(self) -> float:
        """No smaller than the gain per unit of gamma that keeps agreement; infinite for parts."""
        size = np.arange(1, len(self.fewest) + 1)
        p = size * (self.n - size) / self.n
        if not len(p):
            return 0.0
        return float((2 * p / self.fewest).max()) if (self.fewest > 0).all() else np.inf

    def rate(self, beta: Floats, gamma: Floats) -> Floats:
        """Rate r at which disagreement falls at least, in units of the signal per s.

        Parameters
        ----------
        beta, gamma : array (entries,)
            Gain, and bound of the rate of each node's signal.

        Returns
        -------
        array (entries,)
            Negative where disagreement may grow; infinite for a single node.
        """
        if self.n < 2:
            return np.full(beta.shape, np.inf)
        size = np.arange(1, len(self.fewest) + 1)
        p = size * (self.n - size) / self.n
        rates = (np.multiply.outer(beta, self.fewest) - 2 * np.multiply.outer(gamma, p)) / np.sqrt(
            p
        )
        found: Floats = rates.min(axis=1)
        return found - ROOM * np.abs(found)


def profile_of(nodes: Sequence[int], edges: NDArray[np.int64]) -> Profile:
    """Profile of the network of some nodes; links to others are left out.

    Up to `ENUMERATED` nodes every cut is counted. Above, a cut has lambda_2 p links at least, and a
    connected network one.
    """
    place = {node: i for i, node in enumerate(nodes)}
    inner = [(place[i], place[j]) for i, j in edges.tolist() if i in place and j in place]
    n = len(nodes)
    count = n // 2
    if n < 2 or not inner:
        return Profile(n, np.zeros(count), 0.0)
    laplacian = np.zeros((n, n))
    for i, j in inner:
        laplacian[[i, j], [i, j]] += 1
        laplacian[[i, j], [j, i]] -= 1
    values = np.linalg.eigvalsh(laplacian)
    gap = float(values[1] - ROOM * values[-1])
    if n <= ENUMERATED:
        return Profile(n, _counted(n, inner), gap)
    size = np.arange(1, count + 1)
    whole = np.ceil(np.maximum(gap * size * (n - size) / n, 0.0) - ROOM)
    return Profile(n, np.maximum(whole, 1.0 if gap > ROOM else 0.0), gap)


def _counted(n: int, edges: list[tuple[int, int]]) -> Floats:
    """Fewest links by size, over all cuts that leave the last node outside."""
    sets = np.arange(1 << (n - 1), dtype=np.int64)
    inside = [(sets >> i) & 1 for i in range(n)]
    links = np.zeros(len(sets), dtype=np.int64)
    for i, j in edges:
        links += inside[i] ^ inside[j]
    size = sum(inside, np.zeros(len(sets), dtype=np.int64))
    smaller = np.minimum(size, n - size)
    found = np.full(n // 2 + 1, len(edges), dtype=float)
    np.minimum.at(found, smaller, links.astype(float))
    return found[1:]
