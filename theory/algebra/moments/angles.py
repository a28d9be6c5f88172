"""Means of polynomials in the sine and cosine of a Gaussian angle, exactly.

With z = exp(i d) the sine and cosine of d are (z - 1/z)/(2 i) and (z + 1/z)/2, so that every
polynomial in them is a sum of powers of z; and a Gaussian d of mean 0 and standard deviation sigma
has the mean E z^m = E^(m^2) with E = exp(-sigma^2/2), its characteristic function.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

Complex = tuple[Fraction, Fraction]
ZERO = Fraction(0)


@dataclass(frozen=True)
class Wave:
    """A sum of powers of exp(i d) with complex rational coefficients.

    Parameters
    ----------
    terms : mapping of int to (Fraction, Fraction)
        Power to real and imaginary part, none of them zero.
    """

    terms: Mapping[int, Complex]

    def __add__(self, other: Wave) -> Wave:
        found = dict(self.terms)
        for power, (re, im) in other.terms.items():
            old = found.get(power, (ZERO, ZERO))
            found[power] = (old[0] + re, old[1] + im)
        return Wave({power: c for power, c in found.items() if c != (ZERO, ZERO)})

    def __mul__(self, other: Wave) -> Wave:
        found = Wave({})
        for m, (a, b) in self.terms.items():
            for n, (c, d) in other.terms.items():
                found = found + Wave({m + n: (a * c - b * d, a * d + b * c)})
        return found

    def times(self, factor: Fraction | int) -> Wave:
        """A rational multiple."""
        exact = Fraction(factor)
        return Wave({m: (a * exact, b * exact) for m, (a, b) in self.terms.items() if exact})

    @property
    def mean(self) -> dict[int, Fraction]:
        """E of it for a Gaussian d: exponent of exp(-sigma^2/2) to coefficient.

        Raises
        ------
        ValueError
            It is not real.
        """
        found: dict[int, Fraction] = {}
        imaginary: dict[int, Fraction] = {}
        for power, (re, im) in self.terms.items():
            found[power**2] = found.get(power**2, ZERO) + re
            imaginary[power**2] = imaginary.get(power**2, ZERO) + im
        if any(imaginary.values()):
            raise ValueError("mean: of a sum that is not real")
        return {exponent: c for exponent, c in sorted(found.items()) if c}


HALF = Fraction(1, 2)
ONE = Wave({0: (Fraction(1), ZERO)})
SINE = Wave({1: (ZERO, -HALF), -1: (ZERO, HALF)})
COSINE = Wave({1: (HALF, ZERO), -1: (HALF, ZERO)})
