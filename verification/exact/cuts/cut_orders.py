"""Orders in which a search decides the nodes: early ones should leave little to the others."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..cut_problem import Problem
from .cut_search import twins

Floats = NDArray[np.float64]

DENSE = 400
"""Up to this size all modes are computed at once."""

COVER = (0.5, 1.0, 0.0)
"""How much less a node counts for each link to a node before it."""


def orders(task: Problem) -> Iterator[tuple[int, ...]]:
    """Yield different orders of the nodes, twins side by side, the more promising first.

    What is decided bounds the weight of a cut the better, the more links the undecided nodes have
    to decided ones: nodes with many links come first, best of all those without links between
    them. Another way to that is along the fastest mode of the network; networks that are long and
    thin are searched from end to end.
    """
    groups = twin_groups(task)
    seen: set[tuple[int, ...]] = set()
    for plain in _plain_orders(task):
        order = gathered(plain, groups)
        if order not in seen:
            seen.add(order)
            yield order


def _plain_orders(task: Problem) -> Iterator[Sequence[int]]:
    modes = laplacian_modes(task, 1)
    yield covering(task, COVER[0])
    yield along(modes.fast)
    yield along(modes.slow[:, 0])
    yield along(-modes.fast)
    yield along(-modes.slow[:, 0])
    for weight in COVER[1:]:
        yield covering(task, weight)


def along(line: Floats) -> list[int]:
    """Nodes in the order of their values."""
    return [int(i) for i in np.argsort(line, kind="stable")]


def covering(task: Problem, weight: float) -> list[int]:
    """Heavy nodes first, each counting less by `weight` for its links to nodes before it."""
    value = [float(sum(row.values())) for row in task.near]
    heap = [(-value[i], i) for i in range(task.n)]
    heapq.heapify(heap)
    order: list[int] = []
    decided = [False] * task.n
    while heap:
        key, node = heapq.heappop(heap)
        if decided[node] or key != -value[node]:
            continue
        decided[node] = True
        order.append(node)
        for other, link in task.near[node].items():
            if not decided[other] and weight:
                value[other] -= weight * link
                heapq.heappush(heap, (-value[other], other))
    return order


@dataclass(frozen=True)
class Modes:
    """Eigenvectors of the Laplacian.

    Parameters
    ----------
    slow : ndarray, shape (n, count)
        Of the smallest eigenvalues but 0.
    fast : ndarray, shape (n,)
        Of the largest.
    """

    slow: Floats
    fast: Floats


def laplacian_modes(task: Problem, count: int) -> Modes:
    """The `count` slowest modes of a network (fewer if it is small) and its fastest."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.linalg import eigsh

    scale = max(task.weights)
    weights = np.array([weight / scale for weight in task.weights])
    ends = task.edges.T
    links = coo_matrix((weights, (ends[0], ends[1])), shape=(task.n, task.n)).tocsr()
    degrees = np.bincount(ends.ravel(), np.r_[weights, weights], task.n)
    laplacian = coo_matrix(
        (degrees, (np.arange(task.n), np.arange(task.n))), shape=(task.n, task.n)
    ).tocsr() - (links + links.T)
    count = min(count, task.n - 1)
    if task.n <= DENSE:
        vectors = np.linalg.eigh(laplacian.toarray())[1]
        return Modes(vectors[:, 1 : 1 + count], vectors[:, -1])
    start = np.random.default_rng(0).standard_normal(task.n)
    shift = -1e-3 * float(degrees.min())
    _, slow = eigsh(laplacian.tocsc(), k=1 + count, sigma=shift, which="LM", v0=start)
    _, fast = eigsh(laplacian, k=1, which="LM", v0=start, tol=1e-2)
    return Modes(slow[:, 1:], fast[:, 0])


def twin_groups(task: Problem) -> list[list[int]]:
    """Classes of nodes that can be swapped with each other."""
    groups: list[list[int]] = []
    # twins without link between them have the same neighbours, others the same but themselves
    known: dict[tuple[bool, int, int, int], list[list[int]]] = {}
    for node, row in enumerate(task.near):
        apart, joined = (
            (linked, task.gamma[node], len(row), sum(row) + linked * node)
            for linked in (False, True)
        )
        near = [*known.get(apart, []), *known.get(joined, [])]
        group = next((group for group in near if twins(task, group[0], node)), None)
        if group is None:
            group = []
            groups.append(group)
            known.setdefault(apart, []).append(group)
            known.setdefault(joined, []).append(group)
        group.append(node)
    return groups


def gathered(order: Sequence[int], groups: Sequence[Sequence[int]]) -> tuple[int, ...]:
    """Move twins to where the first of them stands."""
    home = {node: group for group in groups for node in group}
    place = {node: i for i, node in enumerate(order)}
    done: set[int] = set()
    out: list[int] = []
    for node in order:
        if node not in done:
            members = sorted(home[node], key=place.__getitem__)
            out += members
            done.update(members)
    return tuple(out)
