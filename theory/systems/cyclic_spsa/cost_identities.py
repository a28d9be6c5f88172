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


def measured_variance() -> tuple[Identity, ...]:
    """The mean of (z k)^2 for a distance z whose deviation is k times the true one.

    Returns
    -------
    tuple of Identity
        Letters ``P`` (probabilities on the diagonal), ``o`` (ones), ``x`` (errors of the distance);
        scalars ``rho k``, ``q`` = 1/(1 + k^2).
    """
    p, o, x = letters("P o x", ("P",))
    rho, k, q = scalars("rho k q")
    square = rho * rho * k * k
    relations = {
        "o' P o": o.T * p * o - ONE,
        "o' P x": o.T * p * x,
        "x' P x": x.T * p * x - square,
        "k**2 q": q * (ONE + k * k) - ONE,
    }
    z = rho * o + x
    mean = k * k * (z.T * p * z)
    goals = {
        "the mean of (z k)^2 is (1 + k^2) (rho k)^2": mean - (ONE + k * k) * square,
        "divided by 1 + k^2 it is (rho k)^2": q * mean - square,
    }
    return _proved(relations, goals)


def mean_square() -> tuple[Identity, ...]:
    """The mean square of the position's error, exactly.

    Returns
    -------
    tuple of Identity
        Letters ``w k o`` (probabilities and cosines of the angle error, ones), ``V t x``
        (probabilities on the diagonal, ones, and relative errors of the distance); scalars ``rho``,
        ``g`` (mean cosine), ``f`` (relative deviation of the distance).
    """
    w, k, o, v, t, x = letters("w k o V t x", ("V",))
    rho, g, f = scalars("rho g f")
    relations = {
        "o' w": o.T * w - ONE,
        "t' V t": t.T * v * t - ONE,
        "t' V x": t.T * v * x,
        "x' V x": x.T * v * x - f * f,
        "k' w": k.T * w - g,
    }
    z = t + x
    sure = o.T * w
    mean = sure * (t.T * v * t) + sure * (z.T * v * z) - 2 * (k.T * w * (t.T * v * z))
    goals = {"2 + f^2 - 2g": rho * rho * (mean - 2 * ONE - f * f + 2 * g)}
    return _proved(relations, goals)


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
