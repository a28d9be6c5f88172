"""H-infinity norms of D(s)^-1 N(s), the largest gain on the imaginary axis, in certified bounds.

A vector q and a frequency give the exact lower bound |q*N|/|q*D|. A level g is an upper bound if

    g^2 D(s) D(-s)' - N(s) N(-s)'

is positive definite somewhere on the axis and has no root on it: its eigenvalues, which are real
there, then never change sign. Both are proved for rational data; the candidates come from floats.

References
----------
S. Boyd, V. Balakrishnan, P. Kabamba, "A bisection method for computing the H-infinity norm of a
transfer matrix and related problems", Math. Control Signals Systems 2 (1989) 207-219.
N. A. Bruinsma, M. Steinbuch, "A fast algorithm to compute the H-infinity norm of a transfer
function matrix", Systems & Control Letters 14 (1990) 287-293.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import islice
from typing import Any

import numpy as np

from ..evaluate import Rows, scaled
from ..rationals import above, below, nearest, root
from .abscissa import off_axis
from .modes import candidates, integer_matrices
from .peak_search import FloatChannel, Peak, highest, left_vector
from .spectral import Enclosure
from .stein import proved_definite

WIDTHS = tuple(Fraction(1, 10**k) for k in (10, 9, 8, 7))
CERTIFIED_UP_TO = 24
"""Outputs up to which an upper bound is proved: the proof's matrices are four times as large."""
TRIES = 2
BITS, ROOT_BITS = 40, 80
FLOATING = "computed in floating point: attained at one frequency, crossed at no other"

Coefficients = tuple[Rows, Rows, Rows]


@dataclass(frozen=True)
class Channel:
    """D(s)^-1 N(s), with exact coefficients of 1, s, s^2.

    All are n by n; D is nowhere singular on the imaginary axis, nor are its first and last
    coefficients.
    """

    d: Coefficients
    n: Coefficients


def peak(channel: Channel) -> Enclosure:
    """Largest singular value of D^-1 N over all imaginary s and infinity.

    Parameters
    ----------
    channel : Channel

    Returns
    -------
    Enclosure
        Of relative width 1e-10 at most unless `stage` says otherwise; without bounds beyond 24
        outputs.
    """
    even, unit = _scaled(channel)
    floats = FloatChannel(*(np.array(part, dtype=float) for part in (even.d, even.n)))
    best = highest(floats)
    if len(channel.d[0]) > CERTIFIED_UP_TO:
        return Enclosure(best.gain * nearest(unit), None, None, FLOATING)
    parts = integer_matrices(*even.d, *even.n)
    d, n = parts[:3], parts[3:]
    low = root(_attained(d, n, floats, best), ROOT_BITS)
    for width in WIDTHS:
        level = _short(low * (1 + width / 2))
        if _never_above(d, n, level):
            stage = "" if width is WIDTHS[0] else f"no bracket narrower than {float(width)}"
            return Enclosure(nearest(unit * low), below(unit * low), above(unit * level), stage)
    return Enclosure(nearest(unit * low), None, None, FLOATING)


def _scaled(channel: Channel) -> tuple[Channel, Fraction]:
    """The same channel with entries near 1, in another unit of time, and the unit of its gain."""
    time = Fraction(2) ** ((_exponent(channel.d[0]) - _exponent(channel.d[2])) // 2)
    moved = [
        [scaled(time**k, rows) for k, rows in enumerate(part)] for part in (channel.d, channel.n)
    ]
    units = [Fraction(2) ** max(map(_exponent, part)) for part in moved]
    (d0, d1, d2), (n0, n1, n2) = (
        [scaled(1 / unit, rows) for rows in part] for part, unit in zip(moved, units, strict=True)
    )
    return Channel((d0, d1, d2), (n0, n1, n2)), units[1] / units[0]


def _exponent(rows: Rows) -> int:
    """Binary exponent of the largest entry, very small for a matrix of zeros."""
    most = max(abs(x) for row in rows for x in row)
    return most.numerator.bit_length() - most.denominator.bit_length() if most else -(1 << 20)


def _attained(d: list[Any], n: list[Any], floats: FloatChannel, best: Peak) -> Fraction:
    """The exact square of a gain that is attained, close to the largest."""
    a, b = (round(x * 2**BITS) for x in (np.sin(best.angle), np.cos(best.angle)))
    q = left_vector(floats, best.angle)
    return _square(n, a, b, q) / _square(d, a, b, q)


def _square(parts: list[Any], a: int, b: int, q: Any) -> Fraction:
    """|q*(P0 + i P1 a/b - P2 (a/b)^2)|^2 times b^4, q rounded."""
    import flint

    real, imaginary = (
        flint.fmpz_mat([[round(x * 2**BITS) for x in part.tolist()]]) for part in (q.real, q.imag)
    )
    even, odd = b * b * parts[0] - a * a * parts[2], a * b * parts[1]
    image = (real * even + imaginary * odd, real * odd - imaginary * even)
    return Fraction(sum(int(x) ** 2 for row in image for x in row.entries()))


def _short(x: Fraction) -> Fraction:
    """The nearest number of 60 bits."""
    unit = Fraction(2) ** (x.numerator.bit_length() - x.denominator.bit_length() - 60)
    return round(x / unit) * unit


def _never_above(d: list[Any], n: list[Any], level: Fraction) -> bool:
    """Tell whether no gain on the axis is proved to reach the level."""
    square, unit = level.numerator**2, level.denominator**2
    parts: list[Any] = [None] * 5
    for i in range(3):
        for j in range(3):
            part = square * d[i] * d[j].transpose() - unit * n[i] * n[j].transpose()
            part = part if j % 2 == 0 else -part
            parts[i + j] = part if parts[i + j] is None else parts[i + j] + part
    if not (proved_definite(parts[0]) and proved_definite(parts[4])):
        return False  # below the gain at 0 or at infinity
    left, right = _companion(parts)
    return any(off_axis(left, right, modes) for modes in islice(candidates(left, right), TRIES))


def _companion(parts: list[Any]) -> tuple[Any, Any]:
    """E and F such that E z' = F z has the roots of the matrix polynomial."""
    import flint

    size = parts[0].nrows()
    n = 4 * size
    left = [[int(i == j) for j in range(n)] for i in range(n)]
    right = [[int(j == i + size) for j in range(n)] for i in range(n)]
    for i in range(size):
        left[n - size + i][n - size :] = [int(x) for x in parts[4].tolist()[i]]
        right[n - size + i] = [-int(x) for part in parts[:4] for x in part.tolist()[i]]
    return flint.fmpz_mat(left), flint.fmpz_mat(right)
