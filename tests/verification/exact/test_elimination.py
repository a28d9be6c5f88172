"""Rounded elimination: both roads take the same steps, and no rounding proves too much."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.kernels import kernel
from sensortrack.networks import Network, read_network
from tests.strategies import networks, rationals
from verification.exact.laplacians import elimination
from verification.exact.laplacians.elimination import (
    EliminationError,
    Matrix,
    negatives,
    negatives_in_python,
    pivot,
)
from verification.exact.laplacians.sparse_pattern import analyse

compiled = pytest.mark.skipif(not kernel("eliminate").library, reason="no C compiler")


def spectrum(network: Network) -> np.ndarray:
    return np.linalg.eigvalsh(network.laplacian().toarray())


@given(
    networks(1, 9, weighted=True),
    rationals(-1, 12),
    st.integers(0, 30),
    st.randoms(use_true_random=False),
)
@settings(max_examples=200)
def test_no_order_and_no_number_of_bits_proves_too_much(network, s, bits, random) -> None:
    order = list(range(network.n))
    random.shuffle(order)
    count = negatives_in_python(order, Matrix(network, s, bits))
    eigenvalues = spectrum(network)
    if count <= 1 and network.n > 1:
        assert float(s) <= eigenvalues[1] + 1e-9
    if count == 0:
        assert float(s) <= eigenvalues[0] + 1e-9


@given(networks(1, 9, weighted=True), rationals(-1, 12), st.randoms(use_true_random=False))
@settings(max_examples=100)
def test_with_enough_bits_the_count_is_that_of_eigenvalues(network, s, random) -> None:
    order = list(range(network.n))
    random.shuffle(order)
    eigenvalues = spectrum(network)
    if np.abs(eigenvalues - float(s)).min() > 1e-6:
        count = negatives_in_python(order, Matrix(network, s, 80))
        assert count == min(2, int((eigenvalues < float(s)).sum()))


@given(st.integers(-(10**9), 10**9), st.integers(0, 10**5))
def test_a_pivot_leaves_room_for_the_rounding_below_it(t: int, many: int) -> None:
    c = pivot(t, many)
    assert c != 0
    assert 2 * t >= 2 * c * abs(c) + many * abs(c)
    if t > 10**4 * (1 + many) ** 2:
        assert c * c >= 0.9 * t


@compiled
@pytest.mark.parametrize("family", ["random_geometric:300,0.12,1", "torus:13,14", "complete:50"])
@pytest.mark.parametrize("bits", [4, 20, 45])
def test_c_takes_the_same_steps(family: str, bits: int) -> None:
    network = read_network(family)
    weights = tuple(Fraction(1 + k % 5, 1 + k % 3) for k in range(network.m))
    network = Network(network.names, network.edges, weights)
    symbolic = analyse(network.n, network.edges)
    eigenvalues = spectrum(network)
    for s in (-0.5, 0.3 * eigenvalues[1], 0.999 * eigenvalues[1], 1.001 * eigenvalues[1]):
        matrix = Matrix(network, Fraction(float(s)), bits)
        assert negatives(symbolic, matrix) == negatives_in_python(symbolic.order.tolist(), matrix)


@compiled
@given(networks(2, 9, weighted=True), rationals(-1, 12), st.integers(0, 40))
@settings(max_examples=100)
def test_c_takes_the_same_steps_on_any_small_network(network, s, bits) -> None:
    symbolic = analyse(network.n, network.edges)
    matrix = Matrix(network, s, bits)
    assert negatives(symbolic, matrix) == negatives_in_python(symbolic.order.tolist(), matrix)


def test_numbers_too_large_for_c_are_eliminated_in_python_or_not_at_all(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    network = read_network("cycle:40")
    symbolic = analyse(network.n, network.edges)
    low, high = (Matrix(network, Fraction(s, 10**4), 90) for s in (240, 250))
    assert (negatives(symbolic, low), negatives(symbolic, high)) == (1, 2)
    monkeypatch.setattr(elimination, "SLOW", 10)
    if len(symbolic.start) > 1:
        with pytest.raises(EliminationError, match="126 bits"):
            negatives(symbolic, low)
    with pytest.raises(EliminationError, match="operations"):
        negatives_in_python(symbolic.order.tolist(), low, 10)


@compiled
def test_c_notices_when_quotients_outgrow_its_numbers() -> None:
    """Hardly any pivot at first: the weights that follow are 2^80 times as large."""
    weights = (Fraction(1, 2**40), Fraction(2**40), Fraction(2**40))
    network = Network(list("abc"), np.array([[0, 1], [0, 2], [1, 2]]), weights)
    symbolic = analyse(3, network.edges)
    assert symbolic.order.tolist() == [0, 1, 2]
    matrix = Matrix(network, Fraction(2**40), 40)
    found = elimination._negatives_in_c(kernel("eliminate").library, symbolic, matrix)
    assert found in (-2, negatives_in_python([0, 1, 2], matrix))
    assert negatives(symbolic, matrix) == negatives_in_python([0, 1, 2], matrix)
