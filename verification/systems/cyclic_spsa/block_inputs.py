"""The inputs that questions about one block of coordinates share, read and checked once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from sensortrack.errors import InputError
from verification.answers import Input
from verification.exact.definite import congruence
from verification.exact.evaluate import Rows
from verification.input_words import positive

READINGS = {"one": 1, "two": 2}
"""Measurement instants of a step."""

HESSIAN = (
    Input("h", "diagonal", "diagonal of the Hessian, positive", optional=True),
    Input("H", "matrix", "Hessian, symmetric positive definite, instead of h", optional=True),
)
NOISE = Input("Xi", "matrix", "covariance of the measured positions", "m^2", "0")
DRIFT = Input("eta", "list", "drift of the positions from sample to sample", "m", "0")
BETA = Input("beta", "number", "size of the perturbation, above 0", "m")
READING = Input("reading", "word", "measurement instants of a step: two or one", "", "two")
BLOCKS = Input("k", "number", "blocks of the cycle; each is updated every 2k samples", "", "1")
BLOCK = (*HESSIAN, NOISE, DRIFT, BETA, READING, BLOCKS)
ALPHA = Input("alpha", "number", "step size, above 0")


@dataclass(frozen=True)
class Block:
    """One block of D coordinates, checked.

    Parameters
    ----------
    hessian : Rows
        D by D, symmetric positive definite.
    given : str
        ``h`` or ``H``: how the Hessian was given.
    noise : Rows
        D by D, symmetric positive semidefinite, in m^2.
    drift : tuple of Fraction
        D numbers, in m a sample.
    beta : Fraction
        Above 0, in m.
    instants : int
        Measurement instants of a step, 1 or 2.
    blocks : int
        Of the cycle, at least 1.
    """

    hessian: Rows
    given: str
    noise: Rows
    drift: tuple[Fraction, ...]
    beta: Fraction
    instants: int
    blocks: int

    @property
    def size(self) -> int:
        """D, the number of coordinates."""
        return len(self.hessian)

    @property
    def diagonal(self) -> bool:
        """Whether the Hessian is diagonal."""
        return all(not x for i, row in enumerate(self.hessian) for j, x in enumerate(row) if i != j)

    def inputs(self) -> dict[str, Any]:
        """The data of a certificate: the Hessian is diag(h) + H, and the one not given is zero."""
        size, own = range(self.size), self.given == "h"
        return {
            "h": [[self.hessian[i][i] if own else Fraction(0)] for i in size],
            "H": [[Fraction(0)] * self.size for _ in size] if own else self.hessian,
            "Xi": self.noise,
            "eta": [[x] for x in self.drift],
            "beta": self.beta,
            "reading": Fraction(self.instants),
            "k": Fraction(self.blocks),
        }


def block_of(values: Mapping[str, Any]) -> Block:
    """Read and check the inputs of `BLOCK`.

    Raises
    ------
    InputError
        The Hessian is missing, given twice or not symmetric positive definite; Xi is not symmetric
        positive semidefinite; beta <= 0; a size, the reading or k is out of range.
    """
    hessian, given = hessian_of(values)
    size = len(hessian)
    noise, drift = covariance("Xi", values["Xi"], size), _drift(values["eta"], size)
    reading, blocks = values["reading"], values["k"]
    if reading not in READINGS:
        raise InputError("reading", repr(reading), f"one of {', '.join(READINGS)} is needed")
    if blocks.denominator != 1 or blocks < 1:
        raise InputError("k", f"{blocks}", "a whole number of blocks, at least 1, is needed")
    beta = positive(values, "beta")
    return Block(hessian, given, noise, drift, beta, READINGS[reading], int(blocks))


def hessian_of(values: Mapping[str, Any]) -> tuple[Rows, str]:
    """Read and check the Hessian, which is given as ``h`` or as ``H``; the other is None.

    Returns
    -------
    hessian : Rows
    given : str
        ``h`` or ``H``.

    Raises
    ------
    InputError
        It is missing, given twice or not symmetric positive definite.
    """
    h, matrix = values["h"], values["H"]
    if (h is None) == (matrix is None):
        found = "neither h nor H is given" if h is None else "h and H are both given"
        raise InputError("h", found, "one of them is needed: a diagonal or a matrix")
    if matrix is None:
        low = [x for x in h if x <= 0]
        if low:
            raise InputError("h", f"{low[0]}", "numbers above 0 are needed: the cost has a minimum")
        size = range(len(h))
        return tuple(tuple(h[i] if i == j else Fraction(0) for j in size) for i in size), "h"
    _symmetric("H", matrix)
    if congruence(matrix) is None:
        found = "a matrix that is not positive definite"
        raise InputError("H", found, "a symmetric positive definite one is needed")
    return matrix, "H"


def _symmetric(name: str, rows: Rows) -> None:
    if rows != tuple(zip(*rows, strict=True)):
        raise InputError(name, "a matrix that is not symmetric", "a symmetric one is needed")


def covariance(name: str, rows: Rows, size: int) -> Rows:
    """A covariance of that size; one number means that multiple of the identity.

    Raises
    ------
    InputError
        It has another size, or is not symmetric positive semidefinite.
    """
    rows = _sized(name, rows, size)
    _symmetric(name, rows)
    if _negative(rows):
        found = "a matrix that is not positive semidefinite"
        raise InputError(name, found, "a covariance, x'Ax >= 0, is needed")
    return rows


def _negative(rows: Rows) -> bool:
    """Whether x'Ax < 0 for some x, by exact elimination with symmetric pivots."""
    left = [list(row) for row in rows]
    live = list(range(len(left)))
    while live:
        if any(left[i][i] < 0 for i in live):
            return True
        pivot = next((i for i in live if left[i][i] > 0), None)
        if pivot is None:
            return any(left[i][j] for i in live for j in live)
        live.remove(pivot)
        for i in live:
            factor = left[i][pivot] / left[pivot][pivot]
            if factor:
                for j in live:
                    left[i][j] -= factor * left[pivot][j]
    return False


def _sized(name: str, rows: Rows, size: int) -> Rows:
    """A number means that multiple of the identity."""
    if len(rows) == size:
        return rows
    if len(rows) == 1:
        unit = range(size)
        return tuple(tuple(rows[0][0] if i == j else Fraction(0) for j in unit) for i in unit)
    raise InputError(name, f"{len(rows)} x {len(rows)}", f"{size} x {size} is needed")


def _drift(drift: tuple[Fraction, ...], size: int) -> tuple[Fraction, ...]:
    if len(drift) == size:
        return drift
    if len(drift) == 1:
        return drift * size
    raise InputError("eta", f"{len(drift)} numbers", f"{size} are needed, one a coordinate")
