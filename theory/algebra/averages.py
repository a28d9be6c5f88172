"""Least squares from bearings, row by row and averaged, as identities of any number of sensors.

Letters: ``H`` (n x 2, a row h' for each sensor), ``z`` (its measurements), ``X`` and ``Y``
(inverses of H'H and of H'H/n), ``e`` (ones), ``M`` = I - ee'/n. The scalar ``r`` is 1/n.
"""

from __future__ import annotations

from .identities import ONE, Identity, hypotheses, identity
from .noncommuting import letters, scalars
from .rewriting import derive


def least_squares() -> tuple[Identity, ...]:
    """X H'z has the smallest sum of squares, and is the position if measurements are exact.

    Returns
    -------
    tuple of Identity
        Letters ``H z X``, ``g`` (X H'z), ``y`` (any position), ``d`` (exact measurements of ``p``).
    """
    h, z, x, g, y, d, p = letters("H z X g y d p", ("X",))
    relations = (x * h.T * h - ONE, g - x * h.T * z, d - h * p)
    words = {0: "X H' H", 1: "g", 2: "d"}
    left, best = z - h * y, z - h * g
    goals = {
        "the sum of squares at y exceeds that at g by (y - g)'H'H(y - g)": (
            left.T * left - best.T * best - (y - g).T * h.T * h * (y - g)
        ),
        "X H'd = p": x * h.T * d - p,
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def stacked() -> tuple[Identity, ...]:
    """What one more sensor adds: by induction over sensors, H'H and H'z are the sums of P and q.

    Returns
    -------
    tuple of Identity
        Letters ``H z``, ``E a`` (places of the old sensors and of the new one), ``h`` (its row),
        ``K Z`` (the longer H and z), ``p``; the scalar ``m`` is its measurement.
    """
    h, z, e, a, row, k, long, p = letters("H z E a h K Z p")
    (m,) = scalars("m")
    relations = (
        e.T * e - ONE,
        e.T * a,
        a.T * a - ONE,
        k - e * h - a * row.T,
        long - e * z - m * a,
    )
    words = {0: "E' E", 1: "E' a", 2: "a' a", 3: "K", 4: "Z"}
    goals = {
        "K'K = H'H + hh'": k.T * k - h.T * h - row * row.T,
        "K'Z = H'z + mh": k.T * long - h.T * z - m * row,
        "rows are exact one by one": k * p - long - e * (h * p - z) - a * (row.T * p) + m * a,
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def averaged() -> Identity:
    """The averaged form of the position is that of the sums.

    Returns
    -------
    Identity
        Letters ``H z X Y``, the scalar ``r``.
    """
    h, z, x, y = letters("H z X Y", ("X", "Y"))
    (r,) = scalars("r")
    relations = (x * h.T * h - ONE, r * (y * h.T * h) - ONE)
    summed, mean = hypotheses(relations)
    proof = mean.before(x * h.T * z) - summed.T.between(r * y, h.T * z)
    goal = r * (y * h.T * z) - x * h.T * z
    return identity("Y H'z/n = X H'z", goal, relations, proof)


def spread() -> tuple[Identity, ...]:
    """The determinant of the averaged P measures how far bearings spread.

    Returns
    -------
    tuple of Identity
        Letters ``k l`` (cosine and sine of twice the bearing of each sensor), ``M e``, scalars
        ``r``, ``a b`` (means of ``k`` and ``l``). The averaged P is [[1 - a, -b], [-b, 1 + a]]/2.
    """
    k, l_, m, e = letters("k l M e", ("M",))
    r, a, b = scalars("r a b")
    relations = (
        r * (k.T * k) + r * (l_.T * l_) - ONE,
        m - ONE + r * (e * e.T),
        a - r * (e.T * k),
        b - r * (e.T * l_),
    )
    words = {0: "r k' k", 1: "M", 2: "r e' k", 3: "r e' l"}
    four = (ONE - a) * (ONE + a) - b * b
    goals = {
        "four times the determinant is the variance of twice the bearings": (
            four - r * (k.T * m * k) - r * (l_.T * m * l_)
        ),
    }
    return tuple(derive(name, goal, relations, words) for name, goal in goals.items())


def agreed() -> tuple[Identity, ...]:
    """From exact averages every sensor computes the position.

    Returns
    -------
    tuple of Identity
        Letters ``N m`` (averages of P and q, so that m = Np), ``A d`` (those of one sensor), ``Y``
        (the inverse of A), ``p``.
    """
    n, m, a, d, y, p = letters("N m A d Y p", ("N", "A", "Y"))
    relations = (m - n * p, a - n, d - m, y * a - ONE)
    own, kept, same, inverse = hypotheses(relations)
    proof = same.after(y) + own.after(y) - kept.between(y, p) + inverse.before(p)
    return (identity("Y d = p", y * d - p, relations, proof),)
