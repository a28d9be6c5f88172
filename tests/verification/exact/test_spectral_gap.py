"""Algebraic connectivity: closed forms, numpy, a second proof of each bound."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings

from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks
from verification.certificates.make import CertificateError, certificate
from verification.exact.spectral_gap import (
    NoBracketError,
    connectivity_bracket,
    connectivity_value,
    exact_connectivity,
    laplacian_rows,
    rayleigh,
)

CLOSED = {
    **{f"path:{n}": 4 * math.sin(math.pi / (2 * n)) ** 2 for n in (2, 3, 10, 77)},
    **{f"cycle:{n}": 4 * math.sin(math.pi / n) ** 2 for n in (3, 8, 31)},
    "complete:7": 7.0,
    "star:9": 1.0,
    "bipartite:3,5": 3.0,
    "hypercube:5": 2.0,
    "petersen": 2.0,
    "grid:3,8": 4 * math.sin(math.pi / 16) ** 2,
    "hypercube:20": 2.0,
    "grid:150,180": 4 * math.sin(math.pi / 360) ** 2,
}


@pytest.mark.parametrize("family", CLOSED)
def test_families_have_their_closed_forms(family: str) -> None:
    network = read_network(family)
    gap = connectivity_bracket(network)
    assert gap.lower < gap.upper
    assert (gap.upper - gap.lower) <= gap.upper * Fraction(1, 10**15)
    assert float(gap.lower) * (1 - 1e-14) <= CLOSED[family] <= float(gap.upper) * (1 + 1e-14)
    value = connectivity_value(network)
    assert value == pytest.approx(CLOSED[family], rel=1e-13)


@given(connected_networks(2, 8, weighted=True))
@settings(max_examples=40)
def test_bounds_are_neighbours_and_certified(network: Network) -> None:
    gap = connectivity_bracket(network)
    eigenvalues = np.linalg.eigvalsh(network.laplacian().toarray())
    assert float(gap.upper) == pytest.approx(eigenvalues[1], rel=1e-9, abs=1e-12)
    assert float(gap.upper) - float(gap.lower) <= 4 * math.ulp(float(gap.upper))
    assert sum(gap.vector) == 0
    assert rayleigh(network, gap.vector) <= gap.upper
    data = {"graph": network.to_data()}
    witness = [{"kind": "vector", "x": list(gap.vector)}]
    ask = ("bearing_dac", "algebraic_connectivity", data, witness)
    certificate(*ask, lower=gap.lower, upper=gap.upper)
    with pytest.raises(CertificateError):
        certificate(*ask, lower=gap.upper + Fraction(1, 10**6), upper=gap.upper)
    exact = exact_connectivity(network, gap)
    assert exact is not None
    assert float(gap.lower) <= exact.nearest <= float(gap.upper)
    size = sum(abs(c) * exact.nearest**k for k, c in enumerate(exact.polynomial))
    value = sum(c * exact.nearest**k for k, c in enumerate(exact.polynomial))
    assert abs(value) <= 1e-9 * size


@pytest.mark.parametrize(
    "family, polynomial",
    [("cycle:8", (2, -4, 1)), ("petersen", (-2, 1)), ("grid:5,7", (-1, 6, -5, 1))],
)
def test_exact_values_are_roots_of_small_polynomials(
    family: str, polynomial: tuple[int, ...]
) -> None:
    network = read_network(family)
    exact = exact_connectivity(network, connectivity_bracket(network))
    assert exact is not None
    assert exact.polynomial == polynomial


def test_a_disconnected_network_has_the_value_zero() -> None:
    network = read_network("random_geometric:12,0.2,1")
    gap = connectivity_bracket(network)
    assert gap.lower == gap.upper == 0
    assert rayleigh(network, gap.vector) == 0
    assert sum(gap.vector) == 0
    assert any(gap.vector)
    exact = exact_connectivity(network, gap)
    assert exact is not None
    assert exact.to_data() == {"kind": "rational", "value": "0"}
    assert connectivity_value(network) == 0
    data = {"graph": network.to_data()}
    witness = [{"kind": "vector", "x": list(gap.vector)}]
    certificate(
        "bearing_dac", "algebraic_connectivity", data, witness, "PROVED 0", lower="0", upper="0"
    )


def test_unlike_weights_cost_no_digits() -> None:
    weights = (Fraction(1, 10**9), Fraction(10**6), Fraction(3))
    network = Network(list("abcd"), [[0, 1], [1, 2], [2, 3]], weights)  # type: ignore[arg-type]
    gap = connectivity_bracket(network)
    assert gap.upper - gap.lower <= gap.upper * Fraction(1, 10**15)
    rows = laplacian_rows(network)
    assert all(sum(row) == 0 for row in rows)


def test_large_networks_are_computed_and_not_proved() -> None:
    network = read_network("path:1500")
    with pytest.raises(NoBracketError, match="200 nodes"):
        connectivity_bracket(network)
    assert connectivity_value(network) == pytest.approx(4 * math.sin(math.pi / 3000) ** 2, rel=1e-9)
