"""Partitions of a network into connected cells of about the same size, and hierarchies of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .wiring import Nodes, Wiring, forest, grow, recentre, smooth

CENTRINGS = 4
SMOOTHINGS = 8
SMOOTHED = 12
"""Smaller cells would be swallowed."""

RESPLITS = 4
LARGE = 1.5
"""Times the size that is asked for: larger cells are split again, so often."""

SEED = 20_230_517


def split(wires: Wiring, home: Nodes, size: int, seed: int = SEED) -> Nodes:
    """Split every home into connected cells.

    Cells are the nodes nearest to seeds, in steps; seeds move to the middles of their cells a few
    times, and boundaries are straightened.

    Parameters
    ----------
    wires : Wiring
    home : ndarray of int32, shape (n,)
        Number of the home of each node, from 0 on; each is connected.
    size : int
        About how many nodes a cell shall have; 1 for single nodes.
    seed : int, optional
        Of the random seeds.

    Returns
    -------
    ndarray of int32, shape (n,)
        Number of the cell of each node, from 0 on; every cell lies in one home and is connected.
    """
    if size == 1:
        return np.arange(wires.n, dtype=np.int32)
    label = _split(wires, home, size, seed, SMOOTHINGS if size >= SMOOTHED else 0)
    for again in range(1, RESPLITS + 1):
        large = np.bincount(label) > LARGE * size
        if not large.any():
            break
        finer = _split(wires, label, size, seed + again, 0)
        label = numbered(np.where(large[label], finer + len(large), label))
    return label


def _split(wires: Wiring, home: Nodes, size: int, seed: int, smoothings: int) -> Nodes:
    seeds = _first_seeds(home, size, seed)
    label = _around(wires, home, seeds)
    for _ in range(CENTRINGS):
        recentre(wires, label, seeds)
        label = _around(wires, home, seeds)
    for _ in range(smoothings):
        if not smooth(wires, home, label):
            break
    return connected(wires, home, label)


def connected(wires: Wiring, home: Nodes, label: Nodes) -> Nodes:
    """Keep the largest connected part of each cell; the rest joins its neighbours."""
    trees = forest(wires, label)
    part = np.empty(wires.n, dtype=np.int32)
    part[trees.order] = np.cumsum(trees.roots[trees.order]) - 1
    sizes = np.bincount(part)
    cell = np.empty(len(sizes), dtype=np.int32)
    cell[part] = label
    by_size = np.lexsort((sizes, cell))
    largest = by_size[np.flatnonzero(np.diff(np.append(cell[by_size], -1)))]
    kept = np.zeros(len(sizes), dtype=bool)
    kept[largest] = True
    label = np.where(kept[part], label, np.int32(-1)).astype(np.int32)
    grow(wires, home, label)
    return numbered(label)


def hierarchy(wires: Wiring, sizes: Sequence[int]) -> list[Nodes]:
    """Partitions, each one finer than the one before: all nodes in one, cells, single nodes.

    Parameters
    ----------
    wires : Wiring
        Connected.
    sizes : sequence of int
        About how many nodes a cell has, decreasing, the last one 1.
    """
    found = [np.zeros(wires.n, dtype=np.int32)]
    for size in sizes:
        found.append(split(wires, found[-1], size))
    return found


def places(home: Nodes, cell: Nodes) -> Nodes:
    """Number of each node's cell among the cells of its home, from 0 on.

    Parameters
    ----------
    home, cell : ndarray of int32, shape (n,)
        Numbers from 0 on, none left out; each cell lies in one home.
    """
    owner = np.empty(int(cell.max()) + 1, dtype=np.int32)
    owner[cell] = home
    order = np.argsort(owner, kind="stable")
    starts = np.searchsorted(owner[order], np.arange(int(home.max()) + 1))
    place = np.empty(len(owner), dtype=np.int32)
    place[order] = np.arange(len(owner)) - starts[owner[order]]
    return place[cell]


def numbered(label: Nodes) -> Nodes:
    """The same cells, numbered from 0 on with none left out."""
    return np.unique(label, return_inverse=True)[1].astype(np.int32)


def _first_seeds(home: Nodes, size: int, seed: int) -> Nodes:
    """Random nodes of each home, one at least, in proportion to its size."""
    shuffled = np.random.default_rng(seed).permutation(len(home))
    by_home = shuffled[np.argsort(home[shuffled], kind="stable")]
    sizes = np.bincount(home)
    starts = np.cumsum(sizes) - sizes
    counts = np.maximum(1, np.rint(sizes / size)).astype(np.int64)
    rank = np.arange(len(home)) - np.repeat(starts, sizes)
    return by_home[rank < np.repeat(counts, sizes)].astype(np.int32)


def _around(wires: Wiring, home: Nodes, seeds: Nodes) -> Nodes:
    label = np.full(wires.n, -1, dtype=np.int32)
    label[seeds] = np.arange(len(seeds))
    grow(wires, home, label)
    return label
