"""Algebraic connectivity: closed forms, numpy, a second proof of each bound."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, rationals
from verification.certificates.make import CertificateError, certificate
from verification.exact.laplacians import slow_modes, spectral_gap
from verification.exact.laplacians.gap_vectors import laplacian_rows, rayleigh
from verification.exact.laplacians.spectral_gap import (
    NoBracketError,
    connectivity_bracket,
    connectivity_value,
    exact_connectivity,
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
    "torus:90,100": 4 * math.sin(math.pi / 100) ** 2,
}
LARGE = {
    "path:3000": 4 * math.sin(math.pi / 6000) ** 2,
    "cycle:1500": 4 * math.sin(math.pi / 1500) ** 2,
    "star:900": 1.0,
    "complete:250": 250.0,
    "bipartite:30,400": 30.0,
}
"""Too large for a dense matrix."""


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
    ask = ("bearing_dac", "algebraic_connectivity", data, [gap.above, gap.below])
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
    ask = ("bearing_dac", "algebraic_connectivity", data, [gap.below], "PROVED 0")
    certificate(*ask, lower="0", upper="0")


def test_unlike_weights_cost_no_digits() -> None:
    weights = (Fraction(1, 10**9), Fraction(10**6), Fraction(3))
    network = Network(list("abcd"), [[0, 1], [1, 2], [2, 3]], weights)  # type: ignore[arg-type]
    gap = connectivity_bracket(network)
    assert gap.upper - gap.lower <= gap.upper * Fraction(1, 10**15)
    rows = laplacian_rows(network)
    assert all(sum(row) == 0 for row in rows)
    assert [[float(x) for x in row] for row in rows] == network.laplacian().toarray().tolist()


@pytest.mark.parametrize("family", LARGE)
def test_large_networks_are_bracketed_narrowly(family: str) -> None:
    network = read_network(family)
    gap = connectivity_bracket(network)
    assert gap.lower < gap.upper <= gap.lower * (1 + Fraction(1, 10**9))
    assert float(gap.lower) * (1 - 1e-14) <= LARGE[family] <= float(gap.upper) * (1 + 1e-14)
    assert sum(gap.vector) == 0
    assert rayleigh(network, gap.vector) <= gap.upper
    assert connectivity_value(network) == pytest.approx(LARGE[family], rel=1e-9)


@pytest.mark.parametrize("road", ["C", "Python"])
@pytest.mark.parametrize("weighted", [False, True])
def test_general_networks_are_bracketed_around_what_numpy_finds(
    road: str, weighted: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SENSORTRACK_NO_COMPILER", "0" if road == "C" else "1")
    network = read_network("random_geometric:350,0.13,4")
    assert network.is_connected()
    if weighted:
        weights = tuple(Fraction(2 + k % 7, 3 + k % 5) for k in range(network.m))
        network = Network(network.names, network.edges, weights)
    gap = connectivity_bracket(network)
    value = float(np.linalg.eigvalsh(network.laplacian().toarray())[1])
    assert float(gap.lower) <= value * (1 + 1e-10)
    assert float(gap.upper) >= value * (1 - 1e-10)
    assert gap.upper <= gap.lower * (1 + Fraction(1, 10**9))
    ask = ("bearing_dac", "algebraic_connectivity", {"graph": network.to_data()})
    certificate(*ask, [gap.above, gap.below], lower=gap.lower, upper=gap.upper)
    with pytest.raises(CertificateError):
        certificate(*ask, [gap.above, gap.below], lower=gap.upper * 2, upper=gap.upper * 2)


def test_long_eliminations_leave_closed_forms() -> None:
    complete, joined = read_network("complete:1500"), read_network("bipartite:800,1000")
    assert connectivity_bracket(complete)[:2] == (1500, 1500)
    assert connectivity_bracket(joined)[:2] == (800, 800)
    for network in (complete, joined):
        gap = connectivity_bracket(network)
        assert gap.above == {}
        assert rayleigh(network, gap.vector) == gap.upper
        exact = exact_connectivity(network, gap)
        assert exact is not None
        assert exact.nearest == gap.upper


def test_what_is_nearly_complete_has_no_closed_form() -> None:
    """One link less, or one weight, and the elimination decides."""
    whole = read_network("bipartite:100,150")
    fewer = Network(whole.names, whole.edges[1:])
    heavier = Network(whole.names, whole.edges, (Fraction(2), *(Fraction(1),) * (whole.m - 1)))
    for network in (fewer, heavier):
        gap = connectivity_bracket(network)
        value = float(np.linalg.eigvalsh(network.laplacian().toarray())[1])
        assert float(gap.lower) <= value * (1 + 1e-12)
        assert float(gap.upper) >= value * (1 - 1e-12)
        assert gap.above
        assert exact_connectivity(network, gap) is None


def test_too_long_an_elimination_is_said_to_be_so(monkeypatch: pytest.MonkeyPatch) -> None:
    network = read_network("random_geometric:300,0.15,4")
    monkeypatch.setattr(spectral_gap, "WORK", 10.0)
    with pytest.raises(NoBracketError, match="too long"):
        connectivity_bracket(network)
    monkeypatch.setattr(spectral_gap, "STORED", 10)
    with pytest.raises(NoBracketError, match="too large"):
        connectivity_bracket(network)
    value = float(np.linalg.eigvalsh(network.laplacian().toarray())[1])
    assert connectivity_value(network) == pytest.approx(value, rel=1e-9)
    monkeypatch.setattr(slow_modes, "RESTARTS", 1)
    assert connectivity_value(network) is None


@given(connected_networks(2, 7), st.data())
@settings(max_examples=25)
def test_weights_of_very_different_sizes_keep_a_bracket(
    network: Network, data: st.DataObject
) -> None:
    """Doubles lose lambda_2 in the rounding of the heaviest weight; integers do not."""
    sizes = st.integers(-90, 90).map(lambda k: Fraction(10) ** k)
    weight = st.builds(lambda share, size: share * size, rationals(Fraction(1, 9), 9, 9), sizes)
    weights = tuple(data.draw(weight) for _ in range(network.m))
    unlike = Network(network.names, network.edges, weights)
    gap = connectivity_bracket(unlike)
    assert 0 < gap.lower < gap.upper <= gap.lower * (1 + Fraction(1, 10**12))
    assert connectivity_value(unlike) == pytest.approx(float(gap.upper), rel=1e-12, abs=0)
    ask = ("bearing_dac", "algebraic_connectivity", {"graph": unlike.to_data()})
    certificate(*ask, [gap.above, gap.below], lower=gap.lower, upper=gap.upper)
