"""Runs of simultaneous perturbation on a quadratic cost: in C, else in NumPy, the same bits."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from sensortrack.normal_numbers import TABLE, normals
from sensortrack.random_numbers import STREAMS, words

from .build import kernel

Floats = NDArray[np.float64]
LANES = 32


@dataclass(frozen=True, eq=False)
class Recursion:
    """The numbers of one block; see `sensortrack.simulation.spsa_batch` for what they mean.

    Parameters
    ----------
    hessian, root : array (D,) or (D, D)
        Symmetric, or a diagonal; `root` times independent numbers is the noise, in m.
    eta : array (D,)
        In m a sample.
    alpha, beta : float
        beta in m.
    instants, blocks : int
        Of measurement in a step; of the cycle.
    gaussian : bool
        Else the numbers of the noise are signs.
    """

    hessian: Floats
    root: Floats
    eta: Floats
    alpha: float
    beta: float
    instants: int
    blocks: int
    gaussian: bool

    @property
    def size(self) -> int:
        """D."""
        return len(self.eta)

    @property
    def layout(self) -> tuple[int, int]:
        """Words of an update that come before the noise, and all of them in whole counters."""
        numbers = self.instants * self.size
        if self.gaussian:  # which leaves the lowest bits of a word to the signs of Delta
            return 0, 4 * -(-numbers // 4)
        signs = -(-self.size // 64)
        return signs, 4 * -(-(signs + -(-numbers // 64)) // 4)


@dataclass(frozen=True, eq=False)
class Tally:
    """What is counted, all in place.

    Parameters
    ----------
    errors : array (runs, D)
        theta_hat - theta before the next update, at its second instant.
    sums : array (runs, D)
        Sum over the updates counted of the errors right after them.
    squares : array (runs,)
        Sum of the squares of their lengths.
    trajectory : array (updates, 2)
        Of each update, sum over the runs of that square and of its square.
    """

    errors: Floats
    sums: Floats
    squares: Floats
    trajectory: Floats


def advance(
    recursion: Recursion,
    tally: Tally,
    seed: int,
    first_run: int = 0,
    skip: int = 0,
) -> None:
    """Make the updates of a tally's trajectory in all its runs.

    Parameters
    ----------
    recursion : Recursion
    tally : Tally
        Contiguous arrays of float64; they are added to.
    seed : int
    first_run : int, optional
        Number of the first run among those with this seed.
    skip : int, optional
        First updates, which are not counted in `sums` and `squares`.
    """
    key = (seed, STREAMS["batch"])
    library = kernel("spsa", native=True).library
    if library is None:
        with np.errstate(over="ignore", invalid="ignore"):  # an error that diverges, as in C
            _in_numpy(recursion, tally, key, first_run, skip)
        return
    runs, updates = len(tally.errors), len(tally.trajectory)
    flags = (recursion.hessian.ndim == 2, recursion.root.ndim == 2, recursion.gaussian)
    shape = (recursion.size, *flags, recursion.instants, recursion.blocks)
    whole = np.array([*shape, first_run, runs, updates, skip], dtype=np.int64)
    scratch = np.empty(LANES * recursion.layout[1], dtype=np.uint64)
    work, keys = np.empty(5 * LANES * recursion.size), np.array(key, dtype=np.uint64)
    arrays = (recursion.hessian, recursion.root, recursion.eta)
    tallied = (tally.errors, tally.sums, tally.squares, tally.trajectory)
    _prepared(library)(
        *_addresses(whole, *arrays),
        recursion.alpha,
        recursion.beta,
        *_addresses(keys, TABLE, *tallied, scratch, work),
    )


def _in_numpy(
    recursion: Recursion,
    tally: Tally,
    key: tuple[int, int],
    first_run: int,
    skip: int,
) -> None:
    """All runs at once, update by update; every line is one of the C source."""
    eta, alpha, beta, size = recursion.eta, recursion.alpha, recursion.beta, recursion.size
    e, runs = tally.errors.T.copy(), len(tally.errors)
    signs, width = recursion.layout
    drift = eta[:, None] if recursion.instants == 2 else np.zeros((size, 1))
    for update in range(len(tally.trajectory)):
        counter = (first_run * (width // 4), update, 0, 0)
        drawn = words(counter, key, runs * width).reshape(runs, width)
        delta = _signs(drawn, 0, size, 64 if recursion.gaussian else 1)
        rest = drawn[:, signs:]
        xi = _noise(recursion, rest, 0)
        before = _cost(recursion.hessian, ((e + drift) - beta * delta) - xi)
        if recursion.instants == 2:
            xi = _noise(recursion, rest, 1)
        after = _cost(recursion.hessian, (e + beta * delta) - xi)
        e = e - delta * (alpha * ((after - before) / (2.0 * beta)))
        square = _in_order(e * e)
        if update >= skip:
            tally.sums[:] += e.T
            tally.squares[:] += square
        for k, values in enumerate((square, square * square)):
            so_far = np.concatenate([tally.trajectory[update, k : k + 1], values])
            tally.trajectory[update, k] = np.cumsum(so_far)[-1]
        e = e - (2.0 * recursion.blocks) * eta[:, None]
    tally.errors[:] = e.T


def _signs(drawn: NDArray[np.uint64], first: int, count: int, apart: int = 1) -> Floats:
    """Bits from a place on, some places apart, as signs: count by runs."""
    index = apart * np.arange(first, first + count)
    bits = drawn[:, index // 64] >> (index % 64).astype(np.uint64) & np.uint64(1)
    return np.where(bits.T == 1, 1.0, -1.0)


def _noise(recursion: Recursion, rest: NDArray[np.uint64], instant: int) -> Floats:
    """Noise of one instant, D by runs."""
    size, root = recursion.size, recursion.root
    first = instant * size
    if recursion.gaussian:
        chosen = np.ascontiguousarray(rest[:, first : first + size].T)
        free = normals(chosen.ravel()).reshape(chosen.shape)
    else:
        free = _signs(rest, first, size)
    if root.ndim == 1:
        return root[:, None] * free
    return np.stack([_in_order(row[:, None] * free) for row in root])


def _cost(hessian: Floats, d: Floats) -> Floats:
    """d'H d / 2 of each run."""
    if hessian.ndim == 1:
        rows = hessian[:, None] * d
    else:
        rows = np.stack([_in_order(row[:, None] * d) for row in hessian])
    return _in_order(rows * d) / 2.0


def _in_order(terms: Floats) -> Floats:
    """Sum over the first axis, one after the other."""
    total = np.zeros(terms.shape[1:])
    for term in terms:
        total = total + term
    return total


def _addresses(*arrays: NDArray[np.generic]) -> list[int]:
    return [array.ctypes.data for array in arrays]


@cache
def _prepared(library: ctypes.CDLL) -> ctypes._NamedFuncPointer:
    function: ctypes._NamedFuncPointer = library.sensortrack_spsa_run
    address, number = ctypes.c_void_p, ctypes.c_double
    function.restype = None
    function.argtypes = [address] * 4 + [number] * 2 + [address] * 8
    return function
