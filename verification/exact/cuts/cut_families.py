"""The largest gain threshold of a family of connected networks, with one witness for all.

The family is written as one network whose components are its members. A cut that is bad in one
member is a hurdle for the others: most members need no more than a short search which shows that
none of their cuts is worse.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from sensortrack.networks import Network

from ..cut_problem import Aim, Hurdle
from .cut_components import Component, Item, clear_item, components, cut_item
from .cut_local import good_cut
from .cut_roads import SMALL, Budget, Shown, refute_or_show, solve
from .extreme import DEFAULT, CutBracket
from .large_cuts import large_cut

ANY_LOAD = Hurdle(0, 1)


def disjoint(networks: Sequence[Network]) -> Network:
    """One network whose components are those of the networks, nodes and edges in their order."""
    names, edges, shift = [], [], 0
    weights: list[Fraction] = []
    for place, network in enumerate(networks, start=1):
        names += [f"{place}: {name}" for name in network.names]
        edges.append(network.edges + shift)
        weights += network.exact_weights()
        shift += network.n
    plain = all(network.weights is None for network in networks)
    return Network(names, np.concatenate(edges), None if plain else tuple(weights))


def worst_threshold(
    network: Network, gamma: Sequence[Fraction], budget: Budget = DEFAULT
) -> CutBracket:
    """Largest N/k of a cut of any component.

    Parameters
    ----------
    network : Network
        At least one edge; see `disjoint`.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance, not negative.
    budget : Budget, optional
        For all components together.

    Returns
    -------
    CutBracket
        The cut attains `lower`; `clear` shows `upper` where every component was decided.

    Raises
    ------
    InputError
        The network has no edge.
    """
    parts = components(network, gamma)
    worst = _Worst(Fraction(0), parts[0], (0,))
    for part in parts:
        worst = worst.beside(part, _bad_cut(part, budget))
    items: list[Item | None] = []
    upper: Fraction | None = Fraction(0)
    for part in parts:
        shown = refute_or_show(part.task, part.task.gain_hurdle(worst.value), budget)
        if not isinstance(shown, Shown):
            solved = solve(part.task, ANY_LOAD, Aim.RATIO, budget)
            worst, shown = worst.beside(part, solved.cut), solved.shown
        if shown is None:
            upper = None
            continue
        items.append(shown.part)
        budget = replace(budget, visits=budget.visits - shown.visits)
        upper = None if upper is None else max(upper, part.task.ratio(shown.hurdle))
    cut = worst.part.whole(worst.cut)
    clear = None if upper is None else clear_item(network, parts, items)
    if upper is not None:
        upper = max(upper, worst.value)
    value = worst.value if upper == worst.value else None
    return CutBracket(worst.value, upper, cut, cut_item(cut), clear, value)


def _bad_cut(part: Component, budget: Budget) -> tuple[int, ...]:
    task = part.task
    if len(task.edges) == task.n - 1:
        return solve(task, ANY_LOAD, Aim.RATIO, budget).cut
    return (good_cut if task.n <= SMALL else large_cut)(task, ANY_LOAD, Aim.RATIO)


@dataclass(frozen=True)
class _Worst:
    """The worst cut so far, and the component it is in."""

    value: Fraction
    part: Component
    cut: tuple[int, ...]

    def beside(self, part: Component, cut: tuple[int, ...]) -> _Worst:
        """The worse of this cut and another."""
        k, load, _ = part.task.measure(cut)
        value = part.task.ratio(Hurdle(load, k))
        return _Worst(value, part, cut) if value > self.value else self
