"""Sharp constants of sign-based consensus: extreme cuts of a network with exact witnesses.

Under x' in -beta B sgn(B'x) + w, |w_i| <= gamma_i before projection, the sides of a cut S of weight
k under the disturbance N drift apart if N > beta k and else close at the rate (beta k - N)/sqrt(p),
p = s (n - s)/n; by the co-area formula and linear programming duality nothing but cuts decides. The
components of a network decide for themselves: the largest threshold and settling time count, and
the smallest rate.

Values come with witnesses in the form that the certificate checker reads: a cut that attains one
end of the bracket, and for the other end a witness for every component that no cut is worse.

References
----------
J. George, "Distributed tracking of maneuvering target: a finite-time algorithm", Theorem 1, whose
printed gain and settling time these constants replace.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from sensortrack.networks import Network

from ..cut_problem import Aim, Hurdle
from .cut_components import (
    Component,
    Item,
    by_factors,
    clear_item,
    components,
    cut_item,
    solved,
    spread,
)
from .cut_roads import Budget, Shown, Solved, refute_or_show

DEFAULT = Budget()
ANY_LOAD = Hurdle(0, 1)
WEIGHT_ALONE = Hurdle(1, 0)
LARGE_PRODUCT = 50_000
"""Nodes of a product above which rates are not bracketed: its edges are then not listed."""


@dataclass(frozen=True)
class CutBracket:
    """A constant between two proved bounds.

    Parameters
    ----------
    lower, upper : Fraction or None
        One end is attained by the cut, the other shown; None if nothing was shown.
    cut : tuple of int
        Nodes of one side; of the factor that `reaches` names if `product`.
    reaches, clear : dict
        Witness items for the two ends. `clear` is None if nothing was shown, or by integers that
        are too many for the checker.
    value : Fraction or None
        The constant where it is known: from witnesses, or from a search of all cuts that is too
        long for a witness.
    product : bool
        Whether the witnesses are about the network given by its factors.
    infinite : bool
        A settling time only: the cut has N >= beta k, and there are no bounds.
    """

    lower: Fraction | None
    upper: Fraction | None
    cut: tuple[int, ...]
    reaches: Item
    clear: Item | None
    value: Fraction | None
    product: bool = False
    infinite: bool = False

    @property
    def closed(self) -> bool:
        """Whether the two ends meet."""
        return self.lower is not None and self.lower == self.upper


def threshold(network: Network, gamma: Sequence[Fraction], budget: Budget = DEFAULT) -> CutBracket:
    """Smallest gain at which no disturbance drives agents apart: largest N/k of a cut.

    Parameters
    ----------
    network : Network
        At least one edge.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance, not negative.
    budget : Budget, optional

    Returns
    -------
    CutBracket
        The cut attains `lower`; `clear` shows `upper`, if it is not too long for the checker.

    Raises
    ------
    InputError
        The network has no edge.
    """
    if by_factors(network, gamma):
        return _threshold_of_factors(network, gamma[0], budget)
    parts = components(network, gamma)
    found = solved(parts, [ANY_LOAD] * len(parts), Aim.RATIO, budget)
    return _bracket(network, parts, found, lambda part, hurdle: part.task.ratio(hurdle))


def margin(network: Network, budget: Budget = DEFAULT) -> CutBracket:
    """Square of the rate that gain above the threshold is worth: smallest k^2/p of a cut.

    Parameters
    ----------
    network : Network
        At least one edge.
    budget : Budget, optional

    Returns
    -------
    CutBracket
        The cut attains `upper`; `clear` shows `lower`.

    Raises
    ------
    InputError
        The network has no edge.
    """
    if network.factors and network.n > LARGE_PRODUCT:
        return _lightest_node(network.factors, network.n)
    parts = components(network, [Fraction(0)] * network.n)
    found = solved(parts, [WEIGHT_ALONE] * len(parts), Aim.RATE, budget)
    of = _bracket(network, parts, found, lambda part, hurdle: 1 / part.task.margin_squared(hurdle))
    return replace(of, lower=_inverse(of.upper), upper=_inverse(of.lower), value=_inverse(of.value))


def slowest(
    network: Network,
    gamma: Sequence[Fraction],
    beta: Fraction,
    x0: Sequence[Fraction],
    budget: Budget = DEFAULT,
) -> CutBracket:
    """Square of the largest settling time from x0: largest |x0 - mean|^2 p/(beta k - N)^2.

    Parameters
    ----------
    network : Network
        At least one edge.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance, not negative.
    beta : Fraction
        Gain, positive.
    x0 : sequence of Fraction, length n
        Error at the start; in each component it is projected to mean zero.
    budget : Budget, optional

    Returns
    -------
    CutBracket
        The cut attains `lower`; `clear` shows `upper` for the certificate's f, the square of the
        time. Infinite if a cut with N >= beta k was found, which then is the cut.

    Raises
    ------
    InputError
        The network has no edge.
    """
    parts = components(network, gamma)
    starts = [part.task.gain_hurdle(beta) for part in parts]
    found = solved(parts, starts, Aim.RATE, budget)
    for part, one in zip(parts, found, strict=True):
        if one.hurdle is None:
            cut = part.whole(one.cut)
            return CutBracket(None, None, cut, cut_item(cut), None, None, infinite=True)
    squares = {part.place: spread([x0[i] for i in part.nodes]) for part in parts}
    for place, (part, start) in enumerate(zip(parts, starts, strict=True)):
        if not squares[part.place] and found[place].shown is None:
            found[place] = _kept(part, start, found[place], budget)

    def time_squared(part: Component, hurdle: Hurdle) -> Fraction:
        square = squares[part.place]
        return square / part.task.rate_squared(hurdle) if square else Fraction(0)

    return _bracket(network, parts, found, time_squared)


def decide(
    network: Network,
    gamma: Sequence[Fraction],
    beta: Fraction,
    known: CutBracket,
    budget: Budget = DEFAULT,
) -> tuple[bool | None, Item | None]:
    """Decide whether a gain is at or above the threshold.

    Parameters
    ----------
    network : Network
        At least one edge.
    gamma : sequence of Fraction, length n
        Bounds on the disturbance, not negative.
    beta : Fraction
        Gain, positive.
    known : CutBracket
        The threshold's.
    budget : Budget, optional

    Returns
    -------
    decision : bool or None
        None if the budget does not suffice.
    witness : dict or None
        For True of the kind ``cuts``, for False of the kind ``cut``.
    """
    if known.lower is not None and beta < known.lower:
        return False, known.reaches
    if known.upper is not None and beta >= known.upper:
        return True, known.clear
    if known.product:
        return None, None
    parts, items = components(network, gamma), []
    for part in parts:
        found = refute_or_show(part.task, part.task.gain_hurdle(beta), budget)
        if isinstance(found, tuple):
            return False, cut_item(part.whole(found))
        if found is None:
            return None, None
        items.append(found.part)
        budget = replace(budget, visits=budget.visits - found.visits)
    return True, clear_item(network, parts, items)


def _bracket(
    network: Network,
    parts: Sequence[Component],
    found: Sequence[Solved],
    badness: Callable[[Component, Hurdle], Fraction],
) -> CutBracket:
    """Bracket of the largest badness: attained by a cut, and shown for all components."""
    pairs = list(zip(parts, found, strict=True))
    attained = [badness(part, one.hurdle) if one.hurdle else Fraction(0) for part, one in pairs]
    place = max(range(len(parts)), key=attained.__getitem__)
    lower, upper, clear = attained[place], None, None
    shown = [one.shown for one in found if one.shown is not None]
    if len(shown) == len(parts):
        clear = clear_item(network, parts, [one.part for one in shown])
        upper = max(badness(part, one.hurdle) for part, one in zip(parts, shown, strict=True))
    known = lower == upper or all(one.complete for one in found)
    cut = parts[place].whole(found[place].cut)
    return CutBracket(lower, upper, cut, cut_item(cut), clear, lower if known else None)


def _kept(part: Component, start: Hurdle, one: Solved, budget: Budget) -> Solved:
    """Show only that agreement is kept, where a component starts in agreement."""
    found = refute_or_show(part.task, start, budget)
    return replace(one, shown=found if isinstance(found, Shown) else None)


def _threshold_of_factors(network: Network, gamma: Fraction, budget: Budget) -> CutBracket:
    """The largest threshold of a factor."""
    brackets: dict[int, CutBracket] = {}
    for factor in network.factors:
        if id(factor) not in brackets:
            brackets[id(factor)] = threshold(factor, [gamma] * factor.n, budget)
    found = [brackets[id(factor)] for factor in network.factors]
    lowers = [one.lower or Fraction(0) for one in found]
    place = max(range(len(found)), key=lowers.__getitem__)
    uppers = [one.upper for one in found if one.upper is not None]
    items = [one.clear["parts"][0] for one in found if one.clear is not None]
    upper = max(uppers) if len(uppers) == len(found) else None
    clear = None
    if len(items) == len(found):
        clear = {"kind": "cuts", "parts": [{"kind": "product", "parts": items}]}
    known = lowers[place] == upper or all(one.value is not None for one in found)
    cut = found[place].cut
    return CutBracket(
        lowers[place],
        upper,
        cut,
        cut_item(cut, place),
        clear,
        lowers[place] if known else None,
        product=True,
    )


def _lightest_node(factors: Sequence[Network], n: int) -> CutBracket:
    """The cut around one node of a large product, without listing its edges."""
    node, degree = 0, 0
    for factor in factors:
        degrees = np.bincount(factor.edges.ravel(), minlength=factor.n)
        place = int(degrees.argmin())
        node, degree = node * factor.n + place, degree + int(degrees[place])
    value = Fraction(degree**2 * n, n - 1)
    return CutBracket(None, value, (node,), cut_item((node,)), None, None)


def _inverse(value: Fraction | None) -> Fraction | None:
    return None if value is None else 1 / value
