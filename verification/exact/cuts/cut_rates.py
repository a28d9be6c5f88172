"""What a routing says about rates: a bound on the threshold is a bound on every cut's weight.

If 2 p/k <= g for all cuts of a connected network, a cut of s nodes has a weight of at least 2 p/g,
p = s (n - s)/n. Weights are multiples of a unit fraction, so that this may be rounded up. In a
small cut a node has at most s - 1 of its neighbours beside it, and the others are across. Where all
nodes have an even number of neighbours, an even number of links leaves every set. With one bound
gamma for all nodes N depends on s alone, and the least (beta k - N)/sqrt(p) follows.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np

from ..cut_problem import Aim, Hurdle, Problem


def least_weights(task: Problem, up: Fraction) -> Iterator[tuple[int, int, int]]:
    """Least weight, load and size of the cuts of s = 1, ..., n/2 nodes.

    Parameters
    ----------
    task : Problem
        One bound for all nodes.
    up : Fraction
        Upper bound on 2 p/k, positive.

    Yields
    ------
    tuple of int
        k in the task's unit, at least 1; N times n and the unit of gamma; s.
    """
    n, gamma = task.n, task.gamma[0]
    factor = Fraction(2 * task.weight_unit, n) / up
    top, bottom = factor.numerator, factor.denominator
    degrees = np.sort(np.bincount(task.edges.ravel(), minlength=n))
    fewest = 1 if (degrees % 2).any() else 2
    for s in range(1, n // 2 + 1):
        small = s <= degrees[-1]
        out = int(np.maximum(degrees[:s] - (s - 1), 0).sum()) if small else 0
        yield max(fewest, out, -(-top * s * (n - s) // bottom)), task.load(s, s * gamma), s


def shown_hurdle(
    task: Problem, start: Hurdle, goal: Hurdle, aim: Aim, up: Fraction
) -> Hurdle | None:
    """The strongest hurdle that a bound on 2 p/k shows for all cuts.

    Parameters
    ----------
    task : Problem
    start : Hurdle
        Carries b and c.
    goal : Hurdle
        That of the best cut known; it is returned if all cuts are shown to clear it.
    aim : Aim
        ``RATIO`` or ``RATE``.
    up : Fraction
        Upper bound on 2 p/k.

    Returns
    -------
    Hurdle or None
        None if no rate above 0 is shown, as for bounds that are not all the same.
    """
    if aim is Aim.RATE:
        return _rate_hurdle(task, start, goal, up) if task.even else None
    top = up * Fraction(max(task.gamma), task.gamma_unit)
    if top <= task.ratio(goal) or (task.even and clears_all(task, goal, up)):
        return goal
    return task.gain_hurdle(top)


def clears_all(task: Problem, goal: Hurdle, up: Fraction) -> bool:
    """Whether no cut can fail a hurdle, as 2 p/k is at most `up`; one bound for all nodes."""
    return all(goal.clears(task.n, k, load, s) for k, load, s in least_weights(task, up))


def _rate_hurdle(task: Problem, start: Hurdle, goal: Hurdle, up: Fraction) -> Hurdle | None:
    found = goal
    for k, load, s in least_weights(task, up):
        if not found.clears(task.n, k, load, s):
            gap = start.b * k - start.c * load
            if gap <= 0:
                return None
            found = replace(start, q=s * (task.n - s), d=gap)
    return found


def is_even_ring(task: Problem) -> bool:
    """Whether a connected network is a cycle with one weight and one bound."""
    if len(task.edges) != task.n or not task.even or len(set(task.weights)) > 1:
        return False
    return bool((np.bincount(task.edges.ravel(), minlength=task.n) == 2).all())


def half_of_ring(task: Problem) -> tuple[int, ...]:
    """Half of the nodes of a ring, side by side."""
    beside: list[list[int]] = [[] for _ in range(task.n)]
    for i, j in task.edges.tolist():
        beside[i].append(j)
        beside[j].append(i)
    arc, here, before = [0], 0, beside[0][0]
    while len(arc) < task.n // 2:
        first, second = beside[here]
        before, here = here, second if first == before else first
        arc.append(here)
    return tuple(sorted(arc))
