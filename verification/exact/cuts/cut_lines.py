"""Lines along which the nodes of a network are swept: slow modes, and the worst cuts on them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from .band_cuts import band_cuts
from .cut_graph import CutGraph, Flags, Floats, Scales

MODES = 4
ANGLES = 8
DENSE = 400
"""Up to this size all modes are computed at once."""

WIDTHS = (0.1, 0.3, 0.6)
"""Shares of the nodes that are free in bands along a line."""


def sweep_values(graph: CutGraph, scales: Scales, line: Floats) -> tuple[NDArray[np.int64], Floats]:
    """Nodes in the order of a line, and how bad the cut behind each but the last is."""
    order = np.argsort(line, kind="stable")
    place = np.empty(graph.n, dtype=np.int64)
    place[order] = np.arange(graph.n)
    ends = place[graph.first], place[graph.second]
    steps = np.bincount(np.minimum(*ends), graph.weight, graph.n)
    steps -= np.bincount(np.maximum(*ends), graph.weight, graph.n)
    sums = (np.cumsum(row)[:-1] for row in (steps, graph.size[order], graph.gamma[order]))
    return order, scales.badness(graph, *sums)


def worst_along(graph: CutGraph, scales: Scales, line: Floats) -> Flags:
    """The worst cut along a line, and what minimum cuts in bands around it make of it."""
    order, values = sweep_values(graph, scales, line)
    middle = int(np.argmax(values)) + 1
    swept = np.zeros(graph.n, dtype=bool)
    swept[order[:middle]] = True
    cuts = [swept]
    value = scales.of(graph, swept)
    if not 0 < value < np.inf:
        return swept
    for width in WIDTHS:
        half = int(width * graph.n / 2)
        free = np.zeros(graph.n, dtype=bool)
        free[order[max(middle - half, 1) : min(middle + half, graph.n - 1)]] = True
        cuts += band_cuts(graph, scales, swept, free, value)
    return max(cuts, key=lambda side: scales.of(graph, side))


def lines_of(graph: CutGraph) -> Iterator[Floats]:
    """Slow modes and mixtures of the slowest ones."""
    kinds = [graph.conductance]
    plain = graph.weight * (graph.conductance.sum() / graph.weight.sum())
    if not np.allclose(graph.conductance, plain):
        kinds.append(graph.weight)
    for links in kinds:
        modes = slow_modes(graph, links)
        yield from modes.T
        for angle in np.arange(1, ANGLES) * np.pi / ANGLES:
            if modes.shape[1] > 1:
                yield np.cos(angle) * modes[:, 0] + np.sin(angle) * modes[:, 1]


def slow_modes(graph: CutGraph, links: Floats, count: int = MODES) -> Floats:
    """Slowest modes of L x = lambda D x with D the sizes, shape (n, at most `count`)."""
    from scipy.linalg import eigh
    from scipy.sparse import coo_array, diags_array
    from scipy.sparse.linalg import LinearOperator, eigsh, splu

    n = graph.n
    half = coo_array((links, (graph.first, graph.second)), shape=(n, n))
    table = (half + half.T).tocsc()
    degrees: Floats = np.asarray(table.sum(axis=0)).ravel()
    laplacian = (diags_array(degrees) - table).tocsc()
    count = min(count, n - 1)
    if n <= DENSE:
        vectors = eigh(laplacian.toarray(), np.diag(graph.size))[1]
        return np.asarray(vectors[:, 1 : 1 + count])
    start = np.random.default_rng(0).standard_normal(n)
    shift = -1e-6 * float(degrees.sum() / graph.whole)
    sizes = diags_array(graph.size).tocsc()
    factor = splu(
        (laplacian - shift * sizes).tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    inverse = LinearOperator((n, n), factor.solve)
    vectors = eigsh(
        laplacian, k=1 + count, M=sizes, sigma=shift, v0=start, tol=1e-4, OPinv=inverse
    )[1]
    return np.asarray(vectors[:, 1:])
