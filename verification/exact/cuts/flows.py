"""Flows with small loads, in floating point: shortest-path trees and currents.

Nothing here is believed: `routing` rounds what is proposed and restores conservation.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..cut_problem import Problem

Flows = NDArray[np.float64]

REWEIGHTING = ((16, 0.3, 24), (24, 0.4, 24), (48, 0.5, 32))
"""Exponent, floor and number of rounds."""


class Carrier:
    """A network that carries flows, in doubles.

    Parameters
    ----------
    task : Problem
        Connected, two nodes or more.
    """

    def __init__(self, task: Problem) -> None:
        self.task, self.n, self.m = task, task.n, len(task.edges)
        self.first, self.second = task.edges[:, 0], task.edges[:, 1]
        self.capacity = np.array([weight / max(task.weights) for weight in task.weights])
        self.gamma = np.array([bound / (max(task.gamma) or 1) for bound in task.gamma])
        self.value = max(task.gamma) * task.weight_unit / (max(task.weights) * task.gamma_unit)

    @cached_property
    def incidence(self) -> Flows:
        """1 where an edge leaves a node, -1 where it enters, shape (n, m)."""
        matrix = np.zeros((self.n, self.m))
        matrix[self.first, np.arange(self.m)] = 1
        matrix[self.second, np.arange(self.m)] = -1
        return matrix

    @cached_property
    def edge_of(self) -> NDArray[np.int64]:
        """Number of the edge between two nodes, -1 where there is none."""
        table = np.full((self.n, self.n), -1, dtype=np.int64)
        table[self.first, self.second] = table[self.second, self.first] = np.arange(self.m)
        return table

    @cached_property
    def tree(self) -> list[tuple[int, int, int, int]]:
        """(node, parent, edge, sign) of a breadth-first tree, leaves first.

        The sign is 1 if the edge leaves the node, that is, if the node is smaller than its parent.
        """
        seen, walk, steps = {0}, [0], []
        for node in walk:
            for other in self.task.near[node]:
                if other not in seen:
                    seen.add(other)
                    walk.append(other)
                    edge = int(self.edge_of[node, other])
                    steps.append((other, node, edge, 1 if other < node else -1))
        return steps[::-1]

    def shares(self, flows: Flows) -> Flows:
        """Load of each edge over its capacity."""
        shares: Flows = (self.gamma @ np.abs(flows)) / (self.capacity * self.n)
        return shares

    def distances(self, lengths: Flows) -> tuple[Flows, NDArray[np.int32]]:
        """Distances between all nodes and the last node before each on its path from each."""
        from scipy.sparse import csr_matrix
        from scipy.sparse.csgraph import dijkstra

        graph = csr_matrix((lengths, (self.first, self.second)), shape=(self.n, self.n))
        found: tuple[Flows, NDArray[np.int32]] = dijkstra(
            graph, directed=False, return_predecessors=True
        )
        return found

    def trees(self, lengths: Flows) -> tuple[Flows, float]:
        """Flows along shortest paths, and a lower bound on the largest load of any routing.

        Parameters
        ----------
        lengths : ndarray, shape (m,)
            Positive.

        Returns
        -------
        flows : ndarray, shape (n, m)
            Along the tree of shortest paths from each node.
        lower : float
            By linear programming duality.
        """
        distances, before = self.distances(lengths)
        order = np.argsort(distances, axis=1, kind="stable")
        rows = np.arange(self.n)
        carried, flows = np.ones((self.n, self.n)), np.zeros((self.n, self.m))
        for rank in range(self.n - 1, 0, -1):
            node = order[:, rank]
            parent = before[rows, node]
            edge = self.edge_of[parent, node]
            flows[rows, edge] += carried[rows, node] * np.where(parent < node, 1, -1)
            carried[rows, parent] += carried[rows, node]
        total = float(self.gamma @ distances.sum(axis=1)) / (
            self.n * float(self.capacity @ lengths)
        )
        return flows, total


def electrical_flows(carrier: Carrier) -> Flows:
    """Currents of a network whose conductances fall where many currents add up.

    Conductances are multiplied by a negative power of the relative load, damped; the round with the
    smallest largest load is kept.

    Returns
    -------
    ndarray, shape (n, m)
        One flow a node.
    """
    n = carrier.n
    demand = n * np.eye(n) - 1
    best, best_load = np.zeros((n, carrier.m)), np.inf
    conductance = carrier.capacity.copy()
    for exponent, floor, rounds in REWEIGHTING:
        step = 1 / (exponent - 1)
        for _ in range(rounds):
            laplacian = (carrier.incidence * conductance) @ carrier.incidence.T
            potential = np.linalg.solve(laplacian + laplacian.trace() / n**2, demand)
            flows = (potential.T @ carrier.incidence) * conductance
            load = carrier.shares(flows)
            if load.max() < best_load:
                best, best_load = flows, float(load.max())
            share = np.maximum(load / load.max(), floor)
            target = carrier.capacity * share ** (2 - exponent)
            conductance = conductance ** (1 - step) * target**step
    return best
