"""Explicit steps over many nodes: one result on every road, in every order, in every part."""

import numpy as np
import pytest

from sensortrack.consensus import SignConsensus
from sensortrack.kernels import kernel
from sensortrack.kernels.consensus import sign_step
from sensortrack.kernels.links import REORDERED, Links, links_of
from sensortrack.networks import DecimalNames, Network, read_network

compiles = pytest.mark.skipif(
    kernel("consensus", native=True).library is None, reason="no C compiler"
)
WITHOUT = "SENSORTRACK_NO_COMPILER"


def ring_with_chords(n: int) -> Network:
    """A ring with chords to drawn nodes: degrees differ, neighbours lie far apart."""
    rng = np.random.default_rng(n)
    around = np.stack([np.arange(n), (np.arange(n) + 1) % n], axis=1)
    pairs = np.sort(np.concatenate([around, rng.integers(0, n, size=(2 * n, 2))]), axis=1)
    pairs = np.unique(pairs[pairs[:, 0] < pairs[:, 1]], axis=0)
    return Network(DecimalNames(n), rng.permutation(pairs))


LARGE = ring_with_chords(REORDERED + 3)


def given(links: Links, width: int, seed: int = 0) -> tuple[np.ndarray, ...]:
    """x and w by place, r by node, gains; whole numbers, so that ties occur."""
    rng = np.random.default_rng(seed)
    x, w, r = rng.integers(-3, 4, size=(3, links.n, width)).astype(float)
    return x, w, r, rng.uniform(0.1, 1, size=width)


@compiles
@pytest.mark.parametrize("width", [1, 2, 4, 6, 8, 11])
@pytest.mark.parametrize("weighted", [False, True])
def test_c_and_numpy_give_the_same_bits(
    width: int, weighted: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    links = links_of(LARGE)
    weights = np.random.default_rng(1).uniform(0, 1, len(links.index)) if weighted else None
    arrays = given(links, width)
    in_c = sign_step(links, *arrays, weights)
    monkeypatch.setenv(WITHOUT, "1")
    for one, two in zip(in_c, sign_step(links, *arrays, weights), strict=True):
        assert np.array_equal(one, two)


@compiles
@pytest.mark.parametrize("width", [1, 6])
def test_all_processors_give_the_same_bits(width: int, monkeypatch: pytest.MonkeyPatch) -> None:
    links = links_of(LARGE)
    arrays = given(links, width)
    found = sign_step(links, *arrays)
    monkeypatch.setattr("sensortrack.kernels.build.NATIVE", ())
    kernel.__globals__["_kernel"].cache_clear()
    plain = sign_step(links, *arrays)
    kernel.__globals__["_kernel"].cache_clear()
    for one, two in zip(found, plain, strict=True):
        assert np.array_equal(one, two)


@pytest.mark.parametrize("road", ["", "1"])
@pytest.mark.parametrize("width", [1, 6])
def test_parts_make_the_whole(width: int, road: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(WITHOUT, road)
    links = links_of(LARGE)
    x, w, r, gain = given(links, width)
    whole = sign_step(links, x, w, r, gain)
    out = np.full_like(w, np.nan), np.full_like(x, np.nan)
    for part in [(0, 64), (4000, links.n), (64, 4000)]:
        sign_step(links, x, w, r, gain, out=out, part=part)
    assert all(np.array_equal(one, two) for one, two in zip(whole, out, strict=True))
    sign_step(links, x, w, r, gain, out=(w, out[1]))
    assert np.array_equal(w, whole[0])


@pytest.mark.parametrize("road", ["", "1"])
@pytest.mark.parametrize("width", [1, 3])
def test_a_component_that_is_no_number_stays_alone(
    width: int, road: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(WITHOUT, road)
    network = read_network("star:6")
    links = links_of(network)
    x, w, r, gain = given(links, width)
    x[2, 0] = r[2, 0] = np.nan
    w_out, x_out = sign_step(links, x, w, r, gain)
    rest = links_of(Network(network.names, network.edges[network.edges[:, 1] != 2]))
    assert np.isnan(x_out[2, 0])
    assert np.isfinite(np.delete(x_out.ravel(), 2 * width)).all()
    assert np.array_equal(w_out[:, 0], sign_step(rest, x, w, r, gain)[0][:, 0])


@pytest.mark.parametrize("method", ["explicit", "implicit"])
def test_a_renumbered_network_answers_by_node(method: str) -> None:
    """The large path is renumbered inside; a step moves nobody further than two nodes see."""
    n = REORDERED + 5
    order = np.random.default_rng(3).permutation(n)
    pairs = np.sort(np.stack([order[:-1], order[1:]], axis=1), axis=1)
    network = Network(DecimalNames(n), pairs)
    assert links_of(network).order is not None
    law = SignConsensus(network, 1.0, 0.25, method)
    r = np.random.default_rng(4).normal(size=(2, n, 2))
    state = law.step(law.init(r[0]), r[1])
    assert state.status.exact
    along = SignConsensus(read_network("path:9"), 1.0, 0.25, method)
    if method == "explicit":
        some = order[:9]
        inner = along.step(along.init(r[0][some]), r[1][some])
        assert np.array_equal(inner.x[:-1], state.x[some[:-1]])
    assert np.allclose(state.x - state.w, r[1], rtol=0, atol=1e-14)
    assert np.abs(state.w.sum(axis=0)).max() < 1e-10


def test_masks_are_by_the_networks_own_links() -> None:
    law = SignConsensus(LARGE, 0.5, 0.5, "explicit")
    r = np.random.default_rng(5).normal(size=(2, LARGE.n, 1))
    active = np.random.default_rng(6).random(LARGE.m) < 0.7
    less = Network(LARGE.names, LARGE.edges[active])
    state = law.init(r[0])
    masked = law.step(state, r[1], active=active)
    assert np.array_equal(masked.x, law.step(state, r[1], network=less).x)
    both = law.step(state, r[1], active=np.stack([active, active], axis=1))
    assert np.array_equal(masked.x, both.x)
    one = np.stack([np.ones(LARGE.m, dtype=bool), np.zeros(LARGE.m, dtype=bool)], axis=1)
    heard = law.step(state, r[1], active=one)
    first = np.zeros(LARGE.n)
    signs = 0.25 * np.sign(r[0][LARGE.edges[:, 0], 0] - r[0][LARGE.edges[:, 1], 0])
    np.subtract.at(first, LARGE.edges[:, 0], signs)
    assert np.array_equal(heard.w[:, 0], first)
