"""Exact mean and covariance of the position that (13) computes, for Gaussian errors.

At range 1, with the angle error d and the relative range error e, the computed position lies
(1 + e) cos d along the line of sight and (1 + e) sin d across it. The radial error is the first
less 1. With E e = 0, E e^2 = s^2, and d Gaussian of standard deviation p, all moments of the cosine
and sine are combinations of powers of exp(-p^2/2).

References
----------
V. Erofeeva, O. Granichin, (10) to (14).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from ...algebra.moments import COSINE, SINE

Powers = Mapping[int, Fraction]
"""Exponent of exp(-p^2/2) to coefficient."""

ALONG: Powers = COSINE.mean
"""E cos d; the mean radial error is this less 1."""
ALONG_SQUARE: Powers = (COSINE * COSINE).mean
"""E cos^2 d; times 1 + s^2, less the square of `ALONG`, it is the radial variance."""
ACROSS_SQUARE: Powers = (SINE * SINE).mean
"""E sin^2 d; times 1 + s^2 it is the tangential variance, as the mean across is 0."""
