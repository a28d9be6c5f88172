"""Sparse factors beside SuperLU, and lambda_2 with its proof and its check, against nodes.

Random geometric graphs of mean degree about 16, without their coordinates.
"""

import json
import math

import numpy as np
import pytest
from scipy.sparse import diags_array
from scipy.sparse.linalg import splu

from sensortrack.networks import Network, read_network
from verification.certificates import check
from verification.certificates.make import certificate, statements
from verification.exact.laplacians.sparse_ldl import analyse, factorise
from verification.exact.laplacians.spectral_gap import connectivity_bracket

SIZES = (1000, 10_000, 100_000)
CHECKED = (1000, 10_000)


def network_of(n: int) -> Network:
    """The largest component, a few nodes short of n."""
    whole = read_network(f"random_geometric:{n},{math.sqrt(16 / math.pi / n):.6f},1")
    return whole.subnetwork(max(whole.components(), key=len))


@pytest.mark.parametrize("n", SIZES)
@pytest.mark.parametrize("road", ["order", "nested dissection", "MMD_AT_PLUS_A", "COLAMD"])
def test_factor(benchmark, road: str, n: int) -> None:
    """Factor the Laplacian plus a small diagonal; SuperLU orders each time, we order once."""
    network = network_of(n)
    if road == "COLAMD" and n > CHECKED[-1]:
        pytest.skip("minutes and tens of gigabytes")
    matrix = (network.laplacian() + diags_array(np.full(network.n, 1e-3))).tocsc()
    right = np.random.default_rng(0).standard_normal(network.n)
    symbolic = analyse(network.n, network.edges)

    def run():
        if road == "order":
            return analyse(network.n, network.edges)
        if road == "nested dissection":
            return factorise(symbolic, None, 1e-3)
        options = {"SymmetricMode": True}
        return splu(matrix, permc_spec=road, diag_pivot_thresh=0.0, options=options)

    found = benchmark(run)

    entries = found.L.nnz if hasattr(found, "L") else symbolic.entries
    benchmark.extra_info |= {"nodes": network.n, "edges": network.m, "entries": int(entries)}
    if road != "order":
        x = found.solve(right)
        assert np.abs(matrix @ x - right).max() <= 1e-8 * np.abs(x).max()


@pytest.mark.parametrize("n", SIZES)
def test_solve_a_block(benchmark, n: int) -> None:
    """64 right-hand sides at once."""
    network = network_of(n)
    factor = factorise(analyse(network.n, network.edges), None, 1e-3)
    block = np.random.default_rng(0).standard_normal((network.n, 64))
    found = benchmark(factor.solve, block)
    flops = 4 * 64 * factor.symbolic.entries
    benchmark.extra_info |= {"nodes": network.n, "flops": flops}
    assert np.isfinite(found).all()


@pytest.mark.parametrize("n", SIZES)
def test_bracket(benchmark, n: int) -> None:
    """The whole way from edges to a bracket that is proved in exact integers."""
    network = network_of(n)
    gap = benchmark.pedantic(connectivity_bracket, (network,), rounds=1)
    width = float((gap.upper - gap.lower) / gap.upper)
    benchmark.extra_info |= {"nodes": network.n, "width": width, "steps": gap.steps}
    assert 0 < gap.lower < gap.upper
    assert width < 1e-8


@pytest.mark.parametrize("n", CHECKED)
def test_check(benchmark, n: int) -> None:
    """The checker's elimination."""
    network = network_of(n)
    gap = connectivity_bracket(network)
    ask = ("bearing_dac", "algebraic_connectivity", {"graph": network.to_data()})
    made = certificate(*ask, [gap.above, gap.below], lower=gap.lower, upper=gap.upper)
    known = statements()
    entry = benchmark.pedantic(check.check_document, (made, known), rounds=1)
    benchmark.extra_info |= {"nodes": network.n, "bytes": len(json.dumps(made))}
    assert entry["verdict"] == "PROVED"
