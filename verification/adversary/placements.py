"""Search for places of sensors whose network within range is a given graph.

Places start at random and are pulled until every pair that should communicate is well within range
and every other pair well beyond it; then they are rounded to short rationals, for which the exact
test has the last word.
"""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction
from itertools import combinations

import numpy as np

Place = tuple[Fraction, Fraction]
NEAR, FAR, GRID, TRIES, STEPS = 0.85, 1.15, 20, 200, 400


def within_range(places: list[Place], radius: Fraction) -> frozenset[tuple[int, int]]:
    """Pairs of sensors within range of each other, exactly."""
    return frozenset(
        (i, j)
        for (i, a), (j, b) in combinations(enumerate(places), 2)
        if (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 <= radius**2
    )


def placement(sensors: int, links: Collection[tuple[int, int]], seed: int = 0) -> list[Place]:
    """Places in the plane whose network within range 1 has these links and no other.

    Parameters
    ----------
    sensors : int
    links : collection of (int, int)
        Smaller number first.
    seed : int, optional

    Returns
    -------
    list of (Fraction, Fraction)
        Empty if none was found.
    """
    rng, wanted = np.random.default_rng(seed), frozenset(links)
    pairs = list(combinations(range(sensors), 2))
    joined = np.array([pair in wanted for pair in pairs])
    first, second = (np.array(side) for side in zip(*pairs, strict=True))
    for _ in range(TRIES):
        x = rng.normal(size=(sensors, 2))
        for _ in range(STEPS):
            apart = x[first] - x[second]
            length = np.maximum(np.linalg.norm(apart, axis=1), 1e-9)
            error = np.where(joined, np.maximum(length - NEAR, 0), np.minimum(length - FAR, 0))
            pull = 0.2 * (error / length)[:, None] * apart
            np.subtract.at(x, first, pull)
            np.add.at(x, second, pull)
        places = [
            (Fraction(round(a * GRID), GRID), Fraction(round(b * GRID), GRID))
            for a, b in x.tolist()
        ]
        if within_range(places, Fraction(1)) == wanted:
            return places
    return []
