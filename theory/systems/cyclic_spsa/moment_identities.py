"""Exact moments of measured distances and positions over finite laws of the noise, as identities.

A law of finitely many outcomes is a vector of probabilities, or a diagonal matrix of them. Letters
and scalars are listed with each function.
"""

from __future__ import annotations

from collections.abc import Mapping

from ...algebra.identities import ONE, Identity
from ...algebra.noncommuting import Form, letters, scalars
from ...algebra.rewriting import derive


def _proved(relations: Mapping[str, Form], goals: Mapping[str, Form]) -> tuple[Identity, ...]:
    given, words = tuple(relations.values()), dict(enumerate(relations))
    return tuple(derive(name, goal, given, words) for name, goal in goals.items())


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


def covariance() -> tuple[Identity, ...]:
    """The covariance of the position over the squared distance, exactly.

    Returns
    -------
    tuple of Identity
        Letters ``W k l o`` (probabilities on the diagonal, cosines and sines of the angle error,
        ones), ``V t x`` (probabilities on the diagonal, ones, and relative errors of the distance);
        scalars ``f`` (relative deviation of the distance), ``g a b`` (means of the cosine, of its
        square and of the squared sine).
    """
    w, k, l_, o, v, t, x = letters("W k l o V t x", ("W", "V"))
    f, g, a, b = scalars("f g a b")
    relations = {
        "k' W k": k.T * w * k - a,
        "l' W l": l_.T * w * l_ - b,
        "k' W o": k.T * w * o - g,
        "l' W o": l_.T * w * o,
        "k' W l": k.T * w * l_,
        "t' V t": t.T * v * t - ONE,
        "t' V x": t.T * v * x,
        "x' V x": x.T * v * x - f * f,
    }
    z = t + x
    square, mean = z.T * v * z, t.T * v * z
    along, across = mean * (k.T * w * o), mean * (l_.T * w * o)
    goals = {
        "along the line of sight (1 + f^2) a - g^2": (
            square * (k.T * w * k) - along * along - (ONE + f * f) * a + g * g
        ),
        "across it (1 + f^2) b": square * (l_.T * w * l_) - across * across - (ONE + f * f) * b,
        "nothing mixed": square * (k.T * w * l_) - along * across,
    }
    return _proved(relations, goals)
