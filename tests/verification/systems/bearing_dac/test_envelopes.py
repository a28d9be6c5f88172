"""Bounds beside a run of bearing consensus: on the right side, and sharp where it can be told."""

import copy
from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest

from sensortrack.network_families import family_network
from sensortrack.simulation import simulate
from sensortrack.simulation.scenario import scenario_of
from tests.sensortrack.test_bearing_simulation import changed
from verification.exact.cuts.extreme import slowest, threshold
from verification.systems.bearing_dac.cut_profiles import ENUMERATED, profile_of
from verification.systems.bearing_dac.envelopes import envelopes

GRAPHS = ("path:5", "cycle:6", "complete:4", "star:5", "petersen", "grid:3,3")


def ran(*changes):
    return simulate(scenario_of("toy", changed(*changes))).to_data()


def held(data):
    found = envelopes(data)
    assert all(bound["holds"] and bound["smallest_slack"] >= 0 for bound in found)
    return {bound["quantity"]: bound for bound in found}


@pytest.mark.parametrize("graph", GRAPHS)
def test_the_profile_is_the_fewest_links_of_literal_cuts(graph):
    network = family_network(graph)
    wanted = []
    for size in range(1, network.n // 2 + 1):
        sides = (set(side) for side in combinations(range(network.n), size))
        wanted.append(min(sum((i in s) != (j in s) for i, j in network.edges) for s in sides))
    found = profile_of(range(network.n), network.edges)
    assert found.fewest.tolist() == wanted


@pytest.mark.parametrize("graph", GRAPHS)
def test_the_rate_is_that_of_the_exact_settling_time(graph):
    network = family_network(graph)
    x0 = [Fraction(i * i % 7) for i in range(network.n)]
    mean = sum(x0) / network.n
    size = float(sum((x - mean) ** 2 for x in x0)) ** 0.5
    for gamma, beta in ((Fraction(0), Fraction(3)), (Fraction(1, 2), Fraction(5))):
        square = slowest(network, [gamma] * network.n, beta, x0).value
        rate = profile_of(range(network.n), network.edges).rate(
            np.array([float(beta)]), np.array([float(gamma)])
        )
        assert size / rate[0] == pytest.approx(float(square) ** 0.5, rel=1e-6)


@pytest.mark.parametrize("graph", GRAPHS)
def test_the_threshold_is_the_exact_one(graph):
    network = family_network(graph)
    exact = threshold(network, [Fraction(1)] * network.n).value
    found = profile_of(range(network.n), network.edges).threshold
    assert found == pytest.approx(float(exact), rel=1e-12)


def test_a_large_network_is_bounded_from_its_connectivity():
    for graph in ("cycle:40", "random_geometric:40,0.35,1", "grid:5,8"):
        network = family_network(graph)
        assert network.n > ENUMERATED
        found = profile_of(range(network.n), network.edges)
        degree = np.bincount(network.edges.ravel()).min()
        assert 1 <= found.fewest[0] <= degree
        assert (found.fewest >= 1).all()
        half = len([1 for i, j in network.edges if (i < network.n // 2) != (j < network.n // 2)])
        assert found.fewest[-1] <= half


def test_links_to_those_who_left_do_not_count_and_parts_have_no_rate():
    edges = family_network("path:5").edges
    assert profile_of([0, 1, 3, 4], edges).fewest.tolist() == [1.0, 0.0]
    assert (profile_of([0, 2, 4], edges).rate(np.ones(2), np.ones(2)) < 0).all()
    assert np.isinf(profile_of([2], edges).rate(np.ones(1), np.ones(1))).all()
    assert profile_of([2], edges).threshold == 0
    assert np.isinf(profile_of([0, 2, 4], edges).threshold)


@pytest.mark.parametrize("graph", ["cycle:4", "path:4", "complete:4"])
def test_every_bound_holds_without_noise_and_proves_agreement(graph):
    found = held(ran((("network",), {"family": graph}), (("baselines",), ["least_squares"])))
    assert set(found) == {"disagreement on P", "disagreement on q", "position error"}
    for bound in found.values():
        assert bound["value"][-1] < 1e-8
    remark = found["disagreement on q"]["remark"]
    assert "agreement proved at 0" in remark
    assert "times the least" in remark


@pytest.mark.parametrize(
    "changes",
    [
        [(("noise",), {"kind": "gaussian", "bearing_deg": 2.0})],
        [(("dropout",), {"rate": 0.4})],
        [(("outage",), [{"link": ["a", "b"], "from_s": 0.2, "until_s": 0.5}])],
        [(("fault",), [{"kind": "leaves", "sensor": "c", "from_s": 0.4, "until_s": 0.7}])],
        [(("fault",), [{"kind": "fails", "sensor": "c", "from_s": 0.4}])],
        [(("fault",), [{"kind": "lost", "sensor": "b", "from_s": 0.4, "until_s": 0.7}])],
        [(("estimator", "entries"), "printed"), (("estimator", "missing"), "withdraw")],
        [(("estimator", "beta_q"), 30.0)],
        [(("estimator", "origin"), "centroid")],
    ],
)
def test_every_bound_holds_through_noise_dropouts_and_comings_and_goings(changes):
    held(ran(*changes, (("baselines",), ["least_squares"])))


def test_explicit_steps_stay_within_their_chattering_bound():
    data = ran((("baselines",), ["explicit"]))
    found = [bound for bound in envelopes(data) if bound["of"] == "explicit"]
    assert [bound["unit"] for bound in found] == ["1", "m"]
    for bound in found:
        assert bound["holds"]
        assert 0.05 < bound["reached"] < 1
    outage = (("outage",), [{"link": ["a", "b"], "from_s": 0.2}])
    assert all(
        b["of"] != "explicit" for b in envelopes(ran((("baselines",), ["explicit"]), outage))
    )


def test_a_gain_below_the_moves_of_the_signals_proves_no_agreement():
    slow = [(("estimator", "beta_q"), 1.0), (("estimator", "beta_P"), 0.01)]
    found = held(ran(*slow, (("baselines",), ["least_squares"])))
    assert "proved at no time" in found["disagreement on q"]["remark"]


def test_a_run_that_breaks_the_law_of_its_steps_crosses_a_bound():
    data = ran((("baselines",), ["least_squares"]))
    wrong = copy.deepcopy(data)
    wrong["consensus"]["disagreement"][30] = [1.0] * 4
    assert not all(bound["holds"] for bound in envelopes(wrong))


@pytest.mark.parametrize("change", [("method", "explicit"), ("sign", "isotropic")])
def test_no_bound_is_claimed_for_other_laws(change):
    key, value = change
    assert envelopes(ran((("estimator", key), value), (("baselines",), []))) == []
