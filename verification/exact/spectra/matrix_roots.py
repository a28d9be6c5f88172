"""Square roots of symmetric positive semidefinite matrices, enclosed.

For S >= 0 and A >= 0, |S - A^(1/2)| <= |S^2 - A|^(1/2) in the spectral norm, also where A is
singular: whatever S was computed from, its residual says how far it is off.

References
----------
R. Bhatia, *Matrix Analysis*, Theorem X.1.1.
"""

from __future__ import annotations

from typing import Any

from ..evaluate import Rows
from .modes import middle

DIGITS = 80


def root_enclosure(rows: Rows, bits: int = 300) -> Any:
    """The positive semidefinite square root.

    Parameters
    ----------
    rows : Rows
        n by n, symmetric positive semidefinite.
    bits : int, optional
        Precision of the balls.

    Returns
    -------
    flint.arb_mat
        Encloses the square root entry by entry.
    """
    import flint

    n = len(rows)
    with flint.ctx.workprec(bits):
        given = flint.arb_mat(
            [[flint.arb(flint.fmpq(x.numerator, x.denominator)) for x in row] for row in rows]
        )
        size = max((abs(x) for x in given.entries()), key=lambda x: x.mid()).upper()
        if size == 0:
            return given
        values, vectors = _eigen(given * (1 / size))
        # whatever the vectors are, V diag V' is positive semidefinite
        near = middle(vectors) * values * middle(vectors).transpose()
        miss = near * near - given * (1 / size)
        error = sum((abs(x).upper() ** 2 for x in miss.entries()), start=flint.arb(0)).sqrt().sqrt()
        radius = flint.arb(0, error.upper())
        spread = flint.arb_mat([[radius] * n for _ in range(n)])
        return (near + spread) * size.sqrt()


def _eigen(matrix: Any) -> tuple[Any, Any]:
    """About the roots of the eigenvalues, as a diagonal matrix, and the eigenvectors."""
    import flint
    from mpmath import mp

    n = matrix.nrows()
    with mp.workdps(DIGITS):
        rows = [[mp.mpf(x.mid().str(DIGITS, radius=False)) for x in row] for row in matrix.tolist()]
        values, vectors = mp.eigsy(mp.matrix(rows))
        roots = [flint.arb(mp.nstr(mp.sqrt(max(x, 0)), DIGITS)) for x in values]
        columns = [[flint.arb(mp.nstr(vectors[i, j], DIGITS)) for j in range(n)] for i in range(n)]
    diagonal = [roots[i].mid() if i == j else flint.arb(0) for i in range(n) for j in range(n)]
    return flint.arb_mat(n, n, diagonal), flint.arb_mat(columns)
