"""The damping that makes the slowest error of the continuous estimator decay fastest."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from verification.answers import Answer
from verification.exact.evaluate import Rows
from verification.exact.rationals import nearest, root

from .gains import definite_gain

SENSITIVE = (
    "all four eigenvalues meet in a defective one: a relative error e of the gains moves them by "
    "about e^(1/4)"
)
TOO_FAR_APART = (
    "the two undamped frequencies are a factor of 3 + 2 sqrt(2) or more apart: the C that reaches "
    "-(det K/det M)^(1/4) is not positive definite"
)


def best_damping(values: Mapping[str, Any]) -> Answer:
    """C that makes all eigenvalues of the continuous estimator -(det K/det M)^(1/4), n = 2.

    With the undamped frequencies a <= b, r = ab and N = M J K - K J M, where J turns by a right
    angle, C = (4 sqrt(r) (K + rM) + s (b - a)/sqrt(det M) N)/(a + b)^2. In the mode basis, N has no
    diagonal; the sign s makes the other entries positive there. det C > 0 iff 6ab > a^2 + b^2.

    Parameters
    ----------
    values : mapping
        ``M``, ``K``: exact symmetric positive definite, 2 by 2.

    Returns
    -------
    Answer
        [C, abscissa], the abscissa in 1/s; no value where C would not be positive definite.

    Raises
    ------
    InputError
        M or K is not symmetric positive definite.

    References
    ----------
    Statements theorem_3_2_stability_ceiling and theorem_3_2_stability_planar.
    """
    m, k = values["M"], values["K"]
    definite_gain("M", m)
    definite_gain("K", k)
    size = _determinant(m)
    square = _determinant(k) / size
    total = (m[0][0] * k[1][1] + m[1][1] * k[0][0] - 2 * m[0][1] * k[0][1]) / size
    if total**2 >= 36 * square:
        return Answer(verdict="UNDECIDED", notes=(TOO_FAR_APART,))
    r = root(square)
    sum_squared = total + 2 * r
    # b - a from (b^2 - a^2)/(b + a), so that nothing cancels
    apart_squared = (total**2 - 4 * square) / (sum_squared * size)
    apart = root(apart_squared) if apart_squared else Fraction(0)
    own, turned = 4 * root(r), _turned(m, k)
    c = [
        [
            nearest((own * (k[i][j] + r * m[i][j]) + apart * turned[i][j]) / sum_squared)
            for j in (0, 1)
        ]
        for i in (0, 1)
    ]
    return Answer(value=[c, -nearest(root(r))], notes=(SENSITIVE,))


def _determinant(rows: Rows) -> Fraction:
    return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]


def _turned(m: Rows, k: Rows) -> Rows:
    """N = M J K - K J M, of the sign that is positive between two modes of positive first entries.

    The second unit vector is a positive multiple of one such mode less one of the other, so that
    its own entry is negative; where it is a mode itself, the entry beside it is positive.
    """
    first = 2 * (m[0][0] * k[0][1] - m[0][1] * k[0][0])
    last = 2 * (m[0][1] * k[1][1] - m[1][1] * k[0][1])
    beside = m[0][0] * k[1][1] - m[1][1] * k[0][0]
    sign = -1 if last > 0 or (last == 0 and beside < 0) else 1
    return (sign * first, sign * beside), (sign * beside, sign * last)
