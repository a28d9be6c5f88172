"""Normal numbers from words of random bits, in plain arithmetic that every language rounds alike.

Only + - * /, square roots and powers of two occur, so that C gives the same bits as NumPy does,
whatever their libraries of functions. `sensortrack/kernels/spsa.c` has the same lines.

References
----------
M. Wichura, *Algorithm AS 241: The Percentage Points of the Normal Distribution* (1988), whose
rational approximations have a relative error of about 1e-16.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Words = NDArray[np.uint64]
Floats = NDArray[np.float64]
_MIDDLE = (
    (3.3871328727963666080e0, 1.0),
    (1.3314166789178437745e2, 4.2313330701600911252e1),
    (1.9715909503065514427e3, 6.8718700749205790830e2),
    (1.3731693765509461125e4, 5.3941960214247511077e3),
    (4.5921953931549871457e4, 2.1213794301586595867e4),
    (6.7265770927008700853e4, 3.9307895800092710610e4),
    (3.3430575583588128105e4, 2.8729085735721942674e4),
    (2.5090809287301226727e3, 5.2264952788528545610e3),
)
_TAIL = (
    (1.42343711074968357734e0, 1.0),
    (4.63033784615654529590e0, 2.05319162663775882187e0),
    (5.76949722146069140550e0, 1.67638483018380384940e0),
    (3.64784832476320460504e0, 6.89767334985100004550e-1),
    (1.27045825245236838258e0, 1.48103976427480074590e-1),
    (2.41780725177450611770e-1, 1.51986665636164571966e-2),
    (2.27238449892691845833e-2, 5.47593808499534494600e-4),
    (7.74545014278341407640e-4, 1.05075007164441684324e-9),
)
_FAR = (
    (6.65790464350110377720e0, 1.0),
    (5.46378491116411436990e0, 5.99832206555887937690e-1),
    (1.78482653991729133580e0, 1.36929880922735805310e-1),
    (2.96560571828504891230e-1, 1.48753612908506148525e-2),
    (2.65321895265761230930e-2, 7.86869131145613259100e-4),
    (1.24266094738807843860e-3, 1.84631831751005468180e-5),
    (2.71155556874348757815e-5, 1.42151175831644588870e-7),
    (2.01033439929228813265e-7, 2.04426310338993978564e-15),
)
TABLE = np.array([row for pairs in (_MIDDLE, _TAIL, _FAR) for row in zip(*pairs, strict=True)])
"""Coefficients by growing power: numerator and denominator of the middle, the tails, the far tails;
the tails in the square root of -log of the probability beyond."""
EDGE, NEAR = 0.425, 5.0
ONE = np.uint64(0x3FF0000000000000)
ROOT_HALF, LOG_2 = 0.70710678118654752, 0.69314718055994531


def centred(words: Words) -> Floats:
    """Middles of 2^52 equal parts of the unit interval, less a half: symmetric, never 0."""
    bits = (words >> np.uint64(12)) | ONE
    found: Floats = (bits.view(np.float64) - 1.5) + 2.0**-53
    return found


def normals(words: Words) -> Floats:
    """One normal number of mean 0 and variance 1 a word.

    Parameters
    ----------
    words : array of uint64
    """
    return quantiles(centred(words))


def quantiles(q: Floats) -> Floats:
    """Where the normal distribution reaches 1/2 + q.

    Parameters
    ----------
    q : array (n,)
        Between -1/2 and 1/2, at least 2^-53 from either.
    """
    r = 0.180625 - q * q
    found = (q * _horner(TABLE[0], r)) / _horner(TABLE[1], r)
    outside = np.abs(q) > EDGE
    found[outside] = _tails(q[outside])
    return found


def _tails(q: Floats) -> Floats:
    beyond = np.where(q < 0, 0.5 + q, 0.5 - q)
    r = np.sqrt(-_log(beyond))
    near = r <= NEAR
    s = r - np.where(near, 1.6, 5.0)
    above = np.where(near, _horner(TABLE[2], s), _horner(TABLE[4], s))
    below = np.where(near, _horner(TABLE[3], s), _horner(TABLE[5], s))
    x = above / below
    return np.where(q < 0, -x, x)


def _log(x: Floats) -> Floats:
    """Logarithm by the series of the area tangent."""
    m, power = np.frexp(x)
    low = m < ROOT_HALF
    m, power = np.where(low, m * 2.0, m), np.where(low, power - 1, power)
    s = (m - 1.0) / (m + 1.0)
    z = s * s
    total = np.full_like(z, 1.0 / 21.0)
    for term in range(19, 0, -2):
        total = total * z + 1.0 / term
    found: Floats = power * LOG_2 + (2.0 * s) * total
    return found


def _horner(coefficients: Floats, r: Floats) -> Floats:
    total = np.full_like(r, coefficients[-1])
    for c in coefficients[-2::-1]:
        total = total * r + c
    return total
