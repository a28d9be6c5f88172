"""Means of the costs (3), (8) and (20) over laws of the noise, as identities.

A law of finitely many outcomes is a vector of probabilities, or a diagonal matrix of them. Letters
and scalars are listed with each function.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...algebra.identities import ONE, Identity, Square, hypotheses, identity
from ...algebra.noncommuting import Form, letters, scalars
from ...algebra.rewriting import derive


def _proved(
    relations: Mapping[str, Form], goals: Mapping[str, Form], squares: Sequence[Square] = ()
) -> tuple[Identity, ...]:
    given, words = tuple(relations.values()), dict(enumerate(relations))
    return tuple(derive(name, goal, given, words, squares) for name, goal in goals.items())


def constant_weights() -> tuple[Identity, ...]:
    """Weights that do not depend on the noise of the moment leave the fit right in the mean.

    Returns
    -------
    tuple of Identity
        Letters ``P`` (probabilities times the weight on the diagonal), ``o`` (ones), ``z``
        (measured); scalars ``r`` (truth), ``x`` (any fit), ``g`` (the weight).
    """
    p, o, z = letters("P o z", ("P",))
    r, x, g = scalars("r x g")
    relations = {"o' P o": o.T * p * o - g * ONE, "o' P z": o.T * p * z - g * r}
    at_x, at_r = z - x * o, z - r * o
    goals = {
        "the excess over the truth is g (x - r)^2": (
            at_x.T * p * at_x - at_r.T * p * at_r - g * (x - r) * (x - r)
        )
    }
    return _proved(relations, goals)


def mean_risk() -> tuple[Identity, ...]:
    """The mean of the weighted cost of one target, over any number of sensors.

    Returns
    -------
    tuple of Identity
        Letters ``c o`` (1/variance of each sensor, ones), ``M`` (its columns are the mean errors),
        ``t`` (mean squares of the errors), ``d`` (truth less estimate); scalars ``k`` = K/n,
        ``l`` = k c'o.
    """
    c, o, m, t, d = letters("c o M t d")
    k, weight = scalars("k l")
    relations = {
        "M": m,
        "k c' o": k * (c.T * o) - weight,
    }
    twice = k * (c.T * o * d.T * d + c.T * m.T * d + d.T * m * c + t.T * c)
    offset = k * (t.T * c)
    goals = {"twice the mean is l |d|^2 + k t'c": twice - offset - weight * (d.T * d)}
    return _proved(relations, goals)


def unlike_copies() -> tuple[Identity, ...]:
    """(x - 1)^2 + (y + 1)^2 has the least value 2 of common points also where copies differ.

    Returns
    -------
    tuple of Identity
        Scalars ``x y`` (copies), ``z`` (any common point).
    """
    x, y, z = scalars("x y z")
    relations = {"x": x - 2 * ONE, "y": y}
    far, near = x - ONE, y + ONE
    goals = {
        "the same value": far * far + near * near - 2 * ONE,
        "the copies differ": x - y - 2 * ONE,
    }
    common = (z - ONE) * (z - ONE) + (z + ONE) * (z + ONE) - 2 * ONE
    least = derive(
        "at common points", common, tuple(relations.values()), {}, [Square(2 * ONE, z, ONE)]
    )
    return (*_proved(relations, goals), least)


def like_copies() -> tuple[Identity, ...]:
    """Where every copy's cost is least in the mean at r, copies that solve the problem agree.

    Returns
    -------
    tuple of Identity
        Letters ``C`` (weights), ``o`` (ones), ``x`` (the copies), ``m`` (means of what they are
        fitted to), ``d`` = x - r o; scalars ``r``, ``t`` (mean square of what they are fitted to).
    """
    c, o, x, m, d = letters("C o x m d", ("C",))
    r, t = scalars("r t")
    relations = {"x": x - r * o - d, "m": m - r * o}

    def risk(y: Form) -> Form:
        return y.T * c * y - y.T * c * m - m.T * c * y + t

    goals = {"the excess over agreement at r": risk(x) - risk(r * o)}
    return _proved(relations, goals, [Square(ONE, d, c)])


def subvectors() -> tuple[Identity, ...]:
    """A quadratic without terms across blocks is the sum of those of the blocks.

    Returns
    -------
    tuple of Identity
        Letters ``A B`` (1 on the diagonal in one block, in all others), ``H``, ``d``.
    """
    a, b, h = letters("A B H", ("A", "B", "H"))
    (d,) = letters("d")
    relations = (a + b - ONE, a * h * b)
    whole, across = hypotheses(relations)
    split = (across + across.T).between(d.T, d)
    parts = whole.times(-1).between(d.T, h * d) - whole.between(d.T * (a + b) * h, d)
    goal = d.T * h * d - d.T * a * h * a * d - d.T * b * h * b * d
    return (identity("no terms across", goal, relations, parts + split),)
