"""Bounds on the second eigenvalue: what the checker believes is so."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, networks, rationals
from verification.certificates import check
from verification.exact.laplacians.spectral_gap import connectivity_bracket

from .documents import REFUSALS, accepts, checked, vector
from .samples import APART, LADDER, PAIR, PATH, RING

KINDS = {"graph": "graph", "s": "number"}
ABOVE, BELOW = ["gap_above(graph, s)"], ["gap_below(graph, s)"]


def ldl(*order, bits=30):
    return {"kind": "sparse_ldl", "order": list(order), "bits": bits}


def product(*parts):
    return {"kind": "product", "parts": list(parts)}


def data(graph, s):
    return {"graph": graph, "s": str(s)}


def second(network: Network) -> float:
    return float(np.linalg.eigvalsh(network.laplacian().toarray())[1])


@given(networks(2, 8, weighted=True), st.integers(0, 60), rationals(-1, 12), st.data())
@settings(max_examples=150)
def test_nothing_above_the_second_eigenvalue_is_believed(network, bits, s, more) -> None:
    order = more.draw(st.permutations(range(network.n)))
    if accepts(ABOVE, [ldl(*order, bits=bits)], data(network.to_data(), s), KINDS):
        assert float(s) <= second(network) + 1e-9


@given(connected_networks(2, 8, weighted=True), st.data())
@settings(max_examples=60)
def test_what_is_a_little_below_is_believed_in_every_order(network, more) -> None:
    order = more.draw(st.permutations(range(network.n)))
    low = Fraction(second(network)) * (1 - Fraction(1, 10**6))
    high = Fraction(second(network)) * (1 + Fraction(1, 10**6))
    assert accepts(ABOVE, [ldl(*order, bits=80)], data(network.to_data(), low), KINDS)
    assert not accepts(ABOVE, [ldl(*order, bits=80)], data(network.to_data(), high), KINDS)


@given(connected_networks(2, 8, weighted=True))
@settings(max_examples=40)
def test_both_ends_of_a_bracket_are_believed_and_not_each_other(network) -> None:
    gap = connectivity_bracket(network)
    graph = network.to_data()
    assert accepts(ABOVE, [gap.above], data(graph, gap.lower), KINDS)
    assert accepts(BELOW, [gap.below], data(graph, gap.upper), KINDS)
    assert not accepts(ABOVE, [gap.above], data(graph, gap.upper * (1 + Fraction(1, 99))), KINDS)
    assert not accepts(BELOW, [gap.below], data(graph, gap.lower * Fraction(98, 99)), KINDS)


@pytest.mark.parametrize(
    "order",
    [
        (0, 1, 2), (0, 1, 2, 3, 4), (0, 1, 2, 2), (1, 2, 3, 4), (-1, 0, 1, 2), (0, 0, 0, 0),
        (0, 1, 2, None), (0, 1, 2, True), (0, 1, 2, "3/2"), (0, 1, 2, 3.0), (0, 1, 2, [3]),
    ],
)  # fmt: skip
def test_what_is_no_order_of_the_nodes_is_refused(order) -> None:
    assert not accepts(ABOVE, [ldl(*order)], data(RING, 1), KINDS)
    assert accepts(ABOVE, [ldl(0, 1, 2, 3)], data(RING, 1), KINDS)


@pytest.mark.parametrize("bits", [-1, "1/2", None, True, 4001, 10**9, "", [], 2.0])
def test_what_is_no_number_of_bits_is_refused(bits) -> None:
    assert not accepts(ABOVE, [ldl(0, 1, 2, 3, bits=bits)], data(RING, 1), KINDS)


def test_two_negative_pivots_are_refused_at_the_second() -> None:
    """Right above the second eigenvalue, and far above it, however fine the rounding is."""
    for s in ("2000001/1000000", 3, 4, 100, 10**30):
        for bits in (0, 10, 100, 1000):
            with pytest.raises(check.Reject, match="two pivots"):
                checked(ABOVE, [ldl(0, 1, 2, 3, bits=bits)], data(RING, s), KINDS)


def test_too_few_bits_prove_less_and_never_more() -> None:
    provable = [
        max(
            (k for k in range(-40, 40) if accepts(ABOVE, [ldl(0, 1, 2, 3, bits=b)],
                                                   data(RING, Fraction(k, 10)), KINDS)),
            default=None,
        )
        for b in (1, 4, 8, 20)
    ]  # fmt: skip
    assert provable[-1] == 19
    assert all(k is None or k <= 19 for k in provable)
    assert provable[0] is None or provable[0] < 19


def test_a_network_in_pieces_has_no_positive_bound() -> None:
    assert accepts(ABOVE, [ldl(0, 1, 2)], data(APART, "-1/1000"), KINDS)
    assert not accepts(ABOVE, [ldl(0, 1, 2, bits=200)], data(APART, "1/1000000000"), KINDS)
    assert accepts(BELOW, [vector(1, 1, -2)], data(APART, 0), KINDS)


@pytest.mark.parametrize("x", [(0, 0, 0), (1, 1, 1), (1, 0, 0), (1, 1, -1), (1, -1), (1, 0, 0, -1)])
def test_what_is_no_vector_of_sum_zero_is_refused(x) -> None:
    assert not accepts(BELOW, [vector(*x)], data(APART, 5), KINDS)


@pytest.mark.parametrize("entry", ["1/2", 0.5, None, True, "x"])
def test_vectors_are_of_integers(entry) -> None:
    assert not accepts(BELOW, [vector(entry, 0, -1)], data(APART, 5), KINDS)


def test_a_product_has_the_smallest_second_eigenvalue_of_its_factors() -> None:
    """PAIR has 2, PATH with weights 1 and 1/2 has (3 - sqrt 3)/2 = 0.63397."""
    parts = ldl(0, 1), ldl(0, 1, 2)
    assert accepts(ABOVE, [product(*parts)], data(LADDER, "633/1000"), KINDS)
    assert not accepts(ABOVE, [product(*parts)], data(LADDER, "634/1000"), KINDS)
    for wrong in ((), parts[:1], parts[::-1], (*parts, ldl(0, 1)), (product(*parts), parts[1])):
        assert not accepts(ABOVE, [product(*wrong)], data(LADDER, "1/10"), KINDS)
    assert not accepts(ABOVE, [ldl(0, 1, 2, 3, 4, 5)], data(LADDER, "1/10"), KINDS)
    assert not accepts(ABOVE, [product(ldl(0, 1, 2))], data(PATH, "1/10"), KINDS)


def test_an_upper_bound_of_a_product_is_that_of_one_factor() -> None:
    slow = {"kind": "vector", "factor": 1, "x": [-2, -1, 3]}
    assert accepts(BELOW, [slow], data(LADDER, "9/14"), KINDS)
    assert not accepts(BELOW, [slow], data(LADDER, "8/14"), KINDS)
    for factor in (-1, 2, 0, "1/2", None):
        assert not accepts(BELOW, [slow | {"factor": factor}], data(LADDER, "9/14"), KINDS)
    assert not accepts(BELOW, [vector(-2, -1, 3)], data(LADDER, "9/14"), KINDS)
    assert not accepts(BELOW, [slow], data(PATH, "9/14"), KINDS)


def test_a_single_node_has_no_second_eigenvalue_and_no_upper_bound() -> None:
    one = {"nodes": ["a"], "edges": []}
    ladder = {"product": [one, PAIR]}
    assert accepts(ABOVE, [ldl(0)], data(one, 10**9), KINDS)
    assert not accepts(BELOW, [vector(0)], data(one, 10**9), KINDS)
    assert accepts(ABOVE, [product(ldl(0), ldl(0, 1))], data(ladder, "19/10"), KINDS)
    assert not accepts(ABOVE, [product(ldl(0), ldl(0, 1))], data(ladder, "21/10"), KINDS)


def test_fill_beyond_all_measure_is_refused() -> None:
    """A star from its hub: every pair of leaves becomes a link."""
    n = 20000
    star = {"nodes": [*map(str, range(n))], "edges": [[0, i] for i in range(1, n)]}
    with pytest.raises(check.Reject, match="too much"):
        checked(ABOVE, [ldl(*range(n))], data(star, "1/2"), KINDS)
    assert accepts(ABOVE, [ldl(*range(1, n), 0)], data(star, "999/1000"), KINDS)


def test_quotients_that_outgrow_their_digits_are_refused() -> None:
    """The first pivot is 2^-300: columns are divided by its root, and more bits hold that."""
    path = {"nodes": ["a", "b", "c"], "edges": [[0, 1], [1, 2]]}
    s = 1 - Fraction(1, 2**300)
    with pytest.raises(check.Reject, match="digits run over"):
        checked(ABOVE, [ldl(0, 1, 2, bits=200)], data(path, s), KINDS)
    assert accepts(ABOVE, [ldl(0, 1, 2, bits=400)], data(path, s), KINDS)
    assert not accepts(ABOVE, [ldl(0, 1, 2, bits=400)], data(path, 2 - s), KINDS)


@given(st.data())
@settings(max_examples=60)
def test_any_forged_item_is_refused_or_proves_what_is_true(more) -> None:
    network = read_network("petersen")
    kind = st.sampled_from(["sparse_ldl", "vector", "product", "tree", "congruence"])
    loose = st.recursive(
        st.none() | st.integers(-3, 12) | st.sampled_from(["1", "-1/2", "x"]),
        lambda inner: st.lists(inner, max_size=4),
        max_leaves=12,
    )
    item = {"kind": more.draw(kind), "order": more.draw(st.permutations(range(10)) | loose)}
    item["bits"] = more.draw(st.integers(0, 20) | loose)
    s = more.draw(rationals(-1, 5))
    try:
        checked(ABOVE, [item], data(network.to_data(), s), KINDS)
    except REFUSALS:
        return
    assert s <= 2
