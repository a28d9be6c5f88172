"""Search for networks on which Theorem 1 fails as printed, with exact runs that show it.

From the error a M 1_S under the disturbance gamma (2 1_S - 1) of a cut S, the two sides move as
rigid bodies: the error stays on the ray through M 1_S and its length changes at the rate
(N - beta k)/p. The search tries every connected graph on few nodes and every cut.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations
from typing import Any

from sensortrack.networks import Network, read_network
from verification.adversary.small_graphs import connected_graphs
from verification.certificates.make import certificate
from verification.exact.laplacians.spectral_gap import connectivity_bracket
from verification.exact.solving import solved

LAMBDA_DIGITS = 1000
GAMMAS_OF_TIME = (Fraction(1), Fraction(0))


@dataclass(frozen=True)
class Counterexample:
    """One network on which the printed statement fails.

    Parameters
    ----------
    network : Network
    gamma, beta : Fraction
        Disturbance bound and a gain that the theorem allows.
    printed, sharp : float
        Printed and true threshold (or printed and true settling time).
    run : dict
        Data of the statement: x0, x1, t and lambda_2.
    document : dict
        The certificate.
    """

    network: Network
    gamma: Fraction
    beta: Fraction
    printed: float
    sharp: float
    run: dict[str, Any]
    document: dict[str, Any]


@dataclass(frozen=True)
class Cut:
    """A cut S of a network without weights: k edges, p = s(n - s)/n."""

    network: Network
    inside: tuple[int, ...]

    @property
    def k(self) -> int:
        """Number of edges that leave S."""
        inside = set(self.inside)
        return sum((i in inside) != (j in inside) for i, j in self.network.edges.tolist())

    @property
    def p(self) -> Fraction:
        """Squared length of M 1_S."""
        s, n = len(self.inside), self.network.n
        return Fraction(s * (n - s), n)

    def ray(self, length: Fraction) -> list[Fraction]:
        """length times M 1_S."""
        share = Fraction(len(self.inside), self.network.n)
        return [length * ((i in self.inside) - share) for i in range(self.network.n)]


def cuts(network: Network) -> Iterator[Cut]:
    """Every cut, the smaller side named, smallest sides first."""
    for size in range(1, network.n // 2 + 1):
        for inside in combinations(range(network.n), size):
            yield Cut(network, inside)


def gain_counterexamples(largest: int) -> Iterator[Counterexample]:
    """Yield every connected graph up to `largest` nodes on which the printed gain is too small.

    Parameters
    ----------
    largest : int
        Largest number of nodes.

    Yields
    ------
    Counterexample
        With the smallest whole gamma at which the printed threshold fails.
    """
    for network in _graphs(largest):
        lam = _lambda_below(network)
        worst = max(cuts(network), key=lambda cut: 2 * cut.p / cut.k)
        ratio = 2 * worst.p / worst.k
        excess = ratio - Fraction(_root_above(network.n)) / lam
        if excess <= 0:
            continue
        gamma = Fraction(math.floor(1 / excess) + 1)
        beta = _printed_gain(network, gamma, lam)
        if beta >= gamma * ratio:
            continue
        document, run = _drive(worst, gamma, beta, Fraction(0), Fraction(5), lam, "theorem_1_gain")
        printed = 1 + float(gamma) * math.sqrt(network.n) / _lambda(network)
        if document:
            yield Counterexample(network, gamma, beta, printed, float(gamma * ratio), run, document)


def time_counterexamples(largest: int) -> Iterator[Counterexample]:
    """Yield every connected graph up to `largest` nodes on which t* comes too early.

    Parameters
    ----------
    largest : int
        Largest number of nodes.

    Yields
    ------
    Counterexample
        At gamma = 1 if it fails there, else at gamma = 0, with a gain above the true threshold.
    """
    for network in _graphs(largest):
        found = (_late(network, gamma) for gamma in GAMMAS_OF_TIME)
        late = next((example for example in found if example), None)
        if late:
            yield late


def complete_time_counterexamples(smallest: int, largest: int) -> Iterator[Counterexample]:
    """Yield the complete graphs on which t* comes too early.

    Parameters
    ----------
    smallest, largest : int
        Numbers of nodes.

    Yields
    ------
    Counterexample
        As from `time_counterexamples`.
    """
    for nodes in range(smallest, largest + 1):
        network = read_network(f"complete:{nodes}")
        label = " ".join(f"{i}{j}" for i, j in network.edges.tolist())
        found = (_late(replace(network, label=label), gamma) for gamma in GAMMAS_OF_TIME)
        late = next((example for example in found if example), None)
        if late:
            yield late


def _late(network: Network, gamma: Fraction) -> Counterexample | None:
    lam = _lambda_below(network)
    beta = _printed_gain(network, gamma, lam)
    slowest = min(cuts(network), key=lambda cut: _pull(cut, gamma, beta) ** 2 / cut.p)
    pull = _pull(slowest, gamma, beta)
    if min(_pull(cut, gamma, beta) for cut in cuts(network)) <= 0:
        return None
    true_time = slowest.p / pull
    printed = Fraction(math.sqrt(slowest.p) / _lambda(network))
    t = ((true_time + printed) / 2).limit_denominator(64)
    if not t * t * lam * lam > slowest.p or t >= true_time:
        return None
    document, run = _drive(slowest, gamma, beta, Fraction(1), t, lam, "theorem_1_time")
    if not document:
        return None
    return Counterexample(network, gamma, beta, float(printed), float(true_time), run, document)


def _pull(cut: Cut, gamma: Fraction, beta: Fraction) -> Fraction:
    return beta * cut.k - 2 * gamma * cut.p


def _drive(
    cut: Cut,
    gamma: Fraction,
    beta: Fraction,
    start: Fraction,
    t: Fraction,
    lam: Fraction,
    name: str,
) -> tuple[dict[str, Any] | None, dict[str, Any]]:
    """Run along the cut's ray for the time t; None if an edge sign inside a side exceeds 1."""
    network, n = cut.network, cut.network.n
    disturbance = [gamma if i in cut.inside else -gamma for i in range(n)]
    end = start - t * _pull(cut, gamma, beta) / cut.p
    signs = _signs(cut, disturbance, beta, (end - start) / t)
    run = {"lambda_2": lam, "x0": cut.ray(start), "x1": cut.ray(end), "t": t}
    if signs is None:
        return None, run
    inputs = {"graph": network.to_data(), "gamma": gamma, "beta": beta, **run}
    piece = {"duration": t, "disturbance": disturbance, "signs": signs}
    witness: list[dict[str, Any]] = [{"kind": "trajectory", "pieces": [piece]}]
    if name == "theorem_1_gain":
        witness.append({"kind": "cut", "nodes": list(cut.inside)})
    else:
        part = {"kind": "enumeration", "order": list(range(n))}
        witness.append({"kind": "cuts", "parts": [part]})
    return certificate("bearing_dac", name, inputs, witness, case="REFUTED"), run


def _signs(
    cut: Cut, disturbance: list[Fraction], beta: Fraction, speed: Fraction
) -> list[Fraction] | None:
    """Selection of the edge signs that keeps both sides rigid, or None if some |sign| > 1."""
    network, n = cut.network, cut.network.n
    edges = [(int(i), int(j)) for i, j in network.edges]
    mean = sum(disturbance, Fraction(0)) / n
    demand = [(u - mean - v) / beta for u, v in zip(disturbance, cut.ray(speed), strict=True)]
    signs: list[Fraction | None] = []
    for i, j in edges:
        crosses = (i in cut.inside) - (j in cut.inside)
        signs.append(Fraction(crosses) if crosses else None)
        demand[i], demand[j] = demand[i] - crosses, demand[j] + crosses
    potential = _potential(cut, edges, demand)
    full = [
        sign if sign is not None else potential[i] - potential[j]
        for sign, (i, j) in zip(signs, edges, strict=True)
    ]
    return full if all(abs(sign) <= 1 for sign in full) else None


def _potential(cut: Cut, edges: list[tuple[int, int]], demand: list[Fraction]) -> list[Fraction]:
    """Electrical potentials inside the two sides that meet the demands (the smallest flow)."""
    n = cut.network.n
    rows = [[Fraction(0)] * n for _ in range(n)]
    for i, j in edges:
        if (i in cut.inside) == (j in cut.inside):
            rows[i][i], rows[j][j] = rows[i][i] + 1, rows[j][j] + 1
            rows[i][j], rows[j][i] = rows[i][j] - 1, rows[j][i] - 1
    for side in (True, False):  # ground one node of each side
        first = next(i for i in range(n) if (i in cut.inside) == side)
        rows[first][first] += 1
    potential = solved(rows, demand)
    if potential is None:  # a side in pieces: not a cut that matters
        return [Fraction(2 * i) for i in range(n)]
    return list(potential)


def _graphs(largest: int) -> Iterator[Network]:
    for nodes in range(2, largest + 1):
        yield from connected_graphs(nodes)


def _lambda(network: Network) -> float:
    return float(connectivity_bracket(network)[0])


def _lambda_below(network: Network) -> Fraction:
    """A short rational strictly below the algebraic connectivity."""
    lower = connectivity_bracket(network)[0]
    return Fraction(math.ceil(lower * LAMBDA_DIGITS) - 1, LAMBDA_DIGITS)


def _root_above(n: int) -> Fraction:
    """A rational a little above sqrt(n)."""
    return Fraction(math.isqrt(n * 10**12) + 1, 10**6)


def _printed_gain(network: Network, gamma: Fraction, lam: Fraction) -> Fraction:
    """A short rational at or a little above 1 + gamma sqrt(n)/lam."""
    exact = gamma * _root_above(network.n) / lam
    return 1 + Fraction(math.ceil(exact * 100), 100)
