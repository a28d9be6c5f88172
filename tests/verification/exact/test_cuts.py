"""Sharp constants by cuts: every road against all cuts, every witness against two checkers."""

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sensortrack.data import load_network, real_networks
from sensortrack.networks import Network, read_network
from tests.strategies import connected_networks, networks, rationals
from tests.verification.exact.literal_cuts import Refused, check_clear, check_reaches
from verification.certificates.make import CertificateError, certificate
from verification.exact.cuts.cut_components import flat, spread
from verification.exact.cuts.cut_reference import CutData, enumerate_all
from verification.exact.cuts.extreme import CutBracket, decide, margin, slowest, threshold

ONE = Fraction(1)
ZERO = Fraction(0)


def bounds(n: int) -> st.SearchStrategy[list[Fraction]]:
    each = rationals(0, 3, 4)
    return st.one_of(each.map(lambda g: [g] * n), st.lists(each, min_size=n, max_size=n))


@st.composite
def weighted(draw: st.DrawFn, largest: int = 7) -> tuple[Network, list[Fraction]]:
    network = draw(connected_networks(2, largest, weighted=draw(st.booleans())))
    return network, draw(bounds(network.n))


def cuts_by_component(network: Network, gamma: Sequence[Fraction]) -> list[list[CutData]]:
    return [
        enumerate_all(network.subnetwork(nodes), [gamma[i] for i in nodes])
        for nodes in network.components()
        if len(nodes) > 1
    ]


def certified(name: str, found: CutBracket, network: Network, **rest: Any) -> dict[str, Any]:
    ends = {end: rest.pop(end) for end in ("lower", "upper") if end in rest}
    data = (network if found.product else flat(network)).to_data()
    assert found.clear is not None
    witness = [found.clear, found.reaches]
    return certificate("bearing_dac", name, {"graph": data, **rest}, witness, **ends)


@given(weighted())
@settings(max_examples=60)
def test_the_threshold_is_the_largest_ratio_of_all_cuts(
    drawn: tuple[Network, list[Fraction]],
) -> None:
    network, gamma = drawn
    found = threshold(network, gamma)
    assert found.closed
    assert found.value == found.lower == max(c.load / c.k for c in enumerate_all(network, gamma))
    certified("gain_threshold", found, network, gamma=gamma, lower=found.lower, upper=found.upper)
    assert found.clear
    assert found.upper is not None
    assert found.lower is not None
    check_clear(network, gamma, found.upper, ONE, ZERO, found.clear)
    check_reaches(network, gamma, found.lower, ONE, ZERO, found.reaches)


@given(networks(2, 8, weighted=True).filter(lambda network: network.m > 0))
@settings(max_examples=60)
def test_the_rate_is_the_smallest_of_all_cuts_of_all_components(network: Network) -> None:
    found = margin(network)
    parts = cuts_by_component(network, [ZERO] * network.n)
    assert found.lower == found.upper == min(c.k**2 / c.p for part in parts for c in part)
    certified("margin_rate_squared", found, network, lower=found.lower, upper=found.upper)
    assert found.clear
    assert found.lower is not None
    check_clear(network, [ZERO] * network.n, ONE, ONE, found.lower, found.clear)
    check_reaches(network, [ZERO] * network.n, ONE, ONE, found.lower, found.reaches)


@given(
    networks(2, 7, weighted=True).filter(lambda network: network.m > 0),
    st.data(),
)
@settings(max_examples=60)
def test_the_settling_time_is_the_largest_of_all_cuts(
    network: Network, data: st.DataObject
) -> None:
    gamma = data.draw(bounds(network.n))
    x0 = data.draw(st.lists(rationals(), min_size=network.n, max_size=network.n))
    beta = data.draw(rationals(Fraction(1, 10), 20))
    found = slowest(network, gamma, beta, x0)
    parts = cuts_by_component(network, gamma)
    if any(c.load >= beta * c.k for part in parts for c in part):
        assert found.infinite
        check_reaches(network, gamma, beta, ONE, ZERO, found.reaches)
        return
    nodes = [part for part in network.components() if len(part) > 1]
    assert (
        found.lower
        == found.upper
        == max(
            spread([x0[i] for i in here]) * c.p / (beta * c.k - c.load) ** 2
            for here, part in zip(nodes, parts, strict=True)
            for c in part
        )
    )
    root = Fraction(math.isqrt(int(found.lower * 10**12)), 10**6)
    low, high = root, root + Fraction(1, 10**6)
    data_of = {"gamma": gamma, "beta": beta, "x0": x0, "lower": low, "upper": high}
    certified("settling_time", found, network, **data_of)
    assert found.clear
    check_clear(network, gamma, beta, high**2, x0, found.clear)
    check_reaches(network, gamma, beta, low**2, x0, found.reaches)


@given(weighted(6))
@settings(max_examples=40)
def test_a_witness_shows_no_smaller_bound_and_a_cut_no_larger(
    drawn: tuple[Network, list[Fraction]],
) -> None:
    network, gamma = drawn
    found = threshold(network, gamma)
    assert found.upper is not None
    assert found.lower is not None
    assert found.clear
    data = {"graph": network.to_data(), "gamma": gamma}
    ask = ("bearing_dac", "gain_threshold", data, [found.clear, found.reaches])
    little = Fraction(1, 10**9)
    with pytest.raises(CertificateError):
        certificate(*ask, lower=found.lower + little, upper=found.upper)
    with pytest.raises(Refused):
        check_reaches(network, gamma, found.lower + little, ONE, ZERO, found.reaches)
    if found.upper > little:
        with pytest.raises(CertificateError):
            certificate(*ask, lower=ZERO, upper=found.upper - little)
        with pytest.raises(Refused):
            check_clear(network, gamma, found.upper - little, ONE, ZERO, found.clear)


@given(weighted(6), st.sampled_from([-1, 0, 1]))
@settings(max_examples=40)
def test_gains_beside_the_threshold_are_told_apart(
    drawn: tuple[Network, list[Fraction]], side: int
) -> None:
    network, gamma = drawn
    found = threshold(network, gamma)
    assert found.value is not None
    beta = found.value + side * Fraction(1, 10**12)
    if beta <= 0:
        return
    holds, witness = decide(network, gamma, beta, found)
    assert holds is (side >= 0)
    case = "PROVED" if holds else "REFUTED"
    data = {"graph": network.to_data(), "gamma": gamma, "beta": beta}
    assert witness
    certificate("bearing_dac", "gain", data, [witness], case=case)


def half(n: int) -> Fraction:
    return Fraction(n // 2 * (n - n // 2), n)


FAMILIES = {
    **{f"path:{n}": (2 * half(n), 1 / half(n)) for n in (2, 5, 12, 101)},
    **{f"cycle:{n}": (half(n), 4 / half(n)) for n in (3, 8, 51)},
    **{f"complete:{n}": (Fraction(2, n), Fraction(n * (n - 1))) for n in (2, 7, 40)},
    **{f"star:{n}": (Fraction(2 * (n - 1), n), Fraction(n, n - 1)) for n in (3, 9)},
    "bipartite:3,4": (Fraction(4, 7), None),
    "bipartite:5,5": (Fraction(2, 5), None),
    "petersen": (ONE, None),
    "hypercube:4": (ONE, Fraction(16)),
    "hypercube:5": (ONE, Fraction(25 * 32, 31)),
    "grid:3,7": (2 * half(7), None),
    "torus:4,5": (half(5), None),
    "grid:2,2": (ONE, Fraction(4)),
}


@pytest.mark.parametrize("family", FAMILIES)
def test_families_have_their_closed_forms(family: str) -> None:
    network = read_network(family)
    ratio, square = FAMILIES[family]
    gamma = [ONE] * network.n
    found = threshold(network, gamma)
    assert found.lower == found.upper == ratio
    certified("gain_threshold", found, network, gamma=1, lower=ratio, upper=ratio)
    rate = margin(network)
    assert rate.closed
    assert square is None or rate.lower == square
    certified("margin_rate_squared", rate, network, lower=rate.lower, upper=rate.upper)


@pytest.mark.parametrize("a, b", [(2, 3), (3, 4), (4, 4), (5, 5), (2, 6)])
def test_complete_bipartite_networks(a: int, b: int) -> None:
    n = a + b
    ratios = [
        Fraction(2 * (i + j) * (n - i - j), n * (i * b + a * j - 2 * i * j))
        for i in range(a + 1)
        for j in range(b + 1)
        if 0 < i + j < n
    ]
    assert threshold(read_network(f"bipartite:{a},{b}"), [ONE] * n).value == max(ratios)


REAL = {
    "topozoo_abilene": "30/11",
    "sndlib_abilene": "3",
    "sndlib_polska": "16/9",
    "sndlib_nobel_us": "7/4",
    "sndlib_newyork": "15/16",
    "sndlib_nobel_germany": "44/17",
    "sndlib_janos_us": "42/13",
    "sndlib_germany50": "272/75",
}


@pytest.mark.parametrize("name", real_networks())
def test_real_networks_are_decided_exactly(name: str) -> None:
    network = load_network(name)
    gamma = [ONE] * network.n
    found = threshold(network, gamma)
    assert found.closed
    assert found.value == Fraction(REAL[name])
    certified("gain_threshold", found, network, gamma=1, lower=found.lower, upper=found.upper)
    rate = margin(network)
    certified("margin_rate_squared", rate, network, lower=rate.lower, upper=rate.lower)


@pytest.mark.parametrize("family, ratio", [("hypercube:20", 1), ("grid:1000,1000", 500)])
def test_a_million_nodes_are_decided_by_their_factors(family: str, ratio: int) -> None:
    network = read_network(family)
    found = threshold(network, [ONE] * network.n)
    assert found.product
    assert found.lower == found.upper == ratio
    certified("gain_threshold", found, network, gamma=1, lower=found.lower, upper=found.upper)
    assert found.clear
    if network.n == 2**20:
        check_clear(network, [ONE], ONE, ONE, ZERO, found.clear)
        check_reaches(network, [ONE], ONE, ONE, ZERO, found.reaches)


def test_a_product_with_unlike_bounds_is_decided_by_its_own_cuts() -> None:
    network = read_network("grid:2,3")
    gamma = [Fraction(i, 3) for i in range(6)]
    found = threshold(network, gamma)
    assert not found.product
    assert found.value == max(c.load / c.k for c in enumerate_all(flat(network), gamma))


def test_agreement_from_the_start_takes_no_time() -> None:
    network = read_network("cycle:5")
    found = slowest(network, [ONE] * 5, Fraction(3), [Fraction(7)] * 5)
    assert found.lower == found.upper == 0


def test_a_component_in_agreement_still_needs_the_gain() -> None:
    network = Network(["a", "b", "c", "d"], [[0, 1], [2, 3]])  # type: ignore[arg-type]
    gamma = [ONE, ONE, Fraction(5), Fraction(5)]
    x0 = [ONE, ZERO, ZERO, ZERO]
    assert slowest(network, gamma, Fraction(5), x0).infinite
    found = slowest(network, gamma, Fraction(6), x0)
    assert found.value == Fraction(1, 2) * Fraction(1, 2) / 25
