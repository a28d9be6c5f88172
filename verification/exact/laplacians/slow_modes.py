"""The slowest mode of a network in floating point: lambda_2 and its eigenvector, at any size.

A block of vectors is iterated with a sparse factor of the grounded Laplacian, then with one of the
Laplacian shifted close below the estimate, where a few steps do. Ritz vectors are taken at every
step.

References
----------
B. N. Parlett, *The Symmetric Eigenvalue Problem*, chapter 14 (subspace iteration).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sensortrack.networks import Network

from .sparse_ldl import Factor, FactorError, factorise
from .sparse_pattern import Symbolic

Floats = NDArray[np.float64]

BLOCK = 6
"""Vectors that are iterated together."""

SHARP = 1e-9
"""Residual relative to lambda_2 at which the iteration ends; the value's error is its square."""

FIRST, SHIFTS, MOST = 5, 16, 8
"""Steps with the grounded Laplacian; most shifts, and most steps with each."""

RESTARTS = 100
"""Most restarts of Lanczos's method."""

FAR, CLOSE = 3e-2, 1e-8
"""How far below the estimate the first and the last shift lie, relative to it."""


class Mode(NamedTuple):
    """An approximate eigenpair.

    Parameters
    ----------
    value : float
        The vector's Rayleigh quotient.
    vector : ndarray, shape (n,)
        Of sum zero but for rounding, and norm one.
    residual : float
        Norm of L x - value x, relative to the value.
    """

    value: float
    vector: Floats
    residual: float


def edge_weights(network: Network) -> Floats | None:
    """The weights in floating point, None where all are one."""
    return None if network.weights is None else network.float_weights()


def slow_mode(network: Network, symbolic: Symbolic) -> Mode:
    """Eigenpair of the second smallest eigenvalue of a connected network's Laplacian.

    Parameters
    ----------
    network : Network
        Connected, two nodes or more.
    symbolic : Symbolic
        Of its edges.

    Returns
    -------
    Mode

    Raises
    ------
    FactorError
        The Laplacian has no usable factor in floating point.
    MemoryError
    """
    weights = edge_weights(network)
    laplacian = network.laplacian()
    ground = np.zeros(network.n)
    ground[symbolic.order[-1]] = float(laplacian.diagonal().mean())
    random = np.random.default_rng(0)
    block = random.standard_normal((network.n, min(BLOCK, network.n - 1)))
    factor = factorise(symbolic, weights, ground)
    for _ in range(FIRST):
        block = _step(laplacian, factor, block)
    del factor
    return _sharpened(network, symbolic, weights, block)


def lanczos_mode(network: Network) -> Mode:
    """The same without a factor, for networks whose factor would be too large: expanders.

    Parameters
    ----------
    network : Network
        Connected, three nodes or more.

    Returns
    -------
    Mode
        With an infinite residual if `RESTARTS` restarts of Lanczos's method were not enough.
    """
    from scipy.sparse.linalg import ArpackNoConvergence, eigsh

    laplacian = network.laplacian()
    start = np.random.default_rng(0).standard_normal(network.n)
    try:
        values, vectors = eigsh(laplacian, k=2, which="SA", v0=start, tol=SHARP, maxiter=RESTARTS)
    except ArpackNoConvergence:
        return Mode(np.inf, start, np.inf)
    return _mode(network, laplacian, vectors[:, int(np.argmax(values))])


def _sharpened(network: Network, symbolic: Symbolic, weights: Floats | None, block: Floats) -> Mode:
    """Iterate with a shift below the estimate, closer where no eigenvalue but 0 lies below it."""
    laplacian = network.laplacian()
    best, near = _mode(network, laplacian, block[:, 0]), FAR
    for _ in range(SHIFTS):
        factor = _shifted(symbolic, weights, best.value, near)
        last = np.inf
        for _ in range(MOST):
            block = _step(laplacian, factor, block)
            mode = _mode(network, laplacian, block[:, 0])
            if mode.value < best.value or mode.residual < best.residual:
                best = mode
            if mode.residual <= SHARP or mode.residual > last / 3:
                break
            last = mode.residual
        if factor.negative <= 1 and (best.residual <= SHARP or near <= CLOSE):
            break
        near = near / 30 if factor.negative <= 1 else min(8 * near, FAR)
    return best


def _shifted(symbolic: Symbolic, weights: Floats | None, value: float, near: float) -> Factor:
    """Factor L - s I for a shift s a little below a value, and below that if a pivot is zero."""
    for times in (1.0, 1.25, 1.5):
        try:
            return factorise(symbolic, weights, -value * (1 - near * times))
        except FactorError:
            continue
    return factorise(symbolic, weights, -value * (1 - 2 * near))


def _step(laplacian: object, factor: Factor, block: Floats) -> Floats:
    """One step of inverse iteration on vectors of sum zero; Ritz vectors, the slowest first."""
    block = factor.solve(block)
    block -= block.mean(axis=0)
    block /= np.linalg.norm(block, axis=0)
    sizes, turn = np.linalg.eigh(block.T @ block)
    kept = sizes > 1e-12 * sizes[-1]
    block = block @ (turn[:, kept] / np.sqrt(sizes[kept]))
    _, turn = np.linalg.eigh(block.T @ (laplacian @ block))  # type: ignore[operator]
    return np.ascontiguousarray(block @ turn)


def _mode(network: Network, laplacian: object, x: Floats) -> Mode:
    x = x - x.mean()
    x = x / np.linalg.norm(x)
    steps = x[network.edges[:, 0]] - x[network.edges[:, 1]]
    weights = edge_weights(network)
    squares = steps**2 if weights is None else weights * steps**2
    value = float(squares.sum())  # no cancellation, unlike x'Lx
    residual = float(np.linalg.norm(laplacian @ x - value * x))  # type: ignore[operator]
    return Mode(value, x, residual / value if value > 0 else np.inf)
