"""Where to draw the nodes of a network: where they are, or spread by hop distances."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
ROUNDS = 300
NUDGE = 0.02
"""How far nodes that would coincide at the start are moved apart, in hops."""


def spread_places(n: int, edges: ArrayLike) -> Floats:
    """Places whose distances are near the hop distances: the same picture every time.

    Stress majorisation from the classical scaling of the hop distances.

    Parameters
    ----------
    n : int
        Number of nodes, at least 1; time and memory grow with its square.
    edges : array_like of int, shape (m, 2)

    Returns
    -------
    ndarray, shape (n, 2)
        In hops. Components are n hops apart.
    """
    hops = _hop_distances(n, np.asarray(edges, dtype=np.int64).reshape(-1, 2))
    x = _scaled(hops)
    weight = np.where(hops > 0, 1 / np.maximum(hops, 1) ** 2, 0.0)
    total = np.maximum(weight.sum(axis=1, keepdims=True), 1e-9)
    for _ in range(ROUNDS):
        apart = x[:, None] - x[None]
        length = np.sqrt((apart**2).sum(axis=2)) + 1e-9
        pull = (weight * hops / length)[:, :, None] * apart
        x = (weight @ x + pull.sum(axis=1)) / total
    return x


def _scaled(hops: Floats) -> Floats:
    """Classical scaling: the two main axes of the squared distances without their means."""
    n = len(hops)
    angle = 2 * np.pi * np.arange(n) / n
    x: Floats = NUDGE * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    if n < 3:
        x[:, 0] += np.arange(n)
        return x
    squares = hops**2
    centred = squares - squares.mean(axis=0) - squares.mean(axis=1)[:, None] + squares.mean()
    values, vectors = np.linalg.eigh(-centred / 2)
    main = vectors[:, -2:][:, ::-1]
    turned = main * np.sign(main[np.abs(main).argmax(axis=0), [0, 1]])
    x += turned * np.sqrt(np.maximum(values[-2:][::-1], 0.0))
    return x


def _hop_distances(n: int, edges: NDArray[np.int64]) -> Floats:
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import shortest_path

    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(n, n)).tocsr()
    hops: Floats = shortest_path(graph, directed=False, unweighted=True)
    hops[~np.isfinite(hops)] = n
    return hops


def framed(places: Floats, width: float, height: float, margin: float, equal: bool) -> Floats:
    """Fit places into a frame whose second coordinate points down, as on a screen.

    Parameters
    ----------
    places : ndarray, shape (n, 2)
    width, height, margin : float
        Of the frame, in its own units.
    equal : bool
        One scale for both directions, as on a map.

    Returns
    -------
    ndarray, shape (n, 2)
    """
    room = np.array([width - 2 * margin, height - 2 * margin])
    low = places.min(axis=0)
    span = np.maximum(places.max(axis=0) - low, 1e-9)
    scale = np.full(2, (room / span).min()) if equal else room / span
    shifted = (places - low) * scale + (room - span * scale) / 2
    shifted[:, 1] = room[1] - shifted[:, 1]
    fitted: Floats = margin + shifted
    return fitted
