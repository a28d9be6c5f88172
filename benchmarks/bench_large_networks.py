"""Proved brackets of the gain threshold of large networks: what they cost, and how wide they are.

Beside the time stand both ends of the bracket and their ratio: a bracket is worth no more.
The tables of docs/systems/bearing_dac_large.md, up to a million nodes, are written by

    python benchmarks/bench_large_networks.py NETWORK...
"""

from __future__ import annotations

import json
import platform
import resource
import sys
import time
from fractions import Fraction

import numpy as np
import pytest

from sensortrack.networks import Network, read_network
from verification.certificates import check
from verification.certificates.make import certificate, statements
from verification.exact.cuts.extreme import CutBracket, threshold

RANDOM = {
    "watts_strogatz": ("connected_watts_strogatz_graph", {"k": 8, "p": 0.02}),
    "barabasi_albert": ("barabasi_albert_graph", {"m": 4}),
    "cubic": ("random_regular_graph", {"d": 3}),
}
SEED = 1


def network_of(text: str) -> Network:
    """A family, or one of ``watts_strogatz:n``, ``barabasi_albert:n``, ``cubic:n``, ``holes:a``."""
    kind, _, size = text.partition(":")
    if kind == "holes":
        return grid_with_holes(int(size))
    if kind not in RANDOM:
        return read_network(text)
    import networkx

    name, options = RANDOM[kind]
    graph = getattr(networkx, name)(n=int(size), seed=SEED, **options)
    return largest(int(size), np.array([sorted(pair) for pair in graph.edges()]), text)


def grid_with_holes(side: int) -> Network:
    """An a x a grid without a hundredth of its nodes' surroundings, discs of radius 3."""
    chance = np.random.default_rng(SEED)
    holes = chance.integers(0, side, size=(side * side // 100, 2))
    place = np.stack(np.divmod(np.arange(side * side), side), axis=1)
    keep = np.ones(side * side, dtype=bool)
    for hole in holes:
        keep &= ((place - hole) ** 2).sum(axis=1) > 9
    number = np.arange(side * side).reshape(side, side)
    pairs = [(number[1:], number[:-1]), (number[:, 1:], number[:, :-1])]
    edges = np.concatenate([np.stack([b.ravel(), a.ravel()], axis=1) for a, b in pairs])
    return largest(side * side, edges[keep[edges].all(axis=1)], f"holes:{side}")


def largest(n: int, edges: np.ndarray, label: str) -> Network:
    """The largest component."""
    whole = Network([str(i) for i in range(n)], edges, label=label)
    return whole.subnetwork(max(whole.components(), key=len))


def bracket(network: Network) -> CutBracket:
    return threshold(network, [Fraction(1)] * network.n)


@pytest.mark.benchmark(group="bracket of the gain threshold")
@pytest.mark.parametrize(
    "text, ratio",
    [
        ("random_geometric:1000,0.08,3", 1.05),
        ("random_geometric:10000,0.0226,1", 1.1),
        ("random_geometric:30000,0.01303,1", 1.2),
        ("holes:100", 1.2),
        ("watts_strogatz:1000", 1.3),
        ("barabasi_albert:1000", 1.6),
        ("cubic:1000", 1.6),
    ],
)
def test_bracket(benchmark, text: str, ratio: float) -> None:
    network = network_of(text)
    found = benchmark.pedantic(bracket, (network,), rounds=1)
    ends = {"lower": str(found.lower), "upper": str(found.upper)}
    benchmark.extra_info |= {"nodes": network.n, "edges": network.m, **ends}
    benchmark.extra_info["ratio"] = float(found.upper / found.lower)
    assert found.lower <= found.upper <= ratio * found.lower


@pytest.mark.benchmark(group="check of a bracket")
@pytest.mark.parametrize("n, radius", [(1000, 0.08), (10000, 0.0226)])
def test_check(benchmark, n: int, radius: float) -> None:
    network = read_network(f"random_geometric:{n},{radius},1")
    found = bracket(network)
    inputs = {"graph": network.to_data(), "gamma": Fraction(1)}
    ends = {"lower": found.lower, "upper": found.upper}
    witness = [found.clear, found.reaches]
    document = certificate("bearing_dac", "gain_threshold", inputs, witness, **ends)
    entry = benchmark.pedantic(check.check_document, (document, statements()), rounds=1)
    benchmark.extra_info |= {"nodes": n, "bytes": len(json.dumps(document))}
    assert entry["verdict"] == "PROVED"


def main(texts: list[str]) -> None:
    """One line of the table for each network; memory is the largest up to then."""
    say = sys.stdout.write
    say(f"{platform.machine()}, Python {platform.python_version()}\n")
    for text in texts:
        network = network_of(text)
        wall, cpu = time.perf_counter(), time.process_time()
        found = bracket(network)
        wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
        inside = len(found.cut)
        upper = "none" if found.upper is None else f"{float(found.upper):.4f}"
        ratio = "" if found.upper is None else f"{float(found.upper / found.lower):.3f}"
        size = f"{network.n} | {network.m}"
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
        row = f"{size} | {float(found.lower):.4f} | {inside} | {upper} | {ratio}"
        written = "yes" if found.clear is not None else "no"
        say(f"| `{text}` | {row} | {written} | {wall:.0f} | {cpu:.0f} | {memory:.1f} |\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main(sys.argv[1:])
