"""What Gaussian noise of a bearing does to the averaged equations, in the mean.

A bearing theta + d has the direction h(theta + d) = cos(d) h - sin(d) phi, phi being the unit
vector to the target. The measured P is its outer product, the measured q is that times the sensor's
position s. The target has h's = h'p; with phi phi' = I - h h' (Proposition 1) only E sin^2 d stays:

    E P = a I + (1 - 2a) h h',      E q = a s + (1 - 2a) h h' p,      a = E sin^2 d.

So averages over many samples and n sensors lead to p - a (a I + (1 - 2a) Pbar)^-1 (p - mean s).
"""

from __future__ import annotations

from fractions import Fraction

from ...algebra.moments import COSINE, SINE, Wave

DIRECTION: dict[str, Wave] = {"h": COSINE, "phi": SINE.times(-1)}
"""h(theta + d) as a combination of h and phi."""


def mean_outer() -> dict[tuple[str, str], dict[int, Fraction]]:
    """E of the measured P as a combination of outer products of h and phi.

    Returns
    -------
    dict
        Pair of vectors to its coefficient: exponent of exp(-sigma^2/2) to rational.
    """
    return {
        (left, right): (one * other).mean
        for left, one in DIRECTION.items()
        for right, other in DIRECTION.items()
    }


SPREAD = mean_outer()["phi", "phi"]
"""a = E sin^2 d, the share of what a sensor does not see that enters its P."""
