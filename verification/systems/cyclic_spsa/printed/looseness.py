"""How far the bounds of Theorem 1, as printed and as proved, are from the exact error.

The cost of a block is |x - theta - xi|^2/2 with Gaussian noise of the variance sigma^2 in each
coordinate, and the target moves by delta along the first axis in every sample. Its constants are
mu = M = 1 and c2 = d sigma^2; c3 and c4 for the printed bound are those of the printed Assumption
5, which does not speak of x, for the proved one those that hold at every x.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from ..block_inputs import block_of
from ..errors.stationary import stationary_mse
from ..stability.witnesses import diagonal_limit
from .bounds import corrected_bound, printed_bound


@dataclass(frozen=True)
class Case:
    """One block of d coordinates, two instants.

    Parameters
    ----------
    d : int
        Coordinates.
    alpha : Fraction
        Step.
    beta : Fraction
        Size of the perturbation, in m.
    sigma : Fraction
        Standard deviation of each coordinate of the noise, in m.
    delta : Fraction
        Drift of a sample, in m.
    k : int, optional
        Blocks of the cycle.
    """

    d: int
    alpha: Fraction
    beta: Fraction
    sigma: Fraction
    delta: Fraction
    k: int = 1

    @property
    def limit(self) -> Fraction:
        """The step from which second moments no longer decay."""
        return diagonal_limit(block_of(self.block()))

    def block(self) -> dict[str, Any]:
        """Inputs of the questions about the exact error."""
        zero, size = Fraction(0), range(self.d)
        variance = self.sigma**2
        return {
            "h": (Fraction(1),) * self.d,
            "H": None,
            "Xi": tuple(tuple(variance if i == j else zero for j in size) for i in size),
            "eta": (self.delta, *(zero,) * (self.d - 1)),
            "beta": self.beta,
            "reading": "two",
            "k": Fraction(self.k),
            "alpha": self.alpha,
            "law": "gaussian",
        }

    def constants(self) -> dict[str, Fraction]:
        """What the cost has by the printed Assumptions 1 to 7."""
        zero, one, d = Fraction(0), Fraction(1), Fraction(self.d)
        own = {"alpha": self.alpha, "beta": self.beta, "delta": self.delta, "k": Fraction(self.k)}
        own |= {"d": d, "mu": one, "M": one, "c2": d * self.sigma**2, "c4": d * self.sigma**4}
        return own | {"c3": zero, "c_v2": zero}

    def constants_at_every_point(self) -> dict[str, Fraction]:
        """What the cost has if Assumption 5 is meant for every x, with the squared distance.

        The change at theta_(t-1) + y is q - y'p with p = eta + xi_t - xi_(t-1) and q = (|eta +
        xi_t|^2 - |xi_(t-1)|^2)/2. At rest the mean square is 2 sigma^2 |y|^2 + E q^2; with drift
        it is at most 2 E(y'p)^2 + 2 E q^2.
        """
        variance, drift = self.sigma**2, self.delta**2
        square = self.d * variance**2 + variance * drift + drift**2 / 4
        twice = 2 if drift else 1
        c3 = twice * (2 * variance + drift)
        return self.constants() | {"c3": c3, "c4": twice * square}


@dataclass(frozen=True)
class Compared:
    """Roots of the mean square of the error of one case, in m; infinite where it grows.

    Parameters
    ----------
    case : Case
    exact : float
        What the error tends to.
    printed, corrected : float
        The bounds; infinite outside their intervals of the step.
    """

    case: Case
    exact: float
    printed: float
    corrected: float


def case(d: int, alpha: str, beta: str, sigma: str, delta: str) -> Case:
    """A case of decimal texts."""
    return Case(d, Fraction(alpha), Fraction(beta), Fraction(sigma), Fraction(delta))


CASES: tuple[Case, ...] = (
    case(1, "0.05", "1", "0.5", "0"),
    case(2, "0.02", "1", "1", "0"),
    case(12, "0.002", "1", "1", "0"),
    case(2, "0.01", "1", "0.1", "0.1"),
    case(2, "0.001", "1", "0.1", "0.1"),
    case(12, "0.0005", "3", "1", "1"),
    case(2, "0.05", "0.03", "0.184", "0"),
)
"""Targets at rest, where both bounds are far above the error, and targets that move, where the
printed one is below it."""


def compared(cases: Iterable[Case] = CASES) -> tuple[Compared, ...]:
    """The exact error beside both bounds.

    Parameters
    ----------
    cases : iterable of Case, optional

    Returns
    -------
    tuple of Compared
    """
    return tuple(map(compare, cases))


def compare(entry: Case) -> Compared:
    """The exact error of one case beside both bounds."""
    exact = float(stationary_mse(entry.block(), certified=False).value) ** 0.5
    printed = float(printed_bound(entry.constants()).value)
    corrected = float(corrected_bound(entry.constants_at_every_point()).value)
    return Compared(entry, exact, printed, corrected)
