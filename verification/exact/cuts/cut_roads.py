"""Ways to the worst cut of one connected network, and to a witness that no cut is worse.

On a tree single edges decide. Else all cuts are searched, if few enough stay open; for the gain
threshold, disturbances are routed. A witness for one hurdle is a witness for every weaker hurdle: a
search then ends its branches no later, and what a routing leaves open shrinks.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from verification.progress import tell

from ..cells.cell_bounds import route_by_cells
from ..cells.cell_routing import CellRouting
from ..cut_problem import Aim, Hurdle, Problem
from .cut_gap import gap_bound, is_dense, may_improve
from .cut_local import congested_cut, good_cut
from .cut_orders import orders
from .cut_rates import half_of_ring, is_even_ring, shown_hurdle
from .cut_search import LARGEST, Found, Walk
from .large_cuts import large_cut
from .routing import Routing, better_routing, closes, first_routing

Part = dict[str, Any]
Cut = tuple[int, ...]

SMALL = 250
"""Up to this size every node of a good cut is moved in turn, instead of bands of nodes."""

LIMITS = (50_000, 2_000_000)
"""Visits of a search before other roads are tried, and after."""

LATE_ORDERS = 3
"""How many orders are tried up to the higher limit."""

LONG_NODES = 40
"""Up to this size a search may be far longer than the checker's, for the value alone."""

EXPLICIT = 250
"""Up to this size flows are written down, edge by edge; in larger networks they go by cells."""

NO_LOAD = Hurdle(0, 1)
"""A hurdle that no load passes."""

LOOKED_TWICE = 20_000
"""Up to this size a worse cut is looked for where a routing finds little room."""

LOOSER = tuple(Fraction(k, 1000) for k in (1003, 1010, 1030, 1100, 1300, 2000, 4000, 16000))
"""Factors by which a hurdle is weakened where it cannot be shown."""


@dataclass(frozen=True)
class Budget:
    """What may be spent on one network.

    Parameters
    ----------
    visits : int
        Nodes of a search tree in all witnesses together; the checker refuses more.
    search : int
        Nodes of a search for the value alone.
    flows : int
        Most entries n m of a routing that is written down.
    """

    visits: int = 2_000_000
    search: int = 300_000_000
    flows: int = 1_000_000


@dataclass(frozen=True)
class Shown:
    """A hurdle that all cuts pass, the witness, and how many nodes of a search tree it costs.

    There is no witness where it would be too long for the checker: then the bound stands on the
    exact integers from which it was computed.
    """

    hurdle: Hurdle
    part: Part | None
    visits: int = 0


@dataclass(frozen=True)
class Solved:
    """The worst cut that was found in one connected network.

    Parameters
    ----------
    cut : tuple of int
    hurdle : Hurdle or None
        What this cut just passes; None if it leaves no rate above 0.
    shown : Shown or None
        The strongest hurdle with a witness: closed if it is `hurdle`.
    complete : bool
        Whether a search of all cuts found no worse one, witness or not.
    """

    cut: Cut
    hurdle: Hurdle | None
    shown: Shown | None = None
    complete: bool = False

    @property
    def closed(self) -> bool:
        """Whether the cut is proved to be the worst."""
        return self.shown is not None and self.shown.hurdle == self.hurdle


def solve(task: Problem, start: Hurdle, aim: Aim, budget: Budget) -> Solved:
    """Find the worst cut of a connected network and show that it is.

    Parameters
    ----------
    task : Problem
        Two nodes or more.
    start : Hurdle
        Carries b and c for ``Aim.RATE``; for ``Aim.RATIO`` a hurdle that no load passes.
    aim : Aim
        ``RATIO`` or ``RATE``.
    budget : Budget

    Returns
    -------
    Solved
    """
    if len(task.edges) == task.n - 1:
        return _tree(task, start, aim)
    if aim is Aim.RATIO and task.total == 0:
        part = {"kind": "enumeration", "order": list(range(task.n))}
        shown = Shown(start, part, 2) if task.n <= LARGEST else None
        return Solved((0,), start, shown, True)
    solved = _with(task, start, aim, Solved((), start), _bad_cut(task, start, aim))
    solved = replace(solved, complete=is_even_ring(task))
    if is_dense(task):
        solved = _expanding(task, start, solved, aim)
    if solved.hurdle is None or solved.closed or (is_dense(task) and task.n > EXPLICIT):
        return solved
    for limit, count in zip(LIMITS, (None, LATE_ORDERS), strict=True):
        solved = _searched(task, solved, aim, min(limit, budget.visits), count)
        if solved.hurdle is None or solved.closed:
            return solved
        if limit == LIMITS[0]:
            road = _routed if aim is Aim.RATIO else _rated
            solved = road(task, start, solved, budget)
            if not (solved.closed or is_dense(task)):
                solved = _expanding(task, start, solved, aim)
            if solved.closed or task.n > EXPLICIT:
                return solved
    solved = _valued(task, solved, aim, budget)
    return _loosened(task, solved, aim, min(LIMITS[0] * 4, budget.visits))


def refute_or_show(task: Problem, hurdle: Hurdle, budget: Budget) -> Cut | Shown | None:
    """Decide one hurdle b k >= N of the weights and loads, if the budget allows.

    Returns
    -------
    tuple of int, Shown or None
        A cut that does not pass, or the witness that all cuts do, or None.
    """
    if len(task.edges) == task.n - 1:
        solved = _tree(task, NO_LOAD, Aim.RATIO)
        passes = hurdle.clears(task.n, *task.measure(solved.cut))
        return Shown(hurdle, {"kind": "tree"}) if passes else solved.cut
    if task.n > EXPLICIT:
        return None
    for order in list(orders(task))[:LATE_ORDERS]:
        found = Walk(task, order).search(hurdle, Aim.FAILURE, budget.visits)
        if found.done:
            part = {"kind": "enumeration", "order": list(order)}
            return found.cut or Shown(hurdle, part, found.visits)
    return None


def _bad_cut(task: Problem, start: Hurdle, aim: Aim) -> Cut:
    """A cut to begin with."""
    if is_even_ring(task):
        return half_of_ring(task)
    tell(f"{task.n} nodes: bad cuts")
    return (good_cut if task.n <= SMALL else large_cut)(task, start, aim)


def _with(task: Problem, start: Hurdle, aim: Aim, solved: Solved, cut: Cut) -> Solved:
    """Keep a cut if it is worse than what was found."""
    k, load, s = task.measure(cut)
    better = solved.hurdle is not None and not solved.hurdle.clears(task.n, k, load, s)
    if solved.cut and not better:
        return solved
    return replace(solved, cut=cut, hurdle=start.marked(aim, task.n, k, load, s))


def _tree(task: Problem, start: Hurdle, aim: Aim) -> Solved:
    """The worst single edge."""
    import numpy as np
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import breadth_first_order

    n, ends = task.n, task.edges
    places = np.arange(1, n)
    links = csr_matrix((places, (ends[:, 0], ends[:, 1])), shape=(n, n))
    order, parents = breadth_first_order(links, 0, directed=False)
    weight_up = [0] * n
    for (i, j), weight in zip(ends.tolist(), task.weights, strict=True):
        weight_up[i if parents[i] == j else j] = weight
    below, inside = [1] * n, list(task.gamma)
    worst, hurdle = -1, start
    for node in order[:0:-1].tolist():
        k, load = weight_up[node], task.load(below[node], inside[node])
        if worst < 0 or not hurdle.clears(n, k, load, below[node]):
            marked = start.marked(aim, n, k, load, below[node])
            if marked is None:
                return Solved(_below(parents.tolist(), order.tolist(), node), None)
            worst, hurdle = node, marked
        up = int(parents[node])
        below[up], inside[up] = below[up] + below[node], inside[up] + inside[node]
    cut = _below(parents.tolist(), order.tolist(), worst)
    return Solved(cut, hurdle, Shown(hurdle, {"kind": "tree"}), True)


def _below(parents: list[int], order: list[int], top: int) -> Cut:
    """Nodes of the subtree of a node."""
    inside = {top}
    for node in order:
        if parents[node] in inside:
            inside.add(node)
    return tuple(sorted(inside))


def _searched(task: Problem, solved: Solved, aim: Aim, limit: int, count: int | None) -> Solved:
    """Search all cuts in several orders; keep the order with the fewest visits."""
    if task.n > LARGEST:
        return solved
    walks = [Walk(task, order) for order in list(orders(task))[:count]]
    for walk in walks:
        assert solved.hurdle is not None
        found = walk.search(solved.hurdle, aim, limit)
        solved = _improved(task, solved, aim, found)
        if solved.hurdle is None:
            return replace(solved, complete=True)
        if found.done:
            return _shortest(solved, walks, limit)
    return solved


def _improved(task: Problem, solved: Solved, aim: Aim, found: Found) -> Solved:
    """Keep the cut of a search for ratio or rate: it is worse than the one before."""
    if found.cut is None or solved.hurdle is None:
        return solved
    hurdle = solved.hurdle.marked(aim, task.n, *task.measure(found.cut))
    return replace(solved, cut=found.cut, hurdle=hurdle, shown=None)


def _shortest(solved: Solved, walks: list[Walk], limit: int) -> Solved:
    """Witness in the order with the fewest visits at the final hurdle."""
    hurdle = solved.hurdle
    assert hurdle is not None
    best: Shown | None = None
    for walk in walks:
        found = walk.search(hurdle, Aim.FAILURE, best.visits - 1 if best else limit)
        if found.done:
            best = Shown(hurdle, {"kind": "enumeration", "order": list(walk.order)}, found.visits)
    return replace(solved, shown=best, complete=True)


def _routed(task: Problem, start: Hurdle, solved: Solved, budget: Budget) -> Solved:
    """Route disturbances; where that leaves room, look for a worse cut where they pile up."""
    if task.n > EXPLICIT or task.n * len(task.edges) > budget.flows:
        return _carried(task, start, solved, budget)
    try:
        routing = first_routing(task)
    except (ArithmeticError, ValueError):  # hopelessly unlike weights: numpy gives up
        return solved
    assert solved.hurdle is not None
    if not closes(task, solved.hurdle, routing.up):
        cut = congested_cut(task, start, routing.shares)
        solved = _with(task, start, Aim.RATIO, solved, cut)
        assert solved.hurdle is not None
        routing = better_routing(task, routing, solved.hurdle)
    return _with_routing(task, solved, routing)


def _rated(task: Problem, start: Hurdle, solved: Solved, budget: Budget) -> Solved:
    """What a routing of even disturbances shows about the rate."""
    if not task.even or solved.hurdle is None:
        return solved
    unit = task.with_unit_bounds()
    cut = _bad_cut(unit, NO_LOAD, Aim.RATIO)
    ratio = _routed(
        unit, NO_LOAD, _with(unit, NO_LOAD, Aim.RATIO, Solved((), NO_LOAD), cut), budget
    )
    if ratio.shown is None:
        return solved
    up = unit.ratio(ratio.shown.hurdle)
    hurdle = shown_hurdle(task, start, solved.hurdle, Aim.RATE, up)
    if hurdle is None:
        return solved
    return _stronger(task, Aim.RATE, solved, replace(ratio.shown, hurdle=hurdle))


def _expanding(task: Problem, start: Hurdle, solved: Solved, aim: Aim) -> Solved:
    """What the second eigenvalue shows, if that is more than is shown already."""
    if solved.hurdle is None:
        return solved
    k, _, s = task.measure(solved.cut)
    bound = gap_bound(task) if is_dense(task) or may_improve(task, (k, s)) else None
    if bound is None:
        return solved
    hurdle = shown_hurdle(task, start, solved.hurdle, aim, bound.up)
    if hurdle is None:
        return solved
    return _stronger(task, aim, solved, Shown(hurdle, bound.part, bound.steps))


def _carried(task: Problem, start: Hurdle, solved: Solved, budget: Budget) -> Solved:
    """The same for a large network, by cells."""
    assert solved.hurdle is not None
    try:
        routing = route_by_cells(task, task.ratio(solved.hurdle), budget.visits)
    except ArithmeticError:  # hopelessly unlike weights
        return solved
    if task.n <= LOOKED_TWICE and not closes(task, solved.hurdle, routing.up):
        cut = large_cut(task, start, Aim.RATIO, conductances=routing.conductances)
        solved = _with(task, start, Aim.RATIO, solved, cut)
    return _with_routing(task, solved, routing)


def _with_routing(task: Problem, solved: Solved, routing: Routing | CellRouting) -> Solved:
    hurdle, part = solved.hurdle, routing.part()
    assert hurdle is not None
    closed = closes(task, hurdle, routing.up)
    shown = Shown(hurdle if closed else task.gain_hurdle(routing.up), part, routing.steps)
    return _stronger(task, Aim.RATIO, solved, shown)


def _stronger(task: Problem, aim: Aim, solved: Solved, shown: Shown) -> Solved:
    """Keep what is shown if it says more than what was shown before."""
    known = solved.shown
    if known is not None and _as_strong(task, aim, known.hurdle, shown.hurdle):
        return solved
    complete = solved.complete or shown.hurdle == solved.hurdle
    return replace(solved, shown=shown, complete=complete)


def _valued(task: Problem, solved: Solved, aim: Aim, budget: Budget) -> Solved:
    """Search all cuts for the value alone."""
    if task.n > LONG_NODES or solved.complete or solved.hurdle is None:
        return solved
    walk = Walk(task, next(orders(task)))
    if not walk.runs_in_c(solved.hurdle, aim):
        return solved
    found = walk.search(solved.hurdle, aim, budget.search)
    return replace(_improved(task, solved, aim, found), complete=found.done)


def _loosened(task: Problem, solved: Solved, aim: Aim, limit: int) -> Solved:
    """A weaker hurdle with a witness, unless a routing already gives a stronger one."""
    if task.n > LARGEST or solved.hurdle is None:
        return solved
    walk = Walk(task, next(orders(task)))
    for factor in LOOSER:
        hurdle = _weaker(solved.hurdle, aim, factor)
        if solved.shown is not None and _as_strong(task, aim, solved.shown.hurdle, hurdle):
            break
        found = walk.search(hurdle, Aim.FAILURE, limit)
        if found.done and found.cut is None:
            part = {"kind": "enumeration", "order": list(walk.order)}
            return replace(solved, shown=Shown(hurdle, part, found.visits))
    return solved


def _as_strong(task: Problem, aim: Aim, one: Hurdle, other: Hurdle) -> bool:
    """Whether one hurdle says as much as the other."""
    if aim is Aim.RATIO:
        return task.ratio(one) <= task.ratio(other)
    return one.d**2 * other.q >= other.d**2 * one.q


def _weaker(hurdle: Hurdle, aim: Aim, factor: Fraction) -> Hurdle:
    """The hurdle of a larger gain, or of a smaller rate."""
    if aim is Aim.RATIO:
        return Hurdle(hurdle.b * factor.numerator, hurdle.c * factor.denominator)
    return replace(hurdle, q=hurdle.q * factor.numerator**2, d=hurdle.d * factor.denominator)
