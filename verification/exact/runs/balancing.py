"""Integer flows that carry excess to where there is need, and the cut that stops them.

The maximum flow of a network whose sources and sinks are the nodes' own excess and need, by
blocking flows along shortest paths (Dinic): exact, because all numbers are integers.

References
----------
E. A. Dinic, "Algorithm for solution of a problem of maximum flow in networks with power
estimation", Soviet Mathematics Doklady 11 (1970).
"""

from __future__ import annotations

from collections.abc import Sequence

Link = tuple[int, int, int]
"""Two nodes and the capacity of the edge between them in either direction."""


def balanced(links: Sequence[Link], excess: Sequence[int]) -> tuple[list[int], set[int]]:
    """Carry as much excess as possible to nodes in need.

    Parameters
    ----------
    links : sequence of (int, int, int)
        Undirected edges with capacities of at least 0.
    excess : sequence of int
        What each node has to give (positive) or needs (negative).

    Returns
    -------
    flows : list of int
        One an edge, positive from its first node to its second.
    stuck : set of int
        The nodes that excess which is left can still reach: empty if nothing is left. Every edge
        that leaves the set carries its full capacity outwards.
    """
    carrier = _Carrier(links, excess)
    while carrier.layer():
        carrier.block()
    return carrier.flows(), carrier.reached if any(v > 0 for v in carrier.excess) else set()


class _Carrier:
    """Residual network: the arcs 2 e and 2 e + 1 are the two directions of the edge e."""

    def __init__(self, links: Sequence[Link], excess: Sequence[int]) -> None:
        self.excess = list(excess)
        self.capacity = [capacity for _, _, capacity in links]
        self.room = [capacity for capacity in self.capacity for _ in range(2)]
        self.head: list[int] = []
        self.out: list[list[int]] = [[] for _ in self.excess]
        for i, j, _ in links:
            self.out[i].append(len(self.head))
            self.out[j].append(len(self.head) + 1)
            self.head += [j, i]

    @property
    def reached(self) -> set[int]:
        """Nodes that the last search came to."""
        return {node for node, depth in enumerate(self.depth) if depth >= 0}

    def flows(self) -> list[int]:
        """Flow of each edge in its own direction."""
        return [c - room for c, room in zip(self.capacity, self.room[::2], strict=True)]

    def layer(self) -> bool:
        """Distances from the nodes with excess; whether a node in need is within reach."""
        walk = [node for node, amount in enumerate(self.excess) if amount > 0]
        self.depth = [-1] * len(self.excess)
        for node in walk:
            self.depth[node] = 0
        found = False
        for node in walk:
            deeper = self.depth[node] + 1
            for arc in self.out[node]:
                other = self.head[arc]
                if self.room[arc] and self.depth[other] < 0:
                    self.depth[other] = deeper
                    found = found or self.excess[other] < 0
                    walk.append(other)
        return found

    def block(self) -> None:
        """Fill shortest paths until none is left in these layers."""
        self.place = [0] * len(self.excess)
        for source, depth in enumerate(self.depth):
            if depth == 0:
                while self.excess[source] > 0 and (path := self._path(source)):
                    self._fill(source, path)

    def _path(self, source: int) -> list[int]:
        """Arcs from a node with excess to one in need, each one layer deeper."""
        path: list[int] = []
        node = source
        while self.excess[node] >= 0:
            arc = self._deeper(node)
            if arc is not None:
                path.append(arc)
                node = self.head[arc]
            elif path:  # a dead end
                node = self.head[path.pop() ^ 1]
                self.place[node] += 1
            else:
                return []
        return path

    def _deeper(self, node: int) -> int | None:
        """The next arc out of a node that leads a layer deeper."""
        out = self.out[node]
        while self.place[node] < len(out):
            arc = out[self.place[node]]
            if self.room[arc] and self.depth[self.head[arc]] == self.depth[node] + 1:
                return arc
            self.place[node] += 1
        return None

    def _fill(self, source: int, path: list[int]) -> None:
        sink = self.head[path[-1]]
        amount = min(self.excess[source], -self.excess[sink], *(self.room[arc] for arc in path))
        self.excess[source] -= amount
        self.excess[sink] += amount
        for arc in path:
            self.room[arc] -= amount
            self.room[arc ^ 1] += amount
