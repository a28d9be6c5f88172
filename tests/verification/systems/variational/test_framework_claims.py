"""Claims about signs, weights, neighbours and noise, on a second road: numbers and networkx."""

from fractions import Fraction

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verification.adversary.placements import placement, within_range
from verification.certificates import check
from verification.certificates.make import CertificateError, certificate, statements
from verification.systems.variational.claims import DECISIONS
from verification.systems.variational.claims.witnesses import derivation


@settings(max_examples=20)
@given(st.integers(0, 10**6), st.integers(2, 5))
def test_a_placement_has_the_links_that_were_asked_for(seed, n):
    graph = nx.gnp_random_graph(n, 0.5, seed=seed)
    links = {tuple(sorted(edge)) for edge in graph.edges}
    places = placement(n, links, seed)
    if places:
        near = {
            (i, j)
            for i in range(n)
            for j in range(i + 1, n)
            if np.hypot(*(float(a - b) for a, b in zip(places[i], places[j], strict=True))) <= 1
        }
        assert near == links == within_range(places, Fraction(1))


@pytest.mark.parametrize("graph", [nx.path_graph(4), nx.cycle_graph(5), nx.complete_graph(4)])
def test_a_placement_is_found_where_one_is_easy(graph):
    links = {tuple(sorted(edge)) for edge in graph.edges}
    assert within_range(placement(len(graph), links), Fraction(1)) == links


def network_of(claim):
    """The network of a refuting placement, from the certificate's own numbers."""
    (document,) = DECISIONS[claim]().certificates.values()
    places = {k: v for k, v in document["inputs"].items() if k != "r"}
    graph = nx.Graph()
    graph.add_nodes_from(places)
    for a, x in places.items():
        for b, y in places.items():
            apart = sum((Fraction(p[0]) - Fraction(q[0])) ** 2 for p, q in zip(x, y, strict=True))
            if a < b and apart <= Fraction(document["inputs"]["r"]) ** 2:
                graph.add_edge(a, b)
    return graph


def test_the_refuting_networks_are_what_they_are_said_to_be():
    path = network_of("variational.section_2_neighbours")
    assert nx.is_connected(path)
    assert min(dict(path.degree).values()) == 1
    triangles = network_of("variational.section_2_two_edge_connected")
    assert nx.is_connected(triangles)
    assert min(dict(triangles.degree).values()) == 2
    assert list(nx.bridges(triangles)) == [("p2", "p3")]


def test_a_moved_sensor_no_longer_refutes():
    (document,) = DECISIONS["variational.section_2_neighbours"]().certificates.values()
    together = document["inputs"] | {"p0": document["inputs"]["p2"]}
    with pytest.raises(check.Reject):
        check.check_document(document | {"inputs": together}, statements())


def test_a_growing_solution_of_the_unsymmetric_recursion_is_seen_in_numbers():
    decision = DECISIONS["variational.discrete_stability_unsymmetric"]()
    inputs = decision.certificates["variational.discrete_stability_unsymmetric"]["inputs"]
    m, k, c = (np.array([[float(Fraction(x)) for x in r] for r in inputs[n]]) for n in "MKC")
    h = float(Fraction(inputs["h"]))
    assert np.linalg.eigvalsh(4 * m + h * (c + c.T) - h * h * k)[0] > 0
    assert np.linalg.eigvalsh(c + c.T)[0] > 0
    damped = np.linalg.inv(m + h * c)
    one = np.eye(2)
    step = np.block([[one, h * one], [-h * damped @ k, damped @ (m - h * h * k)]])
    assert np.abs(np.linalg.eigvals(step)).max() > 1


@settings(max_examples=30)
@given(st.integers(0, 10**6))
def test_the_repaired_energy_never_grows_in_numbers(seed):
    rng = np.random.default_rng(seed)
    half = [rng.normal(size=(2, 2)) for _ in range(2)]
    m, k = (a @ a.T + np.eye(2) for a in half)
    h, turn = 0.3, rng.normal() * np.array([[0, 1], [-1, 0]])
    c = (h * k + np.eye(2)) / 2 + turn
    x, u = rng.normal(size=2), rng.normal(size=2)
    levels = []
    for _ in range(30):
        x = x + h * u
        levels.append((u @ m @ u + x @ k @ x) / 2)
        u = np.linalg.solve(m + h * c, m @ u - h * k @ x)
    assert (np.diff(levels) <= 1e-12).all()


@pytest.mark.parametrize("h, grows", [(1.9, False), (2.1, True)])
def test_the_energy_of_the_newer_position_falls_up_to_twice_c_over_k(h, grows):
    """M = K = C = 1: the worst one-step ratio of that energy, over a circle of states."""
    angle = np.linspace(0, np.pi, 2001)
    y, u = np.cos(angle), np.sin(angle)
    v = (u - h * y) / (1 + h)
    z = y + h * v
    assert bool(((v * v + z * z) / (u * u + y * y)).max() > 1 + 1e-9) == grows


def test_velocity_noise_is_added_in_a_simulation():
    """Seeded: the sample variance is above that of the noise by more than four deviations."""
    rng, h, steps = np.random.default_rng(1), 0.5, 200_000
    nu = rng.normal(size=steps)
    e = w = 0.0
    found = np.empty(steps)
    for k in range(steps):
        found[k] = w - nu[k]
        e = e + h * (w - nu[k])
        w = (w - h * e) / (1 + h)
    assert found[100:].var() > 1 + 4 * np.sqrt(2 / steps)


@pytest.mark.parametrize(
    "name,witness",
    [
        ("eq_6_errors", [derivation((), ("2", "0", "b")), derivation((), ("1", "1", "b"))]),
        ("eq_8_kinematics", [derivation()]),
        ("section_3_robust_reading_a", [derivation((("h", "1", "C"),))] * 4),
        ("discrete_stability_unsymmetric_repair", [derivation(), derivation()]),
    ],
)
def test_a_wrong_derivation_proves_nothing(name, witness):
    with pytest.raises(CertificateError):
        certificate("variational", name, {}, witness)


def test_symmetry_matters_and_the_form_alone_is_not_enough():
    """With the symmetric part of the refuting damping the same gains are stable."""
    decision = DECISIONS["variational.discrete_stability_unsymmetric"]()
    inputs = decision.certificates["variational.discrete_stability_unsymmetric"]["inputs"]
    c = [[Fraction(x) for x in row] for row in inputs["C"]]
    plain = [[(c[i][j] + c[j][i]) / 2 for j in range(2)] for i in range(2)]
    gains = {"M": inputs["M"], "K": inputs["K"], "C": plain, "h": inputs["h"]}
    assert certificate("variational", "step", gains, [])["verdict"] == "PROVED"
