"""The rules by which witnesses about cuts are accepted, as literally as possible and slowly.

Written from the rules alone and in rationals, without the scaling, the caches and the incremental
sums of the checker: a second opinion on every witness.
"""

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from sensortrack.networks import Network

BUDGET = 2_000_000


class Refused(Exception):
    """The witness does not show what it should."""


class Component:
    def __init__(self, network: Network, gamma: Sequence[Fraction]) -> None:
        self.n, self.gamma = network.n, list(gamma)
        self.pairs = [(int(i), int(j)) for i, j in network.edges]
        self.weights = list(network.weights or [Fraction(1)] * network.m)

    @property
    def even(self) -> bool:
        return len(set(self.gamma)) == 1

    @property
    def pushes(self) -> list[Fraction]:
        """What flows carry: with one bound the unit, which bounds the weights of cuts."""
        return [Fraction(1)] * self.n if self.even else self.gamma

    def k(self, inside: set[int]) -> Fraction:
        return sum(
            (
                w
                for (i, j), w in zip(self.pairs, self.weights, strict=True)
                if (i in inside) != (j in inside)
            ),
            Fraction(0),
        )

    def load(self, inside: set[int]) -> Fraction:
        share = Fraction(len(inside), self.n)
        within = sum((self.gamma[i] for i in inside), Fraction(0))
        return (1 - share) * within + share * (sum(self.gamma) - within)

    def p(self, s: int) -> Fraction:
        return Fraction(s * (self.n - s), self.n)

    def largest_load(self, s: int) -> Fraction:
        """Largest load of a set of s nodes: those of the largest or of the smallest bounds."""
        ranked = sorted(range(self.n), key=lambda i: self.gamma[i])
        return max(self.load(set(ranked[:s])), self.load(set(ranked[self.n - s :])))

    def weight_between(self, v: int, others: set[int]) -> Fraction:
        return sum(
            (
                w
                for pair, w in zip(self.pairs, self.weights, strict=True)
                if v in pair and (set(pair) - {v}) & others
            ),
            Fraction(0),
        )

    def twins(self, u: int, v: int) -> bool:
        def seen(a: int, b: int) -> list[Fraction]:
            return [self.weight_between(a, {c}) for c in range(self.n) if c not in (a, b)]

        return self.gamma[u] == self.gamma[v] and seen(u, v) == seen(v, u)


def clear(b: Fraction, f: Fraction, e: Fraction, k: Fraction, load: Fraction, p: Fraction) -> bool:
    return b * k >= load and f * (b * k - load) ** 2 >= e * p


def spread(e: Fraction | Sequence[Fraction], nodes: Sequence[int]) -> Fraction:
    if isinstance(e, Fraction):
        return e
    mean = sum((e[i] for i in nodes), Fraction(0)) / len(nodes)
    return sum(((e[i] - mean) ** 2 for i in nodes), Fraction(0))


def check_clear(
    network: Network,
    gamma: Sequence[Fraction],
    b: Fraction,
    f: Fraction,
    e: Fraction | Sequence[Fraction],
    witness: dict[str, Any],
) -> None:
    """Accept that every cut of every component is clear, or raise Refused."""
    if network.factors:
        (part,) = witness["parts"]
        for factor, inner in zip(network.factors, part["parts"], strict=True):
            inner_witness = {"kind": "cuts", "parts": [inner]}
            check_clear(factor, [gamma[0]] * factor.n, b, f, e, inner_witness)
        return
    components = network.components()
    for nodes, part in zip(components, witness["parts"], strict=True):
        component = Component(network.subnetwork(nodes), [gamma[i] for i in nodes])
        rule = {"tree": tree, "enumeration": enumeration, "routing": routing, "cells": cells}
        (rule | {"gap": gap})[part["kind"]](component, b, f, spread(e, nodes), part)


def tree(c: Component, b: Fraction, f: Fraction, e: Fraction, part: dict[str, Any]) -> None:
    if len(c.pairs) != c.n - 1:
        raise Refused("no tree")
    for left in c.pairs:
        inside, rest = {left[0]}, [pair for pair in c.pairs if pair != left]
        for _ in rest:
            for pair in rest:
                if set(pair) & inside:
                    inside |= set(pair)
        if not clear(b, f, e, c.k(inside), c.load(inside), c.p(len(inside))):
            raise Refused(f"the edge {left}")


def enumeration(c: Component, b: Fraction, f: Fraction, e: Fraction, part: dict[str, Any]) -> None:
    order, visits = part["order"], 0
    if sorted(order) != list(range(c.n)):
        raise Refused("no permutation")

    def visit(inside: set[int], outside: set[int]) -> None:
        nonlocal visits
        visits += 1
        if visits > BUDGET:
            raise Refused("too long")
        free = set(range(c.n)) - inside - outside
        if not free:
            if outside and not clear(b, f, e, c.k(inside), c.load(inside), c.p(len(inside))):
                raise Refused(f"the cut {inside}")
            return
        if inside:
            known = sum((c.weight_between(v, outside) for v in inside), Fraction(0))
            known += sum(
                (min(c.weight_between(v, inside), c.weight_between(v, outside)) for v in free),
                Fraction(0),
            )
            sizes = range(len(inside), min(c.n - len(outside), c.n - 1) + 1)
            load = max(c.largest_load(s) for s in sizes)
            if clear(b, f, e, known, load, max(c.p(s) for s in sizes)):
                return
        v = order[c.n - len(free)]
        last = order[c.n - len(free) - 1] if inside or outside else None
        if last is None or last in inside or not c.twins(last, v):
            visit(inside | {v}, outside)
        if last is not None:
            visit(inside, outside | {v})

    visit(set(), set())


def routing(c: Component, b: Fraction, f: Fraction, e: Fraction, part: dict[str, Any]) -> None:
    unit = part["unit"]
    loads = [Fraction(0)] * len(c.pairs)
    for source, flow in enumerate(part["flows"]):
        net = [0] * c.n
        for edge, value in flow:
            net[c.pairs[edge][0]] += value
            net[c.pairs[edge][1]] -= value
            loads[edge] += c.pushes[source] * abs(value) / (c.n * unit * c.weights[edge])
        if net != [unit * (c.n * (i == source) - 1) for i in range(c.n)]:
            raise Refused(f"the flow of {source}")
    settle(c, b, f, e, max(loads))


def gap(c: Component, b: Fraction, f: Fraction, e: Fraction, part: dict[str, Any]) -> None:
    """lambda_2 is at least this, by elimination in rationals of the Laplacian on sums of zero."""
    least = Fraction(part["least"])
    rows = [[(least + 1) / c.n - least * (i == j) for j in range(c.n)] for i in range(c.n)]
    for (i, j), w in zip(c.pairs, c.weights, strict=True):
        for row, column, value in ((i, i, w), (j, j, w), (i, j, -w), (j, i, -w)):
            rows[row][column] += value
    for k in range(c.n):
        if rows[k][k] <= 0:
            raise Refused("the second eigenvalue is smaller")
        for i in range(k + 1, c.n):
            ratio = rows[i][k] / rows[k][k]
            rows[i] = [x - ratio * y for x, y in zip(rows[i], rows[k], strict=True)]
    settle(c, b, f, e, 2 * max(c.pushes) / least)


def cells(c: Component, b: Fraction, f: Fraction, e: Fraction, part: dict[str, Any]) -> None:
    settle(c, b, f, e, max(pushed_loads(c, part)))


def cell_loads(c: Component, part: dict[str, Any]) -> list[Fraction]:
    """Load of each edge over its weight."""
    factor = c.gamma[0] if c.even else Fraction(1)
    return [factor * load for load in pushed_loads(c, part)]


def pushed_loads(c: Component, part: dict[str, Any]) -> list[Fraction]:
    """The same for what flows carry, home after home."""
    loads = [Fraction(0)] * len(c.pairs)
    grain = part["scale"] * math.lcm(*(bound.denominator for bound in c.pushes))
    homes = [list(range(c.n))]
    for unit, place, weights, sources in part["levels"]:
        within = [pair for pair in c.pairs if any(set(pair) <= set(home) for home in homes)]
        finer = []
        for home in homes:
            tree = spanning_tree(home, within)
            for k, steps in enumerate(sources):
                cell = [i for i in home if place[i] == k]
                if not cell:
                    continue
                finer.append(cell)
                x = {i: sum(steps[j] for j in ancestors(tree, i)) for i in home}
                net = {i: unit * (len(home) * (i in cell) - len(cell)) for i in home}
                flow = {}
                for (i, j), w in zip(within, weights, strict=True):
                    if i in home:
                        flow[i, j] = w * (x[i] - x[j]) // 2**20
                        net[i] -= flow[i, j]
                        net[j] += flow[i, j]
                for i in home:  # what is left at a node goes to the root by itself
                    for j in ancestors(tree, i)[:-1]:
                        up = tree[j]
                        flow[min(j, up), max(j, up)] += net[i] if j < up else -net[i]
                mean = sum(c.pushes[i] for i in cell) / Fraction(len(cell))
                factor = mean / (len(home) * unit)
                factor = Fraction(math.ceil(factor * grain), grain)
                for pair, amount in flow.items():
                    at = c.pairs.index(pair)
                    loads[at] += factor * abs(amount) / c.weights[at]
        homes = finer
    if sorted(homes) != [[i] for i in range(c.n)]:
        raise Refused("not down to single nodes")
    return loads


def spanning_tree(home: list[int], pairs: list[tuple[int, int]]) -> dict[int, int | None]:
    """The node before each, breadth first from the smallest, edges in the order given."""
    tree: dict[int, int | None] = {home[0]: None}
    walk = [home[0]]
    for i in walk:
        for j in [sum(pair) - i for pair in pairs if i in pair]:
            if j not in tree:
                tree[j] = i
                walk.append(j)
    if sorted(walk) != home:
        raise Refused("not connected")
    return tree


def ancestors(tree: dict[int, int | None], node: int) -> list[int]:
    """The node, the one before it, and so on to the root."""
    found, at = [], node
    while at is not None:
        found.append(at)
        at = tree[at]
    return found


def settle(c: Component, b: Fraction, f: Fraction, e: Fraction, up: Fraction) -> None:
    """What the largest load says: with one bound, how little a cut of s nodes may weigh."""
    if not c.even:
        if e or b < up:
            raise Refused("the routing shows less")
        return
    grain = Fraction(1, math.lcm(*(w.denominator for w in c.weights)))
    even = all(sum(i in pair for pair in c.pairs) % 2 == 0 for i in range(c.n))
    for s in range(1, c.n):
        outside = sorted(max(sum(i in pair for pair in c.pairs) - s + 1, 0) for i in range(c.n))
        least = max(1 + even, sum(outside[:s]), math.ceil(2 * c.p(s) / up / grain)) * grain
        if not clear(b, f, e, least, 2 * c.gamma[0] * c.p(s), c.p(s)):
            raise Refused(f"{s} nodes and weight {least} may fail")


def check_reaches(
    network: Network,
    gamma: Sequence[Fraction],
    b: Fraction,
    f: Fraction,
    e: Fraction | Sequence[Fraction],
    witness: dict[str, Any],
) -> None:
    """Accept that a cut is not clear with room to spare, or raise Refused."""
    if network.factors:
        factor = network.factors[witness["factor"]]
        plain = {"kind": "cut", "nodes": witness["nodes"]}
        check_reaches(factor, [gamma[0]] * factor.n, b, f, e, plain)
        return
    inside = set(witness["nodes"])
    (nodes,) = (nodes for nodes in network.components() if inside <= set(nodes))
    if not inside or inside == set(nodes):
        raise Refused("no cut")
    c = Component(network.subnetwork(nodes), [gamma[i] for i in nodes])
    s = {nodes.index(i) for i in inside}
    k, load, square = c.k(s), c.load(s), spread(e, nodes)
    if b * k > load and f * (b * k - load) ** 2 > square * c.p(len(s)):
        raise Refused("the cut is clear")
