"""Proofs of bounds on the spectral radius of E z+ = F z, without inverting E.

From above, Stein (1952): if Q > 0 and r^2 E'QE - F'QF > 0, every solution shrinks faster than r^k,
because V = (Ez)'Q(Ez) falls faster than r^(2k). From below: if r^2 E'QE - F'QF > 0 and E is not
singular, V/r^(2k) falls strictly along every solution, so that one that starts at V <= 0 cannot
shrink like r^k. The candidate is Q = Re(G*SG) with left eigenvectors G and S = sign(r - |z|). It
serves both sides and, unlike the solution of Stein's equation, is no worse conditioned than G when
r comes close to the spectral radius.

References
----------
P. Stein, "Some general theorems on iterants", J. Res. Nat. Bur. Standards 48 (1952) 82-83.
H. K. Wimmer, "Inertia theorems for matrices, controllability, and linear vibrations", Linear
Algebra Appl. 8 (1974) 337-343 (the indefinite case).
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from ..definite import as_rows, congruence, negative_vector
from ..evaluate import Rows
from .modes import Modes, rows_of


def proves_below(e: Any, f: Any, modes: Modes, r: Fraction) -> bool:
    """Tell whether the spectral radius of E z+ = F z is proved to be less than r.

    Parameters
    ----------
    e, f : flint.fmpz_mat
        Square, of one size.
    modes : Modes
        Candidates; whatever they are, the answer True is a proof.
    r : Fraction
        Positive.
    """
    form = _form(modes, [1] * len(modes.moduli))
    # the form is a sum of squares, and r^2 E'QE > F'QF >= 0 makes it definite
    return proved_definite(_decrease(e, f, modes, form, r))


def proves_above(e: Any, f: Any, modes: Modes, r: Fraction) -> bool:
    """Tell whether the spectral radius of E z+ = F z is proved to be more than r.

    Parameters
    ----------
    e, f : flint.fmpz_mat
        Square, of one size; E must not be singular.
    modes : Modes
        Candidates; whatever they are, the answer True is a proof.
    r : Fraction
        Positive.
    """
    if max(modes.moduli) <= r or not splits(e, f, modes, r):
        return False
    return negative_vector(rows_of(_form(modes, _signs(modes, r)))) is not None


def splits(e: Any, f: Any, modes: Modes, r: Fraction) -> bool:
    """Tell whether no eigenvalue of E z+ = F z is proved to have modulus r.

    Parameters are those of `proves_below`. With z* the complex transpose, an eigenvector z at
    modulus r would give z*(r^2 E'QE - F'QF)z = 0 for every symmetric Q.
    """
    return proved_definite(_decrease(e, f, modes, _form(modes, _signs(modes, r)), r))


def decaying_form(e: Any, f: Any, modes: Modes) -> Rows | None:
    """Q > 0 with E'QE - F'QF > 0, which proves that every solution of E z+ = F z tends to 0.

    Parameters
    ----------
    e, f : flint.fmpz_mat
        Square, of one size.
    modes : Modes
        Candidates.

    Returns
    -------
    Rows or None
        None if the candidates prove nothing.
    """
    if not proves_below(e, f, modes, Fraction(1)):
        return None
    return _spread(_form(modes, [1] * len(modes.moduli)), modes)


def staying_form(e: Any, f: Any, modes: Modes) -> tuple[Rows, tuple[int, ...]] | None:
    """Q with E'QE - F'QF > 0 and x with x'Qx <= 0: some solution does not tend to 0.

    Parameters and the case None are those of `decaying_form`; E must not be singular.
    """
    if not proves_above(e, f, modes, Fraction(1)):
        return None
    signs = [-1 if modulus > 1 else 1 for modulus in modes.moduli]
    form = _spread(_form(modes, signs), modes)
    x = negative_vector(form)
    return (form, x) if x else None


def _spread(form: Any, modes: Modes) -> Rows:
    """The form with the column shifts put in."""
    return tuple(
        tuple(Fraction(int(x) << (a + b)) for x, b in zip(row, modes.shifts, strict=True))
        for row, a in zip(form.tolist(), modes.shifts, strict=True)
    )


def proved_definite(matrix: Any) -> bool:
    """Tell whether a symmetric matrix is proved to be positive definite.

    Its diagonal is scaled to about 1 first, by powers of two: units that differ by hundreds of
    digits would ask for a witness of as many.

    Parameters
    ----------
    matrix : flint.fmpz_mat
        Symmetric.
    """
    rows = [[int(x) for x in row] for row in matrix.tolist()]
    halves = [row[i].bit_length() // 2 for i, row in enumerate(rows)]
    shifts = [max(halves) - half for half in halves]
    even = [
        [x << (a + b) for x, b in zip(row, shifts, strict=True)]
        for row, a in zip(rows, shifts, strict=True)
    ]
    return congruence(as_rows(even)) is not None


def _signs(modes: Modes, r: Fraction) -> list[int]:
    return [-1 if modulus > r else 1 for modulus in modes.moduli]


def _form(modes: Modes, signs: list[int]) -> Any:
    """Re(G* S G) without the column shifts."""
    import flint

    n = modes.real.ncols()
    total = flint.fmpz_mat(n, n)
    for part in (modes.real, modes.imaginary):
        signed = [[s * x for x in row] for s, row in zip(signs, part.tolist(), strict=True)]
        total += part.transpose() * flint.fmpz_mat(signed)
    return total


def _decrease(e: Any, f: Any, modes: Modes, form: Any, r: Fraction) -> Any:
    """r^2 E'QE - F'QF times the square of the denominator of r."""
    import flint

    def moved(matrix: Any) -> Any:
        rows = zip(matrix.tolist(), modes.shifts, strict=True)
        return flint.fmpz_mat([[x << shift for x in map(int, row)] for row, shift in rows])

    e, f = moved(e), moved(f)
    return r.numerator**2 * (e.transpose() * form * e) - r.denominator**2 * (
        f.transpose() * form * f
    )
