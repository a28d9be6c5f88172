"""Cuts and the second eigenvalue: k >= lambda_2 p, which no routing beats where a network expands.

References
----------
M. Fiedler, "Algebraic connectivity of graphs", Czechoslovak Mathematical Journal 23 (1973).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from sensortrack.networks import DecimalNames, Network

from ..cut_problem import Problem
from ..laplacians.elimination import CHECKED
from ..laplacians.spectral_gap import NoBracketError, connectivity_bracket, connectivity_value

LARGEST = 3000
"""Most nodes of a network whose second eigenvalue is asked."""

DENSE = 60
"""Nodes from which on it is asked first where a third of all pairs are linked."""

WORTH = 2.0
"""A bound above so many times the best cut's is not looked for."""

STEP = 500
"""Multiplications that the checker counts as one step of a search."""


@dataclass(frozen=True)
class GapBound:
    """An upper bound on 2 p/k of all cuts, with its witness and what checking it costs in steps."""

    up: Fraction
    part: dict[str, Any]
    steps: int


def is_dense(task: Problem) -> bool:
    """Whether a routing would be long and no better than the second eigenvalue."""
    return DENSE < task.n <= LARGEST and 6 * len(task.edges) > task.n * (task.n - 1)


def may_improve(task: Problem, cut: tuple[int, int]) -> bool:
    """Whether the second eigenvalue promises as much as a routing does.

    Parameters
    ----------
    task : Problem
    cut : (int, int)
        Weight, in the task's unit, and number of nodes of the sparsest cut known: no routing proves
        less than its 2 p/k.
    """
    if task.n > LARGEST:
        return False
    k, s = cut
    ratio = 2 * s * (task.n - s) * task.weight_unit / (task.n * k)
    value = connectivity_value(_network(task))
    return value is not None and WORTH * ratio * value > 2


def gap_bound(task: Problem) -> GapBound | None:
    """Bound 2 p/k by an elimination in integers.

    Parameters
    ----------
    task : Problem
        Connected.

    Returns
    -------
    GapBound or None
        None if the elimination is too long to be checked, or proves nothing.
    """
    try:
        gap = connectivity_bracket(_network(task))
    except NoBracketError:
        return None
    if not gap.above or gap.steps > CHECKED or gap.lower <= 0:
        return None
    order, bits = gap.above["order"], gap.above["bits"]
    part = {"kind": "gap", "least": gap.lower, "order": order, "bits": bits}
    steps = int(gap.steps / STEP * (1 + (bits // 100) ** 2))
    return GapBound(2 / gap.lower, part, steps)


def _network(task: Problem) -> Network:
    even = all(weight == task.weight_unit for weight in task.weights)
    weights = None if even else [Fraction(w, task.weight_unit) for w in task.weights]
    return Network(DecimalNames(task.n), task.edges, None if weights is None else tuple(weights))
