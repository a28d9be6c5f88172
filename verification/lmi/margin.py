"""Strict linear matrix inequalities: found by a solver in margin form, proved by us.

The solver maximises the t for which every block is at least t I. What keeps t bounded is a box for
the unknowns or, if no block has a constant part, that the traces of the blocks sum up to their
sizes (P <= I would admit P = 0 and so hide by how much an infeasible LMI misses). Its status is
reported and never believed: the unknowns are rounded to dyadic numbers, every block is evaluated
exactly, and its definiteness is proved or the stage that failed is named.

References
----------
S. Boyd, L. El Ghaoui, E. Feron, V. Balakrishnan, *Linear Matrix Inequalities in System and Control
Theory*, SIAM 1994.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, log2
from typing import Any

import numpy as np

from verification.exact.definite import asymmetry, congruence
from verification.exact.evaluate import Rows, add, identity

from .affine import Affine, Unknown
from .solver import maximal_margin

MORE_BITS = (0, 12, 24, 36)
PROVED_SHARES = (Fraction(7, 8), Fraction(1, 2), Fraction(0))


@dataclass(frozen=True)
class Solution:
    """Exact unknowns for which every block is proved to be positive definite.

    Parameters
    ----------
    values : mapping of str to Rows
        Dyadic matrices, by unknown.
    margin : Fraction
        Every block minus this times the identity is proved to be positive definite.
    bits : int
        Binary digits after the point, relative to the largest entry of each unknown.
    source : str
        Who proposed the values, and what the proposer said about them.
    """

    values: Mapping[str, Rows]
    margin: Fraction
    bits: int
    source: str


@dataclass(frozen=True)
class Stage:
    """Where the search for a proof ended; no proof that there is none.

    Parameters
    ----------
    stage : str
        ``solver``, ``margin`` or ``proof``.
    what : str
        What was seen there.
    miss : float or None
        By how much: the largest margin that the solver saw, or the smallest eigenvalue of the block
        that is not positive definite.
    advice : str
        What to try.
    """

    stage: str
    what: str
    miss: float | None
    advice: str

    def __str__(self) -> str:
        """One sentence for notes."""
        size = "" if self.miss is None else f" by {abs(self.miss):.3g}"
        return f"{self.stage}: {self.what}{size}; {self.advice}"


@dataclass(frozen=True)
class Lmi:
    """Unknown matrices are wanted for which every block is positive definite.

    Parameters
    ----------
    positive : mapping of str to Affine
        Blocks by name, each symmetric for every value of the unknowns.
    box : Fraction, optional
        The solver keeps every entry of the unknowns between -box and box; not used by an LMI
        without constants, whose solutions are rays.
    """

    positive: Mapping[str, Affine]
    box: Fraction = Fraction(1000)

    def __post_init__(self) -> None:
        for name, affine in self.positive.items():
            if affine.shape[0] != affine.shape[1]:
                raise ValueError(f"block {name}: shape {affine.shape}; a square one is needed")

    @property
    def homogeneous(self) -> bool:
        """No block has a constant part."""
        return not any(x for b in self.positive.values() for row in b.constant for x in row)

    @property
    def unknowns(self) -> dict[str, Unknown]:
        """All unknowns, by name."""
        return {k: u for affine in self.positive.values() for k, u in affine.unknowns.items()}

    def solve(self) -> Solution | Stage:
        """Search by cvxpy and Clarabel in margin form, then prove.

        Returns
        -------
        Solution or Stage

        Raises
        ------
        MissingExtra
            cvxpy or Clarabel is not installed.
        """
        box = None if self.homogeneous else float(self.box)
        status, margin, values = maximal_margin(self.positive, self.unknowns, box)
        if margin is None:
            return Stage(
                "solver",
                f"Clarabel gave no numbers ({status})",
                None,
                "bring the blocks to entries of about 1, or a smaller box",
            )
        if margin <= 0:
            return Stage(
                "margin",
                f"the largest margin that Clarabel saw ({status}) misses 0",
                margin,
                "weaken the inequality" + ("" if self.homogeneous else ", or take a larger box"),
            )
        largest = max(float(np.abs(value).max()) for value in values.values())
        return self.prove(values, margin / (largest or 1.0), f"Clarabel ({status})")

    def prove(self, values: Mapping[str, Any], margin: float, source: str) -> Solution | Stage:
        """Round values and prove every block positive definite.

        Parameters
        ----------
        values : mapping of str to array
            Doubles, by unknown.
        margin : float
            Estimate of the smallest eigenvalue of all blocks, relative to the values; it sets the
            number of bits only.
        source : str
            Who proposed the values.

        Returns
        -------
        Solution or Stage

        Raises
        ------
        ValueError
            A block is not symmetric.
        """
        if not all(np.isfinite(value).all() for value in values.values()):
            return Stage("proof", f"{source} proposed numbers that are not finite", None, "rescale")
        size = max(u.rows for u in self.unknowns.values())
        start = max(0, ceil(-log2(margin))) + ceil(log2(size)) + 8 if margin > 0 else 32
        worst = ("", 0.0)
        for bits in (min(start, 52) + more for more in MORE_BITS):
            exact = {k: rounded(values[k], u, bits) for k, u in self.unknowns.items()}
            proved, worst = self._proved(exact)
            if proved is not None:
                return Solution(exact, proved, bits, source)
        name, least = worst
        return Stage(
            "proof",
            f"with the values of {source}, block {name} misses to be positive definite",
            least,
            "weaken the inequality a little, or rescale the data",
        )

    def _proved(self, exact: Mapping[str, Rows]) -> tuple[Fraction | None, tuple[str, float]]:
        """The proved margin, or None and the worst block with its smallest eigenvalue."""
        blocks = {name: affine.at(exact) for name, affine in self.positive.items()}
        for name, rows in blocks.items():
            if asymmetry(rows):
                raise ValueError(f"block {name}: not symmetric; write both halves")
        least = {name: smallest_eigenvalue(rows) for name, rows in blocks.items()}
        worst = min(least.items(), key=lambda item: item[1])
        aim = Fraction(max(worst[1], 0.0))
        for share in PROVED_SHARES:
            shifted = (add(rows, identity(len(rows)), -share * aim) for rows in blocks.values())
            if all(congruence(rows) is not None for rows in shifted):
                return share * aim, worst
        return None, worst


def rounded(value: Any, unknown: Unknown, bits: int) -> Rows:
    """Dyadic entries with `bits` digits below the leading one of the largest entry."""
    array = np.asarray(value, dtype=float).reshape(unknown.rows, unknown.columns)
    array = (array + array.T) / 2 if unknown.symmetric else array
    unit = Fraction(2) ** (int(np.frexp(np.abs(array).max())[1]) - bits)
    return tuple(tuple(round(Fraction(x) / unit) * unit for x in row) for row in array.tolist())


def smallest_eigenvalue(rows: Rows) -> float:
    """Estimate in doubles for a symmetric exact matrix."""
    return float(np.linalg.eigvalsh(np.array([[float(x) for x in row] for row in rows]))[0])
