"""Single steps of Algorithm 1, and what a network's limits leave of it, as identities."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from ...algebra.identities import ONE, Identity, Square, Zero, hypotheses, identity
from ...algebra.noncommuting import Form, letters, scalars
from ...algebra.rewriting import derive

HALF = Fraction(1, 2)


def _proved(
    relations: Mapping[str, Form],
    goals: Mapping[str, Form],
    least: Mapping[str, Form] | None = None,
) -> tuple[Identity, ...]:
    """Goals that are zero, or at least zero where `least` says what they are equal to."""
    given, words = tuple(relations.values()), dict(enumerate(relations))
    squares = {name: [Square(factor, ONE, ONE)] for name, factor in (least or {}).items()}
    return tuple(
        derive(name, goal, given, words, squares.get(name, ())) for name, goal in goals.items()
    )


def two_costs() -> tuple[Identity, ...]:
    """Two values of the cost that the printed steps leave open lead to two estimates.

    Returns
    -------
    tuple of Identity
        Letters ``D`` (Delta), ``x`` (the estimate before), ``g f`` (pseudogradients), ``a b`` (the
        two next estimates); scalars ``y z`` (values of y+), ``m`` (y-), ``alpha``, ``q`` = 1/(2
        beta).
    """
    delta, x, g, f, a, b = letters("D x g f a b")
    y, z, m, alpha, q = scalars("y z m alpha q")
    relations = {
        "a": a - x + alpha * g,
        "b": b - x + alpha * f,
        "g": g - q * (y - m) * delta,
        "f": f - q * (z - m) * delta,
    }
    goals = {"the estimates differ": a - b + alpha * q * (y - z) * delta}
    return _proved(relations, goals)


def one_cost() -> tuple[Identity, ...]:
    """With y+ = c both runs have one next estimate.

    Returns
    -------
    tuple of Identity
        Symbols of `two_costs`, and the scalar ``c``.
    """
    (split,) = two_costs()
    y, z, c = scalars("y z c")
    known = {"a": split.relations[0], "b": split.relations[1], "g": split.relations[2]}
    known |= {"f": split.relations[3], "y": y - c, "z": z - c}
    a, b = letters("a b")
    return _proved(known, {"the estimates are one": a - b})


def inactive() -> tuple[Identity, ...]:
    """A cost over the active targets does not see what stands at inactive coordinates.

    Returns
    -------
    tuple of Identity
        Letters ``A`` (1 on the diagonal at active coordinates, else 0), ``H``, ``x q``.
    """
    a, h = letters("A H", ("A", "H"))
    x, q = letters("x q")
    active = a * h * a
    thinned, full = a * x - q, x - q
    goals = {"equal costs": thinned.T * active * thinned - full.T * active * full}
    return _proved({"A A": a * a - a}, goals)


def same_measurement() -> tuple[Identity, ...]:
    """Inactive targets drop out of the difference of two costs with the same measurement.

    Returns
    -------
    tuple of Identity
        Letters ``A`` (1 on the diagonal at active coordinates, else 0), ``H`` (without terms
        across), ``x y`` (two points), ``q`` (what is measured).
    """
    a, h = letters("A H", ("A", "H"))
    x, y, q = letters("x y q")
    relations = (a * h - a * h * a,)
    (across,) = hypotheses(relations)

    def surplus(point: Form) -> Form:
        thinned, full = a * point - q, point - q
        return thinned.T * h * thinned - full.T * a * h * a * full

    def taken(point: Form) -> Zero:
        return across.between(point.T, q) + across.T.between(q.T, point)

    goal = surplus(x) - surplus(y)
    return (identity("equal differences", goal, relations, taken(y) - taken(x)),)


def sender() -> tuple[Identity, ...]:
    """A neighbour's measurement put at a sensor's own place is off by where the two stand.

    Returns
    -------
    tuple of Identity
        Letters ``e`` (direction), ``r`` (target), ``s q`` (the sensor, its neighbour), ``p`` (the
        place computed from the sensor), ``o`` (from the neighbour); the scalar ``rho``.
    """
    e, r, s, q, p, o = letters("e r s q p o")
    (rho,) = scalars("rho")
    relations = {"p": p - s - rho * e, "o": o - q - rho * e, "r": r - q - rho * e}
    goals = {"p - r = s - q": p - r - s + q, "o = r": o - r}
    return _proved(relations, goals)


def lagging() -> tuple[Identity, ...]:
    """Against a steady drift the mean error of a constant step is inverse to the step.

    Returns
    -------
    tuple of Identity
        Scalars ``x y`` (mean error before and after an update, the same at rest), ``alpha h``
        (step, entry of H), ``c`` (drift between updates).
    """
    x, y, alpha, h, c = scalars("x y alpha h c")
    relations = {"alpha h x": y - x + alpha * h * x + c, "y": y - x}
    return _proved(relations, {"alpha h x = -c": alpha * h * x + c})


def falling_behind() -> tuple[Identity, ...]:
    """Where the step is below c/(2 h B), an error above -B falls by half the drift at least.

    Returns
    -------
    tuple of Identity
        Scalars ``e f`` (mean error before and after an update), ``alpha h c`` as in `lagging`,
        ``B`` (any bound), ``p`` = e + B, ``w`` = c - 2 alpha h B.
    """
    e, f, alpha, h, c, bound, p, w = scalars("e f alpha h c B p w")
    relations = {
        "f": f - e + alpha * h * e + c,
        "e": e + bound - p,
        "c": c - 2 * (alpha * h * bound) - w,
    }
    goals = {"the fall": e - f - HALF * c}
    return _proved(relations, goals, {"the fall": alpha * h * p + HALF * w})


def blocks_needed() -> tuple[Identity, ...]:
    """k blocks of at most m targets hold k m targets at most, and as many as that if they are full.

    Returns
    -------
    tuple of Identity
        Letters ``b o l`` (sizes of the blocks, ones, room left); scalars ``N`` (targets), ``k m``,
        ``g`` (room left in all).
    """
    b, o, left = letters("b o l")
    targets, k, m, room = scalars("N k m g")
    relations = {
        "o' b": o.T * b - targets,
        "l": left - m * o + b,
        "o' o": o.T * o - k,
        "g": room - o.T * left,
    }
    goals = {"k m - N = g": k * m - targets - room}
    return _proved(relations, goals)


def blocks_enough() -> tuple[Identity, ...]:
    """With k = c + 1 blocks and N = c m + l targets, l <= m, c full blocks and one of l do.

    Returns
    -------
    tuple of Identity
        Scalars ``N c m l``, ``f`` = m - l.
    """
    targets, c, m, rest, free = scalars("N c m l f")
    relations = {"N": targets - c * m - rest, "m": m - rest - free}
    goals = {"the sizes add up": c * m + rest - targets, "the last one fits": m - rest}
    return _proved(relations, goals, {"the last one fits": free})


def operations() -> tuple[Identity, ...]:
    """Operations of a cycle are at most proportional to the coordinates.

    Returns
    -------
    tuple of Identity
        Letters ``i o`` (coordinates of each block, ones); scalars ``a b`` (operations for an active
        coordinate, and besides), ``d k`` (coordinates, blocks), ``c`` = d - k, ``n`` (operations).
    """
    sizes, o = letters("i o")
    a, b, d, k, c, n = scalars("a b d k c n")
    relations = {
        "n": n - a * (o.T * sizes) - b * (o.T * o),
        "o' i": o.T * sizes - d,
        "o' o": o.T * o - k,
        "k": k - d + c,
    }
    goals = {"n <= (a + b) d": (a + b) * d - n}
    return _proved(relations, goals, {"n <= (a + b) d": b * c})
